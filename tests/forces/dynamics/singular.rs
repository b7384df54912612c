//! Several inputs where the mass matrix is singular or next to it: refused, or right to the digits that
//! are left.

use std::f64::consts::PI;

use linkage_core::{Float, Real, Series, SolveError, Status, differentiate};
use linkage_tests::in_both_widths;
use linkage_tests::mechanisms::singular_arms::{
    CartArm, CartArmInput, ElbowArm, LightWrist, ThreeAxes,
};
use linkage_tests::widths::{list, number};
use num_dual::DualSVec;

/// A thousand angles all around, none of them a round one.
fn around() -> impl Iterator<Item = f64> {
    (0..1000).map(|step| 0.0492 + 0.006_283 * f64::from(step))
}

/// Elbows that are stretched, folded, and bent by less than rounding can tell.
const STRAIGHT: [f64; 3] = [0.0, PI, 1e-9];

fn singular(group: &'static str) -> SolveError {
    SolveError::Singular { group }
}

/// The stretched arm is known by its last pivot, the folded one by its first: that axis moves no mass.
fn stretched_or_folded<T: Real>() {
    let (arm, cart, axes) =
        (ElbowArm::<T>::default(), CartArm::<T>::default(), ThreeAxes::<T>::default());
    let mut answers = 0;
    for a in around() {
        for b in STRAIGHT {
            let (elbow, bent) = (list::<T, 2>([a, b]), list::<T, 2>([1.0, 2.0]));
            let found = arm.forward_dynamics(elbow, list([0.3, -0.4]), bent).map(|_| ());
            let input = if b == PI { "a" } else { "b" };
            answers += usize::from(found != Err(singular(input)));
            let state = [elbow[0], elbow[1], number(0.0), number(0.0)];
            answers += usize::from(arm.state_rates(state, bent).is_ok());
            let (_, usable) = arm.solve_forward_dynamics(elbow, list([0.0; 2]), bent);
            answers += usize::from(usable);

            let driven = list::<T, 3>([1.0, 2.0, 3.0]);
            let found = cart.forward_dynamics(list([0.2, a / 6.283e-3, b]), list([0.0; 3]), driven);
            answers += usize::from(!matches!(found, Err(SolveError::Singular { .. })));
            let found = axes.forward_dynamics(list([a, b, 0.8]), list([0.5, 0.0, 0.0]), driven);
            answers += usize::from(!matches!(found, Err(SolveError::Singular { .. })));
        }
    }
    assert_eq!(answers, 0);
}

/// In a sweep, lanes and single calls in turn decide.
fn sweeps_refuse_the_same<T: Float>() {
    let (arm, cart) = (ElbowArm::<T>::default(), CartArm::<T>::default());
    let first: Vec<T> = around().map(number).collect();
    let constant = |value| Series::Constant(number::<T>(value));
    for b in STRAIGHT {
        let [mut da, mut db] =
            [vec![number::<T>(0.0); first.len()], vec![number(0.0); first.len()]];
        let mut status = vec![Status::Solved; first.len()];
        let (inputs, rates) = ([Series::Each(&first), constant(b)], [constant(0.0); 2]);
        let push = [constant(1.0), constant(2.0)];
        arm.sweep_forward_dynamics(inputs, rates, push, [&mut da, &mut db], &mut status, ())
            .unwrap();
        assert!(status.iter().all(|status| *status == Status::Singular));
        assert!(da.iter().chain(&db).all(|number| number.value().is_nan()));
        let inputs =
            CartArmInput { slide: Series::Each(&first), a: constant(90.0), b: constant(b) };
        let (rates, push) = ([constant(0.0); 3], [constant(1.0); 3]);
        status.fill(Status::Solved);
        cart.sweep_forward_dynamics(
            inputs,
            rates,
            push,
            [&mut da, &mut [], &mut db],
            &mut status,
            (),
        )
        .unwrap();
        assert!(status.iter().all(|status| *status == Status::Singular));
    }
}

/// The real part decides.
#[test]
fn derivatives_are_refused_the_same() {
    let of_dual = |b: f64| {
        differentiate([0.7, b], |q: [DualSVec<f64, 2>; 2]| {
            let still = [DualSVec::from_re(0.0); 2];
            let push = [1.0, 2.0].map(DualSVec::from_re);
            ElbowArm::default().forward_dynamics(q, still, push)
        })
    };
    for (b, input) in STRAIGHT.into_iter().zip(["b", "a", "b"]) {
        assert_eq!(of_dual(b).unwrap_err(), singular(input));
    }
    // τ stays, M⁻¹ goes as 1/sin² b: the slope of the largest acceleration is −2 cot b of it.
    for b in [1e-3, 0.01] {
        let slope = of_dual(b).unwrap()[(1, 1)];
        let second = ElbowArm::new().forward_dynamics([0.7, b], [0.0; 2], [1.0, 2.0]).unwrap()[1];
        let expected = -2.0 * second / b;
        // The rest of M⁻¹ is smaller by b.
        assert!((slope - expected).abs() < 10.0 * b * expected.abs(), "{slope} {expected}");
    }
}

/// The arm without matrices. With F at the mass and n₁, n₂ across both bars, l n₁·F = τ₁ − τ₂ and
/// l n₂·F = τ₂; u₁ and u₂ are sums of the two over sin b, and so are the accelerations.
fn by_hand([b, mass, length]: [f64; 3], [first, second]: [f64; 2], [t1, t2]: [f64; 2]) -> [f64; 2] {
    let (sin, cos) = b.sin_cos();
    let (across_first, across_second) = ((t1 - t2) / length, t2 / length);
    let turning = second + first;
    let along_second = (across_first - cos * across_second) / (mass * sin);
    let along_first = (cos * across_first - across_second) / (mass * sin);
    let [slow, fast] = [first, turning].map(|rate| length * rate * rate);
    let of_first = (along_second + slow * cos + fast) / (length * sin);
    let of_second = -(along_first + slow + fast * cos) / (length * sin);
    [of_first, of_second - of_first]
}

/// M has an error of 50 u = 25 ε, by `equations::forces::dynamics` of the compiler, and the force one of as
/// many of its own size. M⁻¹ enlarges both by at most M's greatest over its least eigenvalue: with m l² = 1
/// the sum of both is 5 and their product sin² b, so that is 25/b² for a small b. In all 1250 ε/b² of the
/// largest acceleration at the very most; some 10 ε/b² are found, as roundings are not all of one sign.
fn next_to_straight<T: Real>() {
    let bends = if T::EPSILON < 1e-10 { [1e-6, 1e-3, 0.01] } else { [0.01, 0.02, 0.1] };
    let arm = ElbowArm::<T>::default();
    let mut worst = 0.0_f64;
    for bend in bends {
        for a in around() {
            let (rates, drives) = ([0.3, -0.4], [1.5, 0.25]);
            let b = number::<T>(bend).value();
            let found = arm.forward_dynamics(list([a, bend]), list(rates), list(drives));
            let found = found.unwrap_or_else(|error| panic!("{a} {b}: {error}")).map(|x| x.value());
            let [wrist, length] = [1.0, 0.7];
            let rates = rates.map(|rate| number::<T>(rate).value());
            let truth = by_hand([b, wrist, length], rates, drives);
            let size = truth[0].abs().max(truth[1].abs());
            for (found, truth) in found.iter().zip(truth) {
                worst = worst.max((found - truth).abs() / size * (b * b) / T::EPSILON);
            }
        }
    }
    assert!(worst < 1250.0, "{worst}");
}

/// The least bend that is answered: the pivot is b²/4 of m l² and its spread, of 56 u by the count in
/// `equations::forces::dynamics`, 2 · 2 (1 + 2/4) times m l². With 16 ε of it the two are equal at
/// b = √(384 ε), 2.9e-7 and 6.8e-3; the rounding of the pivot itself is a tenth of its threshold at most.
fn least_bend<T: Real>() {
    let (arm, least) = (ElbowArm::<T>::default(), (384.0 * T::EPSILON).sqrt());
    for a in around() {
        let answers = |bend| {
            let found = arm.forward_dynamics(list([a, bend]), list([0.3, -0.4]), list([1.5, 0.25]));
            found.is_ok()
        };
        assert!(answers(1.1 * least) && !answers(0.9 * least), "{a}");
    }
}

/// A wrist of a billionth of the other mass has a pivot of a billionth, and so it should.
fn light_wrists<T: Real>() {
    for exponent in -12..=3 {
        let wrist = 10f64.powi(exponent);
        let arm = LightWrist { wrist: number::<T>(wrist) };
        for a in around().step_by(50) {
            let found = arm.forward_dynamics(list([a, 1.1]), list([0.0; 2]), list([0.0, wrist]));
            let found = found.unwrap().map(|x| x.value());
            // l²[1 + 2w(1 + cos b), w(1 + cos b); w(1 + cos b), w] q̈ = [0, w]
            let (cos, square) = (number::<T>(1.1).value().cos(), 0.49);
            let w = number::<T>(wrist).value();
            let (both, sum) = (1.0 + 2.0 * w * (1.0 + cos), 1.0 + cos);
            let determinant = both - w * sum * sum;
            let truth = [-w * sum / determinant / square, both / determinant / square];
            for (found, truth) in found.iter().zip(truth) {
                // The determinant is 0.27 at least of what it is a difference of, and that known to
                // 25 ε twice, which makes 185 ε; the rest is for L and the quotients.
                assert!(
                    (found - truth).abs() < 300.0 * T::EPSILON * truth.abs(),
                    "{wrist} {found} {truth}"
                );
            }
        }
    }
}

/// Neither the unit of an input, here thousandths of a turn, nor that of all masses changes what is
/// refused, and a light hand is a small pivot of a small row.
#[test]
fn units_do_not_matter() {
    for (hand, cart_mass) in
        [(1e-150, 2e-150), (1e-9, 2.0), (1.0, 2.0), (1.0, 1e-3), (1e150, 2e150)]
    {
        let cart = CartArm { hand, cart_mass };
        for b in [1e-3, 0.4, PI - 1e-3] {
            let found = cart.forward_dynamics([0.2, 130.0, b], [0.0; 3], [0.0, 1e-3 * hand, hand]);
            assert!(found.is_ok(), "{hand} {b} {found:?}");
        }
        for b in STRAIGHT {
            let found = cart.forward_dynamics([0.2, 130.0, b], [0.0; 3], [0.0, 0.0, hand]);
            assert_eq!(found, Err(singular("b")), "{hand} {b}");
        }
    }
}

in_both_widths! { stretched_or_folded sweeps_refuse_the_same least_bend next_to_straight light_wrists }
