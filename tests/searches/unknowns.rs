//! Unknowns: what an equation fixes, against closed forms, tables of many digits, the same solver on
//! dual numbers, and everything that can go wrong while it runs.

use std::f64::consts::{FRAC_PI_2, PI};

use linkage_core::find::Search;
use linkage_core::{Mechanism, Real, SolveError, Status, differentiate_twice};
use linkage_tests::mechanisms::set_points::SliderCrank;
use linkage_tests::mechanisms::unknowns::*;
use linkage_tests::random::Random;

use super::set_points::{Width, ends_of_stroke, ram_over_data};

/// The height of the wheel's centre, then θ, dθ/dz, d²θ/dz², the camber, its derivative, and x of the
/// wheel's centre: the position in closed form of θ, its root and Taylor coefficients in 40 digits
/// (mpmath), of which 25, 20 and 15 are kept.
#[allow(clippy::excessive_precision, reason = "digits as they were computed")]
const WISHBONE: [[f64; 7]; 5] = [
    [
        0.20,
        -0.3529359735550350415651539,
        2.8841150201839472299,
        -3.97277826136112,
        0.2584214057486012229598361,
        -1.0391170518059370398,
        0.3839186447980194389949961,
    ],
    [
        0.25,
        -0.2128467163038969656873629,
        2.7343977755782897514,
        -2.16606422786079,
        0.2222020146585229594776199,
        -0.48700817967957859256,
        0.4035042484554281924172945,
    ],
    [
        0.33,
        0.001102807493508521072099147,
        2.6382221379011620936,
        -0.355910107215406,
        0.2015139285825927208115228,
        -0.07259078082047487749,
        0.414767307539651890349048,
    ],
    [
        0.40,
        0.185992529055986385307098,
        2.6598869407438734399,
        0.984332202123181,
        0.2058253661556756940302963,
        0.19513529047948179981,
        0.4076547509105622240161933,
    ],
    [
        0.47,
        0.3758329249116730781496877,
        2.7834546502611572212,
        2.6555252835078,
        0.230107939081868715216858,
        0.51896826236846970428,
        0.3845254368650926574104296,
    ],
];

#[track_caller]
fn close(found: f64, expected: f64, tolerance: f64) {
    assert!((found - expected).abs() <= tolerance, "{found} {expected}");
}

#[test]
fn a_wishbone_by_its_wheel_agrees_with_forty_digits() {
    let (wide, narrow) = (Wishbone::new(), Wishbone::<f32>::default());
    for [z, theta, first, second, camber, camber_first, x] in WISHBONE {
        let m = wide.motion(z, 1.0, 0.0).expect("within the travel");
        close(m.position.theta, theta, 1e-14);
        close(m.position.kingpin.angle() - FRAC_PI_2, camber, 1e-14);
        close(m.position.W.x, x, 1e-14);
        close(m.position.W.y, z, 1e-15);
        // A rate is right to some ε times what the position's last places do to it.
        close(m.velocity.theta, first, 1e-14 * first.abs().max(1.0));
        close(m.velocity.kingpin.omega, camber_first, 1e-14);
        close(m.velocity.W.y, 1.0, 1e-14);
        close(m.acceleration.theta, second, 1e-13);
        close(m.acceleration.W.y, 0.0, 1e-13);
        let single = narrow.position(z as f32).expect("within the travel");
        close(single.theta.into(), theta, 4.0 * f64::from(f32::EPSILON));
    }
}

#[test]
fn derivatives_of_a_root_agree_with_its_rates_to_second_order() {
    let car = Wishbone::new();
    for [z, ..] in WISHBONE {
        let m = car.motion(z, 1.0, 0.0).expect("within the travel");
        let coefficients = car.coefficients(z).expect("within the travel");
        let jacobian = car.jacobian(z).expect("within the travel");
        for (row, by_formula) in coefficients.iter().enumerate() {
            close(jacobian[row], by_formula[0], 1e-13);
        }
        let twice = differentiate_twice([z], |[z]| Ok(car.lift().position(z)?.theta));
        let twice = twice.expect("within the travel");
        close(twice.gradient[0], m.velocity.theta, 1e-13);
        close(twice.hessian[(0, 0)], m.acceleration.theta, 1e-11);
    }
    // By the length of the upper arm, against a difference of positions four places coarser than
    // either: the step's square, 1e-10, against ε over the step.
    let h = 1e-5;
    let at = |by: f64| {
        let varied = Wishbone { upper_length: 0.28 + by };
        varied.position(0.4).expect("within the travel").theta
    };
    let sensitivity = car.sensitivity(0.4).expect("within the travel");
    close(sensitivity[0], (at(h) - at(-h)) / (2.0 * h), 1e-8);
}

/// Targets from the middle of the stroke to 1e-15 of its ends, the ends of the search beyond the
/// dead points, cold and warm.
fn set_points<T: Width>(last: i32) {
    let data = [0.08, 0.25, 0.03];
    let [(a, far), (b, near)] = ends_of_stroke(data);
    let mut random = Random::new(7);
    let (mut worst, press) = (0.0_f64, Press::<T>::default());
    for exponent in 0..=last {
        for _ in 0..100 {
            let part = random.anywhere(0.2, 1.0) * 10_f64.powi(-exponent);
            let away = part * (far - near) / 2.0;
            let wanted = if random.anywhere(0.0, 1.0) < 0.5 { far - away } else { near + away };
            let seed = T::of(random.anywhere(a, b));
            let warm = Press { seed, ..press }.position(T::of(wanted)).expect("in the stroke");
            let cold = press.position(T::of(wanted)).expect("in the stroke");
            for at in [warm, cold] {
                let data = [data[0], data[1], data[2], wanted].map(T::of);
                worst = worst.max(ram_over_data(data, at.theta));
                let theta: f64 = at.theta.into();
                // Between the dead points, as far as their own place is known.
                let room = 4.0 * (2.0 * T::HALF_UNIT).sqrt();
                assert!((a - room..=b + room).contains(&theta), "{theta}");
            }
        }
    }
    println!("error over the data's {worst}");
    assert!(worst <= 1.0, "{worst}");
}

#[test]
fn set_points_of_a_press_are_as_right_as_its_data() {
    set_points::<f64>(15);
    set_points::<f32>(7);
}

#[test]
fn a_press_moves_as_it_is_told() {
    let press = Press::new();
    let [(_, far), (_, near)] = ends_of_stroke([0.08, 0.25, 0.03]);
    for part in [0.05, 0.3, 0.5, 0.9, 0.99] {
        let x = near + part * (far - near);
        let m = press.motion(x, -0.7, 3.0).expect("in the stroke");
        close(m.position.ram.slide, x, 1e-15);
        close(m.velocity.ram.slide, -0.7, 1e-14);
        close(m.acceleration.ram.slide, 3.0, 1e-12);
        // The drive itself, by the solver that is driven there.
        let driven = SliderCrank::new();
        let (theta, omega) = (m.position.theta, m.velocity.theta);
        let again = driven.motion(theta, omega, m.acceleration.theta).expect("it turns fully");
        close(again.velocity.ram.slide, -0.7, 1e-14);
        close(again.acceleration.ram.slide, 3.0, 1e-12);
        // The ends and the seed change nothing, the dimensions what the ram's own slope makes of
        // them: s(θ(p), p) = x.
        let found = press.sensitivity(x).expect("in the stroke");
        let direct = driven.sensitivity(theta).expect("it turns fully");
        let slope = driven.velocity(theta, 1.0).expect("it turns fully").ram.slide;
        for (column, name) in Press::PARAMS.iter().enumerate() {
            let expected = match SliderCrank::PARAMS.iter().position(|other| other == name) {
                Some(of) => -direct[of] / slope,
                None => 0.0,
            };
            close(found[(0, column)], expected, 1e-12 * expected.abs().max(1.0));
        }
    }
}

#[test]
fn what_has_no_root_says_what_is_missing() {
    let press = Press::new();
    let [(_, far), (_, near)] = ends_of_stroke([0.08, 0.25, 0.03]);
    for (x, missing) in [(far + 0.01, 0.01), (near - 0.02, 0.02), (far + 1e-9, 1e-9)] {
        match press.position(x) {
            Err(SolveError::NoSolution { unknown: "theta", by, unit: "m", .. }) => {
                close(by, missing, 1e-15)
            }
            other => panic!("{other:?}"),
        }
    }
    let error = press.velocity(0.5, 1.0).unwrap_err().to_string();
    assert!(error.starts_with("theta: no solution between its ends"), "{error}");
    // Ends in the wrong order, and numbers that are none.
    let reversed = Press { from: 2.0, to: 1.0, ..press }.position(0.25);
    let invalid = SolveError::Invalid { group: "theta", name: "width of between" };
    assert_eq!(reversed, Err(invalid));
    for (varied, name) in [
        (Press { from: f64::NAN, ..press }, "from"),
        (Press { to: f64::INFINITY, ..press }, "to"),
        (Press { r: f64::NAN, ..press }, "r"),
    ] {
        assert_eq!(varied.position(0.25), Err(SolveError::NotFinite { name }));
    }
    assert_eq!(press.position(f64::NAN), Err(SolveError::NotFinite { name: "x" }));
    let rate = press.motion(0.25, f64::INFINITY, 0.0);
    assert_eq!(rate, Err(SolveError::NotFinite { name: "x_rate" }));
    // A seed that is none costs its use.
    let unseeded = Press { seed: f64::NAN, ..press }.position(0.25).expect("in the stroke");
    close(unseeded.theta, press.position(0.25).expect("in the stroke").theta, 1e-15);
}

#[test]
fn a_bracket_that_cannot_be_assembled_names_the_group() {
    let short = Short::new().position(1.0);
    assert!(
        matches!(short, Err(SolveError::OutOfReach { group: "BC, DC", by }) if by > 0.0),
        "{short:?}"
    );
    // From 5° to 80° the rocker's pin goes down behind its highest point.
    let long = Short { rod: 2.5 };
    assert!(matches!(long.position(1.8), Err(SolveError::NoSolution { .. })));
    assert!(long.position(1.99).expect("on its way up").theta < 0.5);
}

/// A target within four last places of an end gives that end, where there are no rates.
#[test]
fn dead_points_have_a_pose_and_no_rates() {
    let ram = InLine::new();
    let singular = SolveError::Singular { group: "theta" };
    for (end, theta) in [(0.33_f64, 0.0), (0.17, PI)] {
        let outwards = if theta == 0.0 { f64::next_up } else { f64::next_down };
        let beyond = [end, outwards(end), outwards(outwards(end))];
        for x in beyond {
            let at = ram.position(x).expect("at the end");
            close(at.theta, theta, 1e-7);
            close(at.C.x, x, 3e-16);
            if x == end {
                // Rounded, this end may be a last place inside, where the drive races.
                let rate = ram.velocity(x, 1.0).map(|v| v.theta);
                assert!(rate.map_or_else(|e| e == singular, |rate| rate.abs() > 1e7), "{rate:?}");
                continue;
            }
            assert_eq!(ram.velocity(x, 1.0), Err(singular), "{x}");
            assert_eq!(ram.motion(x, 0.0, 0.0), Err(singular));
            assert_eq!(ram.coefficients(x), Err(singular));
            assert_eq!(ram.jacobian(x), Err(singular));
        }
        let far = end + (end - 0.25) * 1e-9;
        assert!(matches!(ram.position(far), Err(SolveError::NoSolution { .. })), "{far}");
        // Next to it there are.
        let inside = end - (end - 0.25) * 1e-9;
        let rate = ram.velocity(inside, 1.0).expect("inside the stroke").theta;
        let by_formula = SliderCrank { r: 0.08, l: 0.25, e: 0.0 };
        let at = ram.position(inside).expect("inside the stroke").theta;
        let slope = by_formula.velocity(at, 1.0).expect("it turns fully").ram.slide;
        close(rate * slope, 1.0, 1e-13);
    }
}

#[test]
fn a_jump_of_an_angle_is_no_root() {
    let jump = Jump::new();
    let refused = jump.position(0.0);
    assert!(matches!(refused, Err(SolveError::NoSolution { unit: "rad", .. })), "{refused:?}");
    let text = refused.map(|_| ()).unwrap_err().to_string();
    // From 180° to −180°, at either of which one side of the jump is left.
    assert_eq!(text, "theta: no solution between its ends, 180° is missing");
    // Rising there is one, at the angle itself; falling there is none.
    assert!(matches!(jump.position(PI), Err(SolveError::NoSolution { unit: "rad", .. })));
    // An angle on either side; what is squared is an area.
    let [left, right] = [Ratio::new().position(9.0), Ratio::new().position(-9.0)];
    assert!(matches!(left, Err(SolveError::NoSolution { unknown: "theta", unit: "rad", .. })));
    assert!(matches!(right, Err(SolveError::NoSolution { unknown: "theta", unit: "rad", .. })));
    let area = Ratio::new().position(0.1).map(|_| ()).unwrap_err().to_string();
    assert_eq!(area, "s: no solution between its ends, 0.990 m² is missing");
}

#[test]
fn a_machine_of_class_three_closes_at_every_angle_of_its_drive() {
    let triad = Triad::new();
    let turns = (0..200).map(|step| 0.04 * f64::from(step));
    let mut last: Option<f64> = None;
    for turn in turns {
        let m = triad.motion(turn, 1.0, 0.3).expect("it turns fully");
        close(m.position.rest, 1.1, 4.0 * f64::EPSILON);
        close(m.velocity.rest, 0.0, 1e-14);
        close(m.acceleration.rest, 0.0, 1e-13);
        // The plate's third corner follows without a jump.
        if let Some(before) = last {
            assert!((m.position.phi - before).abs() < 0.02, "{turn}");
        }
        last = Some(m.position.phi);
        let jacobian = triad.jacobian(turn).expect("it turns fully");
        close(jacobian[0], m.velocity.phi, 1e-13);
    }
}

#[test]
fn one_unknown_stands_on_another() {
    let machine = Pair::new();
    for (x, h) in [(0.2, 0.3), (0.25, 0.1), (0.3, 0.55)] {
        let m = machine.motion([x, h], [0.4, -0.2], [1.0, 2.0]).expect("within reach");
        close(m.position.C.x, x, 1e-15);
        close(m.position.F.y, h, 4e-16);
        close(m.velocity.C.x, 0.4, 1e-14);
        close(m.velocity.F.y, -0.2, 1e-14);
        close(m.acceleration.C.x, 1.0, 1e-12);
        close(m.acceleration.F.y, 2.0, 1e-12);
        let (formula, dual) = (machine.coefficients([x, h]), machine.jacobian([x, h]));
        let (formula, dual) = (formula.expect("within reach"), dual.expect("within reach"));
        for (row, columns) in formula.iter().enumerate() {
            for (column, value) in columns.iter().enumerate() {
                close(dual[(row, column)], *value, 1e-12 * value.abs().max(1.0));
            }
        }
    }
    let none = machine.position([0.25, 2.0]);
    assert!(matches!(none, Err(SolveError::NoSolution { unknown: "phi", .. })), "{none:?}");
    let none = machine.position([0.4, 0.3]);
    assert!(matches!(none, Err(SolveError::NoSolution { unknown: "theta", .. })), "{none:?}");
}

#[test]
fn an_angle_may_be_given_by_its_cosine_and_sine() {
    let generator = Generator::new();
    for psi in [-1.85, -2.0, -2.1, -2.15] {
        let one = generator.motion(psi, 0.5, 0.2).expect("within the swing");
        close(one.position.DC.angle(), psi, 1e-15);
        close(one.velocity.DC.omega, 0.5, 1e-14);
        close(one.acceleration.DC.alpha, 0.2, 1e-12);
        let (sin, cos) = f64::sin_cos(psi);
        for amplitude in [1.0, 1.07] {
            let given = generator.motion_at(amplitude * cos, amplitude * sin, 0.5, 0.2);
            let given = given.expect("within the swing");
            close(given.position.theta, one.position.theta, 1e-14);
            close(given.acceleration.theta, one.acceleration.theta, 1e-11);
        }
    }
}

/// A sweep searches pose by pose; an instruction set that fuses may round otherwise.
#[test]
fn a_sweep_is_the_single_call_at_every_pose() {
    let press = Press::new();
    let x: Vec<f64> = (0..100).map(|step| 0.16 + 0.002 * f64::from(step)).collect();
    let mut status = vec![Status::default(); x.len()];
    let (mut theta, mut slide) = (vec![0.0; x.len()], vec![0.0; x.len()]);
    let out = PressVelocity {
        theta: &mut theta[..],
        ram: linkage_core::Slide { slide: &mut slide[..] },
        AB: linkage_core::AngularVelocity { omega: &mut [][..] },
    };
    press.sweep_velocity(&x, 2.0, out, &mut status, ()).expect("slices of one length");
    let mut refused = 0;
    for (pose, &x) in x.iter().enumerate() {
        match press.velocity(x, 2.0) {
            Ok(single) => {
                assert_eq!((status[pose], theta[pose]), (Status::Solved, single.theta));
            }
            Err(error) => {
                refused += 1;
                assert!(theta[pose].is_nan() && slide[pose].is_nan());
                assert_eq!(status[pose], Status::from(error));
            }
        }
    }
    assert!((10..60).contains(&refused), "{refused}");
}

/// The cost states what the finder promises.
#[test]
fn the_cost_states_the_bound_of_the_search() {
    let cost = Pair::COST;
    let names: Vec<_> = cost.searches.iter().map(|search| search.unknown).collect();
    assert_eq!(names, ["theta", "phi"]);
    for search in cost.searches {
        assert_eq!(search.evaluations, Search::<f64>::MOST);
        assert_eq!(search.evaluations_f32, Search::<f32>::MOST);
    }
    // A sine and a cosine, the rod's root and its inverse; the slope shares them.
    let press = Press::COST.searches[0].evaluation;
    assert_eq!((press.sines, press.roots, press.divisions), (1, 1, 1));
    assert!(press.total() < 30, "{press}");
    assert!(cost.to_string().contains("theta: up to 61"), "{cost}");
    // Whoever serves all mechanisms serves these.
    fn rows<M: Mechanism<Scalar = f64>>(mechanism: &M, value: f64) -> Vec<f64> {
        let rows = mechanism.position(M::inputs(|_| value)).expect("there is a pose");
        rows.as_ref().to_vec()
    }
    let theta = Press::new().position(0.25).expect("in the stroke").theta;
    assert_eq!(rows(&Press::new(), 0.25)[0], theta);
    assert_eq!(theta.value(), theta);
}
