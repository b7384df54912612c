//! Mistakes in outputs.

use super::{LEVERS, Slip, check, slip};

const MASS: &str = "mass 4kg on E;";

/// A mistake in an output behind a mass, whose mending says what is meant.
macro_rules! output {
    ($wrong:literal, $at:literal, $proposed:literal, $mended:literal) => {
        slip(
            MASS,
            concat!("mass 4kg on E; ", $wrong),
            $at,
            $proposed,
            concat!("mass 4kg on E; ", $mended),
        )
        .means(&[(MASS, concat!("mass 4kg on E; ", $mended))])
    };
}

const SLIPS: [Slip; 10] = [
    output!("output E.reaction;", "reaction", "CE.E", "output CE.E;"),
    output!("output C.BC;", "BC", "BC.C", "output BC.C;"),
    output!("output BC.drive;", "drive", "BC.B", "output BC.B;"),
    output!("output peak = max(BC.C);", "max", "", "output peak = hypot(BC.C.x, BC.C.y);")
        .messages(2),
    output!("output v = rate(E);", "E#2", "E.x", "output v = rate(E.x);"),
    output!("output ram.velocity;", "velocity", "output ram.slide", "output ram.slide;"),
    output!(
        "output a = rate(rate(ram.slide));",
        "rate(ram.slide)",
        "",
        "output a = rate(ram.slide);"
    ),
    output!(
        "output angle(BC, DC);",
        "angle",
        "BC.angle - DC.angle",
        "output fold = BC.angle - DC.angle;"
    ),
    output!(
        "output reach: distance(A, C);",
        ":",
        "reach = distance(A, C)",
        "output reach = distance(A, C);"
    ),
    output!("output BC.angel;", "angel", "angle", "output BC.angle;"),
];

#[test]
fn mistakes_about_outputs_are_mended_by_what_is_proposed() {
    check(LEVERS, &SLIPS);
}
