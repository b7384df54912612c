//! Joints that do not turn, turn by rounding alone, or are just starting.

use std::f64::consts::PI;

use linkage_core::{Record, Status};
use linkage_tests::mechanisms::friction::RubbingGroups;
use linkage_tests::mechanisms::still::*;
use linkage_tests::random::Random;

/// The angles at which the parallelogram is one, which is an antiparallelogram behind its change points at 0° and 180°.
fn angles() -> impl Iterator<Item = f64> {
    (1..400).map(|step| PI * f64::from(step) / 400.25)
}

/// Everything is what it is without friction: to the bit, as nothing is added.
#[test]
fn a_coupler_that_stays_parallel_does_not_rub() {
    let (rubs, free) = (
        RubbingParallelogram::new(),
        RubbingParallelogram { mu: 0.0, ..RubbingParallelogram::new() },
    );
    for (theta, rate, accel) in
        angles().flat_map(|q| [(q, 7.0, -3.0), (q, -0.1, 40.0), (q, 1e-9, 0.0)])
    {
        let f = rubs.forces(theta, rate, accel, 90.0).unwrap();
        assert_eq!([f.block.P_friction, f.losses], [0.0; 2], "{theta}");
        assert_eq!(f, free.forces(theta, rate, accel, 90.0).unwrap(), "{theta}");
        let f = rubs.statics(theta, rate, 90.0).unwrap();
        assert_eq!(f, free.statics(theta, rate, 90.0).unwrap(), "{theta}");
        // At rest, and just starting.
        let f = rubs.forces(theta, 0.0, accel, 90.0).unwrap();
        assert_eq!(f, free.forces(theta, 0.0, accel, 90.0).unwrap(), "{theta}");
        let [least, most] = rubs.holding(theta, 90.0).unwrap();
        assert_eq!(least, most, "{theta}");
        for rate in [rate, 0.0] {
            let [own, other] = [rubs, free]
                .map(|machine| machine.forward_dynamics(theta, rate, accel, 90.0).unwrap());
            assert_eq!(own, other, "{theta}");
        }
    }
    // Behind its change point it is no parallelogram, and rubs.
    let mut loaded = 0;
    for theta in angles() {
        let f = rubs.forces(-theta, 7.0, -3.0, 90.0).unwrap();
        let load = f64::hypot(f.block.P.x, f.block.P.y);
        let friction = f.block.P_friction.abs();
        assert!((friction - 0.2 * 0.03 * load).abs() <= 1e-12 * load, "{theta}: {friction} {load}");
        loaded += u32::from(load > 1.0);
    }
    assert!(loaded > 350, "{loaded}");
}

/// Single precision, and a sweep.
#[test]
fn a_coupler_does_not_rub_in_single_precision_and_in_a_sweep() {
    let narrow = RubbingParallelogram::<f32>::default();
    let wide = RubbingParallelogram::new();
    let angles: Vec<f64> = angles().collect();
    let (count, mut rubs) = (angles.len(), 0);
    for &theta in &angles {
        let f = narrow.forces(theta as f32, 7.0, -3.0, 90.0).unwrap();
        assert_eq!([f.block.P_friction, f.losses], [0.0; 2], "{theta}");
        let f = narrow.forces(-theta as f32, 7.0, -3.0, 90.0).unwrap();
        rubs += u32::from(f.block.P_friction.abs() > 5e-3);
    }
    assert!(rubs > 350, "{rubs}");
    const NUMBERS: usize = 9;
    let mut rows = vec![vec![f64::NAN; count]; NUMBERS];
    let mut status = vec![Status::Solved; count];
    let mut parts = rows.iter_mut();
    let out: [&mut [f64]; NUMBERS] = std::array::from_fn(|_| &mut parts.next().unwrap()[..]);
    let out = <RubbingParallelogramForces<&mut [f64]> as Record>::from_array(out);
    wide.sweep_forces(&angles[..], 7.0, -3.0, 90.0, out, &mut status, ()).unwrap();
    assert_eq!(status, vec![Status::Solved; count]);
    for (at, &theta) in angles.iter().enumerate() {
        let f = wide.forces(theta, 7.0, -3.0, 90.0).unwrap().into_array();
        let zeros = f.iter().zip(&rows).filter(|(single, _)| **single == 0.0);
        assert!(
            zeros.clone().count() >= 2 && zeros.clone().all(|(_, row)| row[at] == 0.0),
            "{theta}"
        );
    }
}

/// Two parallelograms, one on the other.
#[test]
fn a_lamp_that_stays_upright_does_not_rub() {
    let (rubs, free) = (RubbingLamp::new(), RubbingLamp { mu: 0.0 });
    let mut random = Random::new(31);
    let mut compared = 0;
    for _ in 0..2000 {
        let mut pair = |least: f64, most: f64| [(); 2].map(|()| random.between(least, most));
        // From 20°, the slope of the ground, to 200° both stay on the left of their couplers.
        let (q, rates, seconds) = (pair(0.4, 3.4), pair(-9.0, 9.0), pair(-40.0, 40.0));
        let Ok(f) = rubs.forces(q, rates, seconds) else { continue };
        assert_eq!(f, free.forces(q, rates, seconds).unwrap(), "{q:?}");
        compared += 1;
    }
    assert!(compared > 1900, "{compared}");
}

/// Bodies that are known to be rigid do not rub, in any state.
#[test]
fn a_truss_does_not_rub() {
    let (rubs, free) = (RubbingTruss::new(), RubbingTruss { mu: 0.0 });
    let mut random = Random::new(37);
    let mut compared = 0;
    for _ in 0..500 {
        let mut draw = |size: f64| random.between(-size, size);
        let (q, rate, accel) = (draw(3.1), draw(9.0), draw(40.0));
        let Ok(f) = rubs.forces(q, rate, accel) else { continue };
        assert_eq!(
            [f.r.H_friction, f.r.F_friction, f.shoe.way_friction, f.losses],
            [0.0; 4],
            "{q}"
        );
        assert_eq!(f, free.forces(q, rate, accel).unwrap(), "{q}");
        assert_eq!(rubs.statics(q, rate), free.statics(q, rate), "{q}");
        compared += 1;
    }
    assert!(compared > 400, "{compared}");
}

/// The limit of an ever slower motion: a smooth sign leaves nothing at rest, in any call.
#[test]
fn a_smooth_sign_is_none_at_rest() {
    let block = SmoothBlock::new();
    for creep in [1.0, -1.0, 1e-9, 0.0] {
        assert_eq!(block.statics(0.0, creep).unwrap().into_array(), [0.0; 3], "{creep}");
    }
    assert_eq!(block.holding(0.0).unwrap(), [0.0; 2]);
    assert_eq!(block.forces(0.0, 0.0, 0.0).unwrap().x.drive, 0.0);
    // 0.1 · 3 kg · 9.81 m/s² · v/√(v² + e²) goes there; at 1 µm/s it is a ten-thousandth of 2.943 N.
    let slow = block.forces(0.0, 1e-6, 0.0).unwrap().x.drive;
    assert!((slow - 2.943e-4).abs() < 1e-11, "{slow}");
    // A drive of 1 N moves 3 kg.
    let second = block.forward_dynamics(0.0, 0.0, 1.0).unwrap();
    assert!((second - 1.0 / 3.0).abs() < 1e-15, "{second}");
}

/// A motion that is just starting has friction as the same motion a little later.
#[test]
fn a_start_is_the_limit_of_a_motion() {
    let (mut random, mut compared) = (Random::new(41), 0);
    for _ in 0..1000 {
        let mu = 0.2 * random.between(0.0, 1.0);
        let groups = RubbingGroups { mu, ..RubbingGroups::new() };
        let mut draw = |size: f64| random.between(-size, size);
        let (q, accel, push) = (draw(3.2), draw(40.0), draw(500.0));
        let (Ok(starts), Ok(later)) =
            (groups.forces(q, 0.0, accel, push), groups.forces(q, 1e-9 * accel, accel, push))
        else {
            continue;
        };
        let (starts, later) = (starts.into_array(), later.into_array());
        let largest = starts.iter().fold(0.0_f64, |size, x| size.max(x.abs()));
        for (starts, later) in starts.iter().zip(&later) {
            // Centripetal terms are 1e-18 of accel²; losses and rates are 1e-9 of it, of some newton metres.
            assert!((starts - later).abs() <= 1e-7 * largest, "{q} {accel}: {starts} {later}");
        }
        compared += 1;
    }
    assert!(compared > 500, "{compared}");
}

/// A pin between two links that move: by numbers of the same motion at a billionth of its speed.
#[test]
fn a_pin_between_links_that_start_rubs_against_their_difference() {
    let pins = RubbingPins::new();
    let mut differ = 0;
    for step in 0..63 {
        let q = 0.1 * f64::from(step);
        for accel in [3.0, -3.0] {
            let [starts, later] =
                [0.0, 1e-9 * accel].map(|rate| pins.forces(q, rate, accel).unwrap().theta.drive);
            assert!((starts - later).abs() < 1e-8, "{q}: {starts} {later}");
            let back = pins.forces(q, -1e-9 * accel, accel).unwrap().theta.drive;
            differ += usize::from((starts - back).abs() > 1e-3);
        }
    }
    assert_eq!(differ, 126, "friction is against the start everywhere");
}
