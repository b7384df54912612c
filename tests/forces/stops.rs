//! Stops against closed forms, virtual work and energy.

use linkage_core::SolveError;
use linkage_tests::mechanisms::stops::*;
use linkage_tests::random::Random;

/// Ends at −0.1 m and 0.2 m, 2000 N/m, 30 N s/m.
#[test]
fn a_buffer_pushes_beyond_its_ends_and_never_pulls() {
    let block = Buffered::new();
    let push = |x: f64, rate: f64| {
        let f = block.forces(x, rate, 0.0).unwrap();
        // The drive holds the block against the stop: the sum is zero without acceleration.
        assert!((f.x.drive + f.buffer.force).abs() <= 1e-12 * f64::abs(f.buffer.force));
        [f.buffer.force, f.buffer.gap]
    };
    for (x, rate, force, gap) in [
        (-0.11, 0.0, 20.0, -0.01),
        (-0.11, -0.5, 35.0, -0.01),
        (-0.11, 0.5, 5.0, -0.01),
        // The block leaves faster than the buffer follows.
        (-0.11, 2.0, 0.0, -0.01),
        (0.23, 0.0, -60.0, -0.03),
        (0.23, 1.0, -90.0, -0.03),
        (0.23, -3.0, 0.0, -0.03),
        // Between the ends nothing acts, however fast the block comes.
        (0.199, 50.0, 0.0, 0.001),
        (-0.04, -50.0, 0.0, 0.06),
        (0.05, 0.0, 0.0, 0.15),
    ] {
        let found = push(x, rate);
        // Ends and middle are known within an ε of 0.2 m, which is 10⁻¹³ N here.
        assert!((found[0] - force).abs() < 1e-12, "{x} {rate}: {found:?}");
        assert!((found[1] - gap).abs() < 1e-16 * 4.0, "{x} {rate}: {found:?}");
    }
    let energy = block.energy(-0.11, 0.0).unwrap();
    assert!((energy.potential - 0.1).abs() < 1e-14, "{energy:?}");
    assert_eq!(block.energy(0.1, 0.0).unwrap().potential, 0.0);
}

#[test]
fn ends_in_the_wrong_order_and_a_negative_stiffness_are_invalid() {
    let turned = Buffered { from: 0.3, ..Buffered::new() };
    let error = turned.forces(0.0, 0.0, 0.0).unwrap_err();
    assert!(matches!(error, SolveError::Invalid { .. }), "{error}");
    let pulls = Buffered { stiffness: -1.0, ..Buffered::new() };
    assert!(matches!(pulls.forces(0.0, 0.0, 0.0), Err(SolveError::Invalid { .. })));
}

/// Without mass the drive's power is that of the stops, backwards.
#[test]
fn the_drive_pays_for_what_stops_take() {
    let (four_bar, mut random, mut beyond) = (StoppedFourBar::new(), Random::new(41), [0; 2]);
    for _ in 0..2000 {
        let (q, rate) = (random.between(-3.1, 3.1), random.between(-9.0, 9.0));
        let (Ok(f), Ok(v)) = (four_bar.forces(q, rate, 0.0), four_bar.velocity(q, rate)) else {
            continue;
        };
        let p = four_bar.position(q).unwrap();
        let (dx, dy) = (p.Q.x - 0.3, p.Q.y - 0.6);
        let distance_rate = (dx * v.Q.x + dy * v.Q.y) / dx.hypot(dy);
        let power = f.rubber.force * v.DC.omega + f.post.force * distance_rate;
        // Efforts of up to some thousand N, with the roundings of some fifty operations.
        let size = f.rubber.force.abs() + f.post.force.abs() + 1.0;
        assert!((f.theta.drive * rate + power).abs() <= 1e-12 * size * rate.abs().max(1.0), "{q}");
        let angle = p.DC.angle().to_degrees();
        assert_eq!(f.rubber.gap < 0.0, !(100.0..=130.0).contains(&angle), "{q}: {angle}");
        beyond[0] += usize::from(f.rubber.force != 0.0);
        beyond[1] += usize::from(f.post.force != 0.0);
    }
    assert!(beyond.iter().all(|&count| count > 200), "{beyond:?}");
}

/// At rest the drive is the slope of the energy: a difference of fourth order.
#[test]
fn stops_are_held_by_the_slope_of_their_energy() {
    let (four_bar, h) = (StoppedFourBar::new(), 1e-4);
    let mut compared = 0;
    for step in 0..400 {
        let q = -3.1 + 0.0155 * f64::from(step);
        let energy = |at: f64| four_bar.energy(at, 0.0).map(|energy| energy.potential);
        let near = [-2.0, -1.0, 1.0, 2.0].map(|steps| energy(q + steps * h));
        let [Ok(a), Ok(b), Ok(c), Ok(d)] = near else { continue };
        let f = four_bar.statics(q).unwrap();
        // The second derivative jumps at an end.
        if [f.rubber.gap, f.post.gap].iter().any(|gap| gap.abs() < 1e-3) {
            continue;
        }
        let slope = (8.0 * (c - b) - (d - a)) / (12.0 * h);
        // Rounding of the energy over h, and h⁴ of its fifth derivative.
        let size = 1.0 + b.abs() + f.theta.drive.abs();
        assert!((slope - f.theta.drive).abs() < 1e-9 * size, "{q}: {slope} {}", f.theta.drive);
        compared += 1;
    }
    assert!(compared > 300, "{compared}");
}

/// A pinion's tooth drives the gear behind it with twice its couple.
#[test]
fn teeth_push_across_their_play() {
    let gears = Backlash::new();
    let quarter = 0.25_f64.to_radians();
    for (off, rate) in [(0.001, 0.0), (-0.002, -1.5), (0.003, -20.0)] {
        let first = 0.7;
        let second = -2.0 * first + off + f64::signum(off) * quarter;
        let f = gears.forces([first, second], [0.0, rate], [0.0, 0.0]).unwrap();
        let push = f64::max(0.0, 4000.0 * f64::abs(off) + rate * f64::signum(off));
        let force = -f64::signum(off) * push;
        // Angles of up to 1.4 rad are known within ε, times 4000 N·m.
        assert!((f.teeth.force - force).abs() < 4e-12, "{off}: {} {force}", f.teeth.force);
        assert!(
            (f.second.drive + force).abs() < 4e-12 && (f.first.drive + 2.0 * force).abs() < 8e-12
        );
    }
    let f = gears.forces([0.7, -1.4], [5.0, -70.0], [0.0, 0.0]).unwrap();
    assert_eq!([f.teeth.force, f.first.drive, f.second.drive], [0.0; 3]);
}

/// A block that meets its buffer turns round: its energy falls by what the damper takes, and it is free again.
#[test]
fn a_block_rebounds() {
    let (block, step) = (Buffered::new(), 1e-5);
    let (mut x, mut rate, mut heat) = (0.19, 1.0, 0.0);
    let before = block.energy(x, rate).unwrap();
    let mut time = 0;
    while time < 20_000 && !(rate < 0.0 && x < 0.2) {
        // Classical Runge and Kutta's, of which the corners leave steps of first order alone.
        let accel = |x: f64, rate: f64| block.forward_dynamics(x, rate, 0.0).unwrap();
        let [k1, l1] = [rate, accel(x, rate)];
        let [k2, l2] = [rate + 0.5 * step * l1, accel(x + 0.5 * step * k1, rate + 0.5 * step * l1)];
        let [k3, l3] = [rate + 0.5 * step * l2, accel(x + 0.5 * step * k2, rate + 0.5 * step * l2)];
        let [k4, l4] = [rate + step * l3, accel(x + step * k3, rate + step * l3)];
        let f = block.forces(x, rate, 0.0).unwrap();
        let elastic = if f.buffer.gap < 0.0 { 2000.0 * f.buffer.gap } else { 0.0 };
        heat -= (f.buffer.force - elastic) * rate * step;
        x += step / 6.0 * (k1 + 2.0 * (k2 + k3) + k4);
        rate += step / 6.0 * (l1 + 2.0 * (l2 + l3) + l4);
        time += 1;
    }
    let after = block.energy(x, rate).unwrap();
    assert!(time < 20_000 && after.kinetic < 0.9 * before.kinetic, "{after:?}");
    // The integral of the heat is of first order: 10⁻⁵ s of some 30 W at each end of the contact.
    let lost = before.kinetic + before.potential - after.kinetic - after.potential;
    assert!((lost - heat).abs() < 1e-3 * before.kinetic, "{lost} {heat}");
}
