//! Intervals that follow the drive.

use super::machine::{Machine, machine};
use super::{Case, cases};

/// A class III machine whose crank turns fully.
fn stephenson() -> Case {
    cases().into_iter().find(|case| case.name == "stephenson_g0_d01").expect("it is a case")
}

fn of(statements: &str) -> Machine {
    machine(&format!("pub struct M {{ {statements} }}")).expect("it is a machine")
}

/// The drive's stretch about the drawing, from the documentation.
fn stretch(machine: &Machine) -> [f64; 2] {
    let text: String = machine.docs();
    let [from, to] = ["goes from ", " to "].map(|word| {
        let rest = text.rsplit_once("goes from ").expect("it says how far").1;
        let rest = if word == " to " { rest.split_once(word).expect("two ends").1 } else { rest };
        let end = rest.find(['°', ' ']).expect("a unit");
        let value: f64 = rest[..end].parse().expect("a number");
        if rest[end..].starts_with('°') { value.to_radians() } else { value }
    });
    [from, to]
}

/// The drive at equal steps over the stretch that is documented, but for its last hundredth: it is
/// written to a tenth of a degree.
fn along(machine: &Machine) -> Vec<f64> {
    let [from, to] = stretch(machine);
    let drawn = machine.mechanism.drawn.as_ref().expect("drives determine the inputs")[0];
    (0..=STEPS)
        .map(|i| drawn + 0.99 * (from + (to - from) * f64::from(i) / f64::from(STEPS)))
        .collect()
}

/// The count of steps along a stretch.
const STEPS: i32 = 36;

/// The equation of an unknown is closed to some units in the last place over the slope in it.
const CLOSED: f64 = 1e-12;

#[test]
fn a_crank_that_turns_fully_does_so_turn_after_turn() {
    let machine = of(stephenson().statements);
    assert_eq!(stretch(&machine).map(|end| end.to_degrees().round()), [-180.0, 180.0]);
    for at in along(&machine) {
        let turn = std::f64::consts::TAU;
        let poses = [at, at + turn, at - 3.0 * turn]
            .map(|at| machine.rigid(&[at], CLOSED).unwrap_or_else(|| panic!("{at}")));
        let [first, rest @ ..] = &poses;
        for ((name, a), (_, b)) in rest.iter().flat_map(|pose| first.iter().zip(pose)) {
            let off = (a[0] - b[0]).hypot(a[1] - b[1]);
            assert!(off < CLOSED, "{name} is off by {off:e} a turn on from {at}");
        }
    }
}

#[test]
fn all_of_the_stretch_that_is_documented_is_solved() {
    let mut following = 0;
    for case in cases() {
        let Some(machine) = machine(&case.declaration()) else { continue };
        if machine.mechanism.unknowns.is_empty() || !machine.docs().contains("_traced`") {
            continue;
        }
        following += 1;
        for at in along(&machine) {
            assert!(machine.rigid(&[at], CLOSED).is_some(), "{} at {at}", case.name);
        }
    }
    println!("{following} machines follow");
    assert!(following > 10);
}

/// The same machine driven along a rail, and by a gear.
#[test]
fn a_stretch_is_one_of_whatever_drives() {
    let statements = stephenson().statements;
    let slides = statements
        .replace("input theta: angle;", "input s: length;")
        .replace("link L1(P01, P15);", "guide rail through P01 along 40deg; link L1(P15) on rail;")
        .replace("drive L1.angle = theta;", "drive L1.slide = s;");
    let geared = statements.replace("= theta;", "= 1.5rad - 2 * theta;");
    for statements in [slides, geared] {
        let machine = of(&statements);
        assert!(machine.docs().contains("_traced`"), "{statements}");
        let ends = stretch(&machine);
        assert!(ends[0] < 0.0 && ends[1] > 0.0, "{ends:?}");
        let poses = along(&machine);
        let poses = match statements.contains("1.5rad") {
            // The stretch is one of the drive.
            true => {
                let drawn = machine.mechanism.drawn.as_ref().expect("it is determined")[0];
                poses.iter().map(|at| drawn - (at - drawn) / 2.0).collect()
            }
            false => poses,
        };
        for at in poses {
            assert!(machine.rigid(&[at], CLOSED).is_some(), "{statements} at {at}");
        }
    }
}

/// The bar that is left out, or another one, is longer than drawn: the motion is that of the machine with
/// the declared length.
#[test]
fn a_motion_is_followed_with_declared_lengths() {
    for (link, from, to, drawn) in
        [("L2", "P24", "P25", 0.405_928_5), ("L3", "P34", "P35", 0.924_153_7)]
    {
        for share in [0.9, 1.05] {
            let length = drawn * share;
            let line = format!("link {link}({from}, {to})");
            let longer = format!("{line} {{ length: {length:?} }}");
            let statements = stephenson().statements.replace(&format!("{line};"), &longer);
            let machine = of(&statements);
            assert!(machine.docs().contains("_traced`"), "{statements}");
            for at in along(&machine) {
                let pins =
                    machine.rigid(&[at], CLOSED).unwrap_or_else(|| panic!("{at} {statements}"));
                let place = |name| pins.iter().find(|(pin, _)| pin == name).expect("a pin").1;
                let [p, q] = [from, to].map(place);
                let off = (p[0] - q[0]).hypot(p[1] - q[1]) - length;
                assert!(off.abs() < CLOSED, "{link} is off by {off:e} at {at}");
            }
        }
    }
}
