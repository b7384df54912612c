//! Parallelograms stay what they are drawn as: behind cranks and rockers, and in chains; what is drawn crossed stays so.

use super::machine::{Machine, machine};
use crate::diagnostics::{Diagnostic, Diagnostics};
use crate::{model, syntax};

/// Products of lengths of less than a metre.
const OFF: f64 = 1e-14;

fn of(statements: &str) -> Machine {
    machine(&format!("pub struct M {{ input theta: angle; {statements} }}"))
        .unwrap_or_else(|told| panic!("{statements}: {told:?}"))
}

/// The notes on a declaration without mistakes.
fn notes(statements: &str) -> Vec<String> {
    let mut diagnostics = Diagnostics::new();
    let source = format!("pub struct M {{ input theta: angle; {statements} }}");
    let tree = syntax::parse(source.parse().expect("tokens"), &mut diagnostics);
    tree.map(|tree| model::resolve(&tree, &mut diagnostics));
    let notes = diagnostics.take_notes();
    assert!(diagnostics.finish().is_ok(), "{statements}");
    notes.iter().map(Diagnostic::text).collect()
}

const WIPER: &str = "ground A(0, 0), D(-250mm, 60mm), H(350mm, 60mm);
    pin B(45mm, 0), C(-245mm, -20mm), E(-320mm, 50mm), F(280mm, 50mm), tip1(-250mm, 660mm), tip2(350mm, 610mm);
    link AB(A, B); link rod(B, C); link first(D, C, E, tip1); link tie(E, F); link right_(H, F, tip2);
    drive AB.angle = theta;";

const SQUARE: &str = "ground J0(0, 0), J1(100mm, 0); pin J2(0, 100mm), J3(100mm, 100mm);
    link link_1(J0, J2); link link_3(J1, J3); link link_2(J2, J3); drive link_1.angle = theta;";

const DIRECT: &str = "ground A(0, 0), D(600mm, 0); pin B(30mm, 60mm), C(630mm, 60mm);
    link AB(A, B); link BC(B, C); link DC(D, C); drive AB.angle = theta;";

/// Three wheels of a locomotive: the coupled ones hang on points of one rod.
const ROD: &str = "ground A(0, 0), D(1.4m, 0), G(2.9m, 10mm);
    pin B(0.2m, 0.2m), C(1.6m, 0.2m), F(3.1m, 0.21m);
    link first(A, B), second(D, C), third(G, F), rod(B, C), rear(C, F); drive first.angle = theta;";

/// A lamp: a parallelogram on the moving side of another.
const LAMP: &str = "ground A(0, 0), D(0, 60mm); pin B(300mm, 100mm), C(300mm, 160mm), E(450mm, 350mm), F(450mm, 410mm);
    link arm(A, B), guide_arm(D, C), head(B, C), upper(B, E), bar(C, F), shade(E, F);
    drive arm.angle = theta; drive upper.angle = 2 * theta + atan(250 / 150) - 2 * atan(100 / 300);";

/// The largest opening C − D − (B − A) of a parallelogram A, B, C, D over more than a turn.
fn opening(drawing: &Machine, grounds: &[(&str, [f64; 2])], corners: &str) -> f64 {
    let mut largest = 0.0_f64;
    for degrees in (-175..=530).step_by(15) {
        let pins = drawing.pins::<f64>(&[f64::from(degrees).to_radians()]);
        let at = |name: &str| {
            let ground = grounds.iter().find(|(known, _)| *known == name).map(|(_, at)| *at);
            let pin = pins.iter().find(|(known, _)| known == name).map(|(_, at)| *at);
            ground.or(pin).unwrap_or_else(|| panic!("no {name}"))
        };
        let [a, b, c, d] =
            [0, 1, 2, 3].map(|nth| at(corners.split(' ').nth(nth).expect("four corners")));
        for axis in 0..2 {
            largest = largest.max(((c[axis] - d[axis]) - (b[axis] - a[axis])).abs());
        }
    }
    largest
}

#[test]
fn what_is_drawn_as_a_parallelogram_stays_one() {
    for (statements, grounds, corners) in [
        (WIPER, &[("D", [-0.25, 0.06]), ("H", [0.35, 0.06])][..], &["D E F H"][..]),
        (SQUARE, &[("J0", [0.0, 0.0]), ("J1", [0.1, 0.0])], &["J0 J2 J3 J1"]),
        (DIRECT, &[("A", [0.0, 0.0]), ("D", [0.6, 0.0])], &["A B C D"]),
        (ROD, &[("A", [0.0, 0.0]), ("D", [1.4, 0.0]), ("G", [2.9, 0.01])], &["A B C D", "D C F G"]),
        (LAMP, &[("A", [0.0, 0.0]), ("D", [0.0, 0.06])], &["A B C D", "B E F C"]),
    ] {
        let drawing = of(statements);
        let docs = drawing.docs();
        assert_eq!(docs.matches("mode: parallel").count(), corners.len(), "{docs}");
        assert_eq!(notes(statements), [""; 0]);
        for corners in corners {
            let open = opening(&drawing, grounds, corners);
            assert!(open < OFF, "{corners}: {open:e}");
        }
        // The declaration of the groups is the same machine.
        let (_, groups) = docs.split_once("pub struct M {").expect("the groups are printed");
        let (groups, _) = groups.split_once("\n     }").expect("they end");
        let by_hand = machine(&format!("pub struct M {{ {groups} }}")).expect("it is read");
        for corners in corners {
            assert!(opening(&by_hand, grounds, corners) < OFF, "{corners}");
        }
    }
}

/// Its mirror image about the line of B and D has the same lengths.
#[test]
fn what_is_drawn_crossed_stays_crossed() {
    let crossed = "ground A(0, 0), D(50mm, 0); pin B(0, 40mm), C(72.1951219512mm, 33.3658536585mm);
        link AB(A, B); link BC(B, C); link DC(D, C); drive AB.angle = theta;";
    let drawing =
        of(&crossed
            .replace("C(72.1951219512mm, 33.3658536585mm)", "C(50mm * 9 / 41, -1600mm / 41)"));
    assert!(!drawing.docs().contains("parallel"), "{}", drawing.docs());
    let grounds = [("A", [0.0, 0.0]), ("D", [0.05, 0.0])];
    assert!(opening(&drawing, &grounds, "A B C D") > 1e-3);
}

/// By the same expressions, or by numbers; else it is said what is not known.
#[test]
fn sides_are_known_to_be_equal_or_it_is_noted() {
    let with = |params: &str, ab: &str, dc: &str| {
        DIRECT
            .replace("ground", &format!("{params} ground"))
            .replace("link AB(A, B);", &format!("link AB(A, B) {ab}"))
            .replace("link DC(D, C);", &format!("link DC(D, C) {dc}"))
    };
    let l = "param l = 67.082039324993690892mm;";
    assert!(of(&with(l, "{ length: l }", "{ length: l }")).docs().contains("mode: parallel"));
    let half = with(l, "{ length: l }", ";");
    assert!(!of(&half).docs().contains("mode: parallel"));
    let note = &notes(&half)[0];
    let expected = "`BC, DC` is drawn as a parallelogram, but does not stay one: that of `DC` is not known to be |AB|\n\
                    near one line its bars jam or cross; draw opposite sides with the same numbers, or give them the \
                    same length";
    assert_eq!(note, expected);
    let nearly = DIRECT.replace("C(630mm, 60mm)", "C(630.01mm, 60mm)");
    assert!(!of(&nearly).docs().contains("mode: parallel"));
    let note = &notes(&nearly)[0];
    assert!(note.contains("`BC` is 0.60001 m, and |AD| is 0.00001 m shorter"), "{note}");
    // So far off it is another machine.
    assert_eq!(notes(&DIRECT.replace("C(630mm, 60mm)", "C(650mm, 60mm)")), [""; 0]);
}

/// A mode that is written stays; one that is left out is that of the drawing.
#[test]
fn a_group_by_hand_has_the_mode_that_is_written_or_drawn() {
    let by_hand = |mode: &str| {
        format!(
            "ground A(0, 0), D(600mm, 0); pin B(30mm, 60mm), C(630mm, 60mm); link AB(A, B); drive AB.angle = theta;
             rrr BC(B), DC(D) -> C {{ lengths: (600mm, hypot(30mm, 60mm)){mode} }}"
        )
    };
    assert!(of(&by_hand("")).docs().contains("mode: parallel"), "{}", of(&by_hand("")).docs());
    for mode in ["left", "parallel"] {
        let docs = of(&by_hand(&format!(", mode: {mode}"))).docs();
        assert!(docs.contains(&format!("mode: {mode}")), "{docs}");
    }
}

#[test]
fn bars_by_hand_that_are_nearly_equal_in_pairs_are_noted() {
    let bars = |lengths: &str, mode: &str| {
        format!(
            "ground A(0, 0), D(4m, 0); crank AB(A) -> B {{ length: 1m, angle: theta }} param side: mode = left;
             rrr BC(B), DC(D) -> C {{ lengths: ({lengths}), mode: {mode} }}
             rrr CE(C), DE(D) -> E {{ lengths: (1m, 1.2m), mode: side }}"
        )
    };
    let note = "`BC, DC` is nearly a parallelogram: `BC` is 4 m, and |AD| is 0.0000001 m shorter\n\
                near one line its bars jam or cross; with equal sides `mode: parallel` keeps it a parallelogram";
    let near_note = |statements: &str| {
        notes(statements).into_iter().filter(|note| note.contains("nearly")).collect::<Vec<_>>()
    };
    assert_eq!(near_note(&bars("4.0000001m, 1m", "right")), [note]);
    assert_eq!(near_note(&bars("4.01m, 1m", "right")), [""; 0]);
    assert_eq!(near_note(&bars("4m, 1m", "right")), [""; 0]);
    assert_eq!(near_note(&bars("4.0000001m, 1m", "side")), [""; 0]);
}

/// A change point is said where a constant mode does not follow the motion, and only there.
#[test]
fn change_points_are_noted_with_what_to_do() {
    let bars = |lengths: &str, mode: &str| {
        format!(
            "ground A(0, 0), D(4m, 0); crank AB(A) -> B {{ length: 1m, angle: theta }} param side: mode = left;
             rrr BC(B), DC(D) -> C {{ lengths: ({lengths}), mode: {mode} }}
             rrr CE(C), DE(D) -> E {{ lengths: (5m, 5m), mode: side }}"
        )
    };
    let follow = "a parameter, `param side: mode = …;`, and a `Tracker` follow the motion through";
    assert_eq!(
        notes(&bars("4m, 1m", "left")),
        [format!(
            "`BC, DC` can be assembled in one way alone at `theta` = 0° and 180°: a change point\n`mode: parallel` \
             keeps it a parallelogram; {follow}"
        )]
    );
    // A kite, and Grashof's sum of the shortest and the longest.
    for (lengths, angles) in [("1m, 4m", "0° and 180°"), ("2m, 3m", "180°")] {
        let found = notes(&bars(lengths, "right"));
        let expected = format!(
            "one way alone at `theta` = {angles}: a change point\nbehind it the mode stands"
        );
        assert!(found.len() == 1 && found[0].contains(&expected), "{lengths}: {found:?}");
    }
    for (lengths, mode) in [("4m, 1m", "side"), ("4m, 1m", "parallel"), ("3m, 3m", "left")] {
        assert_eq!(notes(&bars(lengths, mode)), [""; 0], "{lengths} {mode}");
    }
}

/// Lengths that are not drawn in the place of a pin stay what they are.
#[test]
fn a_parameter_that_moves_a_pin_of_several_links_is_noted() {
    let shear = |pin: &str, length: &str| {
        format!(
            "param crank = 80mm; param tip = 90mm; ground A(0, 0), D(665.7mm, 0);
             pin B({pin}, 0), C(600mm, 360mm), blade(570mm, tip);
             link AB(A, B){length} link BC(B, C, blade), DC(D, C); drive AB.angle = theta;"
        )
    };
    assert_eq!(
        notes(&shear("crank", ";")),
        [
            "`crank` moves `B`, and so changes `AB` and `BC`\nto change the length of one link, draw `B` with numbers \
             and give it to the link: `{ length: crank }`"
        ]
    );
    assert_eq!(notes(&shear("80mm", "{ length: crank }")), [""; 0]);
}
