//! Ratios of rates and instant centres of whole machines: in both widths, on dual numbers, in sweeps, beside forces.

use linkage_core::{Point, Real, SolveError, unwanted};
use linkage_tests::in_both_widths;
use linkage_tests::mechanisms::ratios::*;
use linkage_tests::widths::number;
use num_dual::Dual2_64;

const ARMS: [f64; 5] = [2.9, 3.0, 3.1, 3.2, 3.3];

/// The ratio is that of the velocities at any rate, and the pole has no velocity: v = ω ẑ × (P − I). Some twenty roundings
/// of velocities below ten, and of a pole that is some metres away.
fn as_velocities_say<T: Real>() {
    let rear = Rear::<T>::default();
    for arm in ARMS {
        let (p, v) = (
            rear.position(number(arm)).unwrap(),
            rear.velocity(number(arm), number(-3.0)).unwrap(),
        );
        let ratio = v.axle.y.value() / v.shock.value();
        let allowed = 50.0 * T::EPSILON;
        assert!((p.leverage.value() / ratio - 1.0).abs() <= allowed, "{arm}: {ratio}");
        let [ix, iy] = [p.I.x.value() - p.seat.x.value(), p.I.y.value() - p.seat.y.value()];
        // The seat is on both links.
        let omega = v.seatstay.omega.value();
        let [x, y] = [3.0 * p.seat.y.value(), -3.0 * p.seat.x.value()];
        let allowed = allowed * 10.0 * (1.0 + ix.hypot(iy));
        assert!((x - omega * iy).abs() <= allowed && (y + omega * ix).abs() <= allowed, "{arm}");
    }
}

/// First and second derivative by dual numbers through the position.
#[test]
fn dual_numbers_give_the_same_rates() {
    let rear = Rear::new();
    for arm in ARMS {
        let dual = rear.lift::<Dual2_64>().position(Dual2_64::from_re(arm).derivative()).unwrap();
        let motion = rear.motion(arm, 1.0, 0.0).unwrap();
        let (v, a) = (motion.velocity, motion.acceleration);
        for (dual, first, second) in [
            (dual.leverage, v.leverage, a.leverage),
            (dual.I.x, v.I.x, a.I.x),
            (dual.I.y, v.I.y, a.I.y),
        ] {
            // Sums of some fifty terms, of size far above one next to a pole that moves fast.
            let scale = 1.0 + first.abs() + second.abs();
            assert!((dual.v1 - first).abs() <= 1e-12 * scale, "{arm}: {} {first}", dual.v1);
            assert!((dual.v2 - second).abs() <= 1e-11 * scale, "{arm}: {} {second}", dual.v2);
        }
        let jacobian = rear.jacobian(arm).unwrap();
        let row = Rear::OUTPUTS.iter().position(|name| *name == "leverage").unwrap();
        assert_eq!(jacobian[row], v.leverage);
        assert_eq!(rear.coefficients(arm).unwrap()[row], [v.leverage]);
    }
}

/// Sensitivity to the dimensions against differences of the ratio.
#[test]
fn a_ratio_has_slopes_by_the_dimensions() {
    let (rear, h) = (Rear::new(), 1e-6);
    let slopes = rear.sensitivity(3.1).unwrap();
    let row = Rear::OUTPUTS.iter().position(|name| *name == "leverage").unwrap();
    let at = |stay: f64, lever: f64| Rear { stay, lever }.position(3.1).unwrap().leverage;
    let (stay, lever) = (rear.stay, rear.lever);
    let by_stay = (at(stay + h, lever) - at(stay - h, lever)) / (2.0 * h);
    let by_lever = (at(stay, lever + h) - at(stay, lever - h)) / (2.0 * h);
    // h² of a third derivative below 1e6, and roundings over h.
    assert!((slopes[(row, 0)] - by_stay).abs() < 1e-5, "{} {by_stay}", slopes[(row, 0)]);
    assert!((slopes[(row, 1)] - by_lever).abs() < 1e-5, "{} {by_lever}", slopes[(row, 1)]);
    assert!(by_stay.abs() > 0.1 && by_lever.abs() > 0.1);
}

#[test]
fn sweeps_have_ratios() {
    let rear = Rear::new();
    let angles: [f64; 37] = core::array::from_fn(|k| 2.9 + 0.01 * k as f64);
    let (mut ratios, mut poles) = ([0.0; 37], [0.0; 37]);
    let wanted = RearPosition {
        leverage: &mut ratios[..],
        I: Point { x: &mut poles[..], y: &mut [] },
        ..unwanted()
    };
    rear.sweep_position(&angles, wanted, &mut [], ()).unwrap();
    for (k, &angle) in angles.iter().enumerate() {
        let p = rear.position(angle).unwrap();
        // Lanes may fuse other operations than a single pose does.
        assert!((ratios[k] / p.leverage - 1.0).abs() < 1e-13, "{angle}");
        assert!((poles[k] / p.I.x - 1.0).abs() < 1e-12, "{angle}");
    }
}

/// A number that no rate changes is in the pose, beside masses as well; a rate is among the forces.
#[test]
fn a_ratio_is_no_force() {
    let (heavy, light) = (HeavyRear::new(), Rear::new());
    let arm = 3.1;
    let [own, other] =
        [heavy.position(arm).unwrap().leverage, light.position(arm).unwrap().leverage];
    // Lengths that are constants are folded.
    assert!((own / other - 1.0).abs() < 1e-14, "{own} {other}");
    let forces = heavy.forces(arm, 2.0, 0.0).unwrap();
    assert_eq!(forces.speed, heavy.velocity(arm, 2.0).unwrap().axle.y);
    assert_eq!(HeavyRear::FORCES, ["speed", "wheel"]);
}

/// A coupler that does not turn has no pole, and is named; beside the pose in which it does not, the pole is far away.
fn what_does_not_turn_is_named<T: Real>() {
    let bars = EqualBars::<T>::default();
    for theta in [0.4, 1.1, 2.0, 2.7] {
        let refused = bars.position(number(theta)).map(|p| p.I.x.value());
        assert_eq!(refused, Err(SolveError::Singular { group: "BC" }), "{theta}");
        let near = EqualBars { ground_bar: number::<T>(0.501) }.position(number(theta));
        let near = near.map(|p| p.I.x.value().hypot(p.I.y.value()));
        assert!(near.is_ok_and(|far| far > 5.0), "{theta}");
    }
    let geared = Geared::<T>::default();
    // Willis: the pole divides the line of centres by the ratio, −1 from A where D turns twice as fast.
    let at = geared.position(number(0.7)).unwrap().K;
    assert!(
        (at.x.value() - 2.0).abs() <= 8.0 * T::EPSILON && at.y.value().abs() <= 8.0 * T::EPSILON
    );
    let alike = Geared { teeth: number::<T>(1.0) }.position(number(0.7)).map(|p| p.K.x.value());
    assert_eq!(alike, Err(SolveError::Singular { group: "second against first" }));
}

/// Behind an equation: the roll centre by the pole is where the arms' lines meet, and the gain is that of differences.
#[test]
fn behind_an_equation() {
    let axle = ByTravel::new();
    for travel in [0.25, 0.3, 0.37] {
        let p = axle.position(travel).unwrap();
        let h = 1e-5;
        let [before, after] = [-h, h].map(|by| axle.position(travel + by).unwrap().upright);
        let quotient = after.angle_from(before) / (2.0 * h);
        // h² of a third derivative below 1e3, and roundings over h.
        assert!((p.gain - quotient).abs() < 1e-6, "{travel}: {} {quotient}", p.gain);
        let moved = axle.velocity(travel, 1.0).unwrap();
        let (x, y) = (p.patch.x - p.I.x, p.patch.y - p.I.y);
        assert!(
            (moved.patch.x + p.gain * y).abs() < 1e-12
                && (moved.patch.y - p.gain * x).abs() < 1e-12
        );
    }
}

in_both_widths! { as_velocities_say what_does_not_turn_is_named }
