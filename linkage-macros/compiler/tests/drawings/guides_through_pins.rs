//! Guides through pins that the drawing places: on the ground where a moving pin is drawn, and on a link whose group does
//! not make the pin.

use super::machine::{Machine, machine};

/// Products of lengths of about a metre.
const OFF: f64 = 1e-12;

fn of(statements: &str) -> Machine {
    machine(&format!("pub struct M {{ {statements} }}"))
        .unwrap_or_else(|told| panic!("{statements}: {told:?}"))
}

/// Both declarations mean one machine: every number of their motions is the same.
fn are_one(one: &str, other: &str, off: f64) {
    let machines = [one, other].map(of);
    let drawn = machines[0].drawn_inputs()[0];
    for by in [0.0, 0.02, -0.01] {
        let answers = machines
            .each_ref()
            .map(|machine| machine.answers("motion", &[[drawn + by, 0.7, -0.4]]));
        let mut compared = 0;
        for ((name, one), (known, other)) in answers[0].iter().zip(answers[1].iter()) {
            assert_eq!(name, known);
            assert!(
                (one - other).abs() < off,
                "{name} at {by}: {one} and {other}\n{}",
                machines[0].docs()
            );
            compared += 1;
        }
        assert!(compared > 10);
    }
}

const SLIDER_CRANK: &str = "input t: angle; ground A(0, 0); pin B(30mm, 40mm), C(150mm, 0);
    link AB(A, B), BC(B, C), ram(C) on bed; drive AB.angle = t;";

/// A crank of 50 mm and a rod of √(120² + 40²) mm: upright the crank has the ram at √(120² + 40² − 50²) mm.
#[test]
fn a_guide_of_the_ground_runs_through_a_pin_where_that_is_drawn() {
    let crank = of(&format!("{SLIDER_CRANK} guide bed through C along 0deg;"));
    let answers = crank.answers("position", &[[std::f64::consts::FRAC_PI_2, 0.0, 0.0]]);
    assert!((answers.named("C.x") - 13500_f64.sqrt() * 1e-3).abs() < 1e-15);
    for (named, placed) in [
        ("through C along 0deg", "through (150mm, 0) along 0deg"),
        ("through C along 12deg", "through (150mm, 0) along 12deg"),
        ("through C towards A", "through (150mm, 0) along 180deg"),
        ("through A towards C", "through (0, 0) along 0deg"),
    ] {
        let [named, placed] =
            [named, placed].map(|line| format!("{SLIDER_CRANK} guide bed {line};"));
        are_one(&named, &placed, OFF);
        let moved = |text: &str| {
            text.replace("C(150mm, 0)", "C(0.150000001m, -1e-9m)")
                .replace("(150mm, 0)", "(0.150000001m, -1e-9m)")
        };
        // A guide along the ground's x is 1e-9 m at 0.15 m off the way to the pin.
        are_one(&moved(&named), &moved(&placed), 1e-7);
    }
    let parameter = of(
        "input t: angle; param p = 150mm; ground A(0, 0); pin B(30mm, 40mm), C(p, 10mm); link AB(A, B), BC(B, C), ram(C) on bed;
         drive AB.angle = t; guide bed through C along 0deg;",
    );
    let t = 40_f64.atan2(30.0);
    for p in [0.15, 0.17] {
        let answers = parameter.answers_at("position", &[t], &[p]);
        let off = [answers.named("C.x") - p, answers.named("C.y") - 0.01];
        assert!(off.iter().all(|off| off.abs() < OFF), "{p}: {off:?}");
    }
}

/// A knee that is driven at its shank is searched for, and one of its links is left out: the group has that link at one
/// of its pins alone. A block on a guide through either pin, or towards it, is where the same line by its coordinates
/// has it.
#[test]
fn a_guide_runs_through_any_pin_of_its_link() {
    let knee = "input t: angle; ground A(0, 0), D(-35mm, 10mm), G(60mm, -75mm); pin B(12mm, -70mm), C(-25mm, -62mm), E(20mm, -30mm);
        link front(A, B), rear(D, C), shank(B, C), rod(G, E), block(E) on slot; drive shank.angle = t;";
    for (link, [near, far]) in [("front", ["A", "B"]), ("rear", ["D", "C"]), ("shank", ["B", "C"])]
    {
        let mut lines = vec![(
            format!("through {near} towards {far}"),
            "through (0, 0) along 0deg".to_string(),
        )];
        lines.push((
            format!("through {near} along 20deg"),
            "through (0, 0) along 20deg".to_string(),
        ));
        for (named, placed) in lines {
            let [named, placed] =
                [named, placed].map(|line| format!("{knee} guide slot on {link} {line};"));
            // An equation of a search is closed to some units in the last place, over its slope.
            are_one(&named, &placed, 1e-9);
        }
        let machine = of(&format!("{knee} guide slot on {link} through {far} towards {near};"));
        let drawn = machine.drawn_inputs()[0];
        let answers = machine.answers("position", &[[drawn, 0.0, 0.0]]);
        assert!(
            (answers.named("E.x") - 0.02).abs() < 1e-9
                && (answers.named("E.y") + 0.03).abs() < 1e-9
        );
    }
}
