//! The group that draws what holds the equation of an unknown.

use super::resolved;
use crate::model::mechanism::{LinkId, UnknownId};

const PLATE: &str = "input t: angle; ground A(-1, 0), D(4, 0), E(2, 5); \
                     crank AB(A) -> B { length: 0.8, angle: t } \
                     unknown phi: angle between (135deg, 170deg); \
                     crank DQ(D) -> Q { length: 1.56, angle: phi } \
                     rrr BP(B), plate(Q) -> P { lengths: (1.42, 2.2), mode: left } \
                     point R on plate at (1.1, -1.9); guide rail through (0, 3) along 0deg; \
                     guide far through (0, 4) along 0deg;";

/// The links of the group, of which none may be there.
fn drawn_by(equation: &str, behind: &str) -> Vec<String> {
    let statements = format!("{PLATE} solve phi {{ {equation}, mode: rising }} {behind}");
    let (mechanism, mistakes) = resolved(&statements);
    assert_eq!(mistakes, "", "{statements}");
    let mechanism = mechanism.expect("nothing was reported");
    let name = |link: &LinkId| mechanism.links[link.index()].name.to_string();
    mechanism
        .left_out(UnknownId(0))
        .map_or(Vec::new(), |group| group.links.iter().map(name).collect())
}

#[test]
fn a_bar_is_drawn_between_both_points_and_in_their_line() {
    let bar = "rpr end(R), ER(E) { mode: ahead }";
    for (behind, links) in [
        (bar.to_string(), ["end", "ER"].as_slice()),
        ("rpr end(E), RE(R) { mode: ahead }".to_string(), &["end", "RE"]),
        (String::new(), &[]),
        ("rpr end(R), ER(E) { offset: 0.2, mode: ahead }".to_string(), &[]),
        ("rpr end(R), DR(D) { mode: ahead }".to_string(), &[]),
        ("rrr a(E), b(R) -> U { lengths: (2.5, 2), mode: left }".to_string(), &[]),
        (format!("rrr a(E), b(R) -> U {{ lengths: (2.5, 2), mode: left }} {bar}"), &["end", "ER"]),
        (format!("rpr skew(R), rod(E) {{ offset: 0.2, mode: ahead }} {bar}"), &["end", "ER"]),
    ] {
        for equation in ["distance(E, R) = 2.05", "distance(R, E) = 2.05"] {
            assert_eq!(drawn_by(equation, &behind), *links, "{behind}");
        }
    }
}

#[test]
fn a_block_is_drawn_on_the_guide_with_its_slot_square_to_it() {
    for (behind, links) in [
        ("rpp end(R), block(rail) { slot: 90deg }", ["end", "block"].as_slice()),
        ("rpp end(R), block(rail) { slot: 90deg, offsets: (0.3, 0) }", &["end", "block"]),
        ("", &[]),
        ("rpp end(R), block(rail) { slot: 90deg, offsets: (0, 0.3) }", &[]),
        ("rpp end(R), block(rail) { slot: 80deg }", &[]),
        ("rpp end(R), block(rail) { slot: 90deg + t }", &[]),
        ("rpp end(R), block(far) { slot: 90deg }", &[]),
        ("rpp end(P), block(rail) { slot: 90deg }", &[]),
        ("rrp end(R), block(rail) -> U { length: 3, mode: ahead }", &[]),
    ] {
        for equation in ["offset(R, rail) = 0.3", "0.3 = offset(R, rail)"] {
            assert_eq!(drawn_by(equation, behind), *links, "{behind}");
        }
    }
}

/// A block holds one offset at a given height. Of two, nobody says which bodies hold them.
#[test]
fn nothing_holds_two_offsets() {
    let told = |equation: &str| {
        let statements = "gravity (0, -9.81); mass 2kg on P; output plate.Q;";
        resolved(&format!("{PLATE} solve phi {{ {equation}, mode: rising }} {statements}")).1
    };
    assert_eq!(told("offset(R, rail) = 0.3"), "");
    let two = told("offset(R, rail) = offset(P, far)");
    assert!(two.starts_with("Q#3: no reactions beside `unknown phi`; ask for `t.drive`"), "{two}");
}
