//! Fields and modes.

use super::*;

#[test]
fn a_field_is_one_that_the_group_has() {
    check(&[
        (
            CRANK,
            "rrr BC(B), DC(D) -> C { lengths: 3m, mode: left }",
            "lengths: `lengths` takes two values; write `lengths: (…, …)` / the distances from \
             each outer joint to the pin",
        ),
        (
            CRANK,
            "crank EF(D) -> F { angel: t, length: 1m }",
            "angel: `crank` has no field `angel`; a field with a similar name exists: `angle`",
        ),
        (
            CRANK,
            "crank EF(D) -> F { angle: t, length: 1m, colour: 3 }",
            "colour: `crank` has no field `colour` / its fields are `length`, `angle` and \
             `relative_to`",
        ),
        (
            CRANK,
            "crank EF(D) -> F { angle: t, length: 1m, angle: 3 }",
            "angle#2: the field `angle` is given twice; remove one",
        ),
        (
            CRANK,
            "rrr BC(B), DC(D) -> C { lengths: (3m, 3m) }",
            "}: missing field `mode` / `left` or `right`: the side of `C` seen from `B` looking \
             to `D`",
        ),
        (
            GUIDE,
            "prp p(rail), q(rail) -> X { offset: 3mm }",
            "rail#2: both links of `prp` stand on `rail` / two links on one guide never cross\n\
             offset: `prp` has no field `offset`; a field with a similar name exists: `offsets`",
        ),
        (
            CRANK,
            "rrr BC(B), DC(D) -> C { lengths: (3m, 3m), mode: left, offset: 1m }",
            "offset: `rrr` has no field `offset` / its fields are `lengths` and `mode`",
        ),
        (
            GUIDE,
            "rrp BC(B), block(rail) -> C { radius: 3m, mode: ahead }",
            "radius: `rrp` has no field `radius` / what is missing is `length`: the distance from \
             the outer joint to the pin",
        ),
    ]);
}

#[test]
fn a_field_has_one_value_or_two() {
    check(&[
        (
            CRANK,
            "crank EF(D) -> F { length: (1m, 2m), angle: t }",
            "length: `length` takes one value; write `length: …` / the distance from the pivot \
             to the pin",
        ),
        (
            GUIDE,
            "rpp block(B), yoke(rail) { slot: 90deg, offsets: 3mm }",
            "offsets: `offsets` takes two values; write `offsets: (…, …)` / the distances from \
             the two lines, along their normals",
        ),
        (
            GUIDE,
            "guide up through (0, 0) along 90deg; prp p(rail), q(up) -> X { offsets: (1mm, \
             2deg) }",
            "2deg: an angle where a length belongs / write `2mm`",
        ),
    ]);
}

#[test]
fn no_field_is_missing() {
    check(&[
        (
            CRANK,
            "crank EF(D) -> F { length: 1m }",
            "}: missing field `angle` / the angle from the x axis of what it is relative to",
        ),
        (
            CRANK,
            "crank EF(D) -> F { }",
            "}: missing field `length` / the distance from the pivot to the pin\n\
             }: missing field `angle` / the angle from the x axis of what it is relative to",
        ),
        (
            CRANK,
            "crank EF(D) -> F { angle: t }",
            "}: missing field `length` / the distance from the pivot to the pin",
        ),
        (
            CRANK,
            "crank EF(D) { angle: t, length: 2m }",
            "length: a `crank` without a pin has no `length`; name the pin, `-> B` / `length` \
             is the distance from the pivot to the pin",
        ),
        (CRANK, "crank EF(D) { angle: t }", ""),
        (
            GUIDE,
            "slider ram(rail) -> P { offset: 1m }",
            "}: missing field `slide` / the distance from the guide's point, along its direction",
        ),
        (
            GUIDE,
            "rpp block(B), yoke(rail) { }",
            "}: missing field `slot` / the angle of the slot to the rail",
        ),
    ]);
}

#[test]
fn a_mode_is_one_of_the_group() {
    check(&[
        (
            CRANK,
            "crank EF(D) -> F { angle: t, length: 1m, mode: left }",
            "mode: `crank` has no field `mode` / `crank` can be assembled in one way only",
        ),
        (
            GUIDE,
            "rrp BC(B), block(rail) -> C { length: 3m }",
            "}: missing field `mode` / `ahead` or `behind`: where `C` lies against the foot of \
             `B` on `rail`, along its direction",
        ),
        (
            GUIDE,
            "rrp BC(B), block(rail) -> C { length: 3m, mode: left }",
            "left: `left` is no mode of `rrp` / `ahead` or `behind`: where `C` lies against the \
             foot of `B` on `rail`, along its direction",
        ),
        (
            CRANK,
            "rrr BC(B), DC(D) -> C { lengths: (3m, 3m), mode: ahead }",
            "ahead: `ahead` is no mode of `rrr` / `left` or `right`: the side of `C` seen from \
             `B` looking to `D`",
        ),
        (
            CRANK,
            "rrr BC(B), DC(D) -> C { lengths: (3m, 3m), mode: lefft }",
            "lefft: no mode named `lefft`; a mode with a similar name exists: `left` / `left` \
             or `right`: the side of `C` seen from `B` looking to `D`",
        ),
        (
            CRANK,
            "rrr BC(B), DC(D) -> C { lengths: (3m, 3m), mode: up }",
            "up: no mode named `up`; write `left` or `right` / `left` or `right`: the side of \
             `C` seen from `B` looking to `D`",
        ),
        (
            CRANK,
            "rrr BC(B), DC(D) -> C { lengths: (3m, 3m), mode: 1 }",
            "1: a mode is one word / `left` or `right`: the side of `C` seen from `B` looking \
             to `D`",
        ),
        (
            CRANK,
            "param elbow: mode = left; rrr BC(B), DC(D) -> C { lengths: (3m, 3m), mode: elbow }",
            "",
        ),
        (
            CRANK,
            "param elbow: mode = ahead; rrr BC(B), DC(D) -> C { lengths: (3m, 3m), mode: elbow \
             }",
            "elbow#2: `elbow` is `ahead` or `behind`, no mode of `rrr` / `left` or `right`: the \
             side of `C` seen from `B` looking to `D`",
        ),
        (
            CRANK,
            "param elbow = 2; rrr BC(B), DC(D) -> C { lengths: (3m, 3m), mode: elbow }",
            "elbow#2: `elbow` is a number, not a mode / write `param elbow: mode = left;`",
        ),
        (
            CRANK,
            "rpr block(B), bar(D) { mode: left }",
            "left: `left` is no mode of `rpr` / `ahead` or `behind`: whether `B` lies on the \
             positive or the negative side of the bar, seen from `D`",
        ),
        (CRANK, "rpr block(B), bar(D) { mode: behind }", ""),
        (
            GUIDE,
            "rpp block(B), yoke(rail) { slot: 90deg, mode: ahead }",
            "mode: `rpp` has no field `mode` / `rpp` can be assembled in one way only",
        ),
        (
            CRANK,
            "rrr BC(B), DC(D) -> C { lengths: (3m, 3m), mode: +1 }",
            "1: a mode is one word / `left` or `right`: the side of `C` seen from `B` looking \
             to `D`",
        ),
    ]);
}

#[test]
fn a_mode_parameter_holds_a_mode() {
    check(&[
        (CRANK, "param elbow = left;", "left: `left` is a mode; write `param elbow: mode = left;`"),
        (
            CRANK,
            "param elbow: mode = 3;",
            "3: a mode is `left`, `right`, `ahead`, `behind`, `rising` or `falling` / `left` or \
             `right` for an `rrr`, `ahead` or `behind` for `rrp` and `rpr`, `rising` or `falling` \
             for `solve`",
        ),
        (
            CRANK,
            "param elbow: mode = up;",
            "up: a mode is `left`, `right`, `ahead`, `behind`, `rising` or `falling` / `left` or \
             `right` for an `rrr`, `ahead` or `behind` for `rrp` and `rpr`, `rising` or `falling` \
             for `solve`",
        ),
        (
            CRANK,
            "param elbow: mode = left; let x = 2 * elbow;",
            "elbow#2: `elbow` is a mode, not a number",
        ),
    ]);
}
