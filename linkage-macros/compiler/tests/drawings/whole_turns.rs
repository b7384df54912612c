//! Springs by the angles of drawn links: the whole turns that they count, from the drawing alone.

use std::f64::consts::{PI, TAU};

use super::machine::{Machine, machine};

const STIFFNESS: f64 = 3.0;
const FREE: f64 = 0.4;

/// Angles of a dozen digits, and the products of a pose.
const OFF: f64 = 1e-11;

fn of(statements: &str) -> Machine {
    machine(&format!("pub struct M {{ {statements} }}"))
        .unwrap_or_else(|told| panic!("{statements}: {told:?}"))
}

fn coil(between: &str) -> String {
    format!(
        "spring coil between {between} {{ stiffness: {STIFFNESS:?}(N*m/rad), free_angle: {FREE:?}rad }}"
    )
}

/// A pin at a distance from a place, in a direction of degrees.
fn pin(name: &str, [x, y]: [f64; 2], size: f64, degrees: f64) -> String {
    let (sin, cos) = degrees.to_radians().sin_cos();
    format!("pin {name}({:?}m, {:?}m);", x + size * cos, y + size * sin)
}

/// The torque of the coil at these inputs from the drawing.
fn torque(machine: &Machine, by: &[f64]) -> f64 {
    let drawn = machine.drawn_inputs();
    let inputs: Vec<_> = drawn.iter().zip(by).map(|(drawn, by)| [drawn + by, 0.0, 0.0]).collect();
    machine.answers("forces", &inputs).named("coil.torque")
}

fn is_wound(machine: &Machine, by: &[f64], angle: f64, case: &str) {
    let (found, wanted) = (torque(machine, by), -STIFFNESS * (angle - FREE));
    assert!((found - wanted).abs() < OFF, "{case}: {found} in place of {wanted}");
}

fn within_half_a_turn(angle: f64) -> f64 {
    angle - TAU * (angle / TAU).round()
}

/// A block in the slot of a rocker stands still against it: whichever ways the two are drawn, the coil between them is
/// wound by less than half a turn.
#[test]
fn a_coil_between_links_that_only_slide_on_each_other_is_wound_by_less_than_half_a_turn() {
    for block in (0..6).map(|nth| 60.0 * f64::from(nth) - 179.0) {
        for (rocker, slot) in [(41.0, 3.0), (41.0, -178.0), (-139.0, 181.0), (-170.0, 270.0)] {
            let b = [0.3, 0.35];
            let statements = format!(
                "input t: angle; ground A(0, 0), D(0.6m, 0.1m); pin B({:?}m, {:?}m); {} {}
                 link AB(A, B), rocker(D, P), block(B, Q) on slot; drive AB.angle = t;
                 guide slot on rocker through (20mm, 10mm) along {slot:?}deg; mass 1kg on AB uniform; {}",
                b[0],
                b[1],
                pin("Q", b, 0.2, block),
                pin("P", [0.6, 0.1], 0.3, rocker),
                coil("rocker and block"),
            );
            let case = format!("{block} on {rocker}, {slot}");
            let turned = (block - rocker).to_radians();
            let wound = within_half_a_turn(turned - FREE) + FREE;
            is_wound(&of(&statements), &[0.1], wound, &case);
        }
    }
}

/// A bar on a rack does not turn, and a wheel counts its turns: in the drawing the angle of the bar lies within half a
/// turn, however its rack runs.
#[test]
fn a_coil_counts_turns_from_the_angle_that_a_link_is_drawn_at() {
    for bar in (0..6).map(|nth| 60.0 * f64::from(nth) - 179.0) {
        for rack in [0.0, 102.0, -166.0, 180.0] {
            let (sin, cos) = f64::to_radians(rack).sin_cos();
            let p = [0.3 * cos, 0.3 * sin];
            let l = [0.4 * cos - 0.25 * sin, 0.4 * sin + 0.25 * cos];
            let pivot = [l[0] - 0.1 * cos, l[1] - 0.1 * sin];
            let statements = format!(
                "input t: angle; ground O({:?}m, {:?}m); guide rack through (0, 0) along {rack:?}deg;
                 pin l({:?}m, {:?}m), p({:?}m, {:?}m); {} link bar(p, q) on rack, rod(p, l), wheel(O, l);
                 drive wheel.angle = t; mass 1kg on wheel uniform; {}",
                pivot[0],
                pivot[1],
                l[0],
                l[1],
                p[0],
                p[1],
                pin("q", p, 0.2, bar),
                coil("bar and wheel"),
            );
            let machine = of(&statements);
            let drawn = machine.drawn_inputs()[0];
            for by in [0.0, 0.2, -0.2] {
                let angle = drawn + by - bar.to_radians();
                is_wound(&machine, &[by], angle, &format!("{bar} on {rack}, {by}"));
            }
        }
    }
}

/// A block that is driven along a crank turns with it: the coil to the ground counts the crank's turns, from the angle
/// that the block is drawn at.
#[test]
fn a_coil_counts_the_turns_of_a_crank_that_carries_its_link() {
    for block in (0..6).map(|nth| 60.0 * f64::from(nth) - 179.0) {
        for (crank, slot) in [(170.0, 40.0), (-100.0, -120.0), (20.0, 15.0)] {
            let statements = format!(
                "input t: angle; input s: length; ground A(0, 0); {} pin B(0.3m, 0.2m); {}
                 link AP(A, P), block(B, Q) on slot; drive AP.angle = t; drive block.slide = s;
                 guide slot on AP through (20mm, 10mm) along {slot:?}deg; mass 1kg on AP uniform; {}",
                pin("P", [0.0, 0.0], 0.3, crank),
                pin("Q", [0.3, 0.2], 0.2, block),
                coil("ground and block"),
            );
            for by in [0.0, 7.0, -4.0] {
                let angle = block.to_radians() + by;
                let case = format!("{block} on {crank}, {slot}, {by}");
                is_wound(&of(&statements), &[by, 0.0], angle, &case);
            }
        }
    }
}

/// Half a turn is drawn to a few digits: the coil is wound alike on either side of it.
#[test]
fn the_last_digits_of_half_a_turn_wind_no_coil_by_a_turn() {
    for by in [-1e-9, 0.0, 1e-9] {
        let statements = format!(
            "input t: angle; input s: length; ground A(0, 0); pin P(0.3m, 0.1m), B(0.3m, 0.2m), Q(0.1m, {:?}m);
             link AP(A, P), block(B, Q) on slot; drive AP.angle = t; drive block.slide = s;
             guide slot on AP through (20mm, 10mm) along 7deg; mass 1kg on AP uniform; {}",
            0.2 + by,
            coil("ground and block"),
        );
        let found = torque(&of(&statements), &[0.0, 0.0]);
        // 1e-9 m at the end of 0.2 m.
        assert!((found + STIFFNESS * (PI - FREE)).abs() < 2e-8, "{by}: {found}");
    }
}

/// A machine of class III, of which an unknown turns `L1` against the crank: that is how it is solved, and no drive. Its
/// stop is as far away as the drawing says, and the coil on it is wound by less than half a turn, whichever way the
/// machine lies.
#[test]
fn the_unknown_of_a_search_counts_no_turns() {
    let pins = [
        ("ground G0", [444.9, -403.8]),
        ("ground G4", [-302.5, 458.1]),
        ("pin P1", [255.7, -711.0]),
        ("pin P5", [763.7, -294.5]),
        ("pin P6", [978.2, -648.6]),
        ("pin P7", [-558.1, 181.1]),
    ];
    for turn in [0.0, 100.0, 200.0, 292.0] {
        let (sin, cos) = f64::to_radians(turn).sin_cos();
        let pins = pins.map(|(name, [x, y])| {
            format!("{name}({:?}mm, {:?}mm);", x * cos - y * sin, x * sin + y * cos)
        });
        let of = |ends: [f64; 2]| {
            of(&format!(
                "input t: angle; {} link L0(G0, P1), L1(E2, P5), L2(E3, P6), L3(P7, G4), L4(P7, P6, P5);
                 point E3 on L0 at (77mm, 292.8mm); point E2 on L0 at (-64.9mm, 209.9mm); drive L0.angle = t;
                 mass 1kg on L0 uniform; {}
                 stop end L1.angle between ({:?}rad, {:?}rad) {{ stiffness: 5(N*m/rad) }} output coil.torque, end.gap;",
                pins.concat(),
                coil("ground and L1"),
                ends[0],
                ends[1],
            ))
        };
        let machine = of([0.0, 1.0]);
        assert_eq!(machine.mechanism.unknowns.len(), 1);
        assert!(machine.docs().contains("relative_to: L0"));
        let drawn = machine.drawn_inputs()[0];
        let at = |machine: &Machine, entry| machine.answers(entry, &[[drawn, 0.0, 0.0]]);
        let angle = at(&machine, "motion").angle("L1.angle");
        let wound = -STIFFNESS * within_half_a_turn(angle - FREE);
        // The equation is closed to some units in the last place, over a slope of about one.
        assert!((at(&machine, "forces").named("coil.torque") - wound).abs() < 1e-10, "{turn}");
        let gap = at(&of([angle - 0.2, angle + 0.5]), "forces").named("end.gap");
        assert!((gap - 0.2).abs() < 1e-10, "{turn}: {gap}");
    }
}

/// A link that is driven against a crank: in the drawing its coil and its stop are as far turned as they are drawn, to half
/// a turn, and from there they count.
#[test]
fn a_link_that_is_driven_against_a_crank_is_turned_as_it_is_drawn() {
    for (ab, bc) in
        (0..18).map(|nth| (120.0 * f64::from(nth % 3) - 70.0, 20.0 * f64::from(nth) - 175.0))
    {
        let angles = [("ground and BC", bc), ("AB and BC", bc - ab), ("BC and AB", ab - bc)];
        for (between, drawn) in angles {
            let b = [0.3 * f64::to_radians(ab).cos(), 0.3 * f64::to_radians(ab).sin()];
            let statements = format!(
                    "input t, u: angle; ground A(0, 0); {} {} link AB(A, B), BC(B, C); drive AB.angle = t;
                     drive BC.angle - AB.angle = u; mass 1kg on AB uniform; {}
                     stop end BC.angle between (-3rad, 3rad) {{ stiffness: 5(N*m/rad) }} output coil.torque, end.gap;",
                    pin("B", [0.0, 0.0], 0.3, ab),
                    pin("C", b, 0.2, bc),
                    coil(between),
                );
            let machine = of(&statements);
            let sign = if between.starts_with("BC") { -1.0 } else { 1.0 };
            let drawn = within_half_a_turn(f64::to_radians(drawn));
            for by in [0.0, 8.0] {
                is_wound(&machine, &[0.0, by], drawn + sign * by, &statements);
            }
            let inputs = machine.drawn_inputs();
            let inputs: Vec<_> = inputs.iter().map(|at| [*at, 0.0, 0.0]).collect();
            let gap = machine.answers("forces", &inputs).named("end.gap");
            let wanted = 3.0 - f64::to_radians(bc).abs();
            assert!((gap - wanted).abs() < OFF, "{statements}: {gap} in place of {wanted}");
        }
    }
}
