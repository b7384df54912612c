//! Outputs that read efforts, reactions and rates, in every way that a solver is asked.

use linkage_core::num_dual::DualSVec;
use linkage_core::{Record, Status, differentiate, mechanism};

mechanism! {
    /// A press of which a bearing's wear is asked, by pressure and speed.
    pub struct Worn {
        input theta: angle;
        load work: force;
        ground A(0, 0);
        guide bed through A along 0deg;
        crank AB(A) -> B          { length: 80mm, angle: theta }
        rrp   BC(B), ram(bed) -> C { length: 250mm, mode: ahead }
        let brake = -40(N*s/m) * rate(ram.slide) - work;
        mass 40kg on C;
        mass 5kg on BC uniform;
        inertia 0.4(kg*m^2) on AB;
        force (brake, 0) on C;
        friction 0.1 at A radius 30mm;
        friction 0.1 on BC at C radius 15mm;
        friction 0.12 on ram length 120mm;
        output theta.drive, BC.C, ram.bed, losses, BC.C.friction, ram.bed.friction, brake,
            pv = hypot(BC.C.x, BC.C.y) / (16mm * 20mm) * 8mm * abs(rate(BC.angle)),
            power = theta.drive * rate(theta);
    }
}

/// Pressure times speed from the numbers beside it.
fn pv(press: &Worn, state: [f64; 4]) -> f64 {
    let [q, rate, second, work] = state;
    let (f, v) = (press.forces(q, rate, second, work).unwrap(), press.velocity(q, rate).unwrap());
    f.BC.C.x.hypot(f.BC.C.y) / (0.016 * 0.02) * 0.008 * v.BC.omega.abs()
}

#[test]
fn outputs_of_efforts_are_made_of_the_efforts() {
    let (wide, narrow) = (Worn::new(), Worn::<f32>::default());
    for step in 0..40 {
        let q = 0.1 + 0.155 * f64::from(step);
        let (rate, second, work) = (10.0, -30.0, 2e4);
        let f = wide.forces(q, rate, second, work).unwrap();
        let slide = wide.velocity(q, rate).unwrap().ram.slide;
        let expected = pv(&wide, [q, rate, second, work]);
        // Some ten roundings each.
        let close = |found: f64, expected: f64| {
            assert!(
                (found - expected).abs() <= 4e-15 * expected.abs().max(1.0),
                "{found} {expected}"
            );
        };
        close(f.pv, expected);
        close(f.power, f.theta.drive * rate);
        close(f.brake, -40.0 * slide - work);
        // The friction of a pin and of a guide, against the motion.
        close(f.BC.C_friction.abs(), 0.1 * 0.015 * f.BC.C.x.hypot(f.BC.C.y));
        let pressed = f.ram.bed.normal.abs().max(2.0 * f.ram.bed.couple.abs() / 0.12);
        close(f.ram.bed_friction, -slide.signum() * 0.12 * pressed);
        // Angles of single precision are an ulp of six off, which the forces have twice.
        let single = narrow.forces(q as f32, rate as f32, second as f32, work as f32).unwrap();
        let exact = wide.forces(f64::from(q as f32), rate, second, work).unwrap();
        assert!((f64::from(single.pv) - exact.pv).abs() < 2e-5 * exact.pv.abs().max(1e6), "{q}");
    }
}

/// The slope along a motion, by duals and by a difference.
#[test]
fn outputs_of_efforts_are_differentiated() {
    let (press, h) = (Worn::new(), 1e-6);
    let exact = differentiate([0.7], |[q]: [DualSVec<f64, 1>; 1]| {
        let real = DualSVec::from_re;
        let f = Worn::default().forces(q, real(3.0), real(-2.0), real(500.0))?;
        Ok([f.pv])
    });
    let moved = |by: f64| pv(&press, [0.7 + by, 3.0, -2.0, 500.0]);
    let slope = (moved(h) - moved(-h)) / (2.0 * h);
    let exact = exact.unwrap()[0];
    assert!((exact - slope).abs() < 1e-7 * slope.abs(), "{exact} {slope}");
}

#[test]
fn outputs_of_efforts_stand_in_sweeps_and_at_rest() {
    let press = Worn::new();
    let angles: Vec<f64> = (0..37).map(|step| 0.17 * f64::from(step)).collect();
    let (mut pv, mut friction, mut status) = ([0.0; 37], [0.0; 37], [Status::Solved; 37]);
    let mut out = <WornForces<&mut [f64]> as Record>::from_array(
        [(); WornForces::<f64>::LABELS.len()].map(|()| &mut [][..]),
    );
    assert!(WornForces::<f64>::LABELS.contains(&"ram.bed.friction"));
    out.pv = &mut pv;
    out.BC.C_friction = &mut friction;
    press.sweep_forces(&angles, 3.0, -1.0, 800.0, out, &mut status, ()).unwrap();
    for (k, &theta) in angles.iter().enumerate() {
        let f = press.forces(theta, 3.0, -1.0, 800.0).unwrap();
        // A sweep may fuse where a single call does not.
        assert!((pv[k] - f.pv).abs() < 1e-12 * f.pv.abs().max(1.0), "{theta}");
        assert!((friction[k] - f.BC.C_friction).abs() < 1e-12 * 800.0, "{theta}");
    }
    // At rest rates are zero, whatever the creep; friction is there.
    let f = press.statics(0.7, 3.0, 800.0).unwrap();
    assert!(f.pv == 0.0 && f.power == 0.0 && f.brake == -800.0 && f.BC.C_friction != 0.0);
}
