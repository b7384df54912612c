//! Points beside a crank's circle, whose best circle is known.

use std::f64::consts::{FRAC_PI_2, PI};

use linkage_core::mechanism;
use linkage_design::free;

mechanism! {
    struct Circle {
        input theta: angle;
        param x = 100mm;
        param y = -50mm;
        param radius = 600mm;
        ground A(x, y);
        crank AB(A) -> B { length: radius, angle: theta }
        output B;
    }
}

/// Points at these angles and distances from a place.
fn around<const N: usize>([x, y]: [f64; 2], polar: [[f64; 2]; N]) -> [[f64; 2]; N] {
    polar.map(|[degrees, distance]| {
        let angle = degrees.to_radians();
        [x + distance * angle.cos(), y + distance * angle.sin()]
    })
}

/// About a given centre the best radius is the mean of the distances, and the squares are those of what is left.
#[test]
fn a_radius_is_the_mean_of_the_distances() {
    const POINTS: [[f64; 2]; 5] =
        [[10.0, 0.5], [80.0, 0.62], [171.0, 0.57], [-100.0, 0.49], [-33.0, 0.67]];
    let found = free!(Circle: radius)
        .within([0.1..=2.0])
        .untimed_path("points", [-PI, PI], around([0.1, -0.05], POINTS), |m, q| {
            Ok(m.position(q)?.B)
        })
        .starts(1)
        .run()
        .unwrap();
    let mean = POINTS.iter().map(|[_, distance]| distance).sum::<f64>() / 5.0;
    let squares = POINTS.iter().map(|[_, distance]| (distance - mean).powi(2)).sum::<f64>();
    // Roundings of a metre.
    assert!((found.values[0] - mean).abs() < 1e-14, "{} for {mean}", found.values[0]);
    assert!((found.cost - squares).abs() < 1e-15, "{} for {squares}", found.cost);
}

/// Points on a circle, all of whose numbers are free. The search takes 23 evaluations with the slopes of distances, and
/// 27 with some along the tangents.
#[test]
fn a_circle_through_points_is_found_in_few_steps() {
    let polar = [0.0, 40.0, 95.0, 150.0, 200.0, 265.0, 310.0].map(|degrees| [degrees, 0.62]);
    let found = free!(Circle: x, y, radius)
        .untimed_path("points", [-PI, PI], around([0.13, -0.02], polar), |m, q| {
            Ok(m.position(q)?.B)
        })
        .starts(1)
        .run()
        .unwrap();
    for (value, wanted) in found.values.iter().zip([0.13, -0.02, 0.62]) {
        assert!((value - wanted).abs() < 1e-12, "{:?}", found.values);
    }
    assert!(found.counts.evaluations <= 25, "{:?}", found.counts);
}

/// A quarter of a circle, and a point beyond its end: the distance is that from the end.
#[test]
fn beyond_its_end_a_curve_is_as_far_as_its_end() {
    let found = free!(Circle: radius)
        .within([0.1..=2.0])
        .untimed_path("beyond", [0.0, FRAC_PI_2], [[0.1 - 1.0, -0.05 + 0.5]], |m, q| {
            Ok(m.position(q)?.B)
        })
        .starts(1)
        .run()
        .unwrap();
    // From (−1, 0.5) to (0, r).
    assert!((found.values[0] - 0.5).abs() < 1e-12, "{}", found.values[0]);
    assert!((found.cost - 1.0).abs() < 1e-12, "{}", found.cost);
}
