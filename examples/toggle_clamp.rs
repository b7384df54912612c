//! A toggle clamp that holds its workpiece when the hand lets go: at which friction it does, and how far past
//! its dead point it has to stand to do so without any.
//!
//! The clamping force pushes the handle open before the dead point and shut behind it. Between the two lies a
//! stretch in which friction in the pins holds either way. The hand's moment is the drive of the handle: the clamp holds
//! itself where zero lies between the ends of `holding`.

use linkage_core::{SolveError, mechanism};

mechanism! {
    /// Toggle clamp: handle, link and jaw.
    pub struct ToggleClamp {
        /// The handle's angle, zero where handle and link lie in one line.
        input handle: angle;
        param mu = 0.15;
        /// Force of the workpiece on the jaw.
        load clamping: force;

        ground A(0, 0);
        guide bore through A along 0deg;
        crank lever(A) -> B         { length: 40mm, angle: handle }
        rrp   link(B), jaw(bore) -> C { length: 60mm, mode: ahead }

        force (-clamping, 0) on C;
        friction mu at A radius 4mm;
        friction mu at B radius 4mm;
        friction mu on link at C radius 4mm;
        friction mu on jaw length 40mm;

        output handle.drive, jaw;
    }
}

const FORCE: f64 = 2000.0;

/// The moments of a hand between which the clamp stays.
fn band(mu: f64, degrees: f64) -> Result<[f64; 2], SolveError> {
    ToggleClamp { mu }.holding(degrees.to_radians(), FORCE)
}

/// The largest angle before the dead point from which the clamp does not open by itself, in degrees.
fn largest_angle(mu: f64) -> Result<f64, SolveError> {
    let holds = |degrees| match band(mu, degrees) {
        Ok([backwards, forwards]) => Ok(backwards <= 0.0 && 0.0 <= forwards),
        // So near the dead point friction may hold any force.
        Err(SolveError::Jams { .. }) => Ok(true),
        Err(error) => Err(error),
    };
    let (mut inside, mut outside) = (0.0, 60.0);
    for _ in 0..50 {
        let middle = 0.5 * (inside + outside);
        if holds(middle)? { inside = middle } else { outside = middle }
    }
    Ok(inside)
}

fn main() -> Result<(), SolveError> {
    println!("clamping force {FORCE} N; moments in N·m that hold the handle\n");
    println!("{:>8} {:>10} {:>10} {:>10}  lets go?", "degrees", "backwards", "free", "forwards");
    for degrees in [15.0, 5.0, 2.0, 1.0, -1.0, -2.0, -5.0] {
        let [backwards, forwards] = band(0.15, degrees)?;
        let [free, _] = band(0.0, degrees)?;
        let verdict = match (backwards > 0.0, forwards < 0.0) {
            (true, _) => "turns back by itself",
            (_, true) => "turns on by itself",
            _ => "holds",
        };
        println!("{degrees:>8} {backwards:>10.2} {free:>10.2} {forwards:>10.2}  {verdict}");
    }
    println!("\n{:>8} {:>34}", "friction", "holds from so many degrees on");
    for mu in [0.05, 0.1, 0.15, 0.2, 0.3] {
        println!("{mu:>8} {:>34.2}", largest_angle(mu)?);
    }
    Ok(())
}
