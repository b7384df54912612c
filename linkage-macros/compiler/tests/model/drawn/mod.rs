//! Drawings of links and joints: what is said of those that cannot be cut.

pub(crate) mod drive_equations;

use super::check;
use crate::drawings::lorry::LORRY;
pub(crate) use linkage_compiler::model::drawn::*;

/// A four-bar without its drive.
const BARS: &str = "input t: angle; ground A(0, 0), D(4m, 0); pin B(0.5m, 0.9m), C(3.2m, 2.6m); \
                    link AB(A, B), BC(B, C), DC(D, C);";
/// A four-bar.
const FOUR_BAR: &str = "input t: angle; ground A(0, 0), D(4m, 0); pin B(0.5m, 0.9m), \
                        C(3.2m, 2.6m); link AB(A, B), BC(B, C), DC(D, C); drive AB.angle = t;";

#[test]
fn counts_that_do_not_fit_name_bodies_and_drives() {
    check(&[
        (FOUR_BAR, "", ""),
        (
            BARS,
            "output AB;",
            "before AB: `AB`, `BC` and `DC` still move when every input is held: one drive too few / \
             drive one of them, `drive AB.angle = t;`, or pin one of them to another link",
        ),
        (
            BARS,
            "input u: angle; drive AB.angle = t; drive DC.angle = u;",
            "u#2: `t` and `u` fight: `AB`, `BC`, `DC` and the ground have one freedom and 2 inputs / leave out `drive AB.angle` or `drive DC.angle`",
        ),
        (
            FOUR_BAR,
            "drive DC.angle = t;",
            "t: `drive AB.angle` and `drive DC.angle` fight: `AB`, `BC`, `DC` and the ground have one freedom and 2 drives / leave out `drive AB.angle` or `drive DC.angle`",
        ),
        (
            FOUR_BAR,
            "link BD(B, D);",
            "BD: `AB`, `BD` and the ground hold each other without `drive AB.angle`: one constraint too many / leave out `link BD`, or one of its joints or `drive AB.angle`",
        ),
        (
            FOUR_BAR,
            "pin X(5m, 5m); link tail(C, X);",
            "tail: `tail` still moves when every input is held: one drive too few / drive it, `drive tail.angle = …;`, or pin it to another link",
        ),
        (
            FOUR_BAR,
            "pin X(5m, 5m), Y(6m, 5m); link tail(C, X), end(X, Y);",
            "end: `tail` and `end` still move when every input is held: 2 drives too few / drive one of them, `drive end.angle = …;`, or pin one of them to another link",
        ),
    ]);
}

#[test]
fn names_of_a_drawing_are_given_once_and_exist() {
    check(&[
        (
            FOUR_BAR,
            "pin X(5m, 5m); link tail(C, Y);",
            "Y: no pin named `Y` / say where it is drawn: `pin Y(…, …);`\n\
             X: no link goes through `X` / name it among the pins of one, `link DC(D, C, X)`, or \
             leave it out",
        ),
        (
            FOUR_BAR,
            "guide bed through D towards K; guide rail through L along 0deg;",
            "K: no pin named `K` / say where it is drawn: `pin K(…, …);`",
        ),
        (
            FOUR_BAR,
            "link tail(C, C);",
            "C#2: `C` is named twice; remove one / `tail` goes through it once",
        ),
        (
            FOUR_BAR,
            "drive AD.angle = t;",
            "AD: no link named `AD`; one with a similar name exists: `AB` / links are declared with the pins through them: `link BC(B, C);`",
        ),
        (
            FOUR_BAR,
            "link ram(C) on bed;",
            "bed: no guide named `bed` / declare it: `guide bed through A along 0deg;`, or `guide bed on LINK …` for a slot",
        ),
        (FOUR_BAR, "link AB(A, C);", "AB: the name `AB` is taken; choose another / `AB` is a link"),
        (
            FOUR_BAR,
            "pin E(1m, 0);",
            "E: no link goes through `E` / name it among the pins of one, `link DC(D, C, E)`, or \
             leave it out",
        ),
    ]);
}

#[test]
fn drives_give_an_angle_or_a_slide() {
    check(&[
        (
            FOUR_BAR,
            "drive AB.slide = 1m;",
            "slide: `AB` slides on no guide / a cylinder has a length: `link AB(A, B) { length: … }`; what slides is declared as `link AB(…) on GUIDE;`",
        ),
        (
            FOUR_BAR,
            "drive AB.omega = 1;",
            "omega: a drive gives an angle, the difference of two, or a slide / write `drive AB.angle = …`, `drive BC.angle - AB.angle = …` or `drive ram.slide = …`",
        ),
        (
            "input t: angle; ground A(0, 0); guide bed through A along 0deg; pin C(1m, 0); link ram(C) on bed; drive ram.angle = t;",
            "",
            "angle#2: `ram` slides without turning; drive its slide / write `drive ram.slide = …`",
        ),
        (
            "input t: length; ground A(0, 0); guide bed through A along 0deg; pin C(1m, 0); link ram(C) on bed; drive ram.slide = t;",
            "",
            "",
        ),
    ]);
}

#[test]
fn places_of_pins_are_those_of_points_that_stand_still() {
    check(&[
        (
            FOUR_BAR,
            "pin E(t, 0);",
            "t: `E` is drawn in one pose; its place there cannot depend on an input / the input drives a link, `drive LINK.angle = …;`, and the pins move with it",
        ),
        (FOUR_BAR, "pin E(3deg, 0);", "3deg: an angle where a length belongs / write `3mm`"),
        (
            FOUR_BAR,
            "pin E(x, 0);",
            "x: no input, parameter or `let` named `x` / declared so far: `t`",
        ),
    ]);
}

#[test]
fn poses_and_chains_that_are_not_decided() {
    check(&[
        (
            "input t: angle; ground A(0, 0), D(4m, 0); pin B(1m, 0), C(2m, 0); link AB(A, B), BC(B, C), DC(D, C); drive AB.angle = t;",
            "",
            "DC: in the drawing `BC` and `DC` are in one line: `left` and `right` come together there / draw another pose",
        ),
        (
            "input t: angle; ground A(0, 0), D(4m, 0), E(1m, 0); pin B(0, 1m), C(4m, 1m), F(1m, 1m); link AB(A, B), BC(B, C, F), DC(D, C), EF(E, F); drive AB.angle = t;",
            "",
            "EF: `EF` is one bar too many by count, but these bars are parallel and equal, so it moves / leave out `link EF`; two points draw it",
        ),
    ]);
}

/// Dyads of every kind and a group of class III, a billionth beside a limit.
#[test]
fn drawings_next_to_a_limit_are_refused() {
    let apart = "draw another pose";
    let with_rail = |block: &str, guide: &str| {
        format!(
            "input t: angle; ground A(0, 0), O(3m, 0); pin B(1m, 0), {block}; link AB(A, B); {guide} \
             drive AB.angle = t;"
        )
    };
    let rrp = with_rail(
        "C(1.000000001m, 2m)",
        "guide bed through C along 0deg; link BC(B, C), ram(C) on bed;",
    );
    let rpr = with_rail(
        "C(3m, 1m)",
        "link rod(O, C); guide slot on rod through (0, 2m) along 0.000000001rad; link block(B) on slot;",
    );
    let prp = with_rail(
        "C(2m, 1m)",
        "guide bed through C along 0deg; guide rod on AB through C along 0.000000001rad; \
         link ram(C) on bed; link block(C) on rod;",
    );
    let triad = "input t: angle; ground A(-1m, 0), D(4m, 0), E(2m, 5m); \
                 pin B(0, 0), P(1.000000001m, 1m), Q(3m, 1m), R(2m, 3.5m); \
                 link AB(A, B), BP(B, P), plate(P, Q, R), DQ(D, Q), ER(E, R); drive AB.angle = t;";
    // A hundredth of a metre beside it the crank can go back by a thousandth of a degree.
    let beside = triad.replace("1.000000001m", "1.01m");
    check(&[
        (
            "input t: angle; ground A(0, 0), D(4m, 0); pin B(1m, 0), C(2m, 0.000000001m); link AB(A, B), BC(B, C), DC(D, C); drive AB.angle = t;",
            "",
            &format!(
                "DC: in the drawing `BC` and `DC` are in one line: `left` and `right` come together there / {apart}"
            ),
        ),
        (
            &rrp,
            "",
            &format!(
                "ram: in the drawing `BC` stands square to its guide: `ahead` and `behind` come together there / {apart}"
            ),
        ),
        (
            &rpr,
            "",
            &format!(
                "rod#1: in the drawing `block` is at the foot of `rod`: `ahead` and `behind` come together there / {apart}"
            ),
        ),
        (
            &prp,
            "",
            &format!(
                "block: in the drawing `ram` and `block` slide along one line: they are held by nothing there / {apart}"
            ),
        ),
        (
            triad,
            "",
            &format!(
                "ER: in the drawing `BP`, `plate`, `DQ` and `ER` are at a dead point, or next to one / two ways to assemble them come together there: {apart}"
            ),
        ),
        (
            &beside,
            "",
            &format!(
                "ER: in the drawing `BP`, `plate`, `DQ` and `ER` are at a dead point, or next to one / two ways to assemble them come together there: {apart}"
            ),
        ),
    ]);
}

/// Where a drive holds two moving links together, a bar stands for them: forces in joints that are asked for are
/// refused, and those that nobody asked for are left out.
#[test]
fn reactions_beside_links_that_are_held_together() {
    let held = "input t: angle; ground A(0, 0), D(4m, 0); pin B(0.5m, 0.9m), C(3.2m, 2.6m); \
                link AB(A, B), BC(B, C), DC(D, C); drive AB.angle - BC.angle = t; mass 2kg on C;";
    let reason = "one bar stands for both links in their group, and what pushes in its joints is not what pushes in theirs";
    check(&[
        (held, "", ""),
        (held, "output C, t.drive;", ""),
        (
            held,
            "output C, DC.D;",
            &format!(
                "D: `DC.D` is not known where a drive holds two moving links together; ask for `t.drive` / {reason}"
            ),
        ),
    ]);
}

/// A bar that is a little longer holds the machine, and so does an equal one that is not parallel.
#[test]
fn bars_are_parallel_and_equal_or_too_many() {
    let with = |bar: &str| {
        format!(
            "input t: angle; ground A(0, 0), D(4m, 0), E(1m, 0); pin B(0.6m, 0.8m), C(4.6m, 0.8m), {bar}; \
             link AB(A, B), BC(B, C, F), DC(D, C), FE(F, E); drive AB.angle = t;"
        )
    };
    let parallel = "FE: `FE` is one bar too many by count, but these bars are parallel and equal, so it moves / leave out `link FE`; two points draw it";
    let too_many = "FE: `AB`, `BC`, `DC`, `FE` and the ground hold each other without `drive AB.angle`: one constraint too many / leave out `link FE`, or one of its joints or `drive AB.angle`";
    check(&[
        (&with("F(1.6m, 0.8m)"), "", parallel),
        (&with("F(1.6m, 0.801m)"), "", too_many),
        (&with("F(0.4m, 0.8m)"), "", too_many),
    ]);
}

#[test]
fn a_length_is_that_of_one_bar() {
    check(&[
        (
            "input t: angle; ground A(0, 0); pin B(1m, 0); link AB(A, B) { length: 2m, width: 1m } drive AB.angle = t;",
            "",
            "width: `link` has no field `width` / its only field is `length`; everything else is as drawn",
        ),
        (
            "input t: angle; ground A(0, 0); pin B(1m, 0); link AB(A, B), AC(A, B) { length: 2m } drive AB.angle = t;",
            "",
            "length: a length is that of one link with two pins / write it in a statement of its \
             own: `link AC(A, B) { length: … }`",
        ),
        (
            "input t: angle; ground A(0, 0); pin B(1m, 0); link AB(A, B), AC(A, B) { width: 2m } drive AB.angle = t;",
            "",
            "width: `link` has no field `width` / its only field is `length`; everything else is as drawn",
        ),
    ]);
}

/// A tipping lorry, and ten slips of the pen in it.
#[test]
fn slips_in_a_machine_with_a_slot_and_a_cylinder() {
    check(&[(LORRY, "", "")]);
    let loose = "strut: `tray`, `roller`, `gate` and `strut` still move when every input is held: 2 drives too few";
    let slips = [
        (
            "{ length: s }",
            "; ",
            "s: nothing uses the input `s`; use it or remove it / a cylinder takes it, `link lift(F, G) { length: s }`, or a drive: `drive ram.slide = s;`",
        ),
        (
            "{ length: s }",
            "; drive lift.length = s;",
            "length#2: a drive gives an angle or a slide / the length of a cylinder stands in its braces: `link lift(F, G) { length: … }`",
        ),
        (
            "{ length: s }",
            "; drive lift.slide = s;",
            "slide: `lift` slides on no guide / a cylinder has a length: `link lift(F, G) { length: … }`; what slides is declared as `link lift(…) on GUIDE;`",
        ),
        (
            "roller(R) on slot",
            "roller(R)",
            "roller: `roller` hangs on `R` alone, and turns about it / let it slide, `link roller(R) on slot;`, give it another pin, or drive it: `drive roller.angle = …;`",
        ),
        (
            "tray(O, T, K)",
            "tray(T, K)",
            &format!(
                "{loose} / drive one of them, `drive strut.angle = …;`, or pin one of them to another link"
            ),
        ),
        (
            "on slot;",
            "on tray;",
            "tray#3: `tray` is a link; a link slides on a guide / declare the slot, `guide slot on tray through O towards T;`, and write `on slot`",
        ),
        (
            "towards T",
            "along T",
            "T#2: `T` is a point; a guide runs along an angle / or towards a point: `towards T`",
        ),
        (
            "strut(M, L)",
            "strut(ground, L)",
            "ground#2: a link goes through points of the ground, not through `ground` / name a point: `ground M(…, …);`",
        ),
        (
            ", strut(M, L)",
            "",
            "gate: `gate` still moves when every input is held: one drive too few / drive it, `drive gate.angle = …;`, or pin it to another link",
        ),
        (
            "L(-0.45m, 0.35m)",
            "L(-0.3m, 0.2m)",
            "strut: in the drawing `gate` and `strut` are in one line: `left` and `right` come together there / draw another pose",
        ),
    ];
    for (right, wrong, told) in slips {
        check(&[(&LORRY.replace(right, wrong), "", told)]);
    }
}

/// A declared length says how long a bar is; the drawing only which way the machine assembles.
#[test]
fn a_length_that_is_not_drawn() {
    let bars = |length: &str| {
        format!(
            "input t: angle; ground A(0, 0), D(4m, 0); pin B(0.5m, 0.9m), C(3.2m, 2.6m); \
             link AB(A, B), DC(D, C); link BC(B, C) {{ length: {length} }} drive AB.angle = t;"
        )
    };
    let cases = [
        ("3.5m", ""),
        ("2.3m", ""),
        (
            "3.19mm",
            "3.19mm: `BC` is drawn 3.191 m long and declared 3.19 mm: a unit? / write `3.19m`, or \
             draw it about as long as it is; the pose says which way the machine assembles",
        ),
        (
            "4.26m",
            "4.26m: `BC` is drawn 3.191 m long and declared 4.26 m / draw it about as long as it is; the pose says which way the machine assembles",
        ),
    ];
    for (length, told) in cases {
        check(&[(&bars(length), "", told)]);
    }
    check(&[(
        "input t: angle; ground A(0, 0), D(4m, 0); pin B(0, 1m), C(3.9m, 0.8m); link AB(A, B), DC(D, C); link BC(B, C) { length: 4.95m } drive AB.angle = t;",
        "",
        "4.95m: no pose beside the drawing has `BC` 4.95 m long; it is drawn 3.905 m long / the machine comes to a limit in between: draw a pose with this length",
    )]);
}
