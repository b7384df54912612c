//! Expressions and outputs that read the mechanism itself: coordinates and distances.

use linkage_core::mechanism;

mechanism! {
    /// A four-bar whose coupler point drives a rope: its length, and a second crank as long as a
    /// distance of the first loop.
    struct Rope {
        input theta: angle;
        param lead = 40mm;
        ground A(0, 0), D(665.7mm, 0);
        ground W(A.x + 200mm, D.y + lead);
        crank AB(A) -> B        { length: 80mm, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (632mm, 374mm), mode: right }
        point blade on BC at (500mm, -60mm);
        let rope = distance(blade, W);
        crank hand(W) -> H { length: rope / 2, angle: blade.y / 100mm }
        output blade, blade.x, H.y, W, rope, bar = distance(B, C), span = distance(A, D), H;
    }
}

/// A sum of three rounded terms of a size below 3 m, and a root: within 4 ε of that size.
const NEAR: f64 = 12.0 * f64::EPSILON;

#[test]
fn a_coordinate_is_that_of_the_point() {
    for step in 0..200 {
        let theta = -3.1 + 0.031 * f64::from(step);
        let m = Rope::new().motion(theta, 1.7, -0.4).unwrap();
        assert_eq!(m.position.blade_x, m.position.blade.x);
        assert_eq!(m.position.H_y, m.position.H.y);
        assert_eq!(m.velocity.blade_x, m.velocity.blade.x);
        assert_eq!(m.velocity.H_y, m.velocity.H.y);
        assert_eq!(m.acceleration.blade_x, m.acceleration.blade.x);
        assert_eq!(m.acceleration.H_y, m.acceleration.H.y);
    }
}

#[test]
fn a_distance_is_that_of_the_points_and_a_dimension_like_any_other() {
    for step in 0..200 {
        let theta = -3.1 + 0.031 * f64::from(step);
        let p = Rope::new().position(theta).unwrap();
        let rope = (p.blade.x - p.W.x).hypot(p.blade.y - p.W.y);
        assert!((p.rope - rope).abs() < NEAR);
        let hand = (p.H.x - p.W.x).hypot(p.H.y - p.W.y);
        assert!((hand - rope / 2.0).abs() < NEAR);
        let turned = (p.blade.y / 0.1).sin() * rope / 2.0;
        // The angle is a hundredfold of the blade's height, and rounded as one of up to 5 rad.
        assert!((p.H.y - p.W.y - turned).abs() < 10.0 * NEAR);
    }
}

/// Both points of `bar` are joints of one link, both points of `span` of the ground: they are
/// numbers while compiling, and their rates are nothing but zero.
#[test]
fn a_distance_within_one_body_is_a_constant() {
    let m = Rope::new().motion(0.7, 3.0, 2.0).unwrap();
    assert_eq!((m.position.bar, m.velocity.bar, m.acceleration.bar), (0.632, 0.0, 0.0));
    assert_eq!((m.position.span, m.velocity.span, m.acceleration.span), (0.6657, 0.0, 0.0));
}

#[test]
fn a_ground_point_that_reads_another_follows_its_parameter() {
    let rope = Rope { lead: 0.125 };
    let p = rope.position(0.3).unwrap();
    assert_eq!((p.W.x, p.W.y), (0.2, 0.125));
}

/// The velocity equations against automatic differentiation of the position.
#[test]
fn rates_of_readings_are_derivatives() {
    for step in 0..100 {
        let theta = -3.1 + 0.062 * f64::from(step);
        let rope = Rope::new();
        let (formula, dual) = (rope.coefficients(theta).unwrap(), rope.jacobian(theta).unwrap());
        for (row, name) in Rope::OUTPUTS.iter().enumerate() {
            let apart = (formula[row][0] - dual[(row, 0)]).abs();
            assert!(apart < 1e-13 * dual[(row, 0)].abs().max(1.0), "{name} at {theta}: {apart}");
        }
    }
}

#[test]
fn rows_are_named_as_their_fields() {
    let names =
        ["blade.x", "blade.y", "blade.x", "H.y", "W.x", "W.y", "rope", "bar", "span", "H.x", "H.y"];
    assert_eq!(Rope::OUTPUTS, names);
}
