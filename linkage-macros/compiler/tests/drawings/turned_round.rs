//! Couplings that are followed the other way: what a gear is read from is turned by it.

use super::machine::{Machine, Places, machine};

/// Angles are sums and multiples of a few numbers, arc tangents between them.
const CLOSED: f64 = 1e-12;

fn of(statements: &str) -> Machine {
    machine(&format!("pub struct M {{ {statements} }}"))
        .unwrap_or_else(|told| panic!("{statements}: {told:?}"))
}

fn angle(pins: &Places<f64>, [from, to]: [&str; 2]) -> f64 {
    let at = |name: &str| pins.iter().find(|(known, _)| known == name).expect("a pin").1;
    let ([x0, y0], [x1, y1]) = (at(from), at(to));
    (y1 - y0).atan2(x1 - x0)
}

const PINION: [&str; 2] = ["A", "B"];
const GEAR: [&str; 2] = ["D", "C"];

/// Two wheels, the second read from the first: driven at the second, the first turns by the inverse.
#[test]
fn a_gear_that_is_driven_turns_its_pinion() {
    const WHEELS: &str = "input t: angle; ground A(0, 0), D(3, 0); pin B(0.5, 0), C(3, 0.8); link pinion(A, B), gear(D, C);
        drive gear.angle = t;";
    for (coupling, inverse) in [
        ("-2 * pinion.angle + 90deg", (|t| (t - 90_f64.to_radians()) / -2.0) as fn(f64) -> f64),
        ("90deg - pinion.angle * 2 / 3", |t| (90_f64.to_radians() - t) * 1.5),
        ("-(3 * (pinion.angle - 30deg))", |t| -t / 3.0 + 30_f64.to_radians()),
        ("pinion.angle + 90deg", |t| t - 90_f64.to_radians()),
        ("90deg + t + pinion.angle", |_| -90_f64.to_radians()),
    ] {
        let wheels = of(&format!("{WHEELS} drive gear.angle = {coupling};").replace(
            "B(0.5, 0)",
            if coupling.starts_with("90deg + t") { "B(0, -0.5)" } else { "B(0.5, 0)" },
        ));
        let drawn = wheels.drawn_inputs()[0];
        for step in -8..=8 {
            let t = drawn + 0.35 * f64::from(step);
            let pins = wheels.pins::<f64>(&[t]);
            for (line, wanted) in [(GEAR, t), (PINION, inverse(t))] {
                let off = (angle(&pins, line) - wanted).sin();
                assert!(off.abs() < CLOSED, "{coupling} at {t}: {line:?} {off:e}");
            }
        }
    }
}

/// A four-bar driven at its rocker, and a wheel on the crank that it turns: the poses are those of the same machine driven at
/// the wheel.
#[test]
fn a_machine_that_is_driven_behind_a_gear_has_the_poses_of_one_driven_in_front_of_it() {
    const BARS: &str = "input t: angle; ground A(0, 0), D(4, 0), O(-2, 0); pin B(0.5, 0.9), C(3.2, 2.6), P(-2, 0.6);
        link AB(A, B), BC(B, C), DC(D, C), wheel(O, P); drive AB.angle = 151deg - wheel.angle;";
    let [forwards, backwards] = ["drive wheel.angle = t;", "drive DC.angle = t;"]
        .map(|drive| of(&format!("{BARS} {drive}")));
    // The crank comes to its dead point behind the last of them.
    for degrees in [40, 60, 80, 90, 100] {
        let pins = forwards.pins::<f64>(&[f64::from(degrees).to_radians()]);
        let rocker = angle(&pins, ["D", "C"]);
        let back = backwards.pins::<f64>(&[rocker]);
        for (name, [x, y]) in &pins {
            let [now_x, now_y] = back.iter().find(|(known, _)| known == name).expect("the pin").1;
            let off = (now_x - x).hypot(now_y - y);
            // The rocker's angle is known to some ε, and the crank turns about as fast.
            assert!(off < 1e-11, "{name} at {degrees}: {off:e}");
        }
    }
}

/// A rack that is driven turns its pinion.
#[test]
fn a_rack_that_is_driven_turns_its_pinion() {
    let rack = of("input s: length; ground O(0, 0); guide bed through (0, -0.2m) along 0deg; pin P(0.1m, 0), T(0.3m, -0.2m);
        link pinion(O, P), rack(T) on bed; drive rack.slide = 0.3m + 0.1m * pinion.angle; drive rack.slide = s;");
    for s in [0.2, 0.3, 0.55] {
        let off = angle(&rack.pins::<f64>(&[s]), ["O", "P"]) - (s - 0.3) / 0.1;
        assert!(off.sin().abs() < CLOSED, "{s}: {off:e}");
    }
}

/// A slower wheel behind a link that a group turns: up to whole turns of the link, half turns of the wheel are not known.
#[test]
fn an_angle_that_is_known_up_to_whole_turns_is_not_divided() {
    let told = machine(
        "pub struct M { input t: angle; ground A(0, 0), D(4, 0), O(-2, 0); pin B(0.5, 0.9), C(3.2, 2.6), P(-2, 0.6);
         link AB(A, B), BC(B, C), DC(D, C), wheel(O, P); drive AB.angle = -2 * wheel.angle + 151deg;
         drive DC.angle = t; }",
    );
    let told = told.err().expect("half turns are not known");
    assert!(told[0].contains("fight"), "{told:?}");
}

/// A coupling that no choice drives is told as it is written.
#[test]
fn a_coupling_too_many_is_one_too_many() {
    let told = machine(
        "pub struct M { input t: angle; ground A(0, 0), D(3, 0); pin B(0.5, 0), C(3, 0.8); link pinion(A, B), gear(D, C);
         drive gear.angle = t; drive pinion.angle = t; drive gear.angle = -2 * pinion.angle + 90deg; }",
    );
    let told = told.err().expect("it is too much");
    assert!(told[0].contains("fight"), "{told:?}");
}

/// A drive that contradicts the drawing is told as it is written, and the link that it moves by its name.
#[test]
fn a_coupling_that_contradicts_the_drawing_is_told_as_it_is_written() {
    let told = machine(
        "pub struct M { input q: angle; ground A(0, 0), D(0.4, 0), E(0.2, 0.5);
         pin B(0.1, 0.1), C(0.35, 0.3), F(0.25, 0.2);
         link gear(D, C), BC(B, C), crank(A, B), pinion(E, F);
         drive crank.angle = q; drive gear.angle = pinion.angle - 1rad; }",
    );
    let told = told.err().expect("they are half a turn apart");
    let wanted = "`pinion` by `drive gear.angle` contradicts the drawing: it is 156.8° where the others are as drawn, and drawn as -80.5°";
    assert!(told.len() == 1 && told[0].starts_with(wanted), "{told:?}");
}

/// A turn of `gear` would leave `ED` with a drive that reads what it moves: what is told is of the machine as written.
#[test]
fn no_coupling_is_turned_round_beside_a_drive_that_reads_what_it_moves() {
    let machine_with = |drive: &str| {
        machine(&format!(
            "pub struct M {{ input theta: angle; ground A(0, 0), E(1m, 0), F(3m, 0);
             pin B(-0.2m, 0.5m), C(0.4m, 1.1m), D(1.2m, 0.6m), G(3.2m, 0.3m);
             link AB(A, B), BC(B, C), CD(C, D), ED(E, D), gear(F, G); drive AB.angle = theta;
             drive AB.angle = gear.angle + 180deg - atan(2.5) - atan(1.5); drive ED.angle = {drive}; }}"
        ))
    };
    let told = machine_with("CD.angle + 120deg").err().expect("no drive is left for `gear`");
    assert!(
        told.len() == 2 && told[1].starts_with("`gear` still moves when every input"),
        "{told:?}"
    );
    assert_eq!(machine_with("atan(3)").err(), None);
}
