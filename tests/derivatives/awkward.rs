//! Derivatives where they are easily lost: vertical links, half a turn, zero offsets and inputs,
//! poses assembled at the limit, and the way there.

use core::f64::consts::{FRAC_PI_2, PI};

use linkage_core::num_dual::{Dual, Dual2, Dual2SVec, Dual3, DualSVec, HyperDual};
use linkage_core::{Real, Sense, Side, SolveError, differentiate, differentiate_twice, mechanism};
use linkage_tests::mechanisms::driven_groups::*;
use linkage_tests::random::cases;

/// A few roundings of numbers of the size of the expected one or of 1.
#[track_caller]
fn assert_close(found: f64, expected: f64) {
    let allowed = 8.0 * f64::EPSILON * expected.abs().max(1.0);
    assert!((found - expected).abs() <= allowed, "{found} instead of {expected}");
}

/// (x, y) turned by `quarters` of a turn, exactly.
fn turned([x, y]: [f64; 2], quarters: usize) -> [f64; 2] {
    [[x, y], [-y, x], [-x, -y], [y, -x]][quarters % 4]
}

/// The triangle 3, 4, 5 with a bar along +y, −x, −y and +x in turn. With C = B + r₁ = D + r₂ and
/// r₁ ⟂ BD the constraints r₁·C' = l₁ l₁', r₂·C' = l₂ l₂' give the slopes as fractions.
#[test]
fn bars_along_the_axes_have_their_sensitivities() {
    for quarters in 0..4 {
        let [d, by_l1, by_l2] =
            [[3.0, 0.0], [4.0 / 3.0, 1.0], [-5.0 / 3.0, 0.0]].map(|v| turned(v, quarters));
        let bars = DrivenRrr { l1: 4.0, l2: 5.0, elbow: Side::Left };
        let q = [0.0, 0.0, d[0], d[1]];
        let along = [FRAC_PI_2, PI, -FRAC_PI_2, 0.0][quarters];
        assert_eq!(bars.position(q).unwrap().BC.angle(), along);
        assert_eq!(DrivenRrr::OUTPUTS, ["C.x", "C.y", "BC.angle", "DC.angle"]);
        let expected = [
            [by_l1[0], by_l2[0]],
            [by_l1[1], by_l2[1]],
            [-1.0 / 3.0, 5.0 / 12.0],
            [-1.0 / 3.0, 4.0 / 15.0],
        ];
        let found = bars.sensitivity(q).unwrap();
        let narrow = DrivenRrr::<f32> { l1: 4.0, l2: 5.0, elbow: Side::Left };
        let narrow = narrow.sensitivity(q.map(|x| x as f32)).unwrap();
        for (row, slopes) in expected.iter().enumerate() {
            for (column, slope) in slopes.iter().enumerate() {
                assert_close(found[(row, column)], *slope);
                let error = f64::from(narrow[(row, column)]) - slope;
                assert!(error.abs() <= 16.0 * f64::from(f32::EPSILON));
            }
        }
    }
}

/// The pin on the rail, the offset zero: the bar lies along the rail, which runs along the axes.
#[test]
fn a_bar_along_its_rail_turns_with_the_offset_and_does_not_slide() {
    assert_eq!(DrivenRrp::PARAMS, ["l", "e"]);
    assert_eq!(DrivenRrp::OUTPUTS, ["C.x", "C.y", "BC.angle", "block.angle", "block.slide"]);
    for (side, sign) in [(Sense::Ahead, 1.0), (Sense::Behind, -1.0)] {
        let press = DrivenRrp { l: 5.0, e: 0.0, side };
        let q = [2.0, 0.0, 0.0, 0.0, 0.0];
        assert_eq!(press.position(q).unwrap().BC.angle(), if sign > 0.0 { 0.0 } else { PI });
        let slopes = press.sensitivity(q).unwrap();
        let expected = [[sign, 0.0], [0.0, 1.0], [0.0, sign / 5.0], [0.0, 0.0], [sign, 0.0]];
        for (row, expected) in expected.iter().enumerate() {
            assert_eq!([slopes[(row, 0)], slopes[(row, 1)]], *expected, "row {row}");
        }
        // x = 2 ± √(25 − (e − y)²): C''₌₀ by e is ∓1/5, by e and y ±1/5.
        let slide = differentiate_twice([0.0, 0.0], |[y, e]| {
            let press = DrivenRrp { e, ..press.lift() };
            let zero = Dual2SVec::from(0.0);
            let q = [Dual2SVec::from(2.0), y, zero, zero, zero];
            Ok(press.position(q)?.block.slide)
        })
        .unwrap();
        assert_eq!(slide.value, 2.0 + 5.0 * sign);
        assert_eq!(slide.gradient.as_slice(), [0.0, 0.0]);
        for (i, j, expected) in [(0, 0, -0.2), (1, 1, -0.2), (0, 1, 0.2), (1, 0, 0.2)] {
            assert_close(slide.hessian[(i, j)], sign * expected);
        }
    }
}

#[test]
fn a_bar_through_its_pin_turns_with_the_offset_and_does_not_slide() {
    assert_eq!(DrivenRpr::OUTPUTS, ["bar.angle", "block.slide"]);
    for (quarters, angle) in [0.0, FRAC_PI_2, PI, -FRAC_PI_2].into_iter().enumerate() {
        for (side, sign) in [(Sense::Ahead, 1.0), (Sense::Behind, -1.0)] {
            let crank = DrivenRpr { e: 0.0, side };
            let [x, y] = turned([sign * 2.0, 0.0], quarters);
            let q = [x, y, 0.0, 0.0];
            assert_eq!(crank.position(q).unwrap().bar.angle(), angle);
            let slopes = crank.sensitivity(q).unwrap();
            assert_eq!([slopes[(0, 0)], slopes[(1, 0)]], [-sign / 2.0, 0.0]);
            let jacobian = crank.jacobian(q).unwrap();
            let [u, n] = [turned([1.0, 0.0], quarters), turned([0.0, 1.0], quarters)];
            for axis in 0..2 {
                assert_eq!(jacobian[(0, axis)], sign * n[axis] / 2.0);
                assert_eq!(jacobian[(1, axis)], u[axis]);
            }
        }
    }
}

/// Where each group has its limit, the pose exists and its derivatives do not; nor do they four
/// units in the last place short of it.
#[test]
fn at_the_limit_there_is_a_pose_and_no_derivative() {
    let bars = DrivenRrr { l1: 3.0, l2: 4.0, elbow: Side::Left };
    let singular = |group| Err(SolveError::Singular { group });
    for d in [7.0, 7.0 + 4.0 * 4.0 * f64::EPSILON, 1.0, 1.0 - 8.0 * f64::EPSILON] {
        let q = [0.0, 0.0, d, 0.0];
        assert!((bars.position(q).unwrap().C.x.abs() - 3.0).abs() < 1e-14);
        assert_eq!(bars.jacobian(q).map(drop), singular("BC, DC"));
        assert_eq!(bars.sensitivity(q).map(drop), singular("BC, DC"));
        assert_eq!(bars.coefficients(q).map(drop), singular("BC, DC"));
    }
    let press = DrivenRrp { l: 2.0, e: 0.5, side: Sense::Ahead };
    for y in [2.5, 2.5 + 4.0 * 2.0 * f64::EPSILON, -1.5] {
        let q = [1.0, y, 0.0, 0.0, 0.0];
        assert_eq!(press.position(q).unwrap().block.slide, 1.0);
        assert_eq!(press.jacobian(q).map(drop), singular("BC, block"));
        assert_eq!(press.sensitivity(q).map(drop), singular("BC, block"));
    }
    let crank = DrivenRpr { e: 1.0, side: Sense::Ahead };
    for x in [1.0, 1.0 - 2.0 * f64::EPSILON] {
        let q = [x, 0.0, 0.0, 0.0];
        assert_eq!(crank.position(q).unwrap().block.slide, 0.0);
        assert_eq!(crank.jacobian(q).map(drop), singular("block, bar"));
        assert_eq!(crank.sensitivity(q).map(drop), singular("block, bar"));
    }
}

/// Dual numbers of every kind without a derivative give the pose at the limit as it is.
#[test]
fn constants_are_assembled_at_the_limit() {
    fn pose<D: Real>() -> [D; 4] {
        let bars = DrivenRrr { l1: 3.0, l2: 4.0, elbow: Side::Left }.lift::<D>();
        let pose = bars.position([0.0, 0.0, 7.0, 0.0].map(|x: f64| D::lit(x, x as f32))).unwrap();
        assert!(pose.rows().iter().all(|row| row.is_constant() && row.is_finite()));
        pose.rows()
    }
    let expected = [3.0, 0.0, 0.0, PI];
    let same = |found: [f64; 4]| assert_eq!(found, expected);
    same(pose::<Dual<f64>>().map(Real::value));
    same(pose::<Dual2<f64>>().map(Real::value));
    same(pose::<Dual3<f64>>().map(Real::value));
    same(pose::<HyperDual<f64>>().map(Real::value));
    same(pose::<DualSVec<f64, 3>>().map(Real::value));
    same(pose::<Dual2SVec<f64, 3>>().map(Real::value));
    same(pose::<Dual<Dual2<f64>>>().map(Real::value));
    assert_eq!(pose::<Dual<f32>>().map(Real::value)[..3], expected[..3]);
}

mechanism! {
    /// Two bars that may be stretched out, and a crank on their pin.
    struct Stretched {
        input reach: length;
        input theta: angle;
        param r = 0.5m;

        ground A(0, 0);
        point D at (reach, 0);

        rrr   AC(A), DC(D) -> C { lengths: (3m, 4m), mode: left }
        crank CE(C) -> E        { length: r, angle: theta }

        output E, AC, CE;
    }
}

/// A root of zero upstream does not spoil derivatives that it has no part in.
#[test]
fn derivatives_that_do_not_pass_a_limit_exist_there() {
    let arm = Stretched::new();
    let at = [7.0, 0.0];
    let position = arm.position(at).unwrap();
    assert_eq!((position.E.x, position.E.y), (3.5, 0.0));
    let singular = Err(SolveError::Singular { group: "AC, DC" });
    assert_eq!(arm.jacobian(at).map(drop), singular);
    // By the crank's length alone.
    let slopes = arm.sensitivity(at).unwrap();
    assert_eq!(slopes.as_slice(), [1.0, 0.0, 0.0, 0.0]);
    // By the crank's angle alone, once and twice.
    let slopes = differentiate([0.0], |[theta]| {
        Ok(arm.lift().position([DualSVec::from(7.0), theta])?.rows())
    });
    assert_eq!(slopes.unwrap().as_slice(), [0.0, 0.5, 0.0, 1.0]);
    let height = differentiate_twice([FRAC_PI_2, 0.5], |[theta, r]| {
        let arm = Stretched { r };
        Ok(arm.position([Dual2SVec::from(7.0), theta])?.E.y)
    })
    .unwrap();
    assert_eq!((height.value, height.hessian[(0, 0)]), (0.5, -0.5));
}

/// Two bars of 3 and 4 over a distance d close to 7. With C at x = (d² − 7)/2d along the line of
/// centres and h beside it, ∂BC.angle/∂d = (x − d)/(d h), where h² = (7 − d)(7 + d)(d² − 1)/4d² and
/// 7 − d is exact. Rounding d moves the slope by its condition, d/2(7 − d) times itself.
#[test]
fn towards_a_toggle_slopes_grow_and_stay_right() {
    let mut previous = 0.0;
    for exponent in 1..=49 {
        let d = 7.0 - 2.0_f64.powi(-exponent);
        let gap = 7.0 - d;
        let x = (d * d - 7.0) / (2.0 * d);
        let h = (gap * (7.0 + d) * (d * d - 1.0)).sqrt() / (2.0 * d);
        let truth = (x - d) / (d * h);
        let bars = DrivenRrr { l1: 3.0, l2: 4.0, elbow: Side::Left };
        let slope = bars.jacobian([0.0, 0.0, d, 0.0]).unwrap()[(2, 2)];
        let allowed = 4.0 * f64::EPSILON * truth.abs() * (1.0 + d / (2.0 * gap));
        assert!((slope - truth).abs() <= allowed, "{exponent}: {slope} {truth}");
        // Halving the gap takes the slope √2 times as far.
        let growth: f64 = truth / previous;
        previous = truth;
        assert!(exponent < 8 || (growth / 2.0_f64.sqrt() - 1.0).abs() < 0.01);
    }
}

/// Numbers that break things.
const HOSTILE: [f64; 16] = [
    0.0,
    -0.0,
    1.0,
    -1.0,
    3.0,
    4.0,
    5.0,
    -7.0,
    1.0 + f64::EPSILON,
    1.0 - f64::EPSILON,
    1e-9,
    1e-160,
    5e-324,
    1e160,
    f64::INFINITY,
    f64::NAN,
];

/// Every choice of hostile numbers, one step of a counter after the other.
fn hostile<const N: usize>(count: u64) -> [f64; N] {
    let mut state = count.wrapping_mul(0x9e37_79b9_7f4a_7c15);
    core::array::from_fn(|_| {
        state = state.wrapping_mul(0xd134_2543_de82_ef95).wrapping_add(1);
        HOSTILE[(state >> 60) as usize]
    })
}

/// Whatever goes in: what comes out is finite, or an error. Counts what comes out. A sample of the choices of
/// `.ci/nightly`.
#[test]
fn what_is_not_finite_is_never_ok() {
    let mut outcomes = [0; 2];
    macro_rules! finite {
        ($solver:expr, $q:expr) => {{
            let (solver, q) = ($solver, $q);
            let matrices = [
                solver.jacobian(q).map(|matrix| matrix.iter().copied().collect::<Vec<_>>()),
                solver.sensitivity(q).map(|matrix| matrix.iter().copied().collect::<Vec<_>>()),
            ];
            for matrix in matrices {
                outcomes[usize::from(matrix.is_err())] += 1;
                if let Ok(entries) = matrix {
                    assert!(entries.iter().all(|entry| entry.is_finite()), "{solver:?} {q:?}");
                }
            }
        }};
    }
    let choices = if cfg!(debug_assertions) { cases(1000, 4000) } else { 400_000 };
    for count in 0..choices as u64 {
        let [l1, l2, a, b, c, d, f] = hostile(count);
        let elbow = [Side::Left, Side::Right][(count % 2) as usize];
        let side = [Sense::Ahead, Sense::Behind][(count % 2) as usize];
        finite!(DrivenRrr { l1, l2, elbow }, [a, b, c, d]);
        finite!(DrivenRrp { l: l1, e: l2, side }, [a, b, c, d, f]);
        finite!(DrivenRpr { e: l2, side }, [a, b, c, d]);
        finite!(DrivenPrp { e1: l1, e2: l2 }, [a, b, c, d, f, 0.5]);
        finite!(DrivenRpp { slot: l1, e1: l2, e2: a }, [b, c, d, f, l1]);
        let [l1, l2, a, b, c, d] = [l1, l2, a, b, c, d].map(|number| number as f32);
        finite!(DrivenRrr { l1, l2, elbow }, [a, b, c, d]);
        finite!(DrivenRpr { e: l2, side }, [a, b, c, d]);
    }
    assert!(outcomes[0] > 100 && outcomes[1] > 100, "{outcomes:?}");
}
