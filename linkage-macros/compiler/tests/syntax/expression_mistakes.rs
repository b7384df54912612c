//! Expressions and headers that do not parse.

use super::{check, check_statements};

#[test]
fn numbers() {
    const ROWS: &[(&str, &str)] = &[
        ("let x = 5 mm;", "mm: drop the space: `5mm` / a unit stands directly behind its number"),
        ("let x = 5.mm;", ".: write `5mm` / a point behind a number must be followed by a digit"),
        ("let x = 1.x;", ".: write a digit behind the decimal point"),
        (
            "let x = 2.sqrt();",
            ".: write `sqrt(2)` / a point behind a number must be followed by a digit",
        ),
        (
            "let x = 0x10;",
            "0x10: write `0x10` in decimal / a number is decimal, with its unit directly behind \
             it: `632mm`, `1e-3m`",
        ),
        (
            "let x = \"5\";",
            "\"5\": expected a number or a name, found a string / a number is decimal, with its \
             unit directly behind it: `632mm`, `1e-3m`",
        ),
        (
            "let x = 'a';",
            "'a': expected a number or a name, found a character / a number is decimal, with its \
             unit directly behind it: `632mm`, `1e-3m`",
        ),
        (
            "let x = 1e999;",
            "1e999: write a smaller exponent than in `1e999` / neither `f32` nor `f64` holds \
             such a number",
        ),
        (
            "let x = 1e999m;",
            "1e999m: write a smaller exponent than in `1e999m` / neither `f32` nor `f64` holds \
             such a number",
        ),
        (
            "let x = 0x10mm;",
            "0x10mm: write `0x10mm` in decimal / a number is decimal, with its unit directly behind \
             it: `632mm`, `1e-3m`",
        ),
    ];
    check_statements(ROWS);
}

#[test]
fn products_and_powers() {
    const ROWS: &[(&str, &str)] = &[
        ("let x = 2 pi;", "pi: expected `;`, found `pi` / a product is written with `*`"),
        ("let x = 2 (a + b);", "(: expected `;`, found `(` / a product is written with `*`"),
        (
            "let x = a ^ 2;",
            "^: expected `;`, found `^` / a power is a product or a call: `x * x`, `pow(x, 2)`",
        ),
        (
            "let x = a ** 2;",
            "*#1: expected `;`, found `**` / a power is a product or a call: `x * x`, `pow(x, 2)`",
        ),
        ("let x = a % 2;", "%: expected `;`, found `%` / the operators are `+`, `-`, `*` and `/`"),
        (
            "let x = +3;",
            "+: expected a number or a name, found `+` / a positive number has no sign",
        ),
        (
            "point P on AB at (2 cos(t), 0);",
            "cos: expected `,`, found `cos` / a product is written with `*`",
        ),
    ];
    check_statements(ROWS);
}

/// A reaction in an expression is told once a statement that none reads it; in `output` it is told how
/// it is asked for.
#[test]
fn components_of_reactions() {
    const FRICTION: &str = "a reaction follows from all forces, so none can depend on it; `friction \
                            0.1 at C radius 8mm` does, and `friction 0.1 on ram` of what slides";
    let of_a_pin = format!(
        ".#2: write `D.x` for the point; only an output reads the reaction `DC.D` / {FRICTION}"
    );
    let of_a_guide = format!(".#2: only an output reads the reaction `ram.bed` / {FRICTION}");
    let twice = format!("{of_a_guide}\n{}", of_a_guide.replace(".#2", ".#4"));
    let rows: &[(&str, &str)] = &[
        ("torque -mu * r * hypot(DC.D.x, DC.D.y) on AB;", &of_a_pin),
        ("force (-mu * ram.bed.normal, mu * ram.bed.normal) on C;", &of_a_guide),
        ("let n = ram.bed.normal;", &of_a_guide),
        ("let n = ram.bed.normal; let m = ram.bed.couple;", &twice),
        ("output DC.D.x;", ""),
        ("output r = hypot(DC.D.x, 1m);", ""),
        ("output ram.bed.normal;", ""),
    ];
    check_statements(rows);
}

#[test]
fn powers_of_units() {
    const ROWS: &[(&str, &str)] = &[
        (
            "gravity (0, -9.81m/s^2);",
            "9.81m/s^2: write `9.81(m/s^2)` / a product of units stands in parentheses",
        ),
        (
            "mass 9kg on jaw at G inertia 120kg*m^2;",
            "120kg*m^2: write `120(kg*m^2)` / a product of units stands in parentheses",
        ),
        (
            "let x = 2m * l^2;",
            "^: expected `;`, found `^` / a power is a product or a call: `x * x`, `pow(x, 2)`",
        ),
        (
            "let x = sqrt(100mm^2);",
            "^: write `100(mm^2)` / a unit's power stands in parentheses with it; that of a quantity is \
             `x * x` or `pow(x, 2)`",
        ),
        (
            "let x = sqrt(l^2);",
            "^: expected `,` or `)`, found `^` / a power is a product or a call: `x * x`, `pow(x, 2)`",
        ),
    ];
    check_statements(ROWS);
}

#[test]
fn products_of_units() {
    const ROWS: &[(&str, &str)] = &[
        ("let x = 2(a);", "(: expected `;`, found `(` / a product is written with `*`"),
        ("let x = 2(m + a);", "(: expected `;`, found `(` / a product is written with `*`"),
        (
            "let x = 2(N/m*s);",
            "*: write every `*` in front of the first `/` / units are read from left to right, and \
             `N/m*s` could mean two things",
        ),
        (
            "let x = 2(N m);",
            "m: expected `*`, `/` or `)`, found `m` / units are joined by `*` and `/`",
        ),
        ("let x = 2(m^x);", "(: expected `;`, found `(` / a product is written with `*`"),
        (
            "let x = 2(m^2.5);",
            "2.5: expected a whole number from 1 to 9, found `2.5` / as in `m^2`",
        ),
        ("let x = 2(m^99);", "99: expected a whole number from 1 to 9, found `99` / as in `m^2`"),
        ("let x = 2(N*);", "): expected a unit, found `)`"),
        (
            "let x = 2(1*s);",
            "*: expected `/`, found `*` / a leading `1` is divided by a unit: `(1/s)`",
        ),
    ];
    check_statements(ROWS);
}

#[test]
fn what_is_no_expression() {
    const ROWS: &[(&str, &str)] = &[
        (
            "let x = true;",
            "true: expected a number or a name, found `true` / `true` is a Rust keyword",
        ),
        (
            "let x = a.sqrt();",
            "sqrt: write `sqrt(a)` / expressions have functions and members, but no methods",
        ),
        (
            "let x = BC.angle();",
            "angle: write `BC.angle` without parentheses / expressions have functions and \
             members, but no methods",
        ),
        (
            "let x = std::f64::consts::PI;",
            "std: write `pi` / what Rust computes elsewhere is not known when the mechanism is \
             compiled",
        ),
        (
            "let x = foo::bar;",
            "foo: declare this number with `param` or `let` / what Rust computes elsewhere is \
             not known when the mechanism is compiled",
        ),
        (
            "let x = (1, 2);",
            ",: write one number here, not a pair / only coordinates and fields such as \
             `lengths` take two",
        ),
        (
            "let x = [1];",
            "[: expected a number or a name, found `[` / expressions are grouped by `(` and `)`",
        ),
        (
            "let x = sin(1 2, ^);",
            "2: expected `,` or `)`, found `2` / a product is written with `*`\n^: expected a \
             number or a name, found `^` / a power is a product or a call: `x * x`, `pow(x, 2)`",
        ),
        ("let x = a < b;", "<: expected `;`, found `<` / the operators are `+`, `-`, `*` and `/`"),
        ("let x = at;", "at: expected a number or a name, found `at` / `at` is a reserved word"),
        ("let x = ();", "): expected a number or a name, found `)`"),
        ("let x = a.5;", "5: expected the name of a member, such as `angle`, found `5`"),
        ("let x = (1;2);", ";#1: expected `)`, found `;`"),
    ];
    check_statements(ROWS);
}

#[test]
fn headers() {
    const ROWS: &[(&str, &str)] = &[
        ("", "the call: declare a mechanism: `pub struct Name { … }`"),
        (
            "pub",
            "the call: expected `struct`, found the end / declare a mechanism: `pub struct Name { … }`",
        ),
        ("pub struct", "the call: expected the name of the mechanism, found the end"),
        ("pub struct M;", ";: expected the statements of the mechanism in `{ }`, found `;`"),
        ("enum M {}", "enum: write `struct` instead of `enum`"),
        ("pub M { let x }", "M: write `struct` in front of `M`\n}: expected `=`, found `}`"),
        ("mechanism M {}", "mechanism: write `struct` instead of `mechanism`"),
        (
            "struct M<T> { let x }",
            "<: leave out the generic parameters / the scalar type is added to every \
             mechanism\n}: expected `=`, found `}`",
        ),
        (
            "struct type { let x }",
            "type: `type` is a Rust keyword; choose another name / names become fields and \
             arguments of the generated code\n}: expected `=`, found `}`",
        ),
        (
            "struct r#M {}",
            "r#M: `r#M` is a raw identifier; choose another name / names become fields and \
             arguments of the generated code",
        ),
        ("pub(foo) struct M {}", "pub: write `pub`, `pub(crate)` or no visibility"),
        (
            "struct M {} struct N {}",
            "struct#2: end the declaration here / a second mechanism has a `mechanism!` of its own",
        ),
        ("M", "M: expected `struct`, found `M` / declare a mechanism: `pub struct Name { … }`"),
        ("struct 5 {}", "5: expected the name of the mechanism, found `5`"),
        (
            "#[derive(Debug)] struct M {}",
            "#: leave out `#[derive]` / only doc comments are passed on to the generated code",
        ),
        (
            "fn foo() {}",
            "fn: expected `struct`, found `fn` / declare a mechanism: `pub struct Name { … }`",
        ),
    ];
    check(ROWS, super::mistakes);
}
