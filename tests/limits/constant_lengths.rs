//! Bars of constant lengths: their formulas are as right as those of parameters but for a last place or two,
//! and as careful at limits.

use linkage_core::{Real, Record, Scalar, SolveError};
use linkage_tests::double_double::DoubleDouble;
use linkage_tests::in_both_widths;
use linkage_tests::mechanisms::twins::*;
use linkage_tests::random::Random;
use linkage_tests::widths::number;

/// A value moved by so many last places of its width.
fn moved<T: Real>(value: f64, ulps: i32) -> f64 {
    value + f64::from(ulps) * 2f64.powi(value.abs().log2().floor() as i32) * T::EPSILON
}

fn length_error<T: Real>(cos: T, sin: T) -> f64 {
    (cos.value().hypot(sin.value()) - 1.0).abs()
}

/// Within 6 ulp of both toggles: beyond them the pin is on the line and has no velocity.
fn toggles<T: Real>() {
    let (mut beyond, mut within) = (0, 0);
    for ulps in -6..=6 {
        for (reach, side) in [(1.625, 1.0), (0.375, -1.0)] {
            let d = moved::<T>(reach, ulps);
            let solver = ConstantBars::<T>::default();
            let q = [number(d), number(0.0)];
            let Ok(pose) = solver.position(q) else { continue };
            assert!(pose.into_array().into_iter().all(|x| x.value().is_finite()));
            let velocity = solver.velocity(q, [number(0.0), number(0.5)]);
            if (d - reach) * side >= 0.0 {
                beyond += 1;
                assert_eq!(pose.C.y.value(), 0.0, "{d:?}");
                let singular = SolveError::Singular { group: "BC, DC" };
                assert_eq!(velocity.map(|_| ()), Err(singular), "{d:?}");
            } else {
                within += 1;
                let velocity = velocity.expect("it is no limit");
                assert!(pose.C.y.value() > 0.0, "{d:?}");
                assert!(velocity.into_array().into_iter().all(|x| x.value().is_finite()));
            }
        }
    }
    assert!(beyond >= 4 && within >= 10, "{beyond} {within}");
    let apart = ConstantBars::<T>::default().position([number(1.75), number(0.0)]);
    assert_eq!(apart.map(|_| ()), Err(SolveError::OutOfReach { group: "BC, DC", by: 0.125 }));
}

/// Within 8 ulp of both toggles in any direction: what is beyond is on the line of the joints and has no
/// velocity, and what is within is as high as it is without rounding, or nearly. S counts as it is where it
/// is above 16 ε of its spread, and is wrong by 2.5 of these at most: S by a fifth, the height by a tenth.
fn toggles_in_any_direction<T: Real>() {
    let solver = ConstantBars::<T>::default();
    toggles_of(
        |q| solver.position(q).map(|pose| [pose.C.x, pose.C.y]),
        |q, rate| solver.velocity(q, rate).map(|_| ()),
    );
    // Whatever the power of two that all is made smaller by, nothing is rounded otherwise.
    let (solver, small, large) = (ConstantSmallBars::<T>::default(), 1.0 / 4096.0, 4096.0);
    let scaled = |q: [T; 2], by: f64| q.map(|q| number(q.value() * by));
    toggles_of(
        |q| solver.position(scaled(q, small)).map(|pose| scaled([pose.C.x, pose.C.y], large)),
        |q, rate| solver.velocity(scaled(q, small), scaled(rate, small)).map(|_| ()),
    );
}

fn toggles_of<T: Real>(
    position: impl Fn([T; 2]) -> Result<[T; 2], SolveError>,
    velocity: impl Fn([T; 2], [T; 2]) -> Result<(), SolveError>,
) {
    let mut random = Random::new(11);
    let (mut beyond, mut within) = (0, 0);
    for step in 0..4000 {
        let turn = random.anywhere(-3.2, 3.2);
        let (reach, side) = [(1.625, 1.0), (0.375, -1.0)][step % 2];
        let d = moved::<T>(reach, (step / 2 % 17) as i32 - 8);
        let q = [d * turn.cos(), d * turn.sin()].map(number::<T>);
        let [x, y] = q.map(|q| DoubleDouble::<false>::new(q.value()));
        let exact = |number: f64| DoubleDouble::<false>::new(number);
        let square = x * x + y * y;
        // 4 l₂² l₃² S
        let (inner, outer) = (square - exact(0.140_625), exact(2.640_625) - square);
        let product = (inner * outer).high / (4.0 * 0.625 * 0.625);
        let Ok(pin) = position(q) else {
            assert!(product < 0.0, "{q:?}");
            continue;
        };
        let [cx, cy] = pin.map(|c| exact(c.value()));
        let height = (x * cy - y * cx).high;
        let velocity = velocity(q, [number(0.5), number(0.25)]);
        if product <= 0.0 {
            beyond += 1;
            // Three roundings of a pin 0.625 away, times the distance.
            assert!(height.abs() <= 3.0 * T::EPSILON, "{side} {height:e} at {q:?}");
            let singular = SolveError::Singular { group: "BC, DC" };
            assert_eq!(velocity, Err(singular), "{q:?}");
        } else {
            within += 1;
            let wanted = 0.625 * product.sqrt();
            let off = (height - wanted).abs();
            assert!(off <= 0.11 * wanted + 3.0 * T::EPSILON, "{height:e} for {wanted:e} at {q:?}");
            assert!(velocity.is_ok(), "{q:?}");
        }
    }
    assert!(beyond > 1000 && within > 1500, "{beyond} {within}");
}

/// Bars that are not for the fourth power of their lengths: a picometre is answered like a metre.
fn tiny_bars<T: Real>() {
    let (tiny, bars) = (ConstantTinyBars::<T>::default(), ConstantBars::<T>::default());
    for step in 0..1200 {
        let (d, turn) = (0.4 + f64::from(step) / 1000.0, f64::from(step) / 7.0);
        let q = [d * turn.cos(), d * turn.sin()];
        let (tiny, bars) =
            (tiny.position(q.map(|q| number(q * 1e-11))), bars.position(q.map(number)));
        let (tiny, bars) = (tiny.expect("in reach"), bars.expect("in reach"));
        for (a, b) in [(tiny.BC, bars.BC), (tiny.DC, bars.DC)] {
            let off = (a.cos.value() - b.cos.value()).hypot(a.sin.value() - b.sin.value());
            // Some ten roundings of d and S, where the pin is as high as 1/20 of the shorter bar or more.
            assert!(off <= 200.0 * T::EPSILON, "{off:e} at {d}");
        }
    }
}

/// Joints that nearly meet, of any size: answered as with parameters.
fn joints_that_meet<T: Real>() {
    let (constant, tuned) = (ConstantEqualBars::<T>::default(), TunedEqualBars::<T>::default());
    let mut kinds = [0; 3];
    for exponent in -330..=2 {
        for turn in [0.0_f64, 0.7, 1.6] {
            let d = 10f64.powi(exponent);
            let q = [d * turn.cos(), d * turn.sin()].map(number::<T>);
            let found =
                constant.position(q).map(|p| assert!(length_error(p.BC.cos, p.BC.sin) < 1e-6));
            assert_eq!(found, tuned.position(q).map(|_| ()), "{q:?}");
            kinds[match found {
                Ok(()) => 0,
                Err(SolveError::Singular { .. }) => 1,
                Err(_) => 2,
            }] += 1;
        }
    }
    assert!(kinds.iter().all(|&count| count > 3), "{kinds:?}");
}

/// Rates of any size, up to where a toggle makes them a thousand times as large: what is called solved is
/// finite, and what somebody may mean is solved at once.
fn rates_of_any_size<T: Real + Scalar<Mask = bool>>() {
    let solver = ConstantRocker::<T>::default();
    let all_finite = |rows: &[T]| rows.iter().all(|row| row.value().is_finite());
    let mut random = Random::new(17);
    // Decimal digits of the largest number and of a rate solved at once: 2²⁰ rad/s or 51 471, or its square.
    let [largest, at_once] = if T::EPSILON < 1e-10 { [308.25, 6.02] } else { [38.53, 4.71] };
    let mut solved = 0;
    for pose in 0..4000 {
        let near = random.between(0.0, 6.0);
        let digits = if pose % 2 == 0 { [largest; 2] } else { [at_once, 2.0 * at_once] };
        let [rate, second] =
            digits.map(|digits| number::<T>(10f64.powf(random.between(0.0, digits))));
        let theta = number((1.0_f64 / 6.0).acos() - 10f64.powf(-near));
        let (motion, is_solved) = solver.solve_motion(theta, rate, -second);
        let finite = all_finite(&motion.velocity.rows()) && all_finite(&motion.acceleration.rows());
        assert!(finite || !is_solved, "{theta:?} {rate:?} {second:?}");
        let (velocity, is_moving) = solver.solve_velocity(theta, rate);
        assert!(all_finite(&velocity.rows()) || !is_moving, "{theta:?} {rate:?}");
        solved += u32::from(is_solved);
    }
    assert!((100..3000).contains(&solved), "{solved}");
    let [theta, rate, second] = [1.0, 5e3, 2.5e7].map(number::<T>);
    assert!(solver.solve_motion(theta, rate, second).1 && solver.solve_velocity(theta, rate).1);
}

/// Far from the limit and next to it bars keep their lengths, the short one of the ratio 1000 too.
fn lengths<T: Real>() {
    let mut random = Random::new(3);
    let mut solved = 0;
    for _ in 0..4000 {
        let turn = random.between(-3.0, 3.0);
        let ulps = random.between(-6.5, 6.5).round() as i32;
        let near = random.between(-1.0, 1.0) < 0.0;
        let reach = if random.between(-1.0, 1.0) < 0.0 { 1.001 } else { 0.999 };
        let d = if near { moved::<T>(reach, ulps) } else { random.between(0.9991, 1.0009) };
        let q = [d * turn.cos(), d * turn.sin()].map(number::<T>);
        let Ok(pose) = ConstantUnequalBars::<T>::default().position(q) else { continue };
        solved += 1;
        let [bc, dc] = [pose.BC, pose.DC].map(|link| length_error(link.cos, link.sin));
        // Some ten roundings on the way from d to a direction.
        assert!(bc.max(dc) <= 8.0 * T::EPSILON, "{bc:e} {dc:e} at {d:?}");
    }
    assert!(solved > 1000, "{solved}");
    // Behind a crank: d² = 10 − 6 cos θ is 2.997² and 3.003² at the toggles.
    for step in 0..2000 {
        let theta = number(1.40031 + 3e-6 * f64::from(step));
        let pose =
            ConstantShortBar::<T>::default().position(theta).expect("it is between the toggles");
        let [bc, dc] = [pose.BC, pose.DC].map(|link| length_error(link.cos, link.sin));
        assert!(bc.max(dc) <= 8.0 * T::EPSILON, "{bc:e} {dc:e} at {step}");
    }
}

/// Accelerations of bars whose lengths are parameters, one a thousand times as long as the other, in either
/// order. A joint's coordinate rounded once, by ε of itself, changes them by 9·10⁴ ε of the largest (second
/// differences in 60 digits at 60 such poses); four such roundings are allowed. With the weights of the
/// centripetal terms exchanged they are off by 8·10⁵ and 4·10⁶ ε.
#[test]
fn centripetal_terms_of_unequal_bars_keep_their_digits() {
    let mut random = Random::new(23);
    let mut worst = [0.0_f64; 2];
    for pose in 0..2000 {
        let mut solver = TunedUnequalBars::new();
        if pose % 2 == 1 {
            core::mem::swap(&mut solver.bc, &mut solver.dc);
        }
        let (d, turn) = (random.anywhere(0.9993, 1.0007), random.anywhere(-3.2, 3.2));
        let q = [d * turn.cos(), d * turn.sin()];
        // The line of the joints turns and grows, and the short bar turns a hundred times as fast.
        let (rate, second) = ([0.05 * q[0] - q[1], q[0] + 0.05 * q[1]], [0.3 * q[0], 0.2]);
        let found = solver.motion(q, rate, second).expect("it is between the toggles");
        let [q, rate, second] = [q, rate, second].map(|list| list.map(DoubleDouble::<false>::new));
        let (truth, _) = solver.lift::<DoubleDouble<false>>().solve_motion(q, rate, second);
        let (found, truth) = (found.acceleration.rows(), truth.acceleration.rows());
        let size = truth.iter().fold(0.0_f64, |size, number| size.max(number.high.abs()));
        for (found, truth) in found.into_iter().zip(truth) {
            let error = (DoubleDouble::new(found) - truth).high.abs() / size;
            worst[pose % 2] = worst[pose % 2].max(error / f64::EPSILON);
        }
    }
    assert!(worst.iter().all(|&worst| worst <= 3.6e5), "{worst:?} ε");
}

/// A crank through both toggles: right, or refused.
fn through_toggles<T: Real>() {
    let solver = ConstantRocker::<T>::default();
    // d² = 10 − 6 cos θ is 9 where the bars are stretched, 4 where they are folded.
    let stretched = (1.0_f64 / 6.0).acos();
    let mut solved = 0;
    for step in 0..4000 {
        let off = 10f64.powf(-f64::from(step) / 200.0);
        for theta in [stretched - off, stretched + off, off] {
            let theta = number::<T>(theta);
            let Ok(pose) = solver.position(theta) else { continue };
            solved += 1;
            let [bc, dc] = [pose.BC, pose.DC].map(|link| length_error(link.cos, link.sin));
            // 9 ε of S's spread, (l₂ + l₃)²/4l₂l₃ = 1.8, of a bar a fifth as long as the other.
            assert!(bc.max(dc) <= 48.0 * T::EPSILON, "{bc:e} {dc:e} at {theta:?}");
            if let Ok(motion) = solver.motion(theta, number(1.0), number(1.0)) {
                assert!(motion.into_array().into_iter().all(|x| x.value().is_finite()));
            }
        }
    }
    assert!(solved > 6000, "{solved}");
    assert!(solver.position(number(2.0)).is_err());
}

/// The largest difference of the two over a turn, in ε of each number's largest value.
fn largest<const N: usize>(
    mut one: impl FnMut(f64) -> [f64; N],
    mut other: impl FnMut(f64) -> [f64; N],
) -> f64 {
    let (mut sizes, mut off) = ([0.0_f64; N], [0.0_f64; N]);
    for theta in angles() {
        let (one, other) = (one(theta), other(theta));
        for k in 0..N {
            sizes[k] = sizes[k].max(other[k].abs());
            let error = (one[k] - other[k]).abs();
            off[k] = if error.is_nan() { f64::INFINITY } else { off[k].max(error) };
        }
    }
    (0..N).map(|k| off[k] / sizes[k] / f64::EPSILON).fold(0.0, f64::max)
}

/// A turn, and what is next to quarter turns, so few that the sum of twice the angle and a constant is
/// rounded to 4 ε.
fn angles() -> impl Iterator<Item = f64> {
    let turn = (0..2000).map(|step| f64::from(step) / 512.0);
    turn.chain(quarter_turns(2))
}

/// Within two places of a multiple of a quarter turn, where one of sine and cosine is nearly zero.
fn quarter_turns(most: i32) -> impl Iterator<Item = f64> {
    let near = |quarters: i32| {
        let at = f64::from(quarters) * core::f64::consts::FRAC_PI_2;
        (-2..=2).map(move |ulps| moved::<f64>(at, ulps))
    };
    (-most..=most).filter(|&quarters| quarters != 0).flat_map(near)
}

/// A sine or cosine that is nearly zero has all its places as well: 1.7 ulp of the kernel, and the error of
/// the quarter turn that the kernel subtracts.
#[test]
fn a_crank_next_to_a_quarter_turn_is_right_to_its_places() {
    let (solver, exact) = (ConstantRocker::new(), ConstantRocker::<DoubleDouble<false>>::default());
    let mut solved = 0;
    for theta in quarter_turns(128) {
        let Ok(pose) = solver.position(theta) else { continue };
        solved += 1;
        let (truth, _) = exact.solve_position(DoubleDouble::new(theta));
        for (found, truth) in [(pose.AB.cos, truth.AB.cos), (pose.AB.sin, truth.AB.sin)] {
            let error = (DoubleDouble::new(found) - truth).high.abs();
            let ulp = moved::<f64>(truth.high, 1) - truth.high;
            let quarters = (theta / core::f64::consts::FRAC_PI_2).abs().round();
            assert!(error <= 1.7 * ulp + 1.5e-33 * quarters, "{} ulp at {theta:e}", error / ulp);
        }
    }
    assert!(solved > 300, "{solved}");
}

/// Accelerations of the first loop are within 5 ε of the largest value; what a loop's pin is off by acts on
/// the next one's bars with 1/sin μ at each of three divisions, which is below 2 here. And other formulas
/// for the same give the same.
macro_rules! agrees {
    ($name:ident: $constant:ident $tuned:ident) => {
        #[test]
        fn $name() {
            let constant = |q| $constant::new().motion(q, 20.0, 50.0).unwrap().into_array();
            let tuned = |q| $tuned::new().motion(q, 20.0, 50.0).unwrap().into_array();
            let exact = |q: f64| {
                let [q, w, a] = [q, 20.0, 50.0].map(DoubleDouble::<false>::new);
                let (motion, _) = $constant::<DoubleDouble<false>>::default().solve_motion(q, w, a);
                motion.into_array().map(|number| number.high)
            };
            let (error, difference) = (largest(constant, exact), largest(constant, tuned));
            assert!(error <= 40.0 && difference <= 60.0, "{error:.1} {difference:.1}");
        }
    };
}

agrees! { behind_a_crank_and_between_links: ConstantWatt TunedWatt }
agrees! { behind_a_crank_on_the_level: ConstantStephenson TunedStephenson }
// Accelerations of a block that comes as near to the pivot as a third of its farthest distance: b² has
// three times the places of a sum of squares, of which the bar's acceleration takes 1/b and 1/b².
agrees! { a_block_on_a_crank: ConstantBlock TunedBlock }
agrees! { a_block_on_a_crank_about_the_pivot: ConstantInnerBlock TunedInnerBlock }

/// The slide is the length of what the direction is made of, whatever that is off by: five roundings. A b²
/// that is affine would be off by 50 ε where its parts are a hundred times as large.
#[test]
fn a_direction_next_to_its_pivot_has_its_length() {
    for theta in angles() {
        let pose = ConstantNearBlock::new().position(theta).unwrap();
        let error = length_error(pose.rod.cos, pose.rod.sin);
        assert!(error <= 4.0 * f64::EPSILON, "{:.1} ε at {theta}", error / f64::EPSILON);
    }
}

agrees! { behind_a_crank_longer_than_the_base: ConstantDragLink TunedDragLink }
agrees! { between_cranks_and_beside_one: ConstantFiveBar TunedFiveBar }

/// The pin comes to 1/16 m of the other pivot, where its own rounding, up to 1 ε, turns the line of the
/// joints by 16 ε and moves the foot of C by (1/2 + (l₃² − l₂²)/2d²) ε = 9 ε: 25 ε, and some more for
/// the formulas. An affine d² would be wrong by 3 ε of D² + a², and C by 200 ε.
#[test]
fn a_pin_near_the_other_pivot_keeps_its_digits() {
    let (constant, exact) = (ConstantClose::new(), TunedClose::<DoubleDouble<false>>::default());
    for step in -400..=400 {
        let theta = f64::from(step) / 8192.0;
        let found = constant.position(theta).expect("the bars are long enough").C;
        let (truth, _) = exact.solve_position(DoubleDouble::new(theta));
        for (found, truth) in [(found.x, truth.C.x), (found.y, truth.C.y)] {
            let error = (DoubleDouble::new(found) - truth).high.abs();
            assert!(error <= 40.0 * f64::EPSILON, "{} ε at {theta:e}", error / f64::EPSILON);
        }
    }
}

/// Forces take the bars and 1/J from here: those with parameters, but for accelerations of up to 60 ε.
#[test]
fn forces_are_those_with_parameters() {
    let constant = |q| ConstantDragLink::new().forces(q, 20.0, 50.0).unwrap().into_array();
    let tuned = |q| TunedDragLink::new().forces(q, 20.0, 50.0).unwrap().into_array();
    let difference = largest(constant, tuned);
    assert!(difference <= 100.0, "{difference:.1}");
}

/// Joints that inputs put anywhere are solved on the constant path, of constant lengths and of others.
fn driven_joints_are_solved_at_once<T: Real + Scalar<Mask = bool>>() {
    let [q, rate, second] = [[0.9, 0.3], [1.0, 0.5], [0.2, 0.3]].map(|list| list.map(number::<T>));
    let (constant, tuned) = (ConstantBars::<T>::default(), TunedBars::<T>::default());
    assert!(constant.solve_position(q).1 && tuned.solve_position(q).1);
    assert!(constant.solve_motion(q, rate, second).1 && tuned.solve_motion(q, rate, second).1);
    assert!(constant.solve_coefficients(q).1 && tuned.solve_coefficients(q).1);
}

#[test]
fn what_is_not_constant_is_solved_as_well() {
    let solver = TunedCranks::new();
    let pose = solver.position([0.3, 1.2]).unwrap();
    assert!(length_error(pose.BC.cos, pose.BC.sin) <= 4.0 * f64::EPSILON);
    // Beyond the kernel's range the slow path reduces the angle.
    let far = solver.position([0.3 + 1e7, 1.2]).unwrap();
    let near = solver.position([(0.3 + 1e7) % core::f64::consts::TAU, 1.2]).unwrap();
    assert!((far.C.x - near.C.x).abs() <= 1e-8);
    let refused = ConstantWatt::new().position(f64::NAN).map(|_| ());
    assert_eq!(refused, Err(SolveError::NotFinite { name: "theta" }));
    assert!(ConstantWatt::new().position(1e7).is_ok());
}

in_both_widths! { toggles toggles_in_any_direction tiny_bars driven_joints_are_solved_at_once joints_that_meet lengths rates_of_any_size
    through_toggles
}
