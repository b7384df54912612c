//! `unknown` and `solve`: trees, and what does not parse.

use super::*;

#[test]
fn unknowns_and_equations_have_trees() {
    for (written, tree) in [
        ("unknown theta: angle between (10deg, hi);", "unknown theta: angle between (10deg, hi)"),
        (
            "solve theta { ram.slide = x + 2mm, mode: falling, near: seed }",
            "solve theta { ram.slide = (x + 2mm), mode: falling, near: seed }",
        ),
        // In any order, and with a comma or a semicolon at the end.
        (
            "solve s { mode: rising, distance(P, Q) = 2m, };",
            "solve s { distance(P, Q) = 2m, mode: rising }",
        ),
    ] {
        let (found, mistakes) = body(written);
        assert_eq!((found.as_str(), mistakes.as_str()), (tree, ""), "{written}");
    }
}

#[test]
fn unknowns_and_equations_that_do_not_parse() {
    const UNKNOWN: &str = "an unknown is `unknown theta: angle between (10deg, 170deg);`";
    const SOLVE: &str = "it reads `solve theta { ram.slide = x, mode: falling }`";
    check_statements(&[
        (
            "unknown theta;",
            ";: say what `theta` is: `unknown theta: angle between (…, …)` / its kind tells \
             radians from metres",
        ),
        ("unknown theta: angle;", &format!(";: expected `between (…, …)`, found `;` / {UNKNOWN}")),
        (
            "unknown theta: angle between 10deg;",
            &format!("10deg: expected `(from, to)`, found `10deg` / {UNKNOWN}"),
        ),
        (
            "unknown theta: angle between (0, 1), near 0.5;",
            "near: write `near: …` in `solve theta { … }` / where a search begins may depend on what \
             stands between the two",
        ),
        ("solve theta { a = b, falling }", "falling: write `mode: falling`"),
        ("solve theta;", &format!(";: expected `{{`, found `;` / {SOLVE}")),
        (
            "solve theta { ram.slide == x, mode: rising }",
            "=#1: write `=`: it is an equation, not a comparison",
        ),
        (
            "solve theta { ram.slide, mode: rising }",
            &format!(",: expected `=`, found `,` / {SOLVE}"),
        ),
        (
            "solve theta { a = b, c = d, mode: rising }",
            "c: one equation fixes `theta`; remove this one / each unknown has an equation of its \
             own",
        ),
        (
            "solve theta { a = b, mode: rising, mode: falling }",
            "mode#2: the field `mode` is given twice; remove one",
        ),
        (
            "solve theta { a = b, mode: rising, seed: c }",
            "seed: `solve` has no field `seed` / its fields are `mode`, `rising` or `falling`, and \
             `near`, where to begin",
        ),
        ("solve theta { a = b; mode: rising }", ";: expected `,` or `}`, found `;`"),
    ]);
}
