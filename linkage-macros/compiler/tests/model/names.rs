//! Names: declared once, found, used after they are made.

use super::*;

#[test]
fn a_name_is_declared_once() {
    check(&[
        (
            CRANK,
            "ground B(1m, 1m);",
            "B: the name `B` is taken; choose another / the first `B` is made by `crank AB`",
        ),
        (
            CRANK,
            "ground A(1m, 1m), A(2m, 2m);",
            "A#1: the name `A` is taken; choose another / the first `A` is made by `ground A`\n\
             A#2: the name `A` is taken; choose another / the first `A` is made by `ground A`",
        ),
        (
            CRANK,
            "input t: length;",
            "t: the name `t` is taken; choose another / the first `t` is made by `input t`",
        ),
        (
            CRANK,
            "param t = 2; param AB = 3; param D = 2;",
            "t: the name `t` is taken; choose another / the first `t` is made by `input t`\n\
             AB: the name `AB` is taken; choose another / the first `AB` is made by `crank AB`\n\
             D: the name `D` is taken; choose another / the first `D` is made by `ground D`",
        ),
        (
            CRANK,
            "rrr BC(B), BC(D) -> C { lengths: (3m, 3m), mode: left }",
            "BC#2: the name `BC` is taken; choose another / the first `BC` is made by `rrr BC, \
             BC`",
        ),
        (
            CRANK,
            "param AB = 3; crank X(A) -> Y { length: AB, angle: t }",
            "AB#1: the name `AB` is taken; choose another / the first `AB` is made by `crank AB`",
        ),
        (
            CRANK,
            "rrr BC(B), DC(D) -> A { lengths: (2m, 2m), mode: left } point P on BC at distances \
             (1.5m, 1.5m) left; guide g on BC through A towards B;",
            "A#1: the name `A` is taken; choose another / the first `A` is made by `ground A`",
        ),
    ]);
}

#[test]
fn an_unknown_name_is_reported_with_the_nearest() {
    check(&[
        (
            CRANK,
            "rrr BC(Bb), DC(D) -> C { lengths: (3m, 3m), mode: left }",
            "Bb: no point named `Bb`; a point with a similar name exists: `B`",
        ),
        (
            CRANK,
            "rrr BC(Q), DC(D) -> C { lengths: (3m, 3m), mode: left }",
            "Q: no point named `Q` / declared so far: `A`, `D`, `B`",
        ),
        (
            CRANK,
            "crank EF(D) -> F { length: 1m, angle: thta }",
            "thta: no input, parameter or `let` named `thta` / declared so far: `t`",
        ),
        (
            CRANK,
            "inertia 2kg*m2 on AB;",
            "m2: no input, parameter or `let` named `m2` / a product of units stands in parentheses: \
             `0.1(kg*m^2)`",
        ),
        (
            NOTHING,
            "input theta: angle; ground A(0, 0); crank AB(A) -> B { length: 1m, angle: thata }",
            "thata: no input, parameter or `let` named `thata`; an input with a similar name \
             exists: `theta`",
        ),
        (
            CRANK,
            "guide g on AC through A towards B;",
            "AC: no link named `AC`; a link with a similar name exists: `AB`",
        ),
        (CRANK, "point P on BC at (1m, 0);", "BC: no link named `BC` / declared so far: `AB`"),
        (
            CRANK,
            "crank EF(D) -> F { length: 1m, angle: t, relative_to: AC }",
            "AC: no link named `AC`; a link with a similar name exists: `AB`",
        ),
        (
            NOTHING,
            "ground A(0, 0); crank AB(A) -> B { length: 1m, angle: theta }",
            "theta: no input, parameter or `let` named `theta` / declare it: `input theta: \
             angle;`",
        ),
    ]);
}

#[test]
fn what_is_used_was_made_earlier() {
    check(&[
        (
            CRANK,
            "rrr BC(C), DC(D) -> C { lengths: (3m, 3m), mode: left }",
            "C#1: `C` is used inside the statement that makes it / a statement can use what \
             earlier ones have made",
        ),
        (
            CRANK,
            "rrr BC(P), DC(D) -> C { lengths: (3m, 3m), mode: left } point P on AB at (1m, 0);",
            "P#1: `P` is used before `point P` makes it / this order works: `point P`, `rrr BC, DC`",
        ),
        (
            CRANK,
            "crank EF(D) -> F { length: far, angle: t } param far = 2m;",
            "far#1: `far` is used before `param far` makes it / this order works: `param far`, \
             `crank EF`",
        ),
        (
            CRANK,
            "crank EF(D) -> F { length: 1m, angle: EF.angle }",
            "EF#2: `EF` is used inside the statement that makes it / a statement can use what \
             earlier ones have made",
        ),
        (
            SIX_BAR,
            "crank X(A) -> Y { length: half, angle: t } let half = t * 1m / 2; crank Z(A) { \
             angle: half }",
            "half#3: a length where an angle belongs / a length divided by a length is a number, \
             and so an angle: `s / 20mm`\n\
             half#1: `half` is used before `let half` makes it / this order works: `let half`, \
             `crank X`",
        ),
    ]);
}

#[test]
fn a_mechanism_has_inputs_and_uses_them() {
    check(&[
        (
            NOTHING,
            "ground A(0, 0);",
            "before M: `M` has no input; declare what drives it / an angle, `input theta: angle;`, or \
             a length, `input s: length;`",
        ),
        (
            INPUT,
            "",
            "t: nothing uses the input `t`; use it or remove it / a driver takes it: `crank \
             AB(A) { angle: t }`",
        ),
        (
            INPUT,
            "let half = t / 2; ground A(0, 0);",
            "before t: nothing uses the input `t`; use it or remove it / a driver takes it: `crank \
             AB(A) { angle: t }`",
        ),
        (
            NOTHING,
            "input t: angel; ground A(0, 0); crank AB(A) -> B { length: 1m, angle: t }",
            "angel: no input kind named `angel`; one with a similar name exists: `angle` / it \
             is `angle` or `length`",
        ),
        (
            NOTHING,
            "input t: speed;",
            "speed: no input kind named `speed` / it is `angle` or `length`",
        ),
        (
            NOTHING,
            "ground A(0, 0); crank AB(A) -> B { length: 1m }",
            "}: missing field `angle` / the angle from the x axis of what it is relative to\n\
             before M: `M` has no input; declare what drives it / an angle, `input theta: angle;`, or \
             a length, `input s: length;`",
        ),
        (
            NOTHING,
            "input t: angle; input s: length; ground A(0, 0); crank AB(A) -> B { length: 1m, \
             angle: t } rrr BC(B), DC(Dd) -> C { lengths: (2m, 3m) }",
            "Dd: no point named `Dd` / declared so far: `A`, `B`\n\
             }#2: missing field `mode` / `left` or `right`: the side of `C` seen from `B` looking to \
             `Dd`",
        ),
    ]);
}

/// An unknown that stems from a reported mistake brings no second message in `output`.
#[test]
fn reactions_of_a_group_in_error_are_not_reported() {
    const UNKNOWN: &str = "no input, parameter or `let` named `x` / declared so far: `t`";
    const ASKED: &str = "mass 1kg on AB at (0, 0); output t.drive, AB.drive, ";
    let rows = [
        ("rrr BC(B), DC(D) -> C { lengths: (x, 3m), mode: left }", "BC.B, BC.C, DC.D, DC.push"),
        ("rrp BC(B), ram(rail) -> C { length: x, mode: ahead }", "BC.B, ram.rail, ram.C"),
        ("rpr block(B), bar(D) { offset: x }", "block.B, bar.D, block.bar"),
        ("slider ram(rail) -> C { slide: x }", "ram.drive, ram.rail, ram.C"),
    ];
    for (group, asked) in rows {
        check(&[(GUIDE, &format!("{group} {ASKED}{asked};"), &format!("x: {UNKNOWN}"))]);
    }
    let group = "rrp BC(B), ram(bed) -> C { length: 5m, mode: ahead }";
    check(&[
        (
            GUIDE,
            &format!("{group} {ASKED} ram.bed, BC.C;"),
            "bed#1: no guide named `bed` / declared so far: `rail`",
        ),
        (
            CRANK,
            &format!("{group} {ASKED} ram.bed;"),
            "bed#1: no guide named `bed` / declare it in front of this: `guide bed through A along 0deg;`",
        ),
        // A mistake of its own is still one.
        (
            GUIDE,
            "rrp BC(B), ram(rail) -> C { length: 5m, mode: ahead } mass 1kg on C; output ram.bed, BC.D;",
            "bed: a link has no `bed` / it has `angle`, `slide` if it slides, `margin` and \
             `transmission`; of its forces there is `ram.C` and `ram.rail`\n\
             D: `BC` does not touch `D` / there is `BC.B` and `BC.C`",
        ),
        (
            GUIDE,
            "mass 1kg on B; force (1, 0) in rial on B;",
            "rial: no link or guide named `rial`; a guide with a similar name exists: `rail`",
        ),
        (
            "input t: angle; ground A(0, 0); guide bed through A along 0deg; \
             crank ram(A) -> B { length: 1m, angle: t }",
            "force (1, 0) in rail on B;",
            "rail: no link or guide named `rail`; a link with a similar name exists: `ram` / guides are \
             `bed`",
        ),
    ]);
}

#[test]
fn what_was_in_error_is_not_reported_again() {
    check(&[
        (
            CRANK,
            "let broken = 2 * tt; crank X(A) -> Y { length: broken, angle: broken }",
            "tt: no input, parameter or `let` named `tt`; an input with a similar name exists: \
             `t`",
        ),
        (
            CRANK,
            "crank EF(Dd) -> F { length: 1m, angle: t } guide g on EF through D towards F;",
            "Dd: no point named `Dd`; a point with a similar name exists: `D`",
        ),
        (
            CRANK,
            "rrr BC(B), DC(D) { lengths: (2m, 2m), mode: left } point P on BC at distances \
             (1.5m, 1.5m) left; point Q on DC at distances (1.5m, 0.1m) right;",
            "rrr: `rrr` makes a pin; name it with `-> C` / it reads `rrr BC(B), DC(D) -> C { \
             lengths: (632mm, 374mm), mode: left }`\n\
             Q: no point has the distances of `Q`; change them / `DC` is 2 m, distances 1.5 m + \
             0.1 m reach 1.6 m",
        ),
    ]);
}

#[test]
fn settings_are_known_and_given_once() {
    check(&[
        (
            CRANK,
            "numerics exact;",
            "exact: no numerics named `exact`; write `compensated` / `compensated` carries the rounding \
             errors of a dyad along and takes longer; without the statement they are plain",
        ),
        (
            CRANK,
            "numerics compensated; numerics compensated;",
            "compensated#2: `numerics` is given twice; remove one",
        ),
        (
            CRANK,
            "numerics compensated; numerics fast;",
            "fast: leave `numerics fast;` out / what it asked for is what every declaration has",
        ),
        (
            CRANK,
            "numerics Fast; numerics compensated;",
            "Fast: no numerics named `Fast`; write `compensated` / `compensated` carries the rounding \
             errors of a dyad along and takes longer; without the statement they are plain",
        ),
        (CRANK, "crate = a; crate = b;", "b: `crate` is given twice; remove one"),
        (
            CRANK,
            "export cpp;",
            "cpp: no export named `cpp`; write `export c;` or `export assemblies;`",
        ),
        (CRANK, "export c; export c;", "c#2: `export c` is given twice; remove one"),
        (
            CRANK,
            "export assemblies; export c; export assemblies;",
            "assemblies#2: `export assemblies` is given twice; remove one",
        ),
    ]);
}

/// One message for all names that are used too early, and none that sends statements to and fro.
#[test]
fn an_order_that_works_is_told_or_the_circle() {
    check(&[
        (
            CRANK,
            "rrr EC(E), DC(D) -> C { lengths: (3m, 3m), mode: left } point E on BE at (1m, 0); \
             rrr BE(B), FE(F) -> G { lengths: (3m, 3m), mode: left } ground F(1m, 1m);",
            "E#1: `E` is used before `point E` makes it / this order works: `ground F`, \
             `rrr BE, FE`, `point E`, `rrr EC, DC`",
        ),
        (
            CRANK,
            "rrr BC(B), CF(F) -> C { lengths: (3m, 3m), mode: left } \
             rrr DF(D), EF(C) -> F { lengths: (3m, 2m), mode: left } output C, F;",
            "F#1: `rrr BC, CF` and `rrr DF, EF` need each other: a group of class III or higher / \
             only drivers and dyads are solved in closed form; drive the chain at another link, so \
             that each dyad stands on what is known",
        ),
        // The circle is told where it begins, not at a name that another order would make first.
        (
            CRANK,
            "rrr EG(E), DG(D) -> G { lengths: (3m, 3m), mode: left } \
             rrr BC(B), CF(F) -> C { lengths: (3m, 3m), mode: left } \
             rrr DF(D), EF(C) -> F { lengths: (3m, 2m), mode: left } point E on BC at (1m, 0);",
            "F#1: `rrr BC, CF` and `rrr DF, EF` need each other: a group of class III or higher / \
             only drivers and dyads are solved in closed form; drive the chain at another link, so \
             that each dyad stands on what is known",
        ),
    ]);
}

/// The rewriting proposed in the message of a circle is a mechanism. Where no single unknown opens
/// the circle, the message says so.
#[test]
fn a_group_of_class_three_is_told_what_to_write() {
    const LEGS: &str = "input t: angle; ground A1(0, 0), A2(2.6m, 0.1m), O(2m, 1.5m); param reach = 1.1m; \
                        crank drive(O) -> A3 { length: 0.15m, angle: t }";
    check(&[
        (
            LEGS,
            "rrr leg1(A1), s12(C2) -> C1 { lengths: (1.6m, reach), mode: left } \
             rrr leg2(A2), s23(C3) -> C2 { lengths: (0.9m, 0.7m), mode: left } \
             rrr leg3(A3), s31(C1) -> C3 { lengths: (0.8m, 0.6m), mode: left }",
            "C2#1: `rrr leg1, s12`, `rrr leg2, s23` and `rrr leg3, s31` need each other: a group of \
             class III or higher / write `unknown phi: angle between (…, …);`, `crank leg1(A1) -> C1 \
             { length: 1.6m, angle: phi }` for `rrr leg1, s12`, and last `solve phi { distance(C1, \
             C2) = reach, mode: rising }`",
        ),
        // As it says, each dyad behind what it stands on.
        (
            LEGS,
            "unknown phi: angle between (45deg, 66deg); \
             crank leg1(A1) -> C1 { length: 1.6m, angle: phi } \
             rrr leg3(A3), s31(C1) -> C3 { lengths: (0.8m, 0.6m), mode: left } \
             rrr leg2(A2), s23(C3) -> C2 { lengths: (0.9m, 0.7m), mode: left } \
             solve phi { distance(C1, C2) = reach, mode: rising }",
            "",
        ),
        // A body stands on the bar that would be left over, and so on the other two.
        (
            LEGS,
            "rrr leg1(A1), s12(C2) -> C1 { lengths: (1.6m, reach), mode: left } \
             rrr leg2(A2), s23(C3) -> C2 { lengths: (0.9m, 0.7m), mode: left } \
             rrr leg3(A3), s31(C1) -> C3 { lengths: (0.8m, 0.6m), mode: left } \
             point p on s12 at (1m, 0); point q on s23 at (1m, 0); point r on s31 at (1m, 0);",
            "C2#1: `rrr leg1, s12`, `rrr leg2, s23` and `rrr leg3, s31` need each other: a group of \
             class III or higher / only drivers and dyads are solved in closed form; drive the chain \
             at another link, so that each dyad stands on what is known",
        ),
    ]);
}
