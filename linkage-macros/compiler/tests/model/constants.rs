//! Declarations that constants rule out.

use super::*;

#[test]
fn a_length_is_greater_than_zero() {
    check(&[
        (
            CRANK,
            "crank EF(D) -> F { length: 0, angle: t }",
            "0: the length of `EF` is 0 m; make it greater than zero",
        ),
        (
            CRANK,
            "crank EF(D) -> F { length: -300mm, angle: t }",
            "-300mm: the length of `EF` is -0.3 m; make it greater than zero",
        ),
        (
            CRANK,
            "crank EF(D) -> F { length: 1m - 1m, angle: t }",
            "1m - 1m: the length of `EF` is 0 m; make it greater than zero",
        ),
        (
            CRANK,
            "ground P(-3m, 2m); crank EF(D) -> F { length: P.x, angle: t }",
            "P.x: the length of `EF` is -3 m; make it greater than zero",
        ),
        (
            CRANK,
            "ground P(3m, -2m); crank EF(D) -> F { length: P.y, angle: t }",
            "P.y: the length of `EF` is -2 m; make it greater than zero",
        ),
        (
            CRANK,
            "param l = 0m; crank EF(D) -> F { length: l, angle: t } crank EG(D) -> G { length: \
             l, angle: t }",
            "0m: the length of `EF` is 0 m; make it greater than zero",
        ),
        (
            CRANK,
            "rrr BC(B), DC(D) -> C { lengths: (0.5m, 0m), mode: sideways }",
            "0m: the length of `DC` is 0 m; make it greater than zero\n\
             sideways: no mode named `sideways`; write `left` or `right` / `left` or `right`: \
             the side of `C` seen from `B` looking to `D`",
        ),
    ]);
}

#[test]
fn a_group_of_constants_can_be_assembled() {
    check(&[
        (
            CRANK,
            "rrr BC(A), DC(D) -> C { lengths: (1m, 2m), mode: left }",
            "rrr: `BC, DC` cannot be assembled; change its dimensions / |AD| = 4 m, lengths 1 m \
             + 2 m reach 3 m",
        ),
        (
            NOTHING,
            "input t: angle; ground A(0, 0); crank AB(A) { angle: t } ground B(0, 0), D(5.3m, \
             0); rrr BC(B), DC(D) -> C { lengths: (2m, 3m), mode: left }",
            "rrr: `BC, DC` cannot be assembled; change its dimensions / |BD| = 5.3 m, lengths 2 \
             m + 3 m reach 5 m",
        ),
        (
            CRANK,
            "rrr BC(A), DC(D) -> C { lengths: (8m, 2m), mode: left }",
            "rrr: `BC, DC` cannot be assembled; change its dimensions / |AD| = 4 m, lengths 8 m \
             and 2 m stay 6 m apart",
        ),
        (
            CRANK,
            "ground E(0, 0); rrr BC(A), DC(E) -> C { lengths: (8m, 2m), mode: left }",
            "rrr: `BC, DC` cannot be assembled; change its dimensions / |AE| = 0 m: between two \
             links on one place the pin is undetermined",
        ),
        (
            CRANK,
            "rrr BC(A), DC(A) -> C { lengths: (8m, 2m), mode: left }",
            "A#2: both links of `rrr` stand on `A` / between two links on one point the inner \
             joint is undetermined",
        ),
        (
            GUIDE,
            "guide far through (0, 9m) along 0deg; rrp BC(A), block(far) -> C { length: 8m, \
             mode: ahead }",
            "rrp: `BC, block` cannot be assembled; change its dimensions / `A` is 9 m from the \
             line its pin slides on, length 8 m",
        ),
        (
            CRANK,
            "rpr block(A), bar(D) { offset: 5m }",
            "rpr: `block, bar` cannot be assembled; change its dimensions / |AD| = 4 m, less \
             than the offset of 5 m",
        ),
        (
            CRANK,
            "ground E(0, 0); rpr block(A), bar(E) { }",
            "rpr: `block, bar` cannot be assembled; change its dimensions / |AE| = 0 m: the bar \
             has no direction",
        ),
        (
            GUIDE,
            "guide par through A along 180deg; prp p(rail), q(par) -> C { }",
            "prp: `p, q` cannot be assembled; change its dimensions / `rail` and `par` are \
             parallel and never cross",
        ),
        (
            GUIDE,
            "prp p(rail), q(rail) -> C { }",
            "rail#2: both links of `prp` stand on `rail` / two links on one guide never cross",
        ),
        (
            GUIDE,
            "rpp block(B), yoke(rail) { slot: 180deg }",
            "180deg: a slot at 180° lies along the rail; turn it away / slot and rail \
             must cross for the group to be determined",
        ),
        (
            CRANK,
            "crank fix(D) -> F { length: 2m, angle: 90deg } rrr BC(A), FC(F) -> C { lengths: \
             (1m, 1m), mode: left }",
            "rrr: `BC, FC` cannot be assembled; change its dimensions / |AF| = 4.47214 m, \
             lengths 1 m + 1 m reach 2 m",
        ),
        (
            // Just within reach, and just out of it, by one part in 10^30.
            CRANK,
            "rrr BC(A), DC(D) -> C { lengths: (1m, 3m), mode: left }",
            "",
        ),
        (
            CRANK,
            "rrr BC(A), DC(D) -> C { lengths: (1m, 2.999999999999999999999999999999m), mode: left }",
            "rrr: `BC, DC` cannot be assembled; change its dimensions / |AD| = 4 m, lengths 1 m + \
             3 m reach 4 m",
        ),
        (
            // Both ends are points of one moving link.
            CRANK,
            "point P on AB at (3m, 0); rrr BC(A), PC(P) -> C { lengths: (1m, 1m), mode: left }",
            "rrr: `BC, PC` cannot be assembled; change its dimensions / |AP| = 3 m, lengths 1 m + \
             1 m reach 2 m",
        ),
        (
            GUIDE,
            "slider stop(rail) -> S { slide: 0, offset: 2m } \
             rrr BC(D), SC(S) -> C { lengths: (1m, 0.5m), mode: left }",
            "rrr: `BC, SC` cannot be assembled; change its dimensions / |DS| = 2 m, lengths 1 m + \
             0.5 m reach 1.5 m",
        ),
        (
            CRANK,
            "rrr BC(B), DC(D) -> C { lengths: (1m, 1.5m), mode: left }",
            "rrr: `BC, DC` cannot be assembled at any angle of `AB`; change its dimensions / |BD| \
             runs from 3 m to 5 m, and the bars reach from 0.5 m to 2.5 m",
        ),
        (
            CRANK,
            "guide far through (0, 4m) along 0deg; rrp BC(B), block(far) -> C { length: 2m, \
             mode: ahead }",
            "rrp: `BC, block` cannot be assembled at any angle of `AB`; change its dimensions / B \
             runs from -5 m to -3 m off the line of the pin, and the bar reaches 2 m",
        ),
    ]);
}
