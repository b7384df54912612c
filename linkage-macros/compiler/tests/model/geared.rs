//! Drives of a drawing by one input, which agree with it or not.

use std::f64::consts::PI;

use super::check;
use crate::oracle::mechanism;

/// Two cranks by one input, and a rod between them. The first is drawn at 135°, the second at 45°.
const GEARED: &str = "input t: angle; ground A(0, 0), D(6m, 0); pin B(-1m, 1m), C(7m, 1m), P(3m, 5m); \
                      link AB(A, B), DC(D, C), BP(B, P), CP(C, P); drive AB.angle = t;";

/// Several drives of one input agree with the drawing, but for whole turns and a careless pen.
#[test]
fn drives_that_contradict_the_drawing() {
    let slip = |value: &str, is: &str| {
        format!(
            "{value}: `drive DC.angle` contradicts the drawing: it is {is} where the others are as drawn, and drawn as 45.0° / \
             draw `DC` there, or change the value: in the drawing every drive holds"
        )
    };
    check(&[
        (GEARED, "drive DC.angle = 180deg - AB.angle;", ""),
        (GEARED, "drive DC.angle = 178deg - t;", ""),
        (GEARED, "drive DC.angle = 900deg - AB.angle;", ""),
        (GEARED, "drive DC.angle = 3 * t;", ""),
        (GEARED, "drive DC.angle = 45deg;", ""),
        (GEARED, "drive DC.angle = 170deg - AB.angle;", &slip("170deg - AB.angle", "35.0°")),
        (GEARED, "drive DC.angle = 10deg - t;", &slip("10deg - t", "-125.0°")),
        (GEARED, "drive DC.angle = 60deg;", &slip("60deg", "60.0°")),
        (GEARED, "drive DC.angle - AB.angle = -90deg;", ""),
        (
            GEARED,
            "drive DC.angle - AB.angle = 90deg;",
            "90deg: `drive DC.angle - AB.angle` contradicts the drawing: it is 90.0° where the others are as drawn, and drawn as -90.0° / \
             draw `DC` there, or change the value: in the drawing every drive holds",
        ),
    ]);
    let platform = "input a, c: length; ground A(0, 0), B(4m, 0), C(2m, 5m); pin P(0, 2m), Q(3m, 1m), R(1.7m, 2.6m); \
                    link la(A, P) { length: a } link lc(C, R) { length: c } link plate(P, Q, R);";
    check(&[
        (platform, "link lb(B, Q) { length: a / sqrt(2) }", ""),
        (
            platform,
            "link lb(B, Q) { length: 0.8 * a }",
            "0.8 * a: the length of `lb` contradicts the drawing: it is 1.6 m where the others are as drawn, and drawn as 1.414 m / \
             draw `lb` there, or change the value: in the drawing every drive holds",
        ),
    ]);
}

/// The input is where the drives are drawn, whichever of them says so.
#[test]
fn geared_drives_say_where_the_input_is_drawn() {
    for (second, drawn) in [
        ("180deg - AB.angle", 0.75 * PI),
        ("3 * t", 0.75 * PI),
        ("-5 * t", 0.75 * PI),
        ("t / 3", 0.75 * PI),
    ] {
        let (bars, first) = GEARED.split_at(GEARED.rfind("drive").expect("a drive"));
        let second = format!("drive DC.angle = {second};");
        for drives in [format!("{first} {second}"), format!("{second} {first}")] {
            let inputs = mechanism(&format!("struct M {{ {bars} {drives} }}")).drawn;
            let off = inputs.expect("it is determined")[0] - drawn;
            assert!(off.abs() < 1e-12, "{drives}: {off:e}");
        }
    }
}

/// A block drawn half a length along its guide, and a crank at 30° that another input turns.
const BENT: &str = "ground A(0, 0); guide bed through A along 0deg; pin C(50mm, 0), B(60mm, 34.6410161513775mm); \
                    link block(C) on bed, AB(A, B);";

/// Drives that are no linear functions of their inputs hold in the drawing nevertheless: angles and lengths are
/// those whose sines, roots and squares are drawn.
#[test]
fn bent_drives_say_where_the_input_is_drawn() {
    let drives = |slide: &str, angle: &str| {
        format!("{BENT} drive block.slide = {slide}; drive AB.angle = {angle};")
    };
    for (inputs, slide, angle, drawn) in [
        ("t: angle", "100mm * sin(t)", "t", [PI / 6.0, f64::NAN]),
        ("t: angle", "100mm * cos(t)", "30deg", [PI / 3.0, f64::NAN]),
        // Where the secant from zero to one is level.
        ("t: angle", "50mm + 100mm * sin(180 * t / 57.29577951308232)", "30deg", [0.0, f64::NAN]),
        ("s: length", "sqrt(s * s + 1600(mm^2))", "30deg", [0.03, f64::NAN]),
        ("s: length", "s", "asin(s / 0.1m)", [0.05, f64::NAN]),
        ("a, b: angle", "100mm * sin(a)", "b + sin(2 * a) - sin(60deg)", [PI / 6.0, PI / 6.0]),
    ] {
        let source = format!("struct M {{ input {inputs}; {} }}", drives(slide, angle));
        let found = mechanism(&source).drawn;
        let found = found.unwrap_or_else(|| panic!("{slide}, {angle}: not determined"));
        for (found, drawn) in found.iter().zip(drawn) {
            assert!((found - drawn).abs() < 1e-9, "{slide}, {angle}: {found} for {drawn}");
        }
    }
    let base = format!("input t: angle; {BENT} drive AB.angle = 30deg;");
    check(&[(
        &base,
        "drive block.slide = 40mm * sin(t);",
        "40mm * sin(t): `drive block.slide` cannot be as drawn: no input was found at which it is 50 mm / \
         draw `block` where its value takes it, or change the value",
    )]);
    let base = format!("input t: angle; {BENT}");
    check(&[(
        &base,
        "drive block.slide = 100mm * sin(t); drive AB.angle = 2 * t;",
        "2 * t: `drive AB.angle` contradicts the drawing: it is 60.0° where the others are as drawn, and drawn as 30.0° / \
         draw `AB` there, or change the value: in the drawing every drive holds",
    )]);
}
