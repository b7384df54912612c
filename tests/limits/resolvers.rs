//! The readings of resolvers: a cosine and a sine of an amplitude that is nearly one. Bars keep their lengths
//! for every reading that is not refused.

use linkage_core::{Lanes, Real, Scalar, SolveError, differentiate_twice};
use linkage_tests::in_both_widths;
use linkage_tests::mechanisms::resolvers::*;
use linkage_tests::widths::number;

/// From the least accepted to the largest, a few per cent and a few last places from one.
fn amplitudes<T: Real>() -> [f64; 11] {
    let last = T::EPSILON;
    [0.9001, 0.95, 0.98, 0.99, 1.0 - 4.0 * last, 1.0, 1.0 + 4.0 * last, 1.01, 1.02, 1.05, 1.0999]
}

const STEPS: i32 = 64;

/// Everything that a mechanism answers with a cosine and a sine, of any amplitude, against what it
/// answers with the angle.
macro_rules! assert_solved {
    ($t:ident: $($mechanism:ident),*) => {$(
        let solver = $mechanism::<$t>::default();
        for step in -STEPS..=STEPS {
            let theta = f64::from(step) * 3.0 / f64::from(STEPS);
            let (sin, cos) = theta.sin_cos();
            let expected = solver.motion(number(theta), number(0.5), number(0.25)).unwrap();
            for amplitude in amplitudes::<$t>() {
                let [cos, sin] = [amplitude * cos, amplitude * sin].map(number::<$t>);
                let found = solver.motion_at(cos, sin, number(0.5), number(0.25)).unwrap();
                assert_eq!(found.position, solver.position_at(cos, sin).unwrap());
                let velocity = solver.velocity_at(cos, sin, number(0.5)).unwrap();
                let pairs = [
                    (found.position.rows().to_vec(), expected.position.rows().to_vec()),
                    (found.velocity.rows().to_vec(), expected.velocity.rows().to_vec()),
                    (velocity.rows().to_vec(), expected.velocity.rows().to_vec()),
                    (found.acceleration.rows().to_vec(), expected.acceleration.rows().to_vec()),
                ];
                for (found, expected) in pairs.iter().flat_map(|(a, b)| a.iter().zip(b)) {
                    // Cosine and sine are off by three roundings; what is made of them is at most
                    // forty times as sensitive, at rates below one.
                    let error = (found - expected).abs();
                    assert!(error <= 128.0 * $t::EPSILON, "{found} {expected} at {theta} {amplitude}");
                }
                let (marked, ok) = solver.solve_position_at(cos, sin);
                assert!(ok && marked == found.position);
            }
        }
    )*};
}

#[test]
fn an_amplitude_is_divided_out() {
    assert_solved!(f64: KnownBars, TunedBars, SlidersOnACrank);
    assert_solved!(f32: KnownBars, TunedBars, SlidersOnACrank);
}

fn distance<T: Real>(a: linkage_core::Point<T>, b: [f64; 2]) -> f64 {
    (a.x.value() - b[0]).hypot(a.y.value() - b[1])
}

/// At an amplitude of 1.01 the coupler was off by 0.65 mm, as `Ok`.
fn bars_keep_their_lengths<T: Real>() {
    let (known, tuned) = (KnownBars::<T>::default(), TunedBars::<T>::default());
    for step in -STEPS..=STEPS {
        let (sin, cos) = (f64::from(step) * 3.0 / f64::from(STEPS)).sin_cos();
        for amplitude in amplitudes::<T>() {
            let [cos, sin] = [amplitude * cos, amplitude * sin].map(number::<T>);
            let known = known.position_at(cos, sin).unwrap();
            let tuned = tuned.position_at(cos, sin).unwrap();
            for (b, c) in [(known.B, known.C), (tuned.B, tuned.C)] {
                // Coordinates up to 0.4 m, each with a few roundings.
                let allowed = 4.0 * T::EPSILON * 0.4;
                let (crank, coupler) =
                    (distance(b, [0.0; 2]), distance(c, [b.x.value(), b.y.value()]));
                assert!((crank - 0.1016).abs() <= allowed, "{crank}");
                assert!((coupler - 0.254).abs() <= allowed, "{coupler}");
                assert!((distance(c, [0.3048, 0.0]) - 0.1778).abs() <= allowed);
            }
        }
    }
}

fn what_no_resolver_delivers_is_refused<T: Real>() {
    let bars = KnownBars::<T>::default();
    let given = [
        [0.0, 0.0],
        [-2.0, -2.0],
        [0.5, 0.5],
        [0.0, 0.899],
        [0.0, -1.101],
        [1e-30, 0.0],
        [1e30, 1e30],
        [0.0, 1e-3],
    ];
    for [cos, sin] in given.map(|given| given.map(number::<T>)) {
        let amplitude = cos.value().hypot(sin.value());
        let answers = [
            bars.position_at(cos, sin).map(|_| ()),
            bars.velocity_at(cos, sin, number(1.0)).map(|_| ()),
            bars.motion_at(cos, sin, number(1.0), number(0.0)).map(|_| ()),
        ];
        for answer in answers {
            let Err(SolveError::OffCircle { name: "theta", amplitude: found }) = answer else {
                panic!("{answer:?} from {cos:?} {sin:?}");
            };
            assert!((found - amplitude).abs() <= 2.0 * f64::EPSILON * amplitude);
        }
        assert!(!bars.solve_position_at(cos, sin).1);
        assert!(!bars.solve_motion_at(cos, sin, number(1.0), number(0.0)).1);
    }
    for (cos, sin, name) in [(f64::NAN, 0.0, "cos"), (1.0, f64::INFINITY, "sin")] {
        let answer = bars.position_at(number(cos), number(sin)).map(|_| ());
        assert_eq!(answer, Err(SolveError::NotFinite { name }));
    }
    let message = bars.position_at(number(0.0), number(0.0)).unwrap_err().to_string();
    assert_eq!(message, "the cosine and sine of `theta` have an amplitude of 0, not 1");
}

/// The solver divides by the amplitude before it decides on the limit.
fn a_limit_is_where_the_angle_has_it<T: Real>() {
    let toggle = Toggle::<T>::default();
    for amplitude in amplitudes::<T>() {
        let pose = toggle.position_at(number(amplitude), number(0.0)).unwrap();
        assert_eq!((pose.C.x.value(), pose.C.y.value()), (5.0, 0.0));
        let velocity = toggle.velocity_at(number(amplitude), number(0.0), number(1.0));
        assert_eq!(velocity.map(|_| ()), Err(SolveError::Singular { group: "BC, DC" }));
        let beside = toggle.position_at(number(0.6 * amplitude), number(0.8 * amplitude));
        assert!(matches!(beside, Err(SolveError::OutOfReach { group: "BC, DC", .. })));
    }
}

in_both_widths! {
    bars_keep_their_lengths
    what_no_resolver_delivers_is_refused
    a_limit_is_where_the_angle_has_it
}

#[test]
fn lanes_divide_by_their_own_amplitudes() {
    let amplitudes = [1.0, 0.97, 0.0, 1.04];
    let [cos, sin] = [0.28, 0.96].map(|x| amplitudes.map(|amplitude| amplitude * x));
    let (found, mask) =
        KnownBars::<Lanes<f64, 4>>::default().solve_position_at(Lanes::new(cos), Lanes::new(sin));
    assert_eq!(mask.to_array(), [true, true, false, true]);
    let (x, y) = (found.C.x.to_array(), found.C.y.to_array());
    for lane in [0, 1, 3] {
        let single = KnownBars::new().position_at(cos[lane], sin[lane]).unwrap();
        let error = (x[lane] - single.C.x).abs() + (y[lane] - single.C.y).abs();
        assert!(error <= 8.0 * f64::EPSILON, "{error:e}");
    }
}

/// By cosine and sine an output changes as by θ = atan2(s, c), whose derivatives are −s/r² and c/r²,
/// 2cs/r⁴ and (s² − c²)/r⁴: along the radius not at all.
#[test]
fn derivatives_by_cosine_and_sine_are_those_of_the_direction() {
    let bars = KnownBars::new();
    for theta in [0.4_f64, 1.3, -2.1] {
        let motion = bars.motion(theta, 1.0, 0.0).unwrap();
        let (slope, curvature) = (motion.velocity.C.x, motion.acceleration.C.x);
        for amplitude in [0.95, 1.0, 1.03] {
            let (c, s) = (amplitude * theta.cos(), amplitude * theta.sin());
            let found = differentiate_twice([c, s], |[c, s]| {
                Ok(KnownBars::default().position_at(c, s)?.C.x)
            })
            .unwrap();
            let square = amplitude * amplitude;
            let of_angle = [-s / square, c / square];
            let fourth = square * square;
            let [cc, cs, ss] = [2.0 * c * s, s * s - c * c, -2.0 * c * s].map(|x| x / fourth);
            let second = [[cc, cs], [cs, ss]];
            for i in 0..2 {
                let error = (found.gradient[i] - slope * of_angle[i]).abs();
                assert!(error <= 64.0 * f64::EPSILON, "{error:e}");
                for j in 0..2 {
                    let expected = curvature * of_angle[i] * of_angle[j] + slope * second[i][j];
                    let error = (found.hessian[(i, j)] - expected).abs();
                    assert!(error <= 256.0 * f64::EPSILON, "{error:e}");
                }
            }
            assert!(Scalar::is_finite(found.value));
        }
    }
}
