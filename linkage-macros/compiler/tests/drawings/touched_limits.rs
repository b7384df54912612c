//! Change points behind rockers, geared cranks and couplers: at which inputs constants bring a group to its limit exactly.

use std::f64::consts::TAU;

use crate::diagnostics::Diagnostic;
use crate::pipeline::{self, Options};

/// The notes on a declaration without mistakes, and its documentation.
fn told(statements: &str) -> (Vec<String>, String) {
    let source = format!("pub struct M {{ {statements} }}");
    let output = pipeline::compile(source.parse().expect("tokens"), &Options::NONE);
    assert!(output.diagnostics.is_empty(), "{statements}: {:?}", output.diagnostics);
    (output.notes.iter().map(Diagnostic::text).collect(), output.tokens.to_string())
}

/// A wiper by hand: the second rocker hangs on the first.
fn wiper(mode: &str) -> String {
    format!(
        "input theta: angle; param side: mode = left; ground A(0, 0), D(-250mm, 60mm), H(350mm, 60mm);
         crank AB(A) -> B {{ length: 45mm, angle: theta }}
         rrr rod(B), first(D) -> C {{ lengths: (290mm, 80mm), mode: left }}
         point E on first at (10mm, -70mm);
         rrr tie(E), second(H) -> F {{ lengths: (600mm, hypot(10mm, 70mm)), mode: {mode} }}
         rrr one(E), two(A) -> G {{ lengths: (400mm, 400mm), mode: side }}"
    )
}

/// The angles of a crank at which the rocker of a four-bar points its own point in a direction: B is as far from C as the rod
/// is long, and from A as the crank is.
fn cranks_at(direction: f64) -> Vec<f64> {
    let (ground, crank, rod, rocker) = ([-0.25, 0.06], 0.045, 0.29, 0.08);
    let along = direction + 0.07_f64.atan2(0.01);
    let c = [ground[0] + rocker * along.cos(), ground[1] + rocker * along.sin()];
    let far = c[0].hypot(c[1]);
    let between = ((crank * crank + far * far - rod * rod) / (2.0 * crank * far)).acos();
    let at = c[1].atan2(c[0]);
    let angles = [at - between, at + between].map(|angle| angle - TAU * (angle / TAU).round());
    let mut found: Vec<f64> = angles.into_iter().filter(|angle| angle.is_finite()).collect();
    found.sort_by(f64::total_cmp);
    // The mode in which C is on the left of the way from B to D.
    found.retain(|angle| {
        let b = [crank * angle.cos(), crank * angle.sin()];
        let (to_c, to_d) = ([c[0] - b[0], c[1] - b[1]], [ground[0] - b[0], ground[1] - b[1]]);
        to_d[0] * to_c[1] - to_d[1] * to_c[0] > 0.0
    });
    found
}

fn in_degrees(angles: &[f64]) -> String {
    let degrees = |angle: &f64| format!("{}°", (angle.to_degrees() * 100.0).round() / 100.0);
    angles.iter().map(degrees).collect::<Vec<_>>().join(" and ")
}

/// E passes the line of D and H where both rockers and the tie lie in it.
#[test]
fn a_group_behind_a_rocker_has_change_points() {
    let angles = [cranks_at(0.0), cranks_at(0.5 * TAU)].concat();
    assert!(!angles.is_empty(), "the rocker comes to none");
    let at = in_degrees(&angles);
    let (notes, docs) = told(&wiper("left"));
    assert_eq!(
        notes,
        [format!(
            "`tie, second` can be assembled in one way alone at `theta` = {at}: a change point\n`mode: parallel` keeps \
             it a parallelogram; a parameter, `param side: mode = …;`, and a `Tracker` follow the motion through"
        )]
    );
    let line = format!("rrr tie, second: at `theta` = {at} both assembly modes are one");
    assert!(docs.contains(&line), "{docs}");
    assert!(docs.contains("antiparallelogram"));
    for mode in ["side", "parallel"] {
        assert_eq!(told(&wiper(mode)).0, [""; 0], "{mode}");
    }
}

/// On a crank of the ground the crank's range tells it, and nothing else does.
#[test]
fn a_change_point_on_a_crank_is_noted_once() {
    let (notes, _) = told(
        "input theta: angle; ground A(0, 0), D(2m, 0);
         crank AB(A) -> B { length: 1m, angle: theta }
         rrr BC(B), DC(D) -> C { lengths: (2m, 1m), mode: left }",
    );
    assert_eq!(notes.len(), 1, "{notes:?}");
}

/// Lengths that miss the limit by a nanometre have none, and a rocker that does not come there has none.
#[test]
fn what_misses_its_limit_or_is_not_reached_is_not_noted() {
    let missed = wiper("left").replace("(600mm,", "(600.000001mm,");
    assert_eq!(told(&missed).0.iter().filter(|note| note.contains("change point")).count(), 0);
    let turned = wiper("left")
        .replace("point E on first at (10mm, -70mm)", "point E on first at (70mm, 10mm)");
    assert_eq!(told(&turned).0, [""; 0]);
}

/// Two cranks about one pivot, the second twice as fast: the angle between them is the input.
#[test]
fn a_group_between_geared_cranks_has_change_points() {
    let cranks = |lengths: &str| {
        format!(
            "input theta: angle; ground A(0, 0); crank AB(A) -> B {{ length: 1m, angle: theta }}
             crank AG(A) -> G {{ length: 3m, angle: 2 * theta }}
             rrr BC(B), GC(G) -> C {{ lengths: ({lengths}), mode: left }}"
        )
    };
    for (lengths, at) in [
        ("3m, 1m", Some("0° and 180°: a change point\n`mode: parallel` keeps it a parallelogram")),
        (
            "1m, 3m",
            Some("0° and 180°: a change point\nbehind it the mode stands for another motion"),
        ),
        ("1.5m, 2.5m", Some("180°: a change point\nbehind it")),
        ("4m, 2m", Some("0°: a change point\nbehind it")),
        ("3m, 2m", None),
    ] {
        let (notes, _) = told(&cranks(lengths));
        match at {
            Some(at) => {
                let said = format!("`BC, GC` can be assembled in one way alone at `theta` = {at}");
                assert!(notes.len() == 1 && notes[0].starts_with(&said), "{lengths}: {notes:?}");
            }
            None => assert_eq!(notes, [""; 0], "{lengths}"),
        }
    }
}

/// A bar from a rocker to a block: square to its guide, which the rocker's pivot lies on, where it is as long as the rocker's
/// point comes off the line.
#[test]
fn a_bar_on_a_rocker_has_change_points_at_its_guide() {
    let press = |length: &str| {
        format!(
            "input theta: angle; ground A(0, 0), D(-250mm, 60mm); guide bed through D along 60deg;
             crank AB(A) -> B {{ length: 45mm, angle: theta }}
             rrr rod(B), first(D) -> C {{ lengths: (290mm, 80mm), mode: left }}
             point E on first at (10mm, -70mm);
             rrp bar(E), ram(bed) -> G {{ length: {length}, mode: ahead }}"
        )
    };
    let sixth = TAU / 6.0;
    let angles = [cranks_at(sixth + 0.25 * TAU), cranks_at(sixth - 0.25 * TAU)].concat();
    assert!(!angles.is_empty(), "the rocker comes to none");
    let (notes, _) = told(&press("hypot(10mm, 70mm)"));
    let at = in_degrees(&angles);
    let said = format!("`bar, ram` can be assembled in one way alone at `theta` = {at}: a change");
    assert!(notes.len() == 1 && notes[0].starts_with(&said), "{notes:?} {said}");
    assert_eq!(told(&press("200mm")).0, [""; 0]);
}
