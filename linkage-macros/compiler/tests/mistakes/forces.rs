//! Mistakes in masses, forces, springs and stops.

use super::{LEVERS, Slip, check, slip};

const FORCE: &str = "force (0, -work) on E;";
const MASS: &str = "mass 4kg on E;";

const SLIPS: [Slip; 21] = [
    slip(FORCE, "force (0, -work) on A;", "A", "", FORCE),
    slip(FORCE, "force (0, -work) on CE;", "CE", "", FORCE),
    slip(FORCE, "force work on E;", "on", "", FORCE),
    slip(FORCE, "force work along bed on ram;", "along", "", "force (work, 0) in bed on E;")
        .means(&[(FORCE, "force (work, 0) in bed on E;")]),
    slip(
        FORCE,
        "force (0N, -work) on CE at (10mm, 0);",
        "at",
        "point P on CE at (10mm, 0);",
        "point P on CE at (10mm, 0); force (0N, -work) on P;",
    )
    .means(&[(FORCE, "point P on CE at (10mm, 0); force (0N, -work) on P;")]),
    slip(FORCE, "/* no force */", "before work", "", FORCE),
    slip(MASS, "mass 4kg on D;", "D", "", MASS),
    slip(MASS, "mass 4kg on ram;", "ram", "… on ram at E", "mass 4kg on ram at E;")
        .means(&[(MASS, "mass 4kg on ram at E;")]),
    slip(MASS, "mass 4kg on ram uniform;", "uniform", "", "mass 4kg on ram at E;")
        .means(&[(MASS, "mass 4kg on ram at E;")]),
    slip(
        "mass 1kg on BC uniform;",
        "mass 1kg on BC;",
        "BC",
        "… on BC uniform",
        "mass 1kg on BC uniform;",
    ),
    slip(MASS, "mass -4kg on E;", "-4kg", "", MASS),
    slip(MASS, "mass 40N on E;", "40N", "40N / 9.81(m/s^2)", "mass 40N / 9.81(m/s^2) on E;")
        .means(&[(MASS, "mass 40N / 9.81(m/s^2) on E;")]),
    slip(MASS, "mass 4kg on E inertia 0.1(kg*m^2);", "0.1(kg*m^2)", "", MASS),
    slip(
        "gravity (0, -9.81);",
        "gravity 9.81;",
        "9.81",
        "gravity (0, -9.81);",
        "gravity (0, -9.81);",
    ),
    slip(
        "gravity (0, -9.81);",
        "gravity (0, -9.81N);",
        "-9.81N",
        "-9.81(m/s^2)",
        "gravity (0, -9.81(m/s^2));",
    ),
    slip(
        "gravity (0, -9.81);",
        "gravity (0, -9.81); gravity (0, -1.62);",
        "gravity#2",
        "",
        "gravity (0, -9.81);",
    ),
    slip(
        "link BC(B, C);",
        "link BC(B, C) { length: 304mm + work / 1(N/m) }",
        "work",
        "",
        "link BC(B, C);",
    ),
    slip(
        FORCE,
        "torque 5(N*m) on B; force (0, -work) on E;",
        "B",
        "AB",
        "torque 5(N*m) on AB; force (0, -work) on E;",
    )
    .means(&[(FORCE, "torque 5(N*m) on AB; force (0, -work) on E;")]),
    slip(
        FORCE,
        "torque 5N on AB; force (0, -work) on E;",
        "5N",
        "5(N*m)",
        "torque 5(N*m) on AB; force (0, -work) on E;",
    )
    .means(&[(FORCE, "torque 5(N*m) on AB; force (0, -work) on E;")]),
    slip(FORCE, "force (0, -wrok) on E;", "wrok", "work", FORCE),
    slip("load work: force;", "load work;", ";", "load work: force;", "load work: force;"),
];

/// Behind the mass.
const SPRING: &str =
    "mass 4kg on E; spring s between E and A { stiffness: 10(N/m), free_length: 10mm }";
const STOP: &str =
    "mass 4kg on E; stop low ram.slide between (100mm, 300mm) { stiffness: 2e4(N/m) }";

const HOLDERS: [Slip; 11] = [
    slip(MASS, "mass 4kg on E; spring s on E { stiffness: 10(N/m), free_length: 10mm }", "on#2", "", SPRING)
        .means(&[(MASS, SPRING)]),
    slip(
        MASS,
        "mass 4kg on E; spring s between AB and DC { stiffness: 10(N/m), free_angle: 10deg }",
        "10(N/m)",
        "10(N*m)",
        "mass 4kg on E; spring s between AB and DC { stiffness: 10(N*m), free_angle: 10deg }",
    )
    .means(&[(MASS, "mass 4kg on E; spring s between AB and DC { stiffness: 10(N*m), free_angle: 10deg }")]),
    slip(
        MASS,
        "mass 4kg on E; spring s between E and (0, 0) { stiffness: 10(N/m), free_length: 10mm }",
        "(#1",
        "ground P(0, 0);",
        "mass 4kg on E; ground P(0, 0); spring s between E and P { stiffness: 10(N/m), free_length: 10mm }",
    )
    .means(&[(MASS, "mass 4kg on E; ground P(0, 0); spring s between E and P { stiffness: 10(N/m), free_length: 10mm }")]),
    slip(MASS, "mass 4kg on E; spring s between E and A { free_length: 10mm }", "}", "", SPRING).means(&[(MASS, SPRING)]),
    slip(
        MASS,
        "mass 4kg on E; spring s between E and A { stiffness: 10(N/m), preload: 20N }",
        "preload",
        "free_length",
        SPRING,
    )
    .means(&[(MASS, SPRING)])
    .messages(2),
    slip(
        MASS,
        "mass 4kg on E; spring s between E and A { stiffness: 10N/m, free_length: 10mm }",
        "10N/m",
        "10(N/m)",
        SPRING,
    )
    .means(&[(MASS, SPRING)]),
    slip(
        MASS,
        "mass 4kg on E; damper d between E and A { damping: 10(N*s/m) }",
        "damper",
        "spring d between E and A { damping: 10(N*s/m) }",
        "mass 4kg on E; spring d between E and A { damping: 10(N*s/m) }",
    )
    .means(&[(MASS, "mass 4kg on E; spring d between E and A { damping: 10(N*s/m) }")]),
    slip(
        MASS,
        "mass 4kg on E; spring d between E and A { damping: 10(N/m) }",
        "10(N/m)",
        "10(N*s/m)",
        "mass 4kg on E; spring d between E and A { damping: 10(N*s/m) }",
    )
    .means(&[(MASS, "mass 4kg on E; spring d between E and A { damping: 10(N*s/m) }")]),
    slip(
        MASS,
        "mass 4kg on E; stop low ram.slide between (100deg, 300mm) { stiffness: 2e4(N/m) }",
        "100deg",
        "100mm",
        STOP,
    )
    .means(&[(MASS, STOP)]),
    slip(
        MASS,
        "mass 4kg on E; stop low ram.slide between (300mm, 100mm) { stiffness: 2e4(N/m) }",
        "100mm",
        "between (100mm, 300mm)",
        STOP,
    )
    .means(&[(MASS, STOP)]),
    slip(MASS, "mass 4kg on E; stop low E.y between (100mm, 300mm) { stiffness: 2e4(N/m) }", "E.y", "", STOP)
        .means(&[(MASS, STOP)]),
];

#[test]
fn mistakes_about_forces_are_mended_by_what_is_proposed() {
    check(LEVERS, &SLIPS);
}

#[test]
fn mistakes_about_springs_and_stops_are_mended_by_what_is_proposed() {
    check(LEVERS, &HOLDERS);
}
