//! `unknown` and `solve`: every refusal at its token.

use super::*;

const SEARCH: &str = "input x: length; ground A(0, 0); guide rail through (0, 0) along 0deg; \
                      unknown theta: angle between (10deg, 170deg); \
                      crank AB(A) -> B { length: 80mm, angle: theta } \
                      rrp BC(B), ram(rail) -> C { length: 250mm, mode: ahead }";

const SOLVED: &str = "input x: length; ground A(0, 0); guide rail through (0, 0) along 0deg; \
                      unknown theta: angle between (10deg, 170deg); \
                      crank AB(A) -> B { length: 80mm, angle: theta } \
                      rrp BC(B), ram(rail) -> C { length: 250mm, mode: ahead } \
                      solve theta { ram.slide = x, mode: falling }";

#[test]
fn an_unknown_is_solved_once() {
    check(&[
        // The equation would have used the input.
        (
            SEARCH,
            "",
            "theta#1: `theta` is never solved; end its search with `solve theta { … }` / an equation \
             fixes it, as in `solve theta { ram.slide = x, mode: falling }`",
        ),
        (SEARCH, "solve theta { ram.slide = x, mode: falling }", ""),
        (
            SEARCH,
            "crank G(B) { angle: 2 * x / 1m }",
            "before theta#1: `theta` is never solved; end its search with `solve theta { … }` / an equation \
             fixes it, as in `solve theta { ram.slide = x, mode: falling }`",
        ),
        (
            SOLVED,
            "solve theta { B.y = x, mode: rising }",
            "theta: `theta` is solved already; remove this statement / one equation fixes one \
             unknown",
        ),
        (SOLVED, "solve x { B.y = 1m, mode: rising }", "x: `x` is an input, not an unknown"),
        (
            "input x: length; ground A(0, 0);",
            "crank AB(A) -> B { length: 80mm, angle: theta } \
             solve theta { B.y = x, mode: rising }",
            "theta#2: no unknown named `theta` / declare it in front of what it drives: `unknown theta: \
             angle between (…, …);`",
        ),
        (
            SEARCH,
            "unknown theta: angle between (0, 1); solve theta { ram.slide = x, mode: falling }",
            "theta#1: the name `theta` is taken; choose another / the first `theta` is made by `unknown \
             theta`",
        ),
        (
            SOLVED,
            "output theta.omega;",
            "omega: write `output theta` / `theta` is a number, and `velocity` and `motion` give its \
             rates",
        ),
        (
            SOLVED,
            "solve thta { B.y = 1m, mode: rising }",
            "thta: no unknown named `thta`; an unknown with a similar name exists: `theta`",
        ),
        (
            SEARCH,
            "unknown s: length between (0, 1m); slider other(rail) -> S { slide: s, offset: 5mm } \
             solve theta { ram.slide = x, mode: falling } \
             solve s { distance(S, B) = 1m, mode: falling }",
            "s#1: solve `theta` before this: one unknown is searched at a time / move `unknown s` \
             behind `solve theta { … }`",
        ),
        (
            SOLVED,
            "unknown s: length between (0, 1m); slider other(rail) -> S { slide: s, offset: 5mm } \
             solve s { distance(S, B) = 1m, mode: rising } output theta, s, twice = 2 * theta;",
            "",
        ),
    ]);
}

#[test]
fn ends_are_known_in_order_and_within_a_turn() {
    let start = "input x: length; param low = 10deg; param width = 3m;";
    let of = |ends: &str| {
        format!(
            "ground A(0, 0); guide rail through (0, 0) along 0deg; unknown theta: angle between {ends}; \
             crank AB(A) -> B {{ length: 80mm, angle: theta }} \
             rrp BC(B), ram(rail) -> C {{ length: 250mm, mode: ahead }} \
             solve theta {{ ram.slide = x, mode: falling }}"
        )
    };
    for (ends, expected) in [
        ("(low, 170deg)", ""),
        ("(-low, 2 * low)", ""),
        (
            "(170deg, 10deg)",
            "10deg: the ends of `theta` are not in order; write the lower one first / the lower end \
             comes first, as in `between (10deg, 170deg)`",
        ),
        (
            "(low, 10deg)",
            "10deg: the ends of `theta` are not in order; write the lower one first / the lower end \
             comes first, as in `between (10deg, low)`",
        ),
        (
            "(-200deg, 170deg)",
            "170deg: the ends of `theta` are 370° apart; stay within a turn / beyond a turn every \
             pose comes once more",
        ),
        (
            "(x / 1m, 170deg)",
            "x#1: the ends of `theta` depend on no input; write constants or parameters / the machine \
             has to be assembled from end to end, whatever the inputs are",
        ),
        ("(10mm, 170deg)", "10mm: a length where an angle belongs / write `10deg`"),
        (
            "(low, width)",
            "width: a length where an angle belongs / a length divided by a length is a number, and \
             so an angle: `s / 20mm`",
        ),
    ] {
        check(&[(start, &of(ends), expected)]);
    }
}

#[test]
fn both_ends_of_a_crank_can_be_assembled() {
    let machine = |ends: &str| {
        format!(
            "input y: length; ground A(0, 0), D(4m, 0); unknown theta: angle between {ends}; \
             crank AB(A) -> B {{ length: 2m, angle: theta }} \
             rrr BC(B), DC(D) -> C {{ lengths: (1.5m, 2m), mode: left }} \
             solve theta {{ C.y = y, mode: rising }}"
        )
    };
    // |BD|² = 20 − 16 cos θ ≤ 3.5²: θ from −61.0° to 61.0°.
    let reason = "`AB` turns from -61.028° to 61.028°";
    check(&[("", &machine("(-60deg, 61deg)"), "")]);
    for (ends, at) in [("(-62deg, 40deg)", "-62deg"), ("(10deg, 62deg)", "62deg")] {
        let expected =
            format!("{at}: at this end `BC, DC` cannot be assembled; move it in / {reason}");
        check(&[("", &machine(ends), &expected)]);
    }
}

/// A dyad behind the equation is not there while the unknown is tried: its limits are none of the search.
#[test]
fn what_stands_behind_the_equation_limits_no_end() {
    let machine = "input y: length; ground A(0, 0), D(4m, 0); unknown theta: angle between (-62deg, 62deg); \
                   crank AB(A) -> B { length: 2m, angle: theta } solve theta { B.y = y, mode: rising } \
                   rrr BC(B), DC(D) -> C { lengths: (1.5m, 2m), mode: left }";
    check(&[("", machine, "")]);
}

#[test]
fn an_equation_moves_and_has_sides_of_one_kind() {
    let reason = "what stands between `unknown theta` and `solve theta` moves with it, as far as it \
                  is built on `theta`";
    let still = |equation: &str| {
        format!(
            "{equation}: this equation does not move with `theta`; name what `theta` drives / \
             {reason}"
        )
    };
    let solve = |equation: &str| format!("solve theta {{ {equation}, mode: rising }}");
    for (equation, expected) in [
        ("x = 3 * x", still("x = 3 * x")),
        // A bar's length, whatever the crank's angle.
        ("distance(A, B) = x", still("distance(A, B) = x")),
        ("A.x + x = 20mm", still("A.x + x = 20mm")),
        (
            "ram.slide = 20deg",
            "20deg: an angle where a length belongs / what stands left of the `=` is a length"
                .to_string(),
        ),
        (
            "distance(A, C) = -1m",
            "-1m: the distance is -1 m; make it greater than zero".to_string(),
        ),
        (
            "AB.angle = x",
            "x: a length where an angle belongs / what stands left of the `=` is an angle"
                .to_string(),
        ),
        ("BC.angle - 20deg = theta + x / 1m", String::new()),
        ("offset(B, rail) = x", String::new()),
        ("C.x * C.x = x * 1m", String::new()),
        ("theta = x / 1m", String::new()),
    ] {
        check(&[(SEARCH, &solve(equation), &expected)]);
    }
}

#[test]
fn a_solve_says_its_mode_and_begins_where_nothing_depends_on_it() {
    let modes = "`rising` or `falling`: how left minus right goes at the root while the unknown \
                 grows";
    check(&[
        (SEARCH, "solve theta { ram.slide = x }", &format!("}}: missing field `mode` / {modes}")),
        (
            SEARCH,
            "solve theta { mode: rising }",
            "}: missing equation of `theta` / it comes first, as in `solve theta { ram.slide = x, \
             mode: falling }`",
        ),
        (
            SEARCH,
            "solve theta { ram.slide = x, mode: raising }",
            &format!(
                "raising: no mode named `raising`; a mode with a similar name exists: `rising` / \
                 {modes}"
            ),
        ),
        (
            SEARCH,
            "solve theta { ram.slide = x, mode: left }",
            &format!("left: no mode named `left`; write `rising` or `falling` / {modes}"),
        ),
        (SEARCH, "solve theta { ram.slide = x, mode: falling, near: x / 1m }", ""),
        (
            SEARCH,
            "solve theta { ram.slide = x, mode: falling, near: B.y / 1m }",
            "B.y / 1m: `near` cannot depend on `theta` / it says where the search begins: a \
             parameter, say, that holds the last root",
        ),
        (
            SEARCH,
            "solve theta { ram.slide = x, mode: falling, near: 3mm }",
            "3mm: a length where an angle belongs / write `3deg`",
        ),
    ]);
}

#[test]
fn efforts_beside_an_unknown_are_those_that_power_tells() {
    let reason = "what holds the equation of `solve` exerts a force as well: of `distance(P, Q) = l` a \
                  bar does, of `offset(P, guide) = h` a block, of any other equation nobody says what";
    let refused = |at: &str| {
        format!("{at}: no reactions beside `unknown theta`; ask for `x.drive` / {reason}")
    };
    let machine = |outputs: &str| {
        format!(
            "mass 2kg on BC uniform; force (0, -1) on C; \
             spring s between A and C {{ stiffness: 3, free_length: 0.1 }} {outputs}"
        )
    };
    check(&[
        (SOLVED, &machine(""), ""),
        (SOLVED, &machine("output x.drive, theta.drive, s.force, shaking, energy;"), ""),
        (SOLVED, &machine("output BC.B;"), &refused("B")),
        (SOLVED, &machine("output AB.drive;"), &refused("drive")),
        (SOLVED, &machine("output ram.rail;"), &refused("rail")),
        (
            SOLVED,
            &machine("output theta.torque;"),
            "torque: write `theta.drive` / its effort is a torque or a force, as the unknown is an \
             angle or a length",
        ),
        (
            SOLVED,
            &machine("input y: length; slider other(rail) { slide: y } output theta.drive;"),
            "theta: `theta.drive` stands for one input's, and there are several / ask for `x.drive` \
             and its like",
        ),
    ]);
}

#[test]
fn an_offset_is_that_of_a_point_from_a_guide() {
    let as_in = "as in `offset(C, rail)`; points and guides are declared by themselves";
    let rows: [(&str, String); 7] = [
        ("offset(B, rail)", String::new()),
        ("offset(D, rail)", String::new()),
        (
            "offset(rail, B)",
            "rail: `rail` is a guide; the point comes first / write `offset(P, guide)`: how far P \
             lies on the left of the guide\n\
             B: `B` is a point, and an offset is measured from a guide / between two points there \
             is `distance(P, Q)`"
                .to_string(),
        ),
        ("offset(B)", "offset: `offset` takes a point and a guide, and one is given".to_string()),
        (
            "offset(2 * B.x, rail)",
            format!("2 * B.x: an offset is that of a point; write its name / {as_in}"),
        ),
        (
            "offset(B, 20deg)",
            format!("20deg: an offset is measured from a guide; write its name / {as_in}"),
        ),
        (
            "offset(AB, rail)",
            "AB: `AB` is a link, not a point / name a joint of `AB`, or a `point` on it"
                .to_string(),
        ),
    ];
    for (value, expected) in &rows {
        check(&[(GUIDE, &format!("output o = {value};"), expected)]);
    }
}
