//! Several mistakes in one declaration.

use super::*;

#[test]
fn all_mistakes_of_a_declaration_are_reported() {
    check(&[
        (
            CRANK,
            "crank X(A) -> Y { length: l * 2, angle: t } crank X(A) -> Y { length: 0, angle: 2m \
             } rrr K(Y), L(Z) -> M { lengths: 3m }",
            "l: no input, parameter or `let` named `l` / declared so far: `t`\n\
             X#2: the name `X` is taken; choose another / the first `X` is made by `crank X`\n\
             Y#2: the name `Y` is taken; choose another / the first `Y` is made by `crank X`\n\
             0: the length of `X` is 0 m; make it greater than zero\n\
             2m: a length where an angle belongs / write `2deg`\n\
             Z: no point named `Z` / declared so far: `A`, `D`, `B`, `Y`\n\
             lengths: `lengths` takes two values; write `lengths: (…, …)` / the distances from each \
             outer joint to the pin\n\
             }#3: missing field `mode` / `left` or `right`: the side of `M` seen from `Y` looking to \
             `Z`",
        ),
        (
            NOTHING,
            "input theta: angle; input s: lenght; ground A(0, 0), D(theta, 0); crank AB(a) -> B \
             { length: 0mm, angle: theta } rrr BC(B), DC(D) -> C { lengths: (632mm, 374), mod: \
             left } rrp CE(C), block(B) -> E { length: 1m, mode: ahead } point tip on BD at \
             (1deg, 0); output blade, DC.slide;",
            "lenght: no input kind named `lenght`; one with a similar name exists: `length` / it is \
             `angle` or `length`\n\
             theta#2: a ground point is fixed; it cannot depend on an input / a point that is driven \
             is declared `point D at (x, y);`\n\
             a: no point named `a`; a point with a similar name exists: `A`\n\
             0mm: the length of `AB` is 0 m; make it greater than zero\n\
             mod: `rrr` has no field `mod`; a field with a similar name exists: `mode`\n\
             374: a length of 374 m; write `374mm`, or `374m` if it is meant / every length with a unit is much \
             shorter, and a bare number is in metres\n\
             B#3: `B` is a point, and the third letter of `rrp` is P: it needs a guide / a group \
             with a point there is `rrr`\n\
             BD: no link named `BD`; a link with a similar name exists: `BC`\n\
             1deg: an angle where a length belongs / write `1mm`\n\
             blade: no point, link or `let` named `blade`\n\
             slide: `DC` does not slide / no link of `rrr BC, DC` slides on a guide",
        ),
    ]);
}

/// A statement with a mistake uses its loads all the same.
#[test]
fn a_load_of_a_statement_in_error_is_used() {
    let mut found = String::new();
    for statement in [
        "force f on B;",
        "force (f 0) on B;",
        "force (f, 0) B;",
        "force (f, 0) on;",
        "force (f, 0) at B;",
        "force (f, 0) on Q;",
        "force (f * 1m, 0) on B;",
        "force (2 f, 0) on B;",
        "force (f, 0, 0) on B;",
        "force (f + , 0) on B;",
        "force (f, 0) in Q on B;",
        "force (f.x, 0) on B;",
        "force (-f, 0) on A;",
        "force (0, f(2)) on B;",
        "force (0, 5N(f)) on B;",
        "force f between B;",
        "force f between B and B;",
        "force f between A and D;",
        "forse (f, 0) on B;",
        "force(f, 0)on B",
        "force = f on B;",
        "Force (f, 0) on B;",
        "torque f * 1m on Q;",
        "torque 1m * f AB;",
        "let law = f + 1m; force (law, 0) on B;",
        "let law = f +; force (law, 0) on B;",
        "let law = g + f; force (law, 0) on B;",
        "spring between A and B { stiffness: f / 1m, free_length: 1m }",
        "friction f / 1N at Q radius 8mm;",
        "friction f / 1N at A;",
        "output w = f + 1m;",
        "output w = f + ;",
        "output f;",
        "output 2 * f;",
        "stop AB.angle between (0, f) { stiffness: 5(N*m) }",
        "mass f / 1(m/s^2) on B;",
        "gravity (0, f / 1kg);",
        "let law = f * 1m; rrr BC(B), DC(D) -> C { lengths: (law, 3m), mode: left }",
        "rrr BC(B), DC(D) -> C { lengths: (f / 1(N/m), 3m), mode: left }",
    ] {
        let mut diagnostics = Diagnostics::new();
        let source =
            format!("pub struct M {{ load f: force; {CRANK} mass 1kg on B; {statement} }}");
        let tree = parse(source.parse().expect("tokens"), &mut diagnostics).expect("it has a name");
        drop(resolve(&tree, &mut diagnostics));
        let mistakes = diagnostics.into_mistakes();
        let texts: Vec<_> = mistakes.iter().map(|mistake| mistake.text().to_string()).collect();
        assert!(!texts.is_empty(), "`{statement}` is legal");
        if texts.len() > 1 && texts.iter().any(|text| text.starts_with("nothing uses the load")) {
            found += &format!("{statement}: {texts:?}\n");
        }
    }
    assert!(found.is_empty(), "{found}");
}
