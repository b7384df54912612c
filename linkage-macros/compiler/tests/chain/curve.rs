//! Tests of `chain/curve`.

pub(crate) use linkage_compiler::chain::curve::*;

#[test]
fn a_chebyshev_sum_of_a_polynomial_is_the_polynomial() {
    let found = powers(|u| 0.5 - 2.0 * u + 3.0 * u * u * u, 5);
    for (found, wanted) in found.iter().zip([0.5, -2.0, 0.0, 3.0, 0.0, 0.0]) {
        assert!((found - wanted).abs() < 1e-14, "{found} for {wanted}");
    }
}

/// A curve u + c r + b r², r² the distance from a dead point, whose slope falls as r: the factor is c, before
/// and behind the end.
#[test]
fn the_factor_of_a_dead_point_is_that_of_its_root() {
    let (end, c, b) = (0.3, 0.7, -0.4);
    for way in [-1.0, 1.0] {
        let r: [f64; 3] = [0.01, 0.024, 0.047].map(f64::sqrt);
        let drives = r.map(|r| end + way * r * r);
        let found =
            DeadPoint::through(drives, r.map(|r| 2.0 + c * r + b * r * r), r.map(|r| 1.9 * r));
        let found = found.expect("it is beside the end");
        // Differences of numbers of order one over differences of roots of 0.05, twice.
        let off = [found.at - end, found.factor - c].map(f64::abs);
        assert!(off.iter().all(|off| *off < 1e-12), "{off:?}");
    }
}

/// A curve that turns back at both ends, S(x) + √z (m + k y) with other factors at each: the fit is this curve, and
/// its ends are m and k. Beside an end E, z is its slope there times the distance from E.
#[test]
fn the_ends_of_a_fit_are_those_of_the_curve() {
    let (middle, half, mean, skew) = (0.4, 0.9_f64, 0.7, -0.5);
    let center = (1.0 + half.cos()) / 2.0;
    let reach = 1.0 - center;
    type Of = fn([f64; 3]) -> f64;
    // z, its slope at the first end, y, and S, over the angle or the distance x from the middle.
    let turning: [Of; 3] = [
        |[x, center, reach]| 1.0 + (x.cos() - center) / reach,
        |[x, _, _]| x.sin(),
        |[x, _, _]| 0.3 + 0.2 * x.cos() - 0.6 * x.sin(),
    ];
    let sliding: [Of; 3] = [
        |[x, _, half]| 1.0 - (x / half).powi(2),
        |[x, _, half]| x / half,
        |[x, _, _]| 0.3 - 0.6 * x + 0.2 * x * x,
    ];
    let cases = [(true, turning, reach, half.sin() / reach), (false, sliding, half, 2.0 / half)];
    for (is_angle, [z, y, smooth], unit, fall) in cases {
        let at = |of: Of, x: f64| of([x, center, unit]);
        let curve = |x: f64| at(smooth, x) + at(z, x).max(0.0).sqrt() * (mean + skew * at(y, x));
        let dead = [-1.0, 1.0].map(|side| {
            let end = side * half;
            let factor = fall.sqrt() * (mean + skew * at(y, end));
            Some(DeadPoint { at: middle + end, factor })
        });
        let points = (0..=60).map(|i| 0.97 * half * (f64::from(i) / 30.0 - 1.0));
        let points: Vec<_> = points.map(|x| [middle + x, curve(x)]).collect();
        let curve = Curve { points, turns: None, is_angle, dead, near: Vec::new() };
        let fit = curve.fitted((3, Beside::DeadEnds)).expect("it has dead points");
        let ends = fit.ends.expect("they are asked for");
        let off = [ends.mean - mean, ends.skew - skew, curve.off(&fit)].map(f64::abs);
        // A polynomial of the third degree, or two lines in the cosine, holds S as it is. The last nodes lie a step h of
        // 0.03 beyond the points, where six of these are off by h⁶ |f⁽⁶⁾| ≈ 1e-9.
        assert!(off.iter().all(|off| *off < 1e-8), "{is_angle}: {off:?}");
    }
}

/// Between points a step h apart, the polynomial through six of them is off by h⁶ |f⁽⁶⁾|/720 times the distances from
/// them in steps: (0.5 · 1.5 · 2.5)² in the middle of them, and 0.5 · 0.5 · 1.5 · 2.5 · 3.5 · 4.5 where they begin or end
/// with the points.
#[test]
fn a_value_between_points_is_interpolated_from_both_sides() {
    let step = 0.1;
    let points: Vec<_> = (0..=20).map(|i| f64::from(i) * step).map(|x| [x, x.exp()]).collect();
    for cell in 0..20 {
        let x = (f64::from(cell) + 0.5) * step;
        let beside = match cell {
            0 | 19 => 0.5 * 0.5 * 1.5 * 2.5 * 3.5 * 4.5,
            1 | 18 => 0.5 * 1.5 * 0.5 * 1.5 * 2.5 * 3.5,
            _ => (0.5_f64 * 1.5 * 2.5).powi(2),
        };
        // The exponential grows by less than this over five steps.
        let most = (x + 5.0 * step).exp();
        let off = (between(&points, x) - x.exp()).abs();
        assert!(off < step.powi(6) * most / 720.0 * beside, "{cell}: {off:e}");
    }
}
