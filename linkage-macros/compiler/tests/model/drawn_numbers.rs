//! The numbers of a drawing: every mistake in them is told once, at its token.

use super::{check, resolved};
use crate::model::drawn::value_at_defaults;
use crate::model::mechanism::{Mechanism, Scalar};

/// A four-bar with these statements in place of its pins.
fn bars(pins: &str) -> String {
    format!(
        "input t: angle; ground A(0, 0), D(4m, 0); {pins} \
         link AB(A, B), BC(B, C), DC(D, C); drive AB.angle = t;"
    )
}

fn check_pins(rows: &[(&str, &str)]) {
    for (pins, told) in rows {
        check(&[(&bars(pins), "", told)]);
    }
}

const MOVES: &str =
    "moves with what reads it here / a drive, a length or a place reads what does not move with it";

/// Nobody has written the groups of a drawing, so that no message names them.
#[test]
fn statements_that_need_each_other_through_a_drawing() {
    let four_bar = bars("pin B(0.5m, 0.9m), C(3.2m, 2.6m);");
    let read = |value: &str| four_bar.replace("angle = t", &format!("angle = {value}"));
    let long = |length: &str| {
        let own = format!("DC(D, C); link BC(B, C) {{ length: {length} }}");
        four_bar.replace("BC(B, C), DC(D, C);", &own)
    };
    let gears = "input t: angle; ground A(0, 0), D(4m, 0); pin B(1m, 0.5m), C(5m, 0.5m); \
                 link AB(A, B), DC(D, C); drive AB.angle = DC.angle + t; drive DC.angle = AB.angle - t;";
    let each_other = "each is made of the other; give one of them without it";
    check(&[
        (&read("DC.angle + t"), "", &format!("DC#2: `DC` {MOVES}")),
        (
            &read("t + k").replace("drive", "let k = DC.angle; drive"),
            "",
            &format!("DC#2: `DC` {MOVES}"),
        ),
        (&read("t + atan2(C.y, C.x) - 39deg"), "", &format!("C#4: `C` {MOVES}")),
        (&long("distance(A, C) - 0.9m"), "", &format!("C#4: `C` {MOVES}")),
        (&long("k").replace("link AB", "let k = C.x; link AB"), "", &format!("C#2: `C` {MOVES}")),
        (gears, "", &format!("DC#2: `DC` {MOVES}")),
        (
            &four_bar,
            "let a = b; let b = a;",
            &format!("b#1: `let a` and `let b` need each other / {each_other}"),
        ),
        (
            "input t: angle; ground A(0, 0); pin B(0.5m, 0.9m);",
            "pin C(h, 2m); let h = AB.angle * 1m; link AB(A, B), BC(B, C); drive AB.angle = t; drive BC.angle = t;",
            &format!("h#1: `h` {MOVES}"),
        ),
        (
            "input t: angle; ground A(0, 0);",
            "pin B(C.x, 1m); pin C(B.x, 2m); link AB(A, B), BC(B, C); drive AB.angle = t; drive BC.angle = t;",
            &format!("C#1: `pin B` and `pin C` need each other / {each_other}"),
        ),
    ]);
}

/// The guide is on the link that the group places on what slides.
#[test]
fn an_angle_drives_no_slide_whichever_body_carries_the_guide() {
    let slot = "input t, u: angle; ground A(0, 0), E(1m, 0); pin P(0.5m, 0.2m); link rod(P); \
                guide slot on rod through P along 0deg;";
    let told = "an angle where a length belongs / an angle times a length is a length, as in `theta * 20mm`";
    check(&[
        (slot, "link base(A, E) on slot; drive base.slide = t + u;", &format!("t + u: {told}")),
        (
            slot,
            "pin B(0, 1m); link AB(A, B) on slot; drive AB.angle = t; drive AB.slide = -u;",
            &format!("-u: {told}"),
        ),
        (
            slot,
            "pin B(0, 1m); link AB(A, B) on slot; drive AB.angle = t; drive AB.slide = 1m * u;",
            "",
        ),
    ]);
}

#[test]
fn a_misspelt_mode_of_a_group_beside_a_drawing() {
    let four_bar = bars("pin B(0.5m, 0.9m), C(3.2m, 2.6m), E(4.5m, 1.5m);");
    let meaning = "`left` or `right`: the side of `E` seen from `C` looking to `D`";
    check(&[
        (&four_bar, "rrr CE(C), DE(D) -> E { lengths: (1.7m, 1.58m) }", ""),
        (
            &four_bar,
            "rrr CE(C), DE(D) -> E { lengths: (1.7m, 1.58m), mode: lefft }",
            &format!(
                "lefft: no mode named `lefft`; a mode with a similar name exists: `left` / {meaning}"
            ),
        ),
        (
            &four_bar,
            "rrr CE(C), DE(D) -> E { lengths: (1.7m, 1.58m), mode: ahead }",
            &format!("ahead: `ahead` is no mode of `rrr` / {meaning}"),
        ),
        (
            &four_bar,
            "rrr CE(C), DE(D) -> E { lengths: (1.7m, 1.58m), mod: left }",
            "mod: `rrr` has no field `mod`; a field with a similar name exists: `mode`",
        ),
    ]);
}

/// Sums and products of what `f64` holds may be more than it holds.
#[test]
fn numbers_too_large_for_a_drawing() {
    let told = "a number too large for a drawing; change its exponent / a drawing multiplies lengths with each other, \
                and `f64` ends at 1e308";
    check_pins(&[
        ("pin B(1e308m, 0), C(-1e308m, 1m);", &format!("1e308m#1: {told}")),
        ("pin B(0.5m, -1e200m), C(3.2m, 2.6m);", &format!("-1e200m: {told}")),
        ("param l = 1e308m; pin B(l, 0.9m), C(-l, 2.6m);", &format!("l#2: {told}")),
    ]);
    let crank = "input t: angle; ground A(0, 0); pin B(1m, 0); link AB(A, B); drive AB.angle = t;";
    check(&[
        (crank, "point P on AB at (1e308m, 0);", &format!("1e308m: {told}")),
        (
            &crank.replace("link AB(A, B);", "link AB(A, B) { length: 1e308m }"),
            "",
            &format!("1e308m: {told}"),
        ),
        (
            "input s: length;",
            "ground A(1e308m, 0); guide bed through A along 30deg; pin B(0, 0); link ram(B) on bed; drive ram.slide = s;",
            &format!("1e308m: {told}"),
        ),
    ]);
}

#[test]
fn numbers_that_are_none_at_the_defaults_of_parameters() {
    let told = "this is no number where every parameter is its default; change one of these / a machine is drawn \
                with the defaults of its parameters";
    let pin_c = "C(3.2m, 2.6m);";
    let rows = [
        ("ln(k) * 1m", "ln(k) * 1m"),
        ("1m / (k + 1)", "1m / (k + 1)"),
        ("exp(-k * 2000) * 1m", "exp(-k * 2000) * 1m"),
    ];
    for (place, at) in rows {
        check_pins(&[(
            &format!("param k = -1; pin B({place}, 0.9m), {pin_c}"),
            &format!("{at}: {told}"),
        )]);
    }
    check_pins(&[(
        &format!("param k = -1; let r = sqrt(k) * 1m; pin B(r, 0.9m), {pin_c}"),
        &format!("r#2: {told}"),
    )]);
    let crank = "input t: angle; param k = -1; ground A(0, 0); pin B(1m, 0), C(0.5m, 0.5m); link AC(A, C); \
                 drive AC.angle = t;";
    let link = "link AB(A, B); drive AB.angle = t;";
    for (statements, at) in [
        ("link AB(A, B) { length: sqrt(k) * 1m } drive AB.angle = t;".to_string(), "sqrt(k) * 1m"),
        (format!("{link} point P on AB at polar (1m, acos(2 * k));"), "acos(2 * k)"),
        (
            format!("{link} guide g on AB through (sqrt(k) * 1m, 0) along 0deg; link ram(C) on g;"),
            "sqrt(k) * 1m",
        ),
    ] {
        check(&[(crank, &statements, &format!("{at}: {told}"))]);
    }
}

/// The lengths of the groups at the defaults of the parameters.
fn lengths(pins: &str) -> Vec<f64> {
    let (mechanism, told) = resolved(&bars(pins));
    let mechanism = mechanism.unwrap_or_else(|| panic!("{pins}: {told}"));
    let value = |length: &Scalar, mechanism: &Mechanism| {
        value_at_defaults(length, mechanism, &[]).expect("a length that no input changes")
    };
    let groups = mechanism.group_steps().flat_map(|group| group.lengths.iter().flatten());
    groups.map(|length| value(&length.value, &mechanism)).collect()
}

/// Pins stand still in the drawing, and named expressions that read them are numbers there, whatever they are where the
/// machine moves.
#[test]
fn places_by_functions_and_by_other_pins_are_plain_numbers() {
    let rows = [
        (
            "param k = 2; pin B(ln(k) * 1m, 0.9m), C(3.2m, 2.6m);",
            "pin B(0.6931471805599453m, 0.9m), C(3.2m, 2.6m);",
        ),
        (
            "param k = 0.5m; pin B(k, 0.9m); let h = B.x; pin C(h + 2.7m, 2.6m);",
            "pin B(0.5m, 0.9m), C(3.2m, 2.6m);",
        ),
        (
            "param k = 0.5m; pin B(k, 0.9m); let h = B.x; let g = 2 * h; pin C(g + 2.2m, 2.6m);",
            "pin B(0.5m, 0.9m), C(3.2m, 2.6m);",
        ),
        (
            "param k = 0.3m; pin B(k, 0.4m); pin C(distance(A, B) + 2.7m, 2.6m);",
            "pin B(0.3m, 0.4m), C(3.2m, 2.6m);",
        ),
    ];
    for (given, plain) in rows {
        let (given, plain) = (lengths(given), lengths(plain));
        assert_eq!(given.len(), 3);
        for (given, plain) in given.iter().zip(plain) {
            // Roundings of a few sums and a root.
            assert!((given - plain).abs() < 1e-15 * 8.0, "{given} in place of {plain}");
        }
    }
}

#[test]
fn names_in_places_of_pins() {
    let in_one_pose = "is drawn in one pose; its place there cannot depend on an input / the input drives a link, \
                       `drive LINK.angle = …;`, and the pins move with it";
    let no_place = "`C` has no place in the drawing / a pin is drawn where numbers say, and links move after that";
    let near = "no point named `Bb`; a point with a similar name exists: `B`";
    check_pins(&[
        (
            "pin B(0.5kg, 0.9m), C(3.2m, 2.6m);",
            "0.5kg: a mass where a length belongs / multiply or divide by what is missing",
        ),
        ("pin B(0.5m, 0.9m); pin C(Bb.x + 2.7m, 2.6m);", &format!("Bb: {near}")),
        ("pin B(0.5m, 0.9m); let h = Bb.x + 2.7m; pin C(h, 2.6m);", &format!("Bb: {near}")),
        (
            "pin B(0.5m, 0.9m); let h = B.z; pin C(h, 2.6m);",
            "z: a point has no `z`; it has `x` and `y` / write `B.x` or `B.y`; `output B` gives both",
        ),
        (
            "pin C(B.x + 2.7m, 2.6m); pin B(0.5m, 0.9m);",
            "B#1: `B` is used before `pin B` makes it / this order works: `pin B`, `pin C`",
        ),
        (
            "let h = B.x; pin C(h + 2.7m, 2.6m); pin B(0.5m, 0.9m);",
            "B#1: `B` is used before `pin B` makes it / this order works: `pin B`, `let h`",
        ),
        ("let w = 2 * t; pin B(w * 1m, 0.9m), C(3.2m, 2.6m);", &format!("w#2: `B` {in_one_pose}")),
        ("pin B(0.5m, 0.9m), C(AB.angle * 1m, 2.6m);", &format!("AB.angle#1: `C` {in_one_pose}")),
        ("let w = AB.angle; pin B(0.5m, 0.9m), C(w * 1m, 2.6m);", &format!("w#2: {no_place}")),
        (
            "pin B(0.5m, 0.9m); let w = asin(B.x / 0.1m); pin C(w * 1m, 2.6m);",
            "B.x / 0.1m: `asin(5)` has no value / a sine or a cosine lies between -1 and 1",
        ),
        (
            "param k = AB.angle * 1m; pin B(k, 0.9m), C(3.2m, 2.6m);",
            "AB.angle * 1m: the default of `k` is not a constant / `let` names an expression of inputs and parameters",
        ),
        (
            "load f: force; pin B(0.5m, 0.9m), C(f / 1N * 1m, 2.6m);",
            "f#2: `f` is a load, and stands in forces, torques and outputs alone / what the mechanism is made of and how it moves depends on no load",
        ),
        (
            "pin B(0.5m, 0.9m); pin C(B, 2.6m);",
            "B#2: `B` is a point, not a number / its coordinates are `B.x` and `B.y`",
        ),
        (
            "pin B(0.5m, 0.9m), C(3.2m, 2.6m); pin B(1m, 0.9m);",
            "B#2: the name `B` is taken; choose another / the first `B` is made by `pin B`",
        ),
        (
            "pin A(0, 0), B(0.5m, 0.9m), C(3.2m, 2.6m);",
            "A#2: leave out `A` here / a point of the ground is a pin of the links through it already",
        ),
        (
            "pin B(0, 0), C(3.2m, 2.6m);",
            "B#1: `B` is drawn where `A` is, and `AB` has no length / draw the two pins about as far apart as the link is long",
        ),
        (
            "param k = 0.5m; pin B(k, 0.9m), C(0.5m, 0.9m);",
            "C#1: `C` is drawn where `B` is, and `BC` has no length / draw the two pins about as far apart as the link is long",
        ),
        (
            "let k = zz + 1; pin B(yy, 0.9m), C(3.2m, 2.6m);",
            "zz: no input, parameter or `let` named `zz` / declared so far: `t`\nyy: no input, parameter or `let` named `yy` / declared so far: `t`, `k`",
        ),
    ]);
}

/// A pin that stands still in the drawing moves where a named expression reads it.
#[test]
fn named_expressions_of_pins_are_judged_where_these_move() {
    let four_bar = bars("pin B(0.5m, 0.9m), C(3.2m, 2.6m);");
    check(&[
        (&four_bar, "let h = asin(C.x / 1m); output h;", ""),
        (&four_bar, "let v = rate(C.x); mass 1kg on C; force (-v * 1(kg/s), 0) on C;", ""),
        (&four_bar, "output a; let a = 2 * b; let b = B.x;", ""),
        (
            &four_bar,
            "let h = C.x + 1kg; output h;",
            "1kg: a mass where a length belongs / what stands left of the `+` is a length",
        ),
        (
            &four_bar,
            "let h = Cc.x; output h;",
            "Cc: no point named `Cc`; a point with a similar name exists: `C`",
        ),
        (
            &four_bar,
            "point P on BC at (k, 0); let k = P.x;",
            "k#1: `P` has no place in the drawing / its place on the link depends on an input, or on the point itself",
        ),
    ]);
}
