//! A press's stroke as JSON, a line a pose, and the lines read again.
//!
//! With the feature `serde` of `linkage-core` every record of a mechanism is written and read by its
//! fields' names: `{"position":{"ram":{"slide":0.33}, …}, …}`.

use std::error::Error;

use linkage_core::mechanism;

mechanism! {
    /// An eccentric press.
    pub struct Press {
        input theta: angle;
        ground A(0, 0);
        guide bed through (0, 30mm) along 0deg;
        crank AB(A) -> B           { length: 80mm, angle: theta }
        rrp   BC(B), ram(bed) -> C { length: 250mm, mode: ahead }
        output ram.slide, BC;
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let press = Press::new();
    let mut lines = Vec::new();
    for step in 0..=6 {
        let motion = press.motion(f64::from(30 * step).to_radians(), 6.0, 0.0)?;
        lines.push(serde_json::to_string(&motion)?);
    }
    for line in &lines {
        println!("{line}");
    }
    let read = lines.iter().map(|line| serde_json::from_str::<PressMotion>(line));
    let read: Vec<PressMotion> = read.collect::<Result<_, _>>()?;
    let fastest = read.iter().map(|motion| motion.velocity.ram.slide.abs()).fold(0.0, f64::max);
    println!("{} poses read; the ram moves at {fastest:.3} m/s at most", read.len());
    Ok(())
}
