//! Ratios of rates, and poles.

use super::*;
use crate::model::mechanism::OutputKind;
use crate::pipeline;

const TWO_INPUTS: &str = "input t: angle; input s: angle; ground A(0, 0); \
                          crank AB(A) -> B { length: 1m, angle: t } \
                          crank BC(B) -> C { length: 1m, angle: s }";

/// True if the output `r` of a crank is a number of the pose; else it is one of the forces where a mass moves.
#[track_caller]
fn is_of_the_pose(value: &str) -> bool {
    let (mechanism, mistakes) =
        resolved_on(CRANK, &format!("mass 1kg on B; load f: force; force (f, 0) on B; {value}"));
    assert_eq!(mistakes, "", "{value}");
    let mechanism = mechanism.expect("nothing was reported");
    let asked = mechanism.dynamics.asked.iter().any(|asked| asked.owner == "r");
    let ratio = mechanism.outputs.iter().find(|output| output.field == "r");
    let is_ratio = ratio.is_some_and(|output| matches!(output.kind, OutputKind::Ratio { .. }));
    assert!(asked != is_ratio, "{value}");
    is_ratio
}

#[test]
fn a_number_that_no_rate_changes_is_of_the_pose() {
    for value in [
        "output r = rate(B.x) / rate(B.y);",
        "output r = -rate(AB.angle) / rate(t);",
        "output r = 2 * (rate(B.x) + rate(B.y)) / rate(distance(B, D));",
        "output r = rate(B.x) * rate(B.y) / (rate(t) * rate(t));",
        "output r = sin(1rad * rate(B.x) / rate(B.y)) + 1;",
        "output r = hypot(rate(B.x), rate(B.y)) / abs(rate(t));",
        "output r = abs(rate(B.x) / rate(t));",
        "output r = rate(B.x) / (rate(B.x) - rate(B.y));",
        "let v = rate(B.x); let w = 2 * v; output r = w / v;",
        "let r = rate(B.x) / rate(t); output r;",
        "let q = rate(B.x) / rate(t); output r = sqrt(1m * 1m + q * q);",
    ] {
        assert!(is_of_the_pose(value), "{value}");
    }
    for value in [
        "output r = rate(B.x);",
        "output r = rate(B.x) * rate(B.y);",
        "output r = rate(B.x) / rate(B.y) / rate(t);",
        "output r = 1 / rate(t);",
        "output r = rate(B.x) / rate(B.y) + rate(t) * 1s;",
        "output r = rate(B.x) / rate(B.y) - rate(t) * 1s;",
        "output r = abs(rate(B.x)) / rate(B.y);",
        "output r = hypot(rate(B.x), rate(B.y)) / rate(t);",
        "output r = atan2(rate(B.y), rate(B.x));",
        "output r = min(rate(B.y), rate(B.x)) / rate(t);",
        "output r = hypot(rate(B.x), 1(m/s)) / abs(rate(t));",
        "output r = f * rate(B.x) / rate(t);",
        "output r = t.drive * rate(t) / rate(B.x);",
        "let v = rate(B.x); let w = 2 * v; output r = w * v / v;",
    ] {
        assert!(!is_of_the_pose(value), "{value}");
    }
}

#[test]
fn a_quotient_that_rates_change_is_none_of_the_pose() {
    const ONE: &str = "this one changes with the input's rate: a number of the pose has as many rates below the line as \
                       above, `rate(a) / rate(b)`";
    const RATES: &str = "an output of rates and loads stands in the result of `forces`; of rates alone, `velocity` gives \
                         those of every output";
    let nothing = |reason: &str| {
        format!(
            "r: nothing has mass and nothing acts, so there are no forces beside `r` / {reason}"
        )
    };
    check(&[
        (CRANK, "output r = rate(B.x) / rate(B.y);", ""),
        (CRANK, "output r = rate(B.x) / rate(B.y) / rate(t);", &nothing(ONE)),
        (CRANK, "output r = abs(rate(B.x)) / rate(B.y);", &nothing(ONE)),
        (CRANK, "output r = rate(B.x) * rate(B.y);", &nothing(RATES)),
        (CRANK, "output r = rate(B.x) / 2;", &nothing(RATES)),
        (
            TWO_INPUTS,
            "output r = rate(C.x) / rate(C.y);",
            &nothing(
                "a quotient of rates belongs to the pose of one input; with several it depends on how they move",
            ),
        ),
        (
            CRANK,
            "output r = rate(B.x) / rate(D.y);",
            "D.y: nothing here moves, and its rate is zero / a rate is that of an input, a link's `angle` or `slide`, a \
             point's `x` or `y`, or a `distance`",
        ),
        (
            CRANK,
            "let r = rate(B.x) / rate(B.y); point P on AB at (1m * r, 0);",
            "r#2: `r` reads a rate, and stands in forces, torques and outputs alone / what the mechanism is made of and \
             how it moves depends on no load and no rate",
        ),
    ]);
}

#[test]
fn a_pole_is_that_of_links() {
    check(&[
        (SIX_BAR, "output I = pole(BC), K = pole(BC, CE);", ""),
        (
            SIX_BAR,
            "output I = pole(BCC);",
            "BCC: no link named `BCC`; a link with a similar name exists: `BC`",
        ),
        (
            SIX_BAR,
            "output I = pole(BC, C);",
            "C: `C` is a point, not a link / it is the pin of `rrr BC, DC`: name the link",
        ),
        (SIX_BAR, "output I = pole(rail);", "rail: `rail` is a guide, not a link"),
        (
            SIX_BAR,
            "output I = pole(BC, BC);",
            "BC#2: `BC` has no pole against itself; name two links / its pole against the ground is `pole(BC)`",
        ),
        (SIX_BAR, "output I = pole();", "pole: `pole` takes a link, or two, and none is given"),
        (
            SIX_BAR,
            "output I = pole(BC, CE, DC);",
            "pole: `pole` takes a link, or two, and 3 are given",
        ),
        (
            SIX_BAR,
            "output I = pole(BC.angle);",
            "BC.angle: a pole is that of a link; write its name / as in `output I = pole(BC)`, or `pole(BC, DE)` of two \
             links",
        ),
        (
            TWO_INPUTS,
            "output I = pole(BC);",
            "pole: a pole is that of one input / where `t` and `s` move, it depends on their rates",
        ),
    ]);
}

#[test]
fn a_pole_is_an_output_with_a_name() {
    check(&[
        (
            SIX_BAR,
            "output pole(BC);",
            "pole: a pole has a name; write `output I = pole(…)` / the result has `I.x` and `I.y`",
        ),
        (
            SIX_BAR,
            "output I = 2 * pole(BC);",
            "pole: a pole has a name; write `output I = pole(…)` / the result has `I.x` and `I.y`",
        ),
        (
            SIX_BAR,
            "let I = pole(BC);",
            "pole: a pole has a name; write `output I = pole(…)` / the result has `I.x` and `I.y`",
        ),
        (
            SIX_BAR,
            "output C = pole(BC);",
            "C: the name `C` is taken; choose another / `C` is a point",
        ),
        (
            SIX_BAR,
            "output I = pole(BC), I = pole(DC);",
            "I#2: the output `I` is given twice; remove one",
        ),
    ]);
}

/// A link that keeps its direction in every pose, which the equations show, has no pole in any.
#[test]
fn what_never_turns_has_no_pole() {
    const REASON: &str = "an instant centre is that of a link that turns: what moves along a line, or on a circle without \
                          turning, has it at infinity";
    for (statements, expected) in [
        ("output I = pole(block);", "block: `block` never turns, and has no pole"),
        (
            "crank DF(D) -> F { length: 1m, angle: t + 10deg } output B, I = pole(AB, DF);",
            "AB: `AB` never turns against `DF`, and has no pole there",
        ),
    ] {
        let source = format!("pub struct M {{ {SIX_BAR} {statements} }}");
        let row = source.len() - " }".len() - statements.len()..source.len() - " }".len();
        let mut diagnostics = Diagnostics::new();
        let tokens = source.parse().expect("the source is made of Rust's tokens");
        let tree = parse(tokens, &mut diagnostics).expect("the declaration has a name");
        assert!(pipeline::resolved(&tree, &mut diagnostics).is_err(), "{statements}");
        let found = told(&diagnostics.into_mistakes(), &source, row);
        // The crank's own names come first.
        assert!(found.contains(expected) && found.ends_with(REASON), "{found}");
    }
}
