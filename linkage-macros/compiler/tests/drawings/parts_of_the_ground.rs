//! Links that two pins hold to the ground: they are parts of it.

use super::answers::Answers;
use super::machine::{Machine, machine};

const OFF: f64 = 1e-11;

fn of(statements: &str) -> Machine {
    machine(&format!("pub struct M {{ {statements} }}"))
        .unwrap_or_else(|told| panic!("{statements}: {told:?}"))
}

/// Numbers that both know by one name are the same, but for slides that are measured from other points; their count.
fn shared(one: &Answers, other: &Answers) -> usize {
    let mut compared = 0;
    for (name, value) in one.iter() {
        let mut found =
            other.iter().filter(|(known, _)| *known == name && !name.ends_with("slide"));
        let Some((_, first)) = found.next() else { continue };
        if found.next().is_none() {
            assert!((first - value).abs() < OFF, "{name}: {value} and {first}");
            compared += 1;
        }
    }
    compared
}

/// A frame on two ground pins that carries a slot is what the slot would be on the ground, whichever pins its statement
/// names first, and with a third pin for a rod.
#[test]
fn a_link_on_two_ground_pins_is_ground() {
    let machine = |frame: &str, slot: &str| {
        of(&format!(
            "input t: angle; ground A(0, 0), D(300mm, 0), E(300mm, 100mm); pin B(50mm, 80mm), C(300mm, 200mm), H(150mm, 260mm);
             {frame} link AB(A, B), BC(B, C), block(C) on slot, CH(C, H), FH(F, H); drive AB.angle = t; guide slot {slot};
             mass 2kg on block at (0, 10mm); mass 1kg on AB uniform; mass 1kg on FH uniform; gravity (0, -9.81);"
        ))
    };
    let ground = machine("ground F(200mm, 150mm);", "through D towards E");
    let frames = [
        ("link frame(D, E, F);", "on frame through D towards E"),
        ("link frame(F, E, D);", "on frame through E along 116.56505117707799deg"),
        ("link frame(E, D, F);", "on frame through (0, 0) along 180deg"),
        ("link frame(D, E), arm(E, F), stay(F, D);", "on frame through D along 0deg"),
    ];
    let drawn = ground.drawn_inputs()[0];
    for (frame, slot) in frames {
        let is_truss = frame.contains("stay");
        let held = machine(&format!("pin F(200mm, 150mm); {frame}"), slot);
        for by in [0.0, 0.05, -0.04] {
            let input = [[drawn + by, 0.6, -1.1]];
            let motions = [&ground, &held].map(|machine| machine.answers("motion", &input));
            assert!(shared(&motions[0], &motions[1]) > 10);
            if !is_truss && !slot.contains("180") && !slot.contains("116") {
                let forces = [&ground, &held].map(|machine| machine.answers("forces", &input));
                assert!(shared(&forces[0], &forces[1]) > 6);
            }
        }
    }
}

/// A frame takes masses and forces, and is told of by its own name where it is driven.
#[test]
fn a_part_of_the_ground_is_a_link_that_stands_still() {
    let frame = |more: &str| {
        machine(&format!(
            "pub struct M {{ input t: angle; ground A(0, 0), D(300mm, 0), E(300mm, 100mm); pin B(50mm, 80mm), C(300mm, 200mm);
             guide slot on frame through D towards E; link frame(D, E), AB(A, B), BC(B, C), block(C) on slot;
             drive AB.angle = t; mass 2kg on AB uniform; gravity (0, -9.81); {more} }}"
        ))
    };
    let [bare, heavy] = [
        "",
        "mass 3kg on frame at (50mm, 20mm); mass 1kg on frame uniform; torque 2(N*m) on frame;",
    ]
    .map(|more| frame(more).unwrap_or_else(|told| panic!("{told:?}")));
    let drawn = bare.drawn_inputs()[0];
    let efforts = [&bare, &heavy]
        .map(|machine| machine.answers("forces", &[[drawn, 1.0, 0.0]]).named("t.drive"));
    assert!((efforts[0] - efforts[1]).abs() < OFF, "{efforts:?}");
    let told = frame("drive frame.angle = 2 * t;").err().expect("it is held");
    assert!(told[0].contains("`frame`"), "{told:?}");
}

/// One link turns at a pin of the ground, whichever of its parts go through it: its friction is that without the frame.
#[test]
fn a_part_of_the_ground_does_not_turn_in_a_joint() {
    let rubbing = |frame: &str| {
        machine(&format!(
            "pub struct M {{ input t: angle; ground A(0, 0), D(300mm, 0); pin B(50mm, 80mm), C(300mm, 200mm); {frame}
             link AB(A, B), BC(B, C), DC(D, C); drive AB.angle = t; mass 2kg on BC uniform; gravity (0, -9.81);
             friction 0.1 at A radius 10mm; friction 0.2 at D radius 12mm; }}"
        ))
        .unwrap_or_else(|told| panic!("{frame}: {told:?}"))
    };
    let [bare, framed] = ["", "link frame(A, D);"].map(rubbing);
    let drawn = bare.drawn_inputs()[0];
    let efforts = [&bare, &framed]
        .map(|machine| machine.answers("forces", &[[drawn, 1.0, 0.0]]).named("t.drive"));
    assert!((efforts[0] - efforts[1]).abs() < OFF, "{efforts:?}");
}
