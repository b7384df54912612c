//! Statements that do not parse: per row the source, then per mistake the token at which it is
//! reported, the message, and behind ` / ` its second line.

use super::check_statements;

#[test]
fn inputs_parameters_and_values() {
    const ROWS: &[(&str, &str)] = &[
        ("input : angle;", ":: expected the name of an input, found `:`"),
        (
            "input { a = AB.angle }",
            "{: expected the name of an input, found `{` / a set of inputs has a name: `input \
             motors { … }`",
        ),
        (
            "input theta;",
            ";: say what `theta` is: `input theta: angle;` or `input theta: length;` / its kind \
             tells radians from metres",
        ),
        (
            "input theta: angle, s: length;",
            ",: end this statement with `;` / inputs of another kind have a statement of their \
             own",
        ),
        (
            "input theta: angle = 3;",
            "=: write `param` for a number with a default / an input is an argument of every \
             call",
        ),
        ("input s x: length;", "x: write `,` in front of `x`"),
        (
            "param l;",
            ";: give `l` a default: `param l = …;` / `new()` sets every parameter to its default",
        ),
        (
            "param l: length;",
            ";: give `l` a default: `param l = …;` / `new()` sets every parameter to its default",
        ),
        ("param l: = 5;", "=: expected `mode`, `length`, `angle` or `number`, found `=`"),
        (
            "param l 5;",
            "5: give `l` a default: `param l = …;` / `new()` sets every parameter to its default",
        ),
        (
            "let half: length = 2;",
            ":: write `let half = …;` / the kind of a value follows from its expression",
        ),
        ("let half;", ";: expected `=`, found `;`"),
        ("let half = ;", ";: expected a number or a name, found `;`"),
        ("let half = 1 +;", ";: expected a number or a name, found `;`"),
        (
            "input theta: angle/s;",
            "/: end this statement behind `angle` / rates are no inputs of their own: `velocity` and \
             `motion` take them",
        ),
        ("let = 3m;", "=: expected the name of a value, found `=`"),
    ];
    check_statements(ROWS);
}

#[test]
fn names_that_cannot_be_given() {
    const ROWS: &[(&str, &str)] = &[
        (
            "input type: angle;",
            "type: `type` is a Rust keyword; choose another name / names become fields and \
             arguments of the generated code",
        ),
        (
            "input r#foo: angle;",
            "r#foo: `r#foo` is a raw identifier; choose another name / names become fields and \
             arguments of the generated code",
        ),
        (
            "let mass = 1;",
            "mass: `mass` is a reserved word; choose another name / statements of this and of \
             later versions are made of it",
        ),
        (
            "let at = 1;",
            "at: `at` is a reserved word; choose another name / statements of this and of later \
             versions are made of it",
        ),
        (
            "let in = 1;",
            "in: `in` is a Rust keyword; choose another name / names become fields and arguments \
             of the generated code",
        ),
        (
            "let pi = 3;",
            "pi: `pi` already has a meaning; choose another name / expressions and fields could \
             not tell the two apart",
        ),
        (
            "let _ = 3;",
            "_: `_` is not a name; choose one / names become fields and arguments of the \
             generated code",
        ),
        (
            "point ground at (0,0);",
            "ground: `ground` already has a meaning; choose another name / expressions and \
             fields could not tell the two apart",
        ),
        ("input 5: angle;", "5: expected the name of an input, found `5`"),
        (
            "crank AB(A) -> in {}",
            "in: `in` is a Rust keyword; choose another name / names become fields and arguments \
             of the generated code",
        ),
        (
            "output type = 3;",
            "type: `type` is a Rust keyword; choose another name / names become fields and \
             arguments of the generated code",
        ),
        (
            "ground left(0, 1m);",
            "left: `left` already has a meaning; choose another name / expressions and fields could not \
             tell the two apart",
        ),
    ];
    check_statements(ROWS);
}

#[test]
fn fixed_points() {
    const ROWS: &[(&str, &str)] = &[
        ("ground A;", ";: write `A(x, y)`"),
        ("ground A at (0, 0);", "at: write `A(x, y)`"),
        ("ground A(0);", "): expected `,` and a second value, found `)` / write `(x, y)`"),
        ("ground A();", "): expected two values, found `)` / write `(x, y)`"),
        ("ground A(0,);", "): expected a second value, found `)` / write `(x, y)`"),
        ("ground A(0, 1, 2);", "2: expected `)` after two values, found `2` / write `(x, y)`"),
        ("ground A(0 1);", "1: expected `,` and a second value, found `1` / write `(x, y)`"),
        ("ground A(0,0) D(1,0);", "D: write `,` in front of `D`"),
        ("ground (0,0);", "(: expected the name of a point, found `(`"),
        ("ground A(0,0), 5;", "5: expected the name of a point, found `5`"),
        (
            "ground A(*, +3);",
            "*: expected a number or a name, found `*`\n+: expected a number or a name, found \
             `+` / a positive number has no sign",
        ),
    ];
    check_statements(ROWS);
}

#[test]
fn guides() {
    const ROWS: &[(&str, &str)] = &[
        (
            "guide rail;",
            ";: expected `through`, found `;` / a guide is a point and a direction: `through (x, \
             y) along 0deg` or `through A towards D`",
        ),
        ("guide rail through along 0;", "along: expected the name of a point, found `along`"),
        (
            "guide rail through (0,0);",
            ";: expected `along` or `towards`, found `;` / a guide is a point and a direction: \
             `through (x, y) along 0deg` or `through A towards D`",
        ),
        (
            "guide rail through (0,0) toward D;",
            "toward: expected `along` or `towards`, found `toward` / a guide is a point and a \
             direction: `through (x, y) along 0deg` or `through A towards D`",
        ),
        (
            "guide rail (0,0) along 0;",
            "(: expected `through`, found `(` / a guide is a point and a direction: `through (x, \
             y) along 0deg` or `through A towards D`",
        ),
        (
            "guide rail on through (0,0) along 0;",
            "through: expected the name of a link, found `through`",
        ),
        ("guide rail through A along;", ";: expected a number or a name, found `;`"),
        ("guide rail through A towards 5;", "5: expected the name of a point, found `5`"),
        (
            "guide rail through [0,0] along 0;",
            "[: expected a point or `(x, y)`, found `[` / a guide is a point and a direction: \
             `through (x, y) along 0deg` or `through A towards D`",
        ),
        (
            "guide rail along 0;",
            "along: expected `through`, found `along` / a guide is a point and a direction: `through \
             (x, y) along 0deg` or `through A towards D`",
        ),
    ];
    check_statements(ROWS);
}

#[test]
fn points_on_links() {
    const ROWS: &[(&str, &str)] = &[
        (
            "point P;",
            ";: expected `on` or `at`, found `;` / a place is `at (x, y)`, `at polar (r, angle)` \
             or `at distances (r1, r2) left`",
        ),
        (
            "point P(0,0);",
            "(: write `point P on LINK at (x, y)` / a fixed point is declared by `ground`",
        ),
        (
            "point P on BC;",
            ";: expected `at`, found `;` / a place is `at (x, y)`, `at polar (r, angle)` or `at \
             distances (r1, r2) left`",
        ),
        (
            "point P on BC at 5;",
            "5: expected `(x, y)`, `polar` or `distances`, found `5` / a place is `at (x, y)`, \
             `at polar (r, angle)` or `at distances (r1, r2) left`",
        ),
        (
            "point P on BC at distances (1,2);",
            ";: expected `left` or `right`, found `;` / two places have these distances, one on \
             either side of the link",
        ),
        (
            "point P on BC at distances (1,2) crank AB(A) {}",
            "crank: expected `left` or `right`, found `crank` / two places have these distances, \
             one on either side of the link",
        ),
        ("point P on at (1,2);", "at: expected the name of a link, found `at`"),
        ("point P at polar 5;", "5: expected `(r, angle)`, found `5`"),
        ("point P at (0,0) foo;", "foo: expected `;`, found `foo`"),
        (
            "point P on BC at (1, 2), Q on BC at (1,2);",
            ",#2: expected `;`, found `,` / this statement declares one name",
        ),
        ("numerics: fast;", ":: expected `compensated`, found `:`"),
        (
            "numerics fast, compensated;",
            ",: expected `;`, found `,` / `numerics` takes one word, for numbers of any width",
        ),
        (
            "numerics fast f32;",
            "f32: expected `;`, found `f32` / `numerics` takes one word, for numbers of any width",
        ),
        ("numerics fast crank AB(A) {}", "fast: write `;` after `fast`"),
        (
            "compensated;",
            "compensated: no statement begins with `compensated` / what is meant may be \
             `numerics compensated;`",
        ),
    ];
    check_statements(ROWS);
}

#[test]
fn habits_from_elsewhere() {
    const ROWS: &[(&str, &str)] = &[
        (
            "use std::f64::consts::PI;",
            "use: no statement begins with `use` / names of the crate are not known in here; `pi` \
             is, and other numbers are declared: `param l = …`",
        ),
        (
            "leg!(B);",
            "leg: no statement begins with `leg` / macros are not expanded in here; let a \
             `macro_rules!` write all of `mechanism!`",
        ),
        (
            "ground A(0, 0), crank AB(A) -> B { length: 1m, angle: t }",
            ",#2: write `;` in place of this `,`",
        ),
        ("output B, ground A(0, 0);", ",#1: write `;` in place of this `,`"),
        (
            "let mut x = 2m;",
            "mut: leave out `mut` / what is declared does not change; a `param` can be set at run \
             time",
        ),
        ("# a comment\noutput B;", "#: write `//` in front of a comment"),
        (
            "point upper-blade on BC at (1m, 0);",
            "upper-blade: write `upper_blade` / a `-` in a name would be a difference",
        ),
        ("let x = .08m;", ".: write `0.08m` / a digit stands in front of the decimal point"),
        (
            "let d = |B - D|;",
            "|#1: expected a number or a name, found `|` / a distance is written `distance(P, Q)`",
        ),
    ];
    check_statements(ROWS);
}

#[test]
fn links_of_drawings() {
    const ROWS: &[(&str, &str)] = &[
        (
            "link lift(F, G) length: s;",
            "length: the length of a link stands in braces / write `link lift(F, G) { length: s }`",
        ),
        (
            "link lift;",
            ";: write the pins of `lift`: `lift(B, C)` / a link is named with the pins through it, its \
             first one in front: `link BC(B, C);`",
        ),
    ];
    check_statements(ROWS);
}
