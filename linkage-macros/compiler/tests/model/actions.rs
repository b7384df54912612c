//! Masses, loads, forces and torques, and the outputs about them.

use super::*;

/// Everything that can be said about forces.
const ACTIONS: &str = "param g = 9.81(m/s^2); gravity (0, -g); load cut, work: force; load twist: torque;
    load share: number; point G on BC at (1m, 0.2m); param m = 2kg; guide way on BC through B along 30deg;
    mass m on BC at G inertia 0.1(kg*m^2); mass 2 on DC at (0.5m, 0); mass 100g on BC uniform;
    mass 2kg on C; mass 1kg on BC at C; inertia 0.3(kg*m^2) on AB; mass 1kg on B;
    force (0, -cut) on G; force (share * 10N, 0) in BC on C; force (1kN, 0) in way on E;
    force work + 3N between A and E; torque twist on DC; torque 2(N*m) between ground and BC;
    torque -twist between AB and DC;";

#[test]
fn everything_about_forces_is_understood() {
    check(&[
        (SIX_BAR, ACTIONS, ""),
        (
            SIX_BAR,
            "mass 1kg on BC uniform; output t.drive, AB.drive, BC.B, BC.C, AB.B, block.rail, block.E, CE.C;",
            "",
        ),
        (SIX_BAR, "mass 1kg on BC uniform; output C;", ""),
    ]);
    let (mechanism, _) = resolved(&format!("{SIX_BAR} {ACTIONS}"));
    let dynamics = mechanism.expect("it is understood").dynamics;
    assert_eq!((dynamics.masses.len(), dynamics.forces.len(), dynamics.torques.len()), (7, 4, 3));
    let paths: Vec<_> =
        dynamics.asked.iter().map(|asked| format!("{}.{}", asked.owner, asked.field)).collect();
    let expected = "t.drive AB.drive AB.A AB.B BC.B BC.C DC.D DC.C CE.C CE.E block.E block.rail";
    assert_eq!(paths.join(" "), expected);
}

#[test]
fn dimensions_of_what_acts_are_checked() {
    check(&[
        (CRANK, "mass 2m on AB at (0, 0);", "2m: a length where a mass belongs / write `2kg`"),
        (
            CRANK,
            "mass 2kg on AB at (0, 0) inertia 1kg;",
            "1kg: a mass where a moment of inertia belongs / write `1(kg*m^2)`",
        ),
        (
            CRANK,
            "mass 1kg on B; gravity (0, -9.81N);",
            "-9.81N: a force where an acceleration belongs / write `-9.81(m/s^2)`",
        ),
        (CRANK, "force (0, 2kg) on B;", "2kg: a mass where a force belongs / write `2N`"),
        (CRANK, "torque 2N on AB;", "2N: a force where a torque belongs / write `2(N*m)`"),
        (
            CRANK,
            "load f: force; torque f on AB;",
            "f#2: a force where a torque belongs / multiply or divide by what is missing",
        ),
    ]);
}

#[test]
fn loads_stand_in_forces_and_nowhere_else() {
    const REASON: &str = "what the mechanism is made of and how it moves depends on no load";
    let refused = |at: &str| {
        format!(
            "{at}#2: `{at}` is a load, and stands in forces, torques and outputs alone / {REASON}"
        )
    };
    for statements in [
        "load f: force; mass f on AB at (0, 0); force (f, 0) on B;",
        "load f: number; point P on AB at (f * 1m, 0); force (f * 1N, 0) on B;",
        "load f: number; mass 1kg on B; gravity (0, -f * 9.81(m/s^2)); force (f * 1N, 0) on B;",
    ] {
        check(&[(CRANK, statements, &refused("f"))]);
    }
    check(&[
        (
            CRANK,
            "load cut: force; force (1, 0) on B;",
            "cut: nothing uses the load `cut`; use it or remove it / as in `force (0, -cut) on P`",
        ),
        (
            CRANK,
            "load turn: torque; force (1, 0) on B;",
            "turn: nothing uses the load `turn`; use it or remove it / as in `torque turn on BC`",
        ),
        (
            CRANK,
            "load cut: forc; force (1, cut) on B;",
            "forc: no load kind named `forc`; one with a similar name exists: `force` / it is \
             `force`, `torque` or `number`",
        ),
        (
            CRANK,
            "load AB: force; force (1, 0) on B;",
            "AB: the name `AB` is taken; choose another / the first `AB` is made by `crank AB`",
        ),
    ]);
}

#[test]
fn a_mass_is_the_machines_own() {
    const REASON: &str = "it is made of constants and parameters";
    check(&[
        (CRANK, "mass t * 1kg on B;", &format!("t: a mass cannot depend on an input / {REASON}")),
        (
            CRANK,
            "mass 1kg on AB at (0, 0) inertia t * 1(kg*m^2);",
            &format!("t: a moment of inertia cannot depend on an input / {REASON}"),
        ),
        (
            CRANK,
            "mass 1kg on B; gravity (0, B.y * 1(1/s^2));",
            &format!("B.y: gravity cannot depend on an input / {REASON}"),
        ),
        (CRANK, "mass -2kg on B;", "-2kg: a mass of -2; make it zero or greater"),
        (CRANK, "mass 0kg on B;", ""),
        (
            CRANK,
            "inertia -0.1(kg*m^2) on AB;",
            "-0.1(kg*m^2): a moment of inertia of -0.1; make it zero or greater",
        ),
        (CRANK, "param m = -1kg; mass m on B;", "-1kg: a mass of -1; make it zero or greater"),
        (
            CRANK,
            "mass 1kg on B; gravity (0, -9.81); gravity (0, 0);",
            "gravity#2: gravity is given twice; remove one",
        ),
        (
            CRANK,
            "gravity (0, -9.81); force (1, 0) on B;",
            "gravity: gravity without a mass does nothing; declare one or remove it / as in `mass \
             2kg on BC uniform`",
        ),
    ]);
}

#[test]
fn a_mass_has_a_place_that_moves() {
    check(&[
        (
            CRANK,
            "mass 1kg on D;",
            "D: `D` is a point of the ground, and a mass there does nothing / name a point of a \
             link, a pin or a driven point",
        ),
        (
            CRANK,
            "mass 1kg on AB;",
            "AB: say where on `AB` the mass is / `… on AB uniform`, `… on AB at A` or `… on AB at \
             (x, y)`",
        ),
        (SIX_BAR, "mass 1kg on BC at D;", "D: `D` is no point of `BC` / its points are `B`, `C`"),
        (
            SIX_BAR,
            "mass 1kg on block uniform;",
            "uniform: `block` is no bar with two joints, and cannot be `uniform` / give its centre: \
             `… on block at (x, y) inertia …`",
        ),
        (
            "input s: length; ground A(0, 0), D(4m, 0);",
            "rrr BC(A), DC(D) -> C { lengths: (3m + s, 3m), mode: left } mass 1kg on BC uniform;",
            "uniform: the length of `BC` changes, and it cannot be `uniform` / give its centre: `… \
             on BC at (x, y) inertia …`",
        ),
        (
            SIX_BAR,
            "mass 1kg on BC uniform inertia 1(kg*m^2);",
            "1(kg*m^2): leave this inertia out / `uniform` means m l²/12",
        ),
        (
            SIX_BAR,
            "mass 1kg on C inertia 1(kg*m^2);",
            "1(kg*m^2): leave this inertia out / a mass on a pin is a point; what turns is a link: \
             `mass … on BC at C`",
        ),
        (
            CRANK,
            "crank wheel(B) { angle: 0 } mass 1kg on wheel uniform;",
            "uniform: `wheel` is no bar with two joints, and cannot be `uniform` / give its centre: \
             `… on wheel at (x, y) inertia …`",
        ),
    ]);
}

#[test]
fn a_force_acts_on_what_moves() {
    const GROUND: &str = "name a point of a link, a pin or a driven point";
    const FIXED: &str = "what acts between them moves nothing; it does where an input drives a coordinate \
                         of one, as in `at (0.2m + s, 0)`";
    check(&[
        (
            CRANK,
            "force (1, 0) on D;",
            &format!("D: `D` is a point of the ground, and a force there does nothing / {GROUND}"),
        ),
        (
            CRANK,
            "force 3N between A and D;",
            &format!("D: `A` and `D` are fixed to one body / {FIXED}"),
        ),
        (
            CRANK,
            "point P on AB at (1m, 1m); force 3N between B and P;",
            &format!("P#2: `B` and `P` are fixed to one body / {FIXED}"),
        ),
        (CRANK, "point P on AB at (1m, 0.5m * t); force 3N between B and P;", ""),
        (CRANK, "point P on AB at polar (1m, t); force 3N between P and B;", ""),
        (
            "input t: angle; param e = 0.1m; ground A(0, 0); crank AB(A) -> B { length: 1m + e, angle: t }",
            "point P on AB at (e, 1m); force 3N between B and P;",
            &format!("P#2: `B` and `P` are fixed to one body / {FIXED}"),
        ),
        (
            "input t: angle; input s: length; ground A(0, 0); crank AB(A) -> B { length: s, angle: t }",
            "point P on AB at (1m, 1m); force 3N between P and B;",
            "",
        ),
        (
            CRANK,
            "force 3N between B and B;",
            "B#2: a force acts between two points / what acts inside a body moves nothing",
        ),
        (
            CRANK,
            "torque 3(N*m) between AB and AB;",
            "AB#2: a torque acts between two bodies / what acts inside a body moves nothing",
        ),
        (CRANK, "force (1, 0) in D on B;", "D: `D` is a point, not a link or a guide"),
        (
            "input t: angle; input s: length; ground A(0, 0); crank AB(A) -> B { length: 1m, angle: t }",
            "force (s * 1(N/m), 0) on B;",
            "before s: nothing uses the input `s`; use it or remove it / a driver takes it: `slider \
             ram(rail) { slide: s }`",
        ),
    ]);
}

#[test]
fn outputs_about_forces_name_what_touches() {
    const MASS: &str = "mass 1kg on BC uniform;";
    let rows = [
        ("output BC.D;", "D: `BC` does not touch `D` / there is `BC.B` and `BC.C`"),
        ("output BC.rail;", "rail: `BC` does not touch `rail` / there is `BC.B` and `BC.C`"),
        (
            "output BC.drive;",
            "drive: `BC` is a link of `rrr` and has no drive / cranks and sliders are driven; there \
             is `BC.B` and `BC.C`",
        ),
        (
            "output BC.push;",
            "push: no length of `BC` is driven, and nothing pushes its ends apart / `push` is the \
             force of a bar whose length depends on an input",
        ),
        (
            "output t.force;",
            "force: write `t.drive` / an input's effort is a torque or a force, as the input is",
        ),
        ("output BC.B, BC.B;", "B#2: the output `BC.B` is given twice; remove one"),
    ];
    for (output, expected) in rows {
        check(&[(SIX_BAR, &format!("{MASS} {output}"), expected)]);
    }
    check(&[(
        SIX_BAR,
        "output BC.B;",
        "B: nothing has mass and nothing acts, so `BC.B` is zero / declare what does: `mass 2kg on \
         BC uniform`, `force (0, -10N) on P`",
    )]);
}

#[test]
fn the_whole_mechanism_has_outputs_of_its_own() {
    const NONE: &str = "nothing has mass; declare what has / as in `mass 2kg on BC uniform`";
    check(&[
        (CRANK, "mass 1kg on B; output energy, shaking, centre_of_mass;", ""),
        (CRANK, "spring between B and D { damping: 2 } output energy;", ""),
        (
            CRANK,
            "force (1N, 0) on B; output energy;",
            "energy: nothing has mass and nothing is sprung, so there is no energy / as in `mass 2kg \
             on BC uniform`",
        ),
        (CRANK, "force (1N, 0) on B; output shaking;", &format!("shaking: {NONE}")),
        (CRANK, "output centre_of_mass;", &format!("centre_of_mass: {NONE}")),
        (
            CRANK,
            "mass 1kg on B; output energy.kinetic;",
            "kinetic: write `energy` / `kinetic` is a field of its result",
        ),
        (
            CRANK,
            "mass 1kg on B; output energy, shaking, energy, shaking;",
            "energy#2: the output `energy` is given twice; remove one\nshaking#2: the output `shaking` \
             is given twice; remove one",
        ),
    ]);
}

#[test]
fn a_joint_called_like_an_effort_is_renamed() {
    const CRANK: &str = "input t: angle; ground drive(0, 0), angle(1m, 0); \
                         crank AB(drive) -> B { length: 1m, angle: t } mass 1kg on B;";
    const REASON: &str =
        "is something else of every link: the force at that joint needs another name";
    check(&[
        (
            CRANK,
            "output AB.drive;",
            &format!("drive: rename the point `drive` / `AB.drive` {REASON}"),
        ),
        (CRANK, "", &format!("drive#1: rename the point `drive` / `AB.drive` {REASON}")),
        (CRANK, "output AB.angle, t.drive;", ""),
        (
            CRANK,
            "rpr block(B), bar(angle) {} output bar.angle;",
            &format!("angle#2: rename the point `angle` / `bar.angle` {REASON}"),
        ),
    ]);
}

/// A mass, a force, a torque or a spring alone makes efforts that are not zero, asked for or not.
#[test]
fn any_of_what_acts_is_enough() {
    for acting in [
        "mass 1kg on AB uniform;",
        "force (1N, 0) on B;",
        "torque 2(N*m) on AB;",
        "spring between B and D { stiffness: 3, free_length: 1m }",
    ] {
        check(&[(CRANK, &format!("{acting} output AB.drive;"), "")]);
        let (mechanism, _) = resolved(&format!("{CRANK} {acting}"));
        // The input's drive, the crank's, and what its pivot exerts.
        let asked = mechanism.expect("it is legal").dynamics.asked;
        assert_eq!(asked.len(), 3, "{acting}");
    }
    let nothing = "drive: nothing has mass and nothing acts, so `AB.drive` is zero / declare what does: \
                   `mass 2kg on BC uniform`, `force (0, -10N) on P`";
    check(&[(CRANK, "output AB.drive;", nothing)]);
}

/// Where no output is asked for, energy is one of what has mass or is sprung.
#[test]
fn forces_alone_have_no_energy() {
    for (statement, has_energy) in [
        ("force (0, -1N) on B;", false),
        ("mass 1kg on B;", true),
        ("spring between B and D { stiffness: 2(N/m), free_length: 0 }", true),
        ("stop AB.angle between (0, 1) { stiffness: 3(N*m/rad) }", true),
    ] {
        let (mechanism, mistakes) = resolved(&format!("{CRANK} {statement}"));
        assert_eq!(mistakes, "", "{statement}");
        let mechanism = mechanism.expect("nothing was reported");
        assert_eq!(mechanism.dynamics.energy, has_energy, "{statement}");
    }
}
