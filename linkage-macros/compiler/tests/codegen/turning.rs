//! The documentation of a crank's range, compared with where the solver assembles.

use super::{generate, line_by_line};
use crate::ir::interpret::{ProgramValues, interpret};
use crate::oracle::mechanism;
use crate::reach::turn::Range;
use crate::{equations, passes};

/// A crank AB of 1 m on A(0, 0), turned by `theta`, with what else is declared.
fn on_a_crank(rest: &str) -> String {
    format!(
        "pub struct M {{ input theta: angle; ground A(0, 0);
         crank AB(A) -> B {{ length: 1m, angle: theta }} {rest} }}"
    )
}

/// Two bars of these lengths from B to D.
fn two_bars(d: &str, lengths: &str) -> String {
    on_a_crank(&format!("ground D{d}; rrr BC(B), DC(D) -> C {{ lengths: {lengths}, mode: left }}"))
}

/// A bar and a block whose pin runs along a line through K.
fn bar_and_block(line: &str, fields: &str) -> String {
    on_a_crank(&format!(
        "guide rail {line}; rrp BC(B), block(rail) -> C {{ {fields}, mode: ahead }}"
    ))
}

/// The documented range of the first dyad.
fn said(source: &str) -> String {
    let mechanism = mechanism(source);
    let program = passes::optimise(&equations::derive(&mechanism, passes::RULES));
    let file = super::file(line_by_line(generate(&mechanism, &program)));
    let text = prettyplease::unparse(&file).replace("\n///   ", " ");
    let line = text.split_once("# Range\n/// - ").map(|(_, rest)| rest.lines().next());
    line.flatten().unwrap_or_default().to_string()
}

/// A test that the solver assembles the mechanism at an angle in degrees.
fn assembles(source: &str) -> impl Fn(f64) -> bool {
    let mechanism = mechanism(source);
    let program = passes::optimise(&equations::derive(&mechanism, passes::RULES));
    move |degrees: f64| {
        let inputs = vec![[degrees.to_radians(), 0.0, 0.0]];
        let given = ProgramValues {
            inputs,
            params: Vec::new(),
            loads: Vec::new(),
            drives: Vec::new(),
            unit: None,
        };
        let values = interpret(&program, &given);
        let entry = program.answer("position");
        let sinks = &entry.expect("there is a position").sinks;
        sinks.iter().all(|sink| values[sink.index()].is_finite())
    }
}

/// The stated range holds the angles at which the solver assembles, and no others.
fn agrees_with_the_solver(source: &str) {
    let (assembles, mechanism) = (assembles(source), mechanism(source));
    let range = &mechanism.rotatabilities.first().expect("something is said").turn.range;
    // Steps that meet no limit of the cases below.
    for step in 0..3600 {
        let angle = f64::from(step) * 0.1 + 0.037;
        let inside = match range {
            Range::Full => true,
            Range::Within(intervals) => {
                intervals.iter().any(|[from, to]| (angle - from).rem_euclid(360.0) < to - from)
            }
            Range::Never => false,
        };
        assert_eq!(assembles(angle), inside, "{angle}° in {range:?} of {source}");
    }
}

#[test]
fn a_crank_rocker_turns_fully() {
    let source = two_bars("(3m, 0)", "(2.5m, 1.75m)");
    assert_eq!(
        said(&source),
        "rrr BC, DC: `AB` turns fully; |BD| runs from 2 m to 4 m, and the bars reach from 0.75 m \
         to 4.25 m"
    );
    agrees_with_the_solver(&source);
}

#[test]
fn a_rocker_that_cannot_stretch_further_has_one_range() {
    // cos 60° = (1 + 4 - 3) / 4
    let source = two_bars("(2m, 0)", "(0.75m, sqrt(3) * 1m - 0.75m)");
    let expected = "rrr BC, DC: `theta` from -60° to 60°; |BD| runs from 1 m to 3 m";
    assert!(said(&source).starts_with(expected), "{}", said(&source));
    agrees_with_the_solver(&source);
}

#[test]
fn a_rocker_that_cannot_fold_further_has_the_rest_of_the_turn() {
    // cos 60° again, for the difference of the lengths.
    let source = two_bars("(2m, 0)", "(2m + sqrt(3) * 1m, 2m)");
    let expected = "rrr BC, DC: `theta` from 60° to 300°; |BD| runs from 1 m to 3 m";
    assert!(said(&source).starts_with(expected), "{}", said(&source));
    agrees_with_the_solver(&source);
}

#[test]
fn the_ends_are_said_to_be_dead_points_where_there_is_forward_dynamics() {
    const DEAD: &str =
        "The ends are dead points of `theta`: `forward_dynamics` is `Singular` there";
    let bars = |lengths: &str, mass: &str| {
        on_a_crank(&format!(
            "ground D(2m, 0); rrr BC(B), DC(D) -> C {{ lengths: {lengths}, mode: left }} {mass}"
        ))
    };
    let (rocker, crank) = ("(0.75m, 0.9m)", "(2.2m, 1.5m)");
    let said = |lengths, mass| said(&bars(lengths, mass));
    assert!(said(rocker, "mass 1kg on C;").contains(DEAD));
    assert!(!said(rocker, "").contains("dead points"), "nobody asks for accelerations");
    assert!(!said(crank, "mass 1kg on C;").contains("dead points"), "it turns fully");
}

#[test]
fn a_triple_rocker_has_two_ranges() {
    // |BD|² = 2.44 - 2.4 cos θ is 0.25 at 24.15° and 2.25 at 85.46°.
    let source = two_bars("(1.2m, 0)", "(1m, 0.5m)");
    let (said, ranges) =
        (said(&source), "`theta` from -85.46° to -24.15° or from 24.15° to 85.46°");
    assert!(said.contains(ranges), "{said}");
    agrees_with_the_solver(&source);
}

#[test]
fn a_range_turns_with_the_line_of_the_pivots() {
    let source = two_bars("(0, 2m)", "(0.75m, sqrt(3) * 1m - 0.75m)");
    assert!(said(&source).contains("`theta` from 30° to 150°"), "{}", said(&source));
    agrees_with_the_solver(&source);
    for d in ["(-1.1m, -0.7m)", "(-2m, 0.3m)", "(0.4m, -1.9m)"] {
        agrees_with_the_solver(&two_bars(d, "(1m, 0.75m)"));
    }
}

#[test]
fn pivots_on_one_place_leave_all_or_nothing() {
    agrees_with_the_solver(&two_bars("(0, 0)", "(1m, 0.75m)"));
}

#[test]
fn a_parallelogram_is_pointed_to_its_idiom() {
    let source = two_bars("(2m, 0)", "(2m, 1m)");
    let said = said(&source);
    assert!(said.starts_with("rrr BC, DC: `AB` turns fully;"), "{said}");
    assert!(said.contains("At `theta` = 0° and 180° both assembly modes are one"), "{said}");
    assert!(said.ends_with("`mode: parallel` keeps it one"), "{said}");
    agrees_with_the_solver(&source);
}

#[test]
fn a_kite_is_no_parallelogram_but_has_its_change_points() {
    let source = two_bars("(2m, 0)", "(1m, 2m)");
    let said = said(&source);
    assert!(said.contains("At `theta` = 0° and 180° both assembly modes are one"), "{said}");
    assert!(!said.contains("parallelogram"), "{said}");
    agrees_with_the_solver(&source);
}

/// One pair of sides of the same length makes no parallelogram, although the bars reach their limit.
#[test]
fn one_pair_of_equal_sides_is_no_parallelogram() {
    // |0.5 m - 1 m| = |1.5 m - 1 m|, and |2 m - 1 m| = |2 m - 3 m|.
    for (d, lengths) in [("(0.5m, 0)", "(1.5m, 1m)"), ("(2m, 0)", "(2m, 3m)")] {
        let source = two_bars(d, lengths);
        let said = said(&source);
        assert!(said.contains("At `theta` = 0° both assembly modes are one"), "{said}");
        assert!(!said.contains("parallel"), "{said}");
        agrees_with_the_solver(&source);
    }
}

/// Where a motion under forces may be integrated over a change point, the docs say what to do.
#[test]
fn a_change_point_of_a_motion_under_forces_is_pointed_to_the_tracker() {
    let lengths = "(2m, 1m)";
    let still = said(&two_bars("(2m, 0)", lengths));
    assert!(!still.contains("state_rates"), "{still}");
    let falling = two_bars("(2m, 0)", lengths).replace("ground D", "mass 1kg on B; ground D");
    assert!(said(&falling).contains("ask through `Tracker::follow`"), "{}", said(&falling));
    let clear = two_bars("(3m, 0)", "(2.5m, 2m)").replace("ground D", "mass 1kg on B; ground D");
    assert!(!said(&clear).contains("Tracker::follow"), "{}", said(&clear));
}

#[test]
fn one_change_point_is_found_where_the_lengths_just_reach() {
    // 1 m + 3 m = 2.5 m + 1.5 m, exactly.
    let source = two_bars("(3m, 0)", "(2.5m, 1.5m)");
    assert!(said(&source).contains("At `theta` = 180° both"), "{}", said(&source));
    let source = two_bars("(3m, 0)", "(2.5m, 1.499999999999999m)");
    assert!(!said(&source).contains("both"), "{}", said(&source));
    assert!(matches!(mechanism(&source).rotatabilities[0].turn.range, Range::Within(_)));
}

#[test]
fn a_slider_crank_turns_fully() {
    let source = bar_and_block("through A along 0deg", "length: 3m");
    assert_eq!(
        said(&source),
        "rrp BC, block: `AB` turns fully; B runs from -1 m to 1 m off the line of the pin, and \
         the bar reaches 3 m"
    );
    agrees_with_the_solver(&source);
}

#[test]
fn a_line_too_far_off_limits_the_crank() {
    // The bar reaches 0.5 m below a line 1 m above A: sin θ ≥ 1/2.
    let source = bar_and_block("through (0, 1m) along 0deg", "length: 0.5m");
    assert!(said(&source).contains("`theta` from 30° to 150°"), "{}", said(&source));
    agrees_with_the_solver(&source);
    // The same line, given by an offset, in another direction and from two points.
    let offset = bar_and_block("through A along 0deg", "length: 0.5m, offset: 1m");
    assert!(said(&offset).contains("`theta` from 30° to 150°"), "{}", said(&offset));
    let towards = on_a_crank(
        "ground K(1m, 1m), L(0, 1m); guide rail through K towards L;
         rrp BC(B), block(rail) -> C { length: 0.5m, mode: ahead }",
    );
    assert!(said(&towards).contains("`theta` from 30° to 150°"), "{}", said(&towards));
    for line in ["along 35deg", "along 100deg", "along -160deg"] {
        agrees_with_the_solver(&bar_and_block(
            &format!("through (0.1m, -0.2m) {line}"),
            "length: 0.7m, offset: 0.05m",
        ));
    }
}

#[test]
fn an_isosceles_slider_crank_has_two_change_points() {
    let source = bar_and_block("through A along 30deg", "length: 1m");
    assert!(said(&source).contains("At `theta` = 120° and -60° both"), "{}", said(&source));
}

#[test]
fn an_angle_that_is_no_bare_input_is_the_cranks() {
    let source = "pub struct M { input theta: angle; ground A(0, 0), D(2m, 0);
        crank AB(A) -> B { length: 1m, angle: 2 * theta + 10deg }
        rrr DC(D), BC(B) -> C { lengths: (sqrt(3) * 1m - 0.75m, 0.75m), mode: left } }";
    assert!(said(source).contains("`AB.angle` from -60° to 60°"), "{}", said(source));
}

#[test]
fn nothing_is_said_of_what_depends_on_more_than_the_crank() {
    for rest in [
        "param l = 2m; ground D(3m, 0); rrr BC(B), DC(D) -> C { lengths: (l, 2m), mode: left }",
        "input s: length; ground D(3m, 0);
         rrr BC(B), DC(D) -> C { lengths: (2m + s, 2m), mode: left }",
        "point D at (3m, theta * 1m); rrr BC(B), DC(D) -> C { lengths: (3m, 2m), mode: left }",
    ] {
        assert_eq!(said(&on_a_crank(rest)), "", "{rest}");
    }
}
