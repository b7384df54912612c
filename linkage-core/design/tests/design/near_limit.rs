//! Tolerances near a limit of assembly, where the first order is not enough and says so.

use std::f64::consts::PI;

use linkage_core::{SolveError, mechanism};
use linkage_design::{Reactions, Tolerance};

mechanism! {
    /// A four-bar whose coupler and rocker nearly stretch where the crank points away.
    struct NearLimit {
        input theta: angle;
        load turn: torque;
        param a = 100mm;
        param b = 300mm;
        param c = 260mm;
        param d = 400mm;
        ground A(0, 0), D(d, 0);
        crank AB(A) -> B        { length: a, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (b, c), mode: left }
        torque turn on DC;
        output AB, BC, DC, DC.margin, AB.B, BC.C, DC.D, DC.C;
    }
}

/// The four-bar whose margin at 180° is about this, and its tolerances of 0.1 mm.
fn near_limit(gap: f64) -> (NearLimit, Tolerance) {
    let bars = NearLimit { b: 0.5 - 0.26 + gap, ..NearLimit::new() };
    let [rest, loaded] = [0.0, 1.0].map(|load| bars.statics(PI, load).unwrap());
    let by = Reactions::of(bars.position(PI).unwrap(), rest, loaded);
    let tolerance = Tolerance::new()
        .dimension("a", by.place("AB", "B").unwrap()[0], 1e-4)
        .dimension("b", by.place("BC", "C").unwrap()[0], 1e-4)
        .dimension("c", by.place("DC", "C").unwrap()[0], 1e-4)
        .dimension("d", by.ground("DC", "D").unwrap()[0], 1e-4)
        .margin(bars.position(PI).unwrap().DC_margin);
    (bars, tolerance)
}

/// Near a limit the second order over the first is T/(4·margin), T = 0.4 mm; farther away other curvatures
/// count for a part in ten.
#[test]
fn near_a_limit_the_second_order_follows_its_law() {
    for gap in [10e-3, 3e-3, 1e-3, 0.6e-3, 0.4e-3] {
        let (NearLimit { a, b, c, d }, tolerance) = near_limit(gap);
        let second = linkage_core::differentiate_twice([a, b, c, d], |[a, b, c, d]| {
            Ok(NearLimit { a, b, c, d }.position(PI.into())?.DC.angle())
        })
        .unwrap();
        let first: f64 = second.gradient.iter().map(|slope| slope.abs() * 1e-4).sum();
        assert!((first / tolerance.worst() - 1.0).abs() < 1e-9);
        let sum: f64 = second.hessian.iter().map(|entry| entry.abs()).sum();
        let ratio = 0.5 * sum * 1e-8 / first;
        let law = tolerance.second_over_first().unwrap();
        assert!((ratio / law - 1.0).abs() < 0.1, "{gap}: {ratio} {law}");
        assert_eq!(tolerance.is_trusted(), gap > 2.5e-3, "{gap}");
        assert_eq!(tolerance.to_string().contains("near a limit"), gap < 2.5e-3);
    }
}

/// All sixteen corners: the worst of them is the first order and its second, while the margin is ample.
#[test]
fn the_worst_corner_is_the_worst_case() {
    for (gap, refused) in [(43.4e-3, 0), (10e-3, 0), (3e-3, 0), (0.2e-3, 1)] {
        let (bars, tolerance) = near_limit(gap);
        let NearLimit { a, b, c, d } = bars;
        let exact = bars.position(PI).unwrap().DC;
        let corner = |corner: u32| -> Result<f64, SolveError> {
            let by = |bit: u32| if corner >> bit & 1 == 1 { 1e-4 } else { -1e-4 };
            let moved = NearLimit { a: a + by(0), b: b + by(1), c: c + by(2), d: d + by(3) };
            Ok(moved.position(PI)?.DC.angle_from(exact).abs())
        };
        let corners: Vec<_> = (0..16).map(corner).collect();
        assert_eq!(corners.iter().filter(|corner| corner.is_err()).count(), refused, "{gap}");
        if refused == 0 {
            let worst = corners.into_iter().flatten().fold(0.0, f64::max);
            let ratio = tolerance.second_over_first().unwrap();
            let over = worst / tolerance.worst() - 1.0;
            assert!((over - ratio).abs() < 0.2 * ratio, "{gap}: {over} {ratio}");
        }
    }
}
