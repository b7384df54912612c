//! Groups and settings that do not parse, and words that begin no statement.

use super::check_statements;

#[test]
fn legs_and_pins() {
    const ROWS: &[(&str, &str)] = &[
        (
            "crank AB -> B { length: 1 }",
            "-: write what `AB` stands on: `AB(JOINT)` / an outer joint is a point where the \
             letter says R, a guide where it says P",
        ),
        (
            "crank AB() -> B { }",
            "): expected the name of a point or a guide, found `)` / points are declared by \
             `ground` or made by groups, guides by `guide`",
        ),
        (
            "crank AB(A, B) -> C {}",
            "B: expected `)`, found `B` / a leg is one link and its one outer joint",
        ),
        (
            "crank AB(0, 0) -> B {}",
            "0#1: expected the name of a point or a guide, found `0` / points are declared by \
             `ground` or made by groups, guides by `guide`",
        ),
        ("crank AB(A) => B {}", "=: write `->` / it points to the pin that is made"),
        ("crank AB(A) > B {}", ">: write `->` / it points to the pin that is made"),
        ("crank AB(A) -> B, C {}", ",: expected `{`, found `,` / a group has one inner joint"),
        ("crank AB(A) -> {}", "{: expected the name of a pin, found `{`"),
        (
            "crank (A) -> B { length = 3 }",
            "(: expected the name of a link, found `(`\n=: write `:` after `length`",
        ),
        ("crank AB(at) {}", "at: expected the name of a point or a guide, found `at`"),
        (
            "rrr BC(AB.B), DC(D) -> C {}",
            ".: write the joint without its link: `B` / points, links and guides have one name space",
        ),
        ("rrr BC(B) + DC(D) -> C {}", "+: write `,` between the links"),
        ("rrr BC(B) DC(D) -> C {}", "DC: write `,` in front of `DC`"),
    ];
    check_statements(ROWS);
}

#[test]
fn braces_and_fields() {
    const ROWS: &[(&str, &str)] = &[
        (
            "crank AB(A) -> B;",
            ";: expected `{`, found `;` / write the fields of `crank` in braces: `{ length: …, \
             angle: … }`",
        ),
        (
            "crank AB(A) -> B",
            "after }: expected `{`, found `}` / write the fields of `crank` in braces: `{ length: …, \
             angle: … }`",
        ),
        (
            "crank AB(A) -> B (length: 80mm);",
            "(#2: expected `{`, found `(` / write the fields in braces",
        ),
        ("crank AB(A) { length }", "length: write `length: …`"),
        ("crank AB(A) { length = 80mm, angle: 3 }", "=: write `:` after `length`"),
        ("crank AB(A) { length: , angle: 3 }", ",: expected the value of `length`, found `,`"),
        ("crank AB(A) { length: 80mm angle: theta }", "angle: write `,` in front of `angle`"),
        (
            "crank AB(A) { length: 80mm; angle: theta }",
            ";: write `,` / fields are separated by commas",
        ),
        (
            "crank AB(A) { length: 80mm foo, angle: + }",
            "foo: expected `,` or `}`, found `foo` / a product is written with `*`\n+: expected \
             a number or a name, found `+` / a positive number has no sign",
        ),
        (
            "crank AB(A) { length: (1,2) * 3, x: (1,2,3), y: ( ,1), z: (), 5: 3 }",
            "*: expected `,` or `}`, found `*`\n3#2: expected `)` after two values, found `3` / \
             write `(first, second)`\n,#6: expected a number or a name, found `,`\n)#5: expected a \
             number or a name, found `)`\n5: expected the name of a field, found `5`",
        ),
        (
            "crank AB(A) { /// doc\n length: 3 }",
            "/// doc: move the doc comment in front of its statement",
        ),
        ("crank AB(A) { length: 5, , angle: 3 }", ",#2: expected the name of a field, found `,`"),
        (
            "rrr BC(B), DC(D) -> C lengths: (3m, 3m), mode: left;",
            "lengths: expected `{`, found `lengths` / write the fields of `rrr` in braces: `{ lengths: \
             (…, …), mode: … }`",
        ),
        (
            "rrr BC(B), DC(D) -> C { lengths (3m, 3m), mode = left }",
            "(#3: write `:` after `lengths`\n=: write `:` after `mode`",
        ),
    ];
    check_statements(ROWS);
}

#[test]
fn outputs_and_settings() {
    const ROWS: &[(&str, &str)] = &[
        (
            "output;",
            ";: name what to compute: `output blade, BC.angle;` / without this statement every \
             moving point and link is computed",
        ),
        (
            "output all;",
            "all: leave this statement out / without `output` every moving point and link is \
             computed",
        ),
        ("output a b;", "b: write `,` in front of `b`"),
        ("output fold = ;", ";: expected a number or a name, found `;`"),
        ("output a, = 3;", "=: expected a number or a name, found `=`"),
        (
            "output A.x.y;",
            ".#2: expected the end of a member, found `.` / a member is one name behind a \
             link: `BC.angle`",
        ),
        ("output beam.S.x;", ""),
        (
            "let brake = 3 * H.y.rate;",
            ".#2: write `rate(H.y)` / in the values of forces and torques; of outputs, `velocity` gives \
             the rates",
        ),
        ("numerics;", ";: expected `compensated`, found `;`"),
        ("crate = \"x\";", "\"x\": write the path of `linkage-core`: `crate = ::linkage_core;`"),
        ("crate;", ";: write the path of `linkage-core`: `crate = ::linkage_core;`"),
        ("crate = ::Self;", ":#1: write the path of `linkage-core`: `crate = ::linkage_core;`"),
        ("crate = a<u8>;", "a: write the path of `linkage-core`: `crate = ::linkage_core;`"),
        ("crate = a::self;", "a: write the path of `linkage-core`: `crate = ::linkage_core;`"),
        ("crate = ::crate;", ":#1: write the path of `linkage-core`: `crate = ::linkage_core;`"),
        ("crate = super::super::a;", ""),
        ("crate::foo;", ":#1: write the path of `linkage-core`: `crate = ::linkage_core;`"),
        ("export \"c\";", "\"c\": expected `c` or `assemblies`, found `\"c\"`"),
        (
            "output *;",
            "*: leave this statement out / without `output` every moving point and link is computed",
        ),
    ];
    check_statements(ROWS);
}

#[test]
fn words_that_begin_no_statement() {
    const ROWS: &[(&str, &str)] = &[
        (
            "damper BC { }",
            "damper: `damper` is reserved for a later statement / a damper is a spring without \
             stiffness: `spring between P and Q { damping: 10(N*s/m) }`",
        ),
        (
            "D(1m, 0);",
            "D: no statement begins with `D` / ground points stand in one statement, with commas: \
             `ground A(0, 0), D(1m, 0);`",
        ),
        (
            "point P on left-lever at (1m, 0);",
            "left-lever: write `left_lever` / a `-` in a name would be a difference",
        ),
        ("triad s(A) {}", "triad: `triad` is reserved for a later statement"),
        (
            "gorund A(0, 0);",
            "gorund: no statement begins with `gorund` / a statement with a similar name exists: \
             `ground`",
        ),
        (
            "gruond A(x);",
            "gruond: no statement begins with `gruond` / a statement with a similar name exists: \
             `ground`",
        ),
        ("const x = 3;", "const: no statement begins with `const` / what is meant may be `let`"),
        (
            "fixed A(0,0);",
            "fixed: no statement begins with `fixed` / what is meant may be `ground`",
        ),
        (
            "anchor A(0,0);",
            "anchor: no statement begins with `anchor` / what is meant may be `ground`",
        ),
        (
            "foo;",
            "foo: no statement begins with `foo` / statements are `input`, `param`, `let`, \
             `ground`, `guide`, `point`, `output` and the groups `crank`, `slider`, `rrr`, `rrp`, \
             `rpr`, `prp`, `rpp`; others are about drawings, unknowns and forces",
        ),
        (
            "BC(B), DC(D) -> C { }",
            "BC: no statement begins with `BC` / a group begins with its keyword: `rrr BC(B), \
             DC(D) -> C { … }`",
        ),
        ("5;", "5: expected a statement, found `5`"),
        (
            "#[allow(foo)] let x = 3;",
            "#: leave out `#[allow]` / only doc comments are passed on to the generated code",
        ),
        ("//! x\n let x = 3;", "//! x: write `///` in front of what is documented"),
        ("/// doc\n", "after }: write a statement behind this doc comment, or drop it"),
        (
            "find x { a = b }",
            "find: no statement begins with `find` / what is meant may be `solve`",
        ),
        (
            "pub input t: angle;",
            "pub: no statement begins with `pub` / leave it out: parameters and results are public",
        ),
    ];
    check_statements(ROWS);
}

#[test]
fn missing_semicolons() {
    const ROWS: &[(&str, &str)] = &[
        (
            "input theta: angle ground A(0,0); let x = 3",
            "angle: write `;` after `angle`\n3: write `;` after `3`",
        ),
        ("input theta: angle\n crank AB(A) {}", "angle: write `;` after `angle`"),
        ("let x = 3 /// d\n let y = 3;", "3#1: write `;` after `3`"),
        (
            "input theta: angle crank AB(A) { length: }",
            "angle: write `;` after `angle`\n}: expected the value of `length`, found `}`",
        ),
    ];
    check_statements(ROWS);
}

#[test]
fn habits_from_elsewhere() {
    const ROWS: &[(&str, &str)] = &[
        (
            "crank AB(A) -> B { length: 0,08m, angle: t }",
            "0: write `0.08m` / decimals stand behind a point",
        ),
        (
            "crank AB(A) -> B { length: .08m, angle: t }",
            ".: write `0.08m` / a digit stands in front of the decimal point",
        ),
        (
            "rrr BC(B), DC(D) -> C { lengths: [632mm, 374mm], mode: left }",
            "[: write `(` and `)` in place of the brackets / two values of a field stand in parentheses",
        ),
        (
            "rrr BC(B), DC(D) -> C { lengths: 632mm, 374mm, mode: left }",
            "lengths: write `lengths: (…, …)` / two values of a field stand in parentheses",
        ),
        (
            "rrr BC(B), DC(D) -> C { mode: left, lengths: 2 * 0.3m, 374mm }",
            "lengths: write `lengths: (…, …)` / two values of a field stand in parentheses",
        ),
        (
            "rrr BC(B), DC(D) -> C { lengths: (1m, 1m), mode: Side::Left }",
            "Side: write `left` / a mode is one word",
        ),
        (
            "rrr BC(B), DC(D) -> C { lengths: (1m, 1m), mode: \"left\" }",
            "\"left\": write `left` without quotes / there are no strings here",
        ),
        (
            "crank AB(A) {}, output B;",
            ",: leave out this `,` / a group ends with its braces, every other statement with `;`",
        ),
        // The model reports the mistakes in these, once.
        ("rrr BC(B), DC(D) -> C { lengths: (1m, 1m), mode: +1 }", ""),
        ("rrr BC(B), DC(D), EC(E) -> C { lengths: (1m, 1m, 1m), mode: left }", ""),
    ];
    check_statements(ROWS);
}
