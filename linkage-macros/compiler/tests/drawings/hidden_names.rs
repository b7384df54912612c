//! Names for what a drawing does not name: none is taken from the declaration, and none shows in an error.

use super::machine::{Machine, machine};

fn of(statements: &str) -> Result<Machine, Vec<String>> {
    machine(&format!("pub struct M {{ {statements} }}"))
}

const SHEAR: &str = "input x: length; ground A(0, 0), D(665.7mm, 0); guide floor through (0, 0) along 0deg;
    pin B(-30mm, 70mm), C(560mm, -360mm), blade(500mm, -410mm);
    link AB(A, B), BC(B, C, blade), DC(D, C), cross() on floor; guide way on cross through blade along 90deg;
    link ride(blade) on way; drive cross.slide = x;";

const KNEE: &str =
    "input flexion: angle; ground A(0, 0), D(-35mm, 10mm); pin B(12mm, -70mm), C(-25mm, -62mm);
    link front(A, B), rear(D, C), shank(B, C); drive shank.angle = 167.8deg - flexion;";

/// The knee with what presses in its joints, which makes it a search.
fn loaded() -> String {
    format!("{KNEE} mass 1kg on front at (0, 0);")
}

/// The output is the angle that is drawn, and not the unknown of the search.
#[test]
fn an_output_may_have_any_name() {
    for name in ["phi", "phi_traced", "phi_u", "psi", "ride_end", "BC_end", "way_on_ride"] {
        let shear = of(&format!("{SHEAR} output {name} = AB.angle;"));
        let shear = shear.unwrap_or_else(|told| panic!("{name}: {told:?}"));
        assert_eq!(shear.mechanism.unknowns.len(), 1);
        let drawn = shear.drawn_inputs()[0];
        let angle = shear.answers("position", &[[drawn, 0.0, 0.0]]).angle(name);
        assert!((angle - 70_f64.atan2(-30.0)).abs() < 1e-12, "{name}: {angle}");
    }
}

/// A name that nothing declares is none of those that the compiler has made, and none of these is proposed.
#[test]
fn no_expression_reads_what_nobody_has_named() {
    for name in ["phi", "psi", "phi_traced", "front_end"] {
        let told = of(&format!("{KNEE} output twice = 2 * {name};")).err().expect("it is unknown");
        let [told] = &told[..] else { panic!("{told:?}") };
        assert!(
            told.starts_with(&format!("no input, parameter or `let` named `{name}`")),
            "{told}"
        );
        assert!(!told.contains("similar"), "{told}");
    }
}

/// A failure of a call is told by links of the drawing.
#[test]
fn errors_name_links_that_are_drawn() {
    let dyad = of(KNEE).unwrap_or_else(|told| panic!("{told:?}")).mechanism;
    assert_eq!(
        dyad.titles()[..dyad.groups.len()],
        ["shank", "front, rear, shank", "rear", "shank"]
    );
    let knee = of(&loaded()).unwrap_or_else(|told| panic!("{told:?}")).mechanism;
    assert_eq!(
        knee.titles()[..knee.groups.len()],
        ["rear, shank, front", "rear", "shank", "front"]
    );
    assert_eq!(knee.title_of_unknown(&knee.unknowns[0]), "rear, shank, front");
    // A bar stands for two links that a drive holds together.
    let held = of(
        "input u, v: angle; ground A(0, 0), D(4m, 0), F(1m, 4m); pin B(0.5m, 1m), C(2m, 2.2m), E(3.5m, 1.5m);
         link AB(A, B), BC(B, C), CE(C, E), DE(D, E); drive CE.angle - BC.angle = u; drive AB.angle = v;",
    );
    let held = held.unwrap_or_else(|told| panic!("{told:?}")).mechanism;
    let titles = held.titles();
    assert!(titles[..held.groups.len()].contains(&"BC, CE, DE".to_string()), "{titles:?}");
    for title in &titles[..held.groups.len()] {
        for name in title.split(", ") {
            assert!(["AB", "BC", "CE", "DE"].contains(&name), "{title}");
        }
    }
}

/// Beyond a dead point the value that an unknown is searched beside is still a number, so that a search says that it
/// finds no root. An output of the last link is then what is left of the search: a number as well.
#[test]
fn a_traced_unknown_is_a_number_in_every_pose() {
    let knee =
        of(&format!("{} output rear.angle;", loaded())).unwrap_or_else(|told| panic!("{told:?}"));
    for flexion in [-3.0, -1.7, -1.0, 0.0, 0.05, 1.0, 3.0] {
        let angle = knee.answers("position", &[[flexion, 0.0, 0.0]]).angle("rear.angle");
        assert!(angle.is_finite(), "at {flexion}");
    }
}

/// The force at the joint of a link that a search left out is the link's, where a block stands for it: as an output, and
/// in a formula.
#[test]
fn the_force_at_an_end_is_that_of_the_link() {
    for pin in ["A", "B"] {
        let outputs = format!("output front.{pin}, twice = 2 * front.{pin}.x;");
        let weight = "mass 1kg on shank at (0, -0.2m); gravity (0, -9.81(m/s^2));";
        let knee = of(&format!("{KNEE} {weight} {outputs}"));
        let knee = knee.unwrap_or_else(|told| panic!("{told:?}"));
        let mut links = knee.mechanism.links.iter();
        assert!(links.any(|link| link.known_as() == "front" && link.name != "front"));
        let forces = knee.answers("forces", &[[0.3, 0.5, 0.0]]);
        let (own, twice) = (forces.named(&format!("front.{pin}.x")), forces.named("twice"));
        assert!(own.abs() > 0.01 && twice == 2.0 * own, "{pin}: {own}, {twice}");
    }
}

/// Friction is refused at joints whose reactions a search or a held pair does not tell, in names of the drawing.
#[test]
fn friction_is_refused_by_names_of_the_drawing() {
    const HELD: &str = "input u, v: angle; ground A(0, 0), D(4m, 0); pin B(0.5m, 1m), C(2m, 2.2m), E(3.5m, 1.5m);
        link AB(A, B), BC(B, C), CE(C, E), DE(D, E); drive CE.angle - BC.angle = u; drive AB.angle = v;";
    let machines: [(&str, &[&str], &[&str]); 3] = [
        (SHEAR, &["A", "B", "C", "D", "blade"], &["AB", "BC", "DC", "ride"]),
        (KNEE, &["A", "B", "C", "D"], &["front", "rear", "shank"]),
        (HELD, &["A", "B", "C", "D", "E"], &["AB", "BC", "CE", "DE"]),
    ];
    for (statements, pins, links) in machines {
        let at_pins = pins.iter().map(|pin| format!("at {pin} radius 8mm"));
        let at_links = links
            .iter()
            .flat_map(|link| pins.iter().map(move |pin| format!("on {link} at {pin} radius 8mm")));
        for site in at_pins.chain(at_links) {
            let machine = of(&format!(
                "{statements} mass 1kg on {} at (0, 0); friction 0.1 {site};",
                links[0]
            ));
            let Err(told) = machine else { continue };
            for name in ["phi", "_end", "_bar", "_traced", "CE_DE", "BC_CE", "_on_"] {
                assert!(told.iter().all(|told| !told.contains(name)), "{site}: {told:?}");
            }
            assert!(!told[0].contains("an unknown"), "{told:?}");
        }
    }
    let told = of(&format!("{KNEE} mass 1kg on front at (0, 0); friction 0.1 at C radius 8mm;"));
    assert_eq!(
        told.err().expect("the knee is searched for"),
        ["beside `rear, shank, front`, which are one group of class III, no joint has friction\n\
          what closes the group follows from reactions, friction among them, and friction from it; drive another joint, \
          so that each pair of links stands on what is known"]
    );
}
