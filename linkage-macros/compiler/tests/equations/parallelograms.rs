//! Bars that stay opposite sides of a parallelogram: behind a crank, a rocker and another parallelogram, on moving links,
//! with driven sides; and what they do where all joints are in one line.

use crate::equations::declarations::Variant;
use crate::interface::quantity::{Order, Quantity};
use crate::ir::interpret::{Number, ProgramValues};
use crate::ir::text::text;
use crate::model::mechanism::Mechanism;
use crate::oracle::{Digits, defaults, mechanism, values};
use crate::{equations, passes};

const TWO: &[[f64; 3]] = &[[0.7, 1.3, -0.6], [0.21, -0.4, 0.9]];

macro_rules! on_a_crank {
    ($($rest:literal)*) => {
        concat!(
            "pub struct M { input q: angle; input s: length; ground A(0, 0), D(0.9, 0.15);",
            "crank AB(A) -> B { length: 0.3, angle: q }",
            "guide post through (0.7, 0) along 90deg;",
            $($rest,)* "}"
        )
    };
}

/// A variant each: its parallelogram is A, B, C, D.
pub(crate) const PARALLELOGRAMS: &[Variant] = &[
    Variant {
        name: "parallelogram behind a crank",
        source: on_a_crank!("rrr BC(B), DC(D) -> C { lengths: (hypot(0.9m, 0.15m), 0.3), mode: parallel }"
            "point X on BC at (0.3, 0.2); point Y on DC at polar (0.2, 100deg);"
            "slider z(post) { slide: s } output A, B, C, D, BC, DC, X, Y, z, BC.transmission;"),
        inputs: TWO,
    },
    Variant {
        name: "parallelogram whose rocker is written first, on an upright base",
        source: on_a_crank!("ground E(0, -0.5); rrr EC(E), BC(B) -> C { lengths: (0.3, 0.5), mode: parallel }"
            "slider z(post) { slide: s } output A, B, C, EC, BC, z, BC.transmission;"),
        inputs: TWO,
    },
    Variant {
        name: "parallelograms behind a rocker and behind each other",
        source: concat!(
            "pub struct M { input q: angle; ground A(0, 0), D(0.9, 0.15), H(1.5, 0.4);",
            "crank AB(A) -> B { length: 0.3, angle: q }",
            "rrr BK(B), DK(D) -> K { lengths: (0.8, 0.5), mode: left } point L on DK at (-0.1, 0.2);",
            "rrr LM(L), HM(H) -> M { lengths: (hypot(0.6m, 0.25m), hypot(0.1m, 0.2m)), mode: parallel }",
            "point N on HM at (0.15, 0.25); point O on DK at distances (0.4, 0.3) left;",
            "rrr OP(O), HP(H) -> P { lengths: (hypot(0.6m, 0.25m), 0.4), mode: parallel } }"
        ),
        inputs: &[[0.7, 1.3, -0.6]],
    },
    Variant {
        name: "parallelogram on a moving link, a side of which lies against its direction",
        source: on_a_crank!("crank EF(B) { angle: 2 * q + 0.4 } point I on AB at (0.1, 0.35); point J on EF at (-0.2, 0);"
            "rrr IK(I), JK(J) -> K { lengths: (0.2, hypot(0.2m, 0.35m)), mode: parallel }"
            "point X on IK at (0.1, -0.1); slider z(post) { slide: s }"),
        inputs: TWO,
    },
    Variant {
        name: "parallelogram with driven sides",
        source: on_a_crank!("let l = 0.5 + s; crank AG(A) -> G { length: l, angle: 2 * q }"
            "rrr GK(G), DK(D) -> K { lengths: (hypot(0.9m, 0.15m), l), mode: parallel }"
            "point J on AB at (0.3 + s, 0.1m * q);"
            "rrr JL(J), GL(G) -> L { lengths: (l, hypot(0.3 + s, 0.1m * q)), mode: parallel } slider z(post) { slide: s }"),
        inputs: TWO,
    },
];

/// The position at some inputs, by the names of its points and links.
fn position(mechanism: &Mechanism, inputs: &[[f64; 3]]) -> Vec<(String, Vec<Digits>)> {
    let program = equations::derive(mechanism, passes::RULES);
    let given = ProgramValues {
        inputs: inputs.iter().map(|q| q.map(Digits::float)).collect(),
        params: defaults(mechanism),
        loads: Vec::new(),
        drives: Vec::new(),
        unit: None,
    };
    let mut values = values(&program, "position", &given).into_iter();
    let outputs = mechanism.outputs.iter();
    let named = outputs.map(|output| {
        let count = Quantity::of(&output.kind).layout(Order::Position).parts.len();
        (output.field.to_string(), values.by_ref().take(count).collect())
    });
    named.collect()
}

fn named<'p>(position: &'p [(String, Vec<Digits>)], name: &str) -> &'p [Digits] {
    let found = position.iter().find(|(known, _)| known == name);
    &found.unwrap_or_else(|| panic!("no {name}")).1
}

/// The inputs in front of the change points of each parallelogram, behind them and far away.
const POSES: [f64; 6] = [0.7, 2.9, 3.4, 4.5, 6.9, -40.0];

/// Every corner is where the other three say, the bars point to it from their joints, and the circles that an rrr would
/// cut meet there.
#[test]
fn the_corners_of_every_parallelogram_are_where_the_other_three_say() {
    for (variant, corners) in PARALLELOGRAMS.iter().zip([
        &["A B C D BC DC"][..],
        &["A B C E BC EC"],
        &["D L M H LM HM", "D O P H OP HP"],
        &["B I K J IK JK"],
        &["A G K D GK DK", "A J L G JL GL"],
    ]) {
        let mechanism = mechanism(variant.source);
        for q in POSES {
            // The links that carry them have a limit of their own.
            let q = if corners[0].starts_with("D L") { q.rem_euclid(0.5) + 0.3 } else { q };
            let inputs = &[[q, 0.0, 0.0], [0.21, 0.0, 0.0]][..variant.inputs.len()];
            let at = position(&with_everything(variant.source, &mechanism), inputs);
            for corners in corners {
                check_corners(&at, corners);
            }
        }
    }
}

/// The same mechanism with every point and link as output.
fn with_everything(source: &str, plain: &Mechanism) -> Mechanism {
    let body = source.split_once(" output ").map(|(body, _)| body);
    let body = body.or_else(|| source.strip_suffix('}')).expect("a declaration ends with a brace");
    let points = plain.points.iter().map(|point| &point.name);
    let names = points.chain(plain.links.iter().map(|link| &link.name));
    let names: Vec<_> = names.map(ToString::to_string).collect();
    mechanism(&format!("{body} output {}; }}", names.join(", ")))
}

fn check_corners(at: &[(String, Vec<Digits>)], corners: &str) {
    let names: Vec<_> = corners.split(' ').collect();
    let [a, b, c, d] = [0, 1, 2, 3].map(|corner| named(at, names[corner]));
    let size = |v: &[Digits; 2]| v[0].mul(&v[0]).add(&v[1].mul(&v[1])).to_f64().sqrt();
    let to = |p: &[Digits], q: &[Digits]| [q[0].sub(&p[0]), q[1].sub(&p[1])];
    for axis in 0..2 {
        assert!(to(d, c)[axis].apart(&to(a, b)[axis]) < 1e-60, "{corners}");
    }
    for (joint, link) in [(b, names[4]), (d, names[5])] {
        let (along, u) = (to(joint, c), named(at, link));
        for axis in 0..2 {
            let by_length = along[axis].to_f64() / size(&along);
            assert!((by_length - u[axis].to_f64()).abs() < 1e-14, "{corners}: {link}");
        }
    }
}

/// Four bars, whose second dyad is made in a mode.
fn four_bars(mode: &str) -> Mechanism {
    mechanism(&format!(
        "pub struct M {{ input q: angle; ground A(0, 0), D(4, 0); crank AB(A) -> B {{ length: 1, angle: q }}
         rrr BC(B), DC(D) -> C {{ lengths: (4, 1), mode: {mode} }} output C, DC; }}"
    ))
}

/// In front of 180° `left` is the parallelogram, behind it `right` is.
#[test]
fn no_mode_of_a_side_goes_on_as_the_parallelogram() {
    let at = |mode, q| {
        let position = position(&four_bars(mode), &[[q, 0.0, 0.0]]);
        [0, 1].map(|axis| named(&position, "C")[axis].to_f64())
    };
    let off = |a: [f64; 2], b: [f64; 2]| (a[0] - b[0]).hypot(a[1] - b[1]);
    for (q, same, other) in [
        (0.7, "left", "right"),
        (2.9, "left", "right"),
        (3.6, "right", "left"),
        (5.9, "right", "left"),
    ] {
        assert!(off(at("parallel", q), at(same, q)) < 1e-14, "{q}");
        assert!(off(at("parallel", q), at(other, q)) > 0.1, "{q}");
    }
}

/// No root, no division and no condition in what moves, and no clearance to follow.
#[test]
fn a_parallelogram_has_neither_root_nor_limit() {
    let program = equations::derive(&four_bars("parallel"), passes::RULES);
    let mut program = passes::optimise(&program);
    assert!(program.clearances.is_empty());
    program.answers.retain(|answer| answer.entry.is_some_and(|entry| entry.name() == "motion"));
    let written = text(&passes::optimise(&program));
    for word in ["sqrt", " if ", "div"] {
        assert!(!written.contains(word), "{word}: {written}");
    }
}
