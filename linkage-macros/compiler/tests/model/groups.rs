//! The parts of a group.

use super::*;

#[test]
fn a_joint_stands_on_what_its_letter_says() {
    check(&[
        (
            GUIDE,
            "rrr BC(B), DC(rail) -> C { lengths: (3m, 3m), mode: left }",
            "rail: `rail` is a guide, and the third letter of `rrr` is R: it needs a point / a \
             group with a guide there is `rrp`",
        ),
        (
            GUIDE,
            "rrp BC(B), block(D) -> C { length: 3m, mode: ahead }",
            "D: `D` is a point, and the third letter of `rrp` is P: it needs a guide / a group \
             with a point there is `rrr`",
        ),
        (
            GUIDE,
            "rrp BC(rail), block(rail) -> C { length: 3m, mode: ahead }",
            "rail#1: `rail` is a guide, and the first letter of `rrp` is R: it needs a point / a \
             group with a guide there is `prp`",
        ),
        (
            GUIDE,
            "rpr block(B), bar(rail) { }",
            "rail: `rail` is a guide, and the third letter of `rpr` is R: it needs a point / a \
             group with a guide there is `rpp`",
        ),
        (
            GUIDE,
            "rpr block(rail), bar(D) { }",
            "rail: `rail` is a guide, and the first letter of `rpr` is R: it needs a point / a \
             group with a guide there is `rpp`",
        ),
        (
            GUIDE,
            "prp p(rail), q(D) -> C { }",
            "D: `D` is a point, and the third letter of `prp` is P: it needs a guide / a group \
             with a point there is `rrp`",
        ),
        (
            GUIDE,
            "prp p(D), q(rail) -> C { }",
            "D: `D` is a point, and the first letter of `prp` is P: it needs a guide / a group \
             with a point there is `rrp`",
        ),
        (
            GUIDE,
            "rpp p(rail), q(rail) { slot: 90deg }",
            "rail#1: `rail` is a guide, and the first letter of `rpp` is R: it needs a point",
        ),
        (
            GUIDE,
            "rpp p(B), q(D) { slot: 90deg }",
            "D: `D` is a point, and the third letter of `rpp` is P: it needs a guide / a group \
             with a point there is `rpr`",
        ),
        (
            GUIDE,
            "crank EF(rail) -> F { length: 1m, angle: t }",
            "rail: `rail` is a guide, and a `crank` turns about a point / it reads `crank AB(A) \
             -> B { length: 80mm, angle: theta }`",
        ),
        (
            GUIDE,
            "slider ram(B) -> F { slide: 1m }",
            "B: `B` is a point, and a `slider` slides on a guide / it reads `slider ram(rail) \
             -> P { slide: s }`",
        ),
    ]);
}

#[test]
fn a_group_has_its_links_and_its_pin() {
    check(&[
        (
            CRANK,
            "rrr BC(B) -> C { lengths: (3m, 3m), mode: left }",
            "rrr: `rrr` has two links, and one is given / it reads `rrr BC(B), DC(D) -> C { \
             lengths: (632mm, 374mm), mode: left }`",
        ),
        (
            CRANK,
            "rrr BC(B), DC(D), EC(A) -> C { lengths: (3m, 3m), mode: left }",
            "EC: `rrr` has two links, and 3 are given / it reads `rrr BC(B), DC(D) -> C { \
             lengths: (632mm, 374mm), mode: left }`",
        ),
        (
            CRANK,
            "crank EF(D), FG(A) -> F { length: 1m, angle: t }",
            "FG: `crank` has one link, and 2 are given / it reads `crank AB(A) -> B { length: \
             80mm, angle: theta }`",
        ),
        (
            CRANK,
            "rrr BC(B), DC(D) { lengths: (3m, 3m), mode: left }",
            "rrr: `rrr` makes a pin; name it with `-> C` / it reads `rrr BC(B), DC(D) -> C { \
             lengths: (632mm, 374mm), mode: left }`",
        ),
        (
            CRANK,
            "rpr block(B), bar(D) -> C { }",
            "C: `rpr` makes no pin; remove `-> C` / its inner joint is prismatic and has no \
             point",
        ),
        (
            GUIDE,
            "rpp block(B), yoke(rail) -> C { slot: 90deg }",
            "C: `rpp` makes no pin; remove `-> C` / its inner joint is prismatic and has no \
             point",
        ),
        (
            CRANK,
            "rrr BC(B), DC(D) -> C { length: (3m, 3m), mode: left }",
            "length: `rrr` has no field `length`; a field with a similar name exists: `lengths`",
        ),
    ]);
}

#[test]
fn a_group_is_one_that_exists() {
    check(&[
        (
            CRANK,
            "prr BC(B), DC(D) -> C { lengths: (3m, 3m) }",
            "prr: no group `prr`; write `rrp` with the bar first / a dyad is the same read from \
             either end",
        ),
        (
            CRANK,
            "ppr BC(B), DC(D) { } point P on BC at (0, 0);",
            "ppr: no group `ppr`; write `rpp` with the pinned block first / a dyad is the same \
             read from either end",
        ),
        (
            CRANK,
            "ppp BC(B), DC(D) { }",
            "ppp: no group `ppp`; a dyad needs a revolute joint / links with prismatic joints \
             alone cannot turn, and are not determined",
        ),
        (
            CRANK,
            "rr BC(B), DC(D) { }",
            "rr: no group `rr`; a dyad has three joints, so three letters / outer joint of the \
             first link, inner joint, outer joint of the second",
        ),
        (
            CRANK,
            "RRR BC(B), DC(D) -> C { lengths: (3m, 3m), mode: left }",
            "RRR: no driver or group `RRR`; one with a similar name exists: `rrr` / they are \
             `crank`, `slider`, `rrr`, `rrp`, `rpr`, `prp`, `rpp`",
        ),
        (
            CRANK,
            "cranck EF(D) -> F { length: 1m, angle: t } point P on EF at (0, 0); crank FG(F) -> \
             G { length: 1m, angle: t }",
            "cranck: no driver or group `cranck`; one with a similar name exists: `crank` / \
             they are `crank`, `slider`, `rrr`, `rrp`, `rpr`, `prp`, `rpp`",
        ),
        (
            CRANK,
            "gears EF(D), G(A) { }",
            "gears: no driver or group `gears` / they are `crank`, `slider`, `rrr`, `rrp`, \
             `rpr`, `prp`, `rpp`",
        ),
        (
            CRANK,
            "gear G(D) { ratio: -2 }",
            "gear: no driver or group `gear` / a gear is a crank whose angle is a multiple of \
             another's: `crank G(O) { angle: -2 * AB.angle }`",
        ),
    ]);
    const PAIRS: &str =
        "bars come in pairs, as dyads: `rrr BC(B), DC(D) -> C { lengths: (…, …), mode: left }`";
    for word in ["bar", "rocker"] {
        let told = format!("{word}: no driver or group `{word}` / {PAIRS}");
        check(&[(CRANK, &format!("{word} DC(D) -> C {{ length: 3m }}"), &told)]);
    }
}

#[test]
fn a_crank_is_relative_to_a_body() {
    check(&[
        (CRANK, "crank EF(D) -> F { length: 1m, angle: t, relative_to: ground }", ""),
        (CRANK, "crank EF(D) -> F { length: 1m, angle: t, relative_to: AB }", ""),
        (
            CRANK,
            "crank EF(D) -> F { length: 1m, angle: t, relative_to: 2 }",
            "2: `relative_to` takes `ground` or the name of a link",
        ),
        (
            CRANK,
            "crank EF(D) -> F { length: 1m, angle: t, relative_to: B }",
            "B: `B` is a point, not a link / it is the pin of `crank AB`: name the link",
        ),
    ]);
}

#[test]
fn bars_are_parallel_where_opposite_sides_are_known_to_be_as_long() {
    const SIDES: &str = "input t: angle; param l = 4m; param r = 1m; let two = 2 * r; ground A(0, 0), D(l, 0); \
                         crank AB(A) -> B { length: r, angle: t } crank AE(A) -> E { length: two, angle: -t }";
    check(&[
        (CRANK, "rrr BC(B), DC(D) -> C { lengths: (4m, 1m), mode: parallel }", ""),
        (CRANK, "rrr DC(D), BC(B) -> C { lengths: (1m, 4m), mode: parallel }", ""),
        (
            CRANK,
            "rrr BC(B), DC(D) -> C { lengths: (sqrt(2) * sqrt(8) * 1m, 1m), mode: parallel }",
            "",
        ),
        (SIDES, "rrr BC(B), DC(D) -> C { lengths: (l, r), mode: parallel }", ""),
        (SIDES, "rrr EF(E), DF(D) -> F { lengths: (l, 2 * r), mode: parallel }", ""),
        (
            SIDES,
            "point P on AB at (r, two); rrr PC(P), DC(D) -> C { lengths: (l, hypot(r, 2 * r)), mode: parallel }",
            "",
        ),
        (
            SIDES,
            "point P on AB at (r, two); rrr PC(P), DC(D) -> C { lengths: (l, hypot(r, 3 * r)), mode: parallel }",
            "parallel: `parallel` needs opposite sides of one length: that of `DC` is not known to be |AP| / give \
             both the same expression or the same number, or write `left` or `right`",
        ),
        (
            SIDES,
            "point P on AB at polar (two, 0.3); rrr PC(P), DC(D) -> C { lengths: (l, two), mode: parallel }",
            "",
        ),
        (
            SIDES,
            "point P on AB at distances (l, r) left; rrr PC(P), DC(D) -> C { lengths: (l, l), mode: parallel }",
            "",
        ),
        (
            CRANK,
            "rrr BC(B), DC(D) -> C { lengths: (4.001m, 1m), mode: parallel }",
            "parallel: `parallel` needs opposite sides of one length: `BC` is 4.001 m, and |AD| is 0.001 m shorter / give both the \
             same expression or the same number, or write `left` or `right`",
        ),
        (
            CRANK,
            "rrr BC(B), DC(D) -> C { lengths: (4m, 1.01m), mode: parallel }",
            "parallel: `parallel` needs opposite sides of one length: `DC` is 1.01 m, and |AB| is 0.01 m shorter / give both the \
             same expression or the same number, or write `left` or `right`",
        ),
        (
            SIDES,
            "rrr BC(B), DC(D) -> C { lengths: (4m, r), mode: parallel }",
            "parallel: `parallel` needs opposite sides of one length: that of `BC` is not known to be |AD| / give \
             both the same expression or the same number, or write `left` or `right`",
        ),
        (
            SIX_BAR,
            "rrr CP(C), EP(E) -> P { lengths: (3m, 3m), mode: left } rrr PQ(P), DQ(D) -> Q { lengths: (3m, 3m), mode: parallel }",
            "",
        ),
        (
            SIX_BAR,
            "rrr EP(E), BP(B) -> P { lengths: (5m, 3m), mode: left } rrr PQ(P), DQ(D) -> Q { lengths: (3m, 3m), mode: parallel }",
            "parallel: `P` and `D` make no parallelogram with `Q`; write `left` or `right` / `parallel` needs a fourth \
             corner: a point that is on one body with `P` and on another with `D`",
        ),
    ]);
}

#[test]
fn no_other_group_and_no_parameter_is_parallel() {
    check(&[
        (
            GUIDE,
            "rrp BC(B), block(rail) -> C { length: 5m, mode: parallel }",
            "parallel: `parallel` is no mode of `rrp` / `ahead` or `behind`: where `C` lies against the foot of `B` on \
             `rail`, along its direction",
        ),
        (
            CRANK,
            "param side: mode = parallel; rrr BC(B), DC(D) -> C { lengths: (4m, 1m), mode: left }",
            "parallel: `parallel` is no value of a parameter; write `mode: parallel` in the braces of the `rrr` / a \
             parallelogram stays one in every pose, and nothing is left to choose",
        ),
        (
            CRANK,
            "rrr BC(B), DC(D) -> C { lengths: (4m, 1m), mode: paralel }",
            "paralel: no mode named `paralel`; a mode with a similar name exists: `parallel` / `left` or `right`: the \
             side of `C` seen from `B` looking to `D`",
        ),
        // A parameter that had the name before it was a word.
        (
            CRANK,
            "param parallel: mode = left; rrr BC(B), DC(D) -> C { lengths: (4m, 1m), mode: parallel }",
            "",
        ),
        (
            CRANK,
            "rrr BC(B), DC(D) -> C { lengths: (4m, 1m), mode: parallel } output BC.transmission, BC.margin;",
            "margin: a parallelogram has no `margin` / it is never out of reach; `transmission` tells how far its joints \
             are from one line",
        ),
    ]);
}
