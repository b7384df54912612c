//! The groups that are found in a drawing: a part of the struct's documentation, and of no picture or page.

use super::cases;
use super::machine::machine;
use crate::pipeline::{Options, compile};

const DRAWN: &str = "/// A crank and a rocker.
    pub struct M { input t: angle; ground A(0, 0), D(4m, 0); pin B(0.5m, 0.9m), C(3.2m, 2.6m);
    link AB(A, B), BC(B, C), DC(D, C); drive AB.angle = t; }";

/// The tokens of a machine, with its picture and its page.
fn expanded(source: &str) -> String {
    let output = compile(source.parse().expect("these are tokens"), &Options::PAGE);
    assert!(output.diagnostics.is_empty(), "{:?}", output.diagnostics);
    output.tokens.to_string()
}

#[test]
fn a_picture_has_the_words_of_the_author_alone() {
    let code = expanded(DRAWN);
    assert_eq!(code.matches("Groups found in the drawing").count(), 1, "they are documentation");
    assert!(code.contains("docs : \"A crank and a rocker.\""), "the plan has the author's words");
    let unsaid = expanded(&DRAWN.replace("/// A crank and a rocker.", ""));
    assert!(unsaid.contains("docs : \"\""), "nobody has said anything");
}

/// Machines with parameters, modes by name, offsets, slots, cylinders, links on links and what is declared by hand.
const OTHERS: [&str; 6] = [
    "input t: angle; param h = 12mm; ground A(0, 0); pin B(30mm, 40mm), C(150mm, 20mm); \
     link AB(A, B), BC(B, C), ram(C) on bed; guide bed through (0, h) along 5deg; drive AB.angle = t;",
    "input t: angle; param elbow: mode = right; ground A(0, 0), D(4, 0), F(7, 1); pin B(0.5, 0.9), C(3.2, 2.6); \
     link AB(A, B), BC(B, C), DC(D, C); drive AB.angle = t; \
     rrr CE(C), FE(F) -> E { lengths: (3.1, 2.9), mode: elbow }",
    "input s: length; ground A(0, 0), D(1.5, 0); pin B(0.4, 1.2), P(0.9, 1.4); link AB(A, B, P); link DB(D, B) { length: s } \
     point Q on AB at polar (0.3, 20deg);",
    "input t, u: angle; ground A(0, 0); pin B(1, 0.4), C(1.7, 1.1), T(2.2, 1.9); link AB(A, B), BC(B, C, T); \
     drive AB.angle = t; drive BC.angle - AB.angle = u;",
    "input t: angle; ground A(0, 0), D(0.8, -0.3); pin B(0.3, 0.5); link AB(A, B), block(B) on slot, lever(D); \
     guide slot on lever through D towards B; drive AB.angle = 2 * t;",
    "input x: length; ground D(0.9, 0.1); pin B(0.2, 0), C(0.6, 0.45); link foot(B) on floor, BC(B, C), DC(D, C); \
     guide floor through (0, 0) along 0deg; drive foot.slide = x;",
];

/// The declaration that is printed is the same machine: its points are in the same places, and move alike.
#[test]
fn the_declaration_of_the_groups_is_the_same_machine() {
    let drawn = cases().into_iter().take(15).map(|case| case.declaration());
    let others = OTHERS.into_iter().map(|statements| format!("pub struct M {{ {statements} }}"));
    let mut compared = 0;
    for source in drawn.chain(others) {
        let Ok(drawing) = machine(&source) else { continue };
        let docs = drawing.docs();
        let (_, groups) = docs.split_once("pub struct M {").expect("the groups are printed");
        let (groups, _) = groups.split_once("\n     }").expect("they end");
        let by_hand = machine(&format!("pub struct M {{ {groups} }}"))
            .unwrap_or_else(|told| panic!("{groups}\n{told:?}"));
        let Some(inputs) = &drawing.mechanism.drawn else { continue };
        for by in [0.0, 0.011, -0.017] {
            let inputs: Vec<_> = inputs.iter().map(|input| input + by).collect();
            let [one, other] = [&drawing, &by_hand].map(|machine| machine.pins::<f64>(&inputs));
            for (name, at) in &other {
                let is_given = by_hand.mechanism.outputs.iter().any(|output| output.field == name);
                let known = one.iter().find(|(known, _)| known == name).filter(|_| is_given);
                let Some((_, known)) = known else { continue };
                // Machines of some metres, and roots that are found to 1e-11.
                let off = (at[0] - known[0]).hypot(at[1] - known[1]);
                assert!(off < 1e-9, "{name} at {by}: {off:e}\n{groups}");
                compared += 1;
            }
        }
    }
    assert!(compared > 200, "{compared}");
}
