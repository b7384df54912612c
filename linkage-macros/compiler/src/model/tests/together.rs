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
             X: the name `X` is taken; choose another / the first `X` is made by `crank X`\n\
             Y: the name `Y` is taken; choose another / the first `Y` is made by `crank X`\n\
             0: the length of `X` is 0 m; make it greater than zero\n\
             2m: a length where an angle belongs / a length divided by a length is a number, \
             and so an angle: `s / 20mm`\n\
             Z: no point named `Z` / declared so far: `A`, `D`, `B`, `Y`\n\
             lengths: `lengths` takes two values; write `lengths: (…, …)` / the distances from \
             each outer joint to the pin\n\
             }: missing field `mode` / `left` or `right`: the side of `M` seen from `Y` looking \
             to `Z`",
        ),
        (
            NOTHING,
            "input theta: angle; input s: lenght; ground A(0, 0), D(theta, 0); crank AB(a) -> B \
             { length: 0mm, angle: theta } rrr BC(B), DC(D) -> C { lengths: (632mm, 374), mod: \
             left } rrp CE(C), block(B) -> E { length: 1m, mode: ahead } point tip on BD at \
             (1deg, 0); output blade, DC.slide;",
            "lenght: no input kind named `lenght`; one with a similar name exists: `length` / \
             it is `angle` or `length`\n\
             theta: a ground point is fixed; it cannot depend on an input / a point that is \
             driven is declared `point D at (x, y);`\n\
             a: no point named `a`; a point with a similar name exists: `A`\n\
             0mm: the length of `AB` is 0 m; make it greater than zero\n\
             mod: `rrr` has no field `mod`; a field with a similar name exists: `mode`\n\
             B: `B` is a point, and the third letter of `rrp` is P: it needs a guide / a group \
             with a point there is `rrr`\n\
             BD: no link named `BD`; a link with a similar name exists: `BC`\n\
             1deg: an angle where a length belongs / an angle times a length is a length, as in \
             `theta * 20mm`\n\
             blade: no point, link or `let` named `blade`\n\
             slide: `DC` does not slide / no link of `rrr BC, DC` slides on a guide",
        ),
    ]);
}
