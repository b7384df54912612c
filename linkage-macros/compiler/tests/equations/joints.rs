//! Positions against the conditions that the joints of each group state.

use std::f64::consts::FRAC_PI_2;

use crate::ir::interpret::{Number, ProgramValues};
use crate::oracle::{Digits, defaults, mechanism, values};
use crate::{equations, passes};

/// The position's components at q = 0.7 (and s = 0.21).
fn position(source: &str) -> Vec<Digits> {
    let mechanism = mechanism(source);
    let program = equations::derive(&mechanism, passes::RULES);
    let inputs = [0.7, 0.21].map(|q| [q, 0.0, 0.0].map(Digits::float)).to_vec();
    let given = ProgramValues {
        inputs,
        params: defaults(&mechanism),
        loads: Vec::new(),
        drives: Vec::new(),
        unit: None,
    };
    values(&program, "position", &given)
}

fn to_f64(values: &[Digits]) -> Vec<f64> {
    values.iter().map(Digits::to_f64).collect()
}

/// The squared distance of two points.
fn square(a: &[Digits], b: &[Digits]) -> Digits {
    let (x, y) = (a[0].sub(&b[0]), a[1].sub(&b[1]));
    x.mul(&x).add(&y.mul(&y))
}

#[track_caller]
fn same(a: &Digits, b: f64) {
    assert!(a.apart(&Digits::float(b)) < 1e-15, "{} is not {b}", a.to_f64());
}

const ARM: &str =
    "input q: angle; ground A(0, 0), D(1, 0.25); crank AB(A) -> B { length: 0.5, angle: q }";

#[test]
fn rrr_keeps_its_lengths_and_takes_the_side_it_is_told() {
    for (mode, side) in [("left", 1.0), ("right", -1.0)] {
        let p = position(&format!(
            "struct M {{ {ARM} rrr BC(B), DC(D) -> C {{ lengths: (0.75, 0.5), mode: {mode} }} output B, C, BC, DC; }}"
        ));
        let d = [Digits::float(1.0), Digits::float(0.25)];
        same(&square(&p[0..2], &p[2..4]), 0.75 * 0.75);
        same(&square(&d, &p[2..4]), 0.25);
        let v = to_f64(&p);
        let cross = (1.0 - v[0]) * (v[3] - v[1]) - (0.25 - v[1]) * (v[2] - v[0]);
        assert!(cross * side > 0.0, "{mode}: C is on the wrong side of B → D");
        // The links' x point from their outer joints to the pin.
        same(&p[0].add(&p[4].mul(&Digits::float(0.75))), v[2]);
        same(&p[5].mul(&Digits::float(0.75)).add(&p[1]), v[3]);
        same(&p[6].mul(&Digits::float(0.5)), v[2] - 1.0);
        same(&p[7].mul(&Digits::float(0.5)), v[3] - 0.25);
    }
}

#[test]
fn rrp_keeps_its_length_and_its_offset_and_its_sense() {
    for (mode, sense) in [("ahead", 1.0), ("behind", -1.0)] {
        let p = position(&format!(
            "struct M {{ {ARM} guide g through (0.25, 0.5) along 30deg;
             rrp BC(B), block(g) -> C {{ length: 1.25, offset: 0.125, mode: {mode} }}
             output B, C, block; }}"
        ));
        same(&square(&p[0..2], &p[2..4]), 1.25 * 1.25);
        let v = to_f64(&p);
        let (c, s) = (30f64.to_radians().cos(), 30f64.to_radians().sin());
        same(&p[2], 0.25 + v[6] * c - 0.125 * s);
        same(&p[3], 0.5 + v[6] * s + 0.125 * c);
        let ahead = (v[2] - v[0]) * c + (v[3] - v[1]) * s;
        assert!(ahead * sense > 0.0, "{mode}: C is on the wrong side of the foot of B");
        same(&p[4], c);
        same(&p[5], s);
    }
}

#[test]
fn rpr_keeps_its_offset_and_its_sense() {
    for (mode, sense) in [("ahead", 1.0), ("behind", -1.0)] {
        for offset in [0.0, 0.125, -0.25] {
            let p = position(&format!(
                "struct M {{ {ARM} rpr block(B), bar(D) {{ offset: {offset}, mode: {mode} }} output B, block; }}"
            ));
            let v = to_f64(&p);
            let (u, slide) = ((v[2], v[3]), v[4]);
            assert!(slide * sense > 0.0, "{mode}");
            same(&p[0], 1.0 + slide * u.0 - offset * u.1);
            same(&p[1], 0.25 + slide * u.1 + offset * u.0);
            same(&p[2].mul(&p[2]).add(&p[3].mul(&p[3])), 1.0);
        }
    }
}

#[test]
fn prp_lies_on_both_guides() {
    let p = position(&format!(
        "struct M {{ {ARM} guide g through (0.25, 0.5) along 30deg; guide h on AB through B along 90deg;
         prp a(g), b(h) -> C {{ offsets: (0.125, -0.25) }} output B, AB, C, a, b; }}"
    ));
    let v = to_f64(&p);
    let (c, s) = (30f64.to_radians().cos(), 30f64.to_radians().sin());
    same(&p[4], 0.25 + v[8] * c - 0.125 * s);
    same(&p[5], 0.5 + v[8] * s + 0.125 * c);
    // The guide on AB stands across it: u = (−sin, cos), n = (−cos, −sin).
    same(&p[4], v[0] - v[11] * v[3] + 0.25 * v[2]);
    same(&p[5], v[1] + v[11] * v[2] + 0.25 * v[3]);
}

#[test]
fn rpp_reaches_its_pin_by_two_slides() {
    let p = position(&format!(
        "struct M {{ {ARM} guide g through (0.25, 0.5) along 30deg;
         rpp block(B), yoke(g) {{ slot: 60deg, offsets: (0.125, -0.25) }} output B, block, yoke; }}"
    ));
    let v = to_f64(&p);
    let unit = |degrees: f64| (degrees.to_radians().cos(), degrees.to_radians().sin());
    let (rail, slot) = (unit(30.0), unit(90.0));
    same(&p[2], slot.0);
    same(&p[3], slot.1);
    same(&p[5], rail.0);
    let (s2, s1) = (v[4], v[7]);
    same(&p[0], 0.25 + s1 * rail.0 - 0.125 * rail.1 + s2 * slot.0 + 0.25 * slot.1);
    same(&p[1], 0.5 + s1 * rail.1 + 0.125 * rail.0 + s2 * slot.1 - 0.25 * slot.0);
}

#[test]
fn points_and_guides_lie_where_their_frames_say() {
    let p = position(&format!(
        "struct M {{ {ARM} rrr BC(B), DC(D) -> C {{ lengths: (0.75, 0.5), mode: left }}
         point P on BC at (0.25, -0.125); point Q on BC at polar (0.5, 90deg);
         point L on BC at distances (0.5, 0.5) left; point R on BC at distances (0.5, 0.5) right;
         guide g on BC through P along 90deg; slider z(g) -> Z {{ slide: 0.5, offset: 0.25 }}
         output B, BC, P, Q, L, R, Z; }}"
    ));
    let v = to_f64(&p);
    let place = |x: f64, y: f64| (v[0] + x * v[2] - y * v[3], v[1] + x * v[3] + y * v[2]);
    let height = (0.25f64 - 0.375 * 0.375).sqrt();
    let places = [(0.25, -0.125), (0.0, 0.5), (0.375, height), (0.375, -height), (0.0, 0.375)];
    for (k, (x, y)) in places.into_iter().enumerate() {
        let expected = place(x, y);
        assert!((v[4 + 2 * k] - expected.0).abs() < 1e-15, "point {k}");
        assert!((v[5 + 2 * k] - expected.1).abs() < 1e-15, "point {k}");
    }
}

#[test]
fn compensated_numerics_mean_the_same() {
    for lengths in ["(0.75, 0.5)", "(0.6, 0.6)", "(0.5 + s, 0.8 - s)"] {
        let body = format!(
            "input s: length; {ARM} rrr BC(B), DC(D) -> C {{ lengths: {lengths}, mode: left }}
             slider z(g) {{ slide: s }}"
        );
        let body = body.replace("ground A", "guide g through (0, 0) along 0deg; ground A");
        let body = body.replacen("input s: length;", "", 1).replacen(
            "input q: angle;",
            "input q: angle; input s: length;",
            1,
        );
        let plain = position(&format!("struct M {{ {body} }}"));
        let careful = position(&format!("struct M {{ {body} numerics compensated; }}"));
        assert_eq!(plain.len(), careful.len());
        for (plain, careful) in plain.iter().zip(&careful) {
            assert!(plain.apart(careful) < 1e-80, "{lengths}");
        }
    }
}

/// Values of an output at q = 0.7.
fn output(body: &str) -> Vec<f64> {
    to_f64(&position(&format!("struct M {{ {ARM} {body} }}")))
}

#[track_caller]
fn near(found: f64, expected: f64) {
    // A handful of operations in f64 on numbers of order one.
    assert!((found - expected).abs() < 1e-14, "{found} is not {expected}");
}

#[test]
fn margins_and_transmission_are_what_the_joints_say() {
    let v = output(
        "rrr BC(B), DC(D) -> C { lengths: (0.75, 0.5), mode: left } output B, C, BC.margin, BC.transmission;",
    );
    let d = (1.0 - v[0]).hypot(0.25 - v[1]);
    let (outer, inner) = (1.25 * 1.25 - d * d, d * d - 0.0625);
    near(v[4], outer * inner / (8.0 * 0.375 * d));
    let dot = (v[2] - v[0]) * (v[2] - 1.0) + (v[3] - v[1]) * (v[3] - 0.25);
    near(v[5], (dot / 0.375).acos());

    let v = output(
        "guide g through (0.25, 0.5) along 30deg;
         rrp BC(B), block(g) -> C { length: 1.25, offset: 0.125, mode: ahead }
         output B, C, BC.margin, BC.transmission;",
    );
    let u = (30f64.to_radians().cos(), 30f64.to_radians().sin());
    let t = 0.125 - (u.0 * (v[1] - 0.5) - u.1 * (v[0] - 0.25));
    near(v[4], (1.25 - t) * (1.25 + t) / 2.5);
    near(v[5], (((v[3] - v[1]) * u.0 - (v[2] - v[0]) * u.1) / 1.25).acos());

    let v = output(
        "rpr block(B), bar(D) { offset: -0.25 } output B, block.slide, bar.margin, bar.transmission;",
    );
    let d = (1.0 - v[0]).hypot(0.25 - v[1]);
    near(v[3], d - 0.25);
    near(v[4], (-0.25 / d).acos());
    assert!(v[4] > FRAC_PI_2);

    let v = output("rpr block(B), bar(D) { mode: behind } output B, bar.margin, bar.transmission;");
    near(v[2], (1.0 - v[0]).hypot(0.25 - v[1]));
    near(v[3], FRAC_PI_2);

    let v = output(
        "guide g through (0.25, 0.5) along 30deg; guide h on AB through B along 90deg;
         prp a(g), b(h) -> C {} rpp c(B), y(h) { slot: -60deg } output AB, a.transmission, y.transmission;",
    );
    let across = (-v[1], v[0]);
    near(v[2], (u.0 * across.0 + u.1 * across.1).acos());
    near(v[3], 60f64.to_radians());
}

#[test]
fn a_guide_towards_a_point_passes_through_both() {
    let p = position(&format!(
        "struct M {{ {ARM} point P on AB at (0.25, 0.5); point Q on AB at (-0.375, 0.125);
         guide g on AB through P towards Q; guide h through D towards A;
         slider a(g) -> U {{ slide: 0.5, offset: 0.25 }} slider b(h) -> V {{ slide: 0.5, offset: 0.25 }}
         output P, Q, U, V; }}"
    ));
    let v = to_f64(&p);
    let along = |from: (f64, f64), to: (f64, f64)| {
        let (x, y) = (to.0 - from.0, to.1 - from.1);
        let (x, y) = (x / x.hypot(y), y / x.hypot(y));
        (from.0 + 0.5 * x - 0.25 * y, from.1 + 0.5 * y + 0.25 * x)
    };
    let u = along((v[0], v[1]), (v[2], v[3]));
    near(v[4], u.0);
    near(v[5], u.1);
    let h = along((1.0, 0.25), (0.0, 0.0));
    near(v[6], h.0);
    near(v[7], h.1);
}

#[test]
fn guides_on_different_links_cross_on_both() {
    let p = position(&format!(
        "struct M {{ {ARM} rrr BC(B), DC(D) -> C {{ lengths: (0.75, 0.5), mode: left }}
         guide g on BC through (0.25, 0.125) along 30deg; guide h on DC through (0.125, 0.25) along -70deg;
         prp a(g), b(h) -> P {{ offsets: (0.0625, -0.125) }} output B, BC, DC, P, a, b; }}"
    ));
    let v = to_f64(&p);
    let on = |origin: (f64, f64),
              link: (f64, f64),
              at: (f64, f64),
              degrees: f64,
              slide: f64,
              offset: f64| {
        let (c, s) = (degrees.to_radians().cos(), degrees.to_radians().sin());
        let local = (at.0 + slide * c - offset * s, at.1 + slide * s + offset * c);
        (
            origin.0 + local.0 * link.0 - local.1 * link.1,
            origin.1 + local.0 * link.1 + local.1 * link.0,
        )
    };
    let first = on((v[0], v[1]), (v[2], v[3]), (0.25, 0.125), 30.0, v[10], 0.0625);
    let second = on((1.0, 0.25), (v[4], v[5]), (0.125, 0.25), -70.0, v[13], -0.125);
    near(v[6], first.0);
    near(v[7], first.1);
    near(v[6], second.0);
    near(v[7], second.1);
}

#[test]
fn guides_along_the_axes_cross_at_their_own_coordinates() {
    let p = position(&format!(
        "struct M {{ {ARM} guide level through (0.25, 0.125) along 180deg; guide upright through (0.375, -0.5) along 90deg;
         prp a(level), b(upright) -> P {{ offsets: (0.0625, -0.125) }}
         prp c(upright), d(level) -> Q {{ offsets: (0.25, 0.5) }} output AB, P, Q; }}"
    ));
    for (found, expected) in p[2..].iter().zip([0.5, 0.0625, 0.125, -0.375]) {
        same(found, expected);
    }
}
