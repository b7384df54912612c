//! The groups that are found in a drawing: a part of the struct's documentation, and of no picture or page.

use super::tracked::GRIPPER;
use super::{machine, textbook};
use crate::oracle::mechanism;
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

/// Constants beside parameters have the units of their places.
#[test]
fn constants_keep_their_units() {
    let machine = mechanism(
        "pub struct M { input t: angle; param h = 30mm; ground A(0, 0), D(300mm, 0);
         pin B(0, 80mm), C(280mm, 150mm);
         link AB(A, B); link BC(B, C) { length: 228mm + hypot(h, 20mm) * (50mm / h) };
         link DC(D, C) { length: hypot(h, 133mm) + 0.5 * h };
         pin F(450mm, 200mm); ground G(600mm, 0);
         link CF(C, F) { length: sqrt(h * h + 0.0307(m^2)) }
         link GF(G, F) { length: 0.0075(m^2) / h };
         drive AB.angle = t * (h / 30mm) + 0.1; }",
    );
    let docs = machine::documentation(&machine);
    for printed in [
        "angle: t * (h / 30mm) + 0.1",
        "228mm + (hypot(h, 20mm) * (50mm / h))",
        "hypot(h, 133mm) + (0.5 * h)",
        "sqrt(h * h + 0.0307(m^2))",
        "0.0075(m^2) / h",
    ] {
        assert!(docs.contains(printed), "{printed} in {docs}");
    }
    textbook::the_documentation_compiles_as_it_stands(&machine);
}

/// A plate on three bars, the first of which a crank carries. By `tests/assemblies/by_homotopy.py` two of its six complex assemblies are real.
const TRIAD: &str = "pub struct M { input t: angle; ground A(-1m, 0), D(4m, 0), G(2m, 5m);
    pin B(-0.5m, 0.6m), P(0.8m, 1.2m), Q(3m, 0.6m), R(1.9m, 3.1m);
    link AB(A, B), BP(B, P), plate(P, Q, R), DQ(D, Q), GR(G, R); drive AB.angle = t; }";

/// The documentation and a note say how many ways there are to assemble a group of class III where it is drawn.
#[test]
fn the_assemblies_of_a_triad_are_counted() {
    let docs = machine::documentation(&mechanism(TRIAD));
    let told = "Where it is drawn its group has 2 assemblies, of at most 6: in the nearest other `phi` is ";
    assert!(docs.contains(told), "{docs}");
    let output = compile(TRIAD.parse().expect("these are tokens"), &Options::default());
    let [note] = &output.notes[..] else { panic!("{:?}", output.notes) };
    let told = "can be assembled in 2 ways where they are drawn, of at most 6";
    assert!(note.message.contains(told), "{}", note.message);
    println!("{} {:?}", note.message, note.note);
    println!("{docs}");
}

/// A crank, six links that no statement by hand solves, and a dyad behind them.
const AT_ONCE: &str = "pub struct M { input theta: angle; ground P26(0.885, 0.043), P67(0.743, 0.312), E(2, 1);
    pin P01(0.102, 0.069), P02(0.935, 0.827), P13(0.6, 0.124), P04(0.09, 0.631), P34(0.207, 0.988), P15(0.884, 0.368),
        P25(0.535, 0.864), P37(0.703, 0.282), D(1.2, 1.9);
    link L0(P01, P02, P04), L1(P01, P13, P15), L2(P02, P25, P26), L3(P13, P34, P37);
    link L4(P04, P34), L5(P15, P25), L7(P37, P67), L8(P02, D), L9(E, D); drive L7.angle = theta; }";

/// Groups that are solved at once are told in words, and nothing claims to be a declaration.
#[test]
fn groups_of_several_unknowns_are_told_in_words() {
    let docs = machine::documentation(&mechanism(AT_ONCE));
    println!("{docs}");
    assert!(!docs.contains("mechanism!") && !docs.contains("```"), "{docs}");
    let all = [
        "# Groups found in the drawing",
        "The list is no declaration: no statement by hand solves several unknowns at once.",
        " - `crank L7(P67)",
        " together, so that they meet at ",
        " - `rrr L8(P02), L9(E) -> D { ",
        "are certified while the first drive goes from -180.0° to 180.0° about the drawing.",
    ];
    let places = all.map(|told| docs.find(told).unwrap_or_else(|| panic!("{told} in {docs}")));
    assert!(places.is_sorted(), "{docs}");
    let docs = machine::documentation(&mechanism(&format!("pub struct M {{ {GRIPPER} }}")));
    println!("{docs}");
    assert!(
        docs.contains("the first drive goes from -5.5e-6 m to 0.158 m about the drawing."),
        "{docs}"
    );
}
