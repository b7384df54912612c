//! Bodies that never move against each other.

use super::resolved_on;
use crate::model::rigid::RigidBodies;
pub(crate) use linkage_compiler::model::rigid::*;

/// A four-bar, its coupler with two points and a guide.
const FOUR_BAR: &str = "input t: angle; input s: length; param l = 0.4; ground A(0, 0), D(0.9, 0);
    crank AB(A) -> B { length: 0.3, angle: t }
    rrr BK(B), DK(D) -> K { lengths: (0.8, 0.5), mode: left }
    point E on BK at (0.5, 0.1); point G on BK at (0.6, -0.1); point M on BK at (0.2 + s, 0.1);
    guide way on BK through (0.1, 0.2) along 20deg; guide turned on BK through E along 0.1 * t;
    guide line on BK through E towards G; guide rail through (0, -1) along 0deg;
    force (0, -1) on K;";

/// True for each friction of the statements, if the bodies of its joint never move against each other.
fn held(statements: &str) -> Vec<bool> {
    let (mechanism, mistakes) = resolved_on(FOUR_BAR, statements);
    assert_eq!(mistakes, "", "{statements}");
    let mechanism = mechanism.expect("it has no mistakes");
    let bodies = RigidBodies::of(&mechanism);
    let frictions = mechanism.dynamics.frictions.iter();
    frictions.map(|friction| bodies.hold(&mechanism, friction.contact)).collect()
}

#[test]
fn a_group_on_one_body_is_rigid_with_it() {
    const PIN: &str = "friction 0.1 on p at B radius 0.01; friction 0.1 at C radius 0.01;";
    let bars = |lengths: &str, on: &str| {
        held(&format!("rrr p(B), q({on}) -> C {{ lengths: {lengths}, mode: left }} {PIN}"))
    };
    // B is a point of AB and of BK; D and the ground's are none of BK's.
    assert_eq!(held(&format!("{TRIANGLE} {PIN}")), [false, true]);
    assert_eq!(bars("(0.31, l)", "E"), [false, true]);
    assert_eq!(bars("(0.31 + s, 0.4)", "E"), [false, false]);
    assert_eq!(bars("(0.31, 0.4)", "M"), [false, false]);
    assert_eq!(bars("(0.31, 0.9)", "D"), [false, false]);
    let on_coupler = "friction 0.1 on q at E radius 0.01;";
    assert_eq!(held(&format!("{TRIANGLE} {on_coupler}")), [true]);
    // Two triangles deep, and on the first.
    let deep =
        "point F on p at (0.2, 0.15); rrr r(F), u(G) -> H { lengths: (0.4, 0.45), mode: right }
        friction 0.1 on r at F radius 0.01; friction 0.1 at H radius 0.01;
        friction 0.1 on u at G radius 0.01;";
    assert_eq!(held(&format!("{TRIANGLE} {deep}")), [true; 3]);
}

const TRIANGLE: &str = "rrr p(B), q(E) -> C { lengths: (0.31, 0.27), mode: left }";

#[test]
fn what_slides_on_one_body_slides_not_at_all() {
    let shoe = |guide: &str, fields: &str| {
        held(&format!(
            "rrp rod(E), shoe({guide}) -> S {{ length: 0.3, mode: ahead {fields} }}
             friction 0.1 on shoe; friction 0.1 on rod at S radius 0.01;"
        ))
    };
    assert_eq!(shoe("way", ""), [true; 2]);
    assert_eq!(shoe("line", ", offset: 0.01"), [true; 2]);
    assert_eq!(shoe("way", ", offset: s"), [false; 2]);
    assert_eq!(shoe("turned", ""), [false; 2]);
    assert_eq!(shoe("rail", ""), [false; 2]);
    let bar = |on: &str| held(&format!("rpr block(E), bar({on}) {{}} friction 0.1 on block;"));
    assert_eq!([bar("G"), bar("M"), bar("D")].concat(), [true, false, false]);
    let slot = |angle: &str| {
        held(&format!(
            "rpp block(E), yoke(way) {{ slot: {angle} }} friction 0.1 on block; friction 0.1 on yoke;"
        ))
    };
    assert_eq!(slot("70deg"), [true; 2]);
    assert_eq!(slot("70deg + 0.1 * t"), [false; 2]);
    let blocks = |second: &str| {
        held(&format!(
            "prp one(way), two({second}) -> S {{}} friction 0.1 on one; friction 0.1 on two;"
        ))
    };
    assert_eq!([blocks("line"), blocks("rail")].concat(), [true, true, false, false]);
}

#[test]
fn a_driver_that_no_input_moves_is_rigid() {
    let arm = |angle: &str, against: &str| {
        held(&format!(
            "crank arm(E) -> F {{ length: 0.1, angle: {angle}, relative_to: {against} }}
             rrr p(F), q(G) -> C {{ lengths: (0.31, 0.27), mode: left }}
             friction 0.1 at C radius 0.01; friction 0.1 on q at G radius 0.01;"
        ))
    };
    assert_eq!(arm("30deg", "BK"), [true; 2]);
    assert_eq!(arm("0.1 * t", "BK"), [false; 2]);
    assert_eq!(arm("30deg", "AB"), [false; 2]);
    assert_eq!(arm("AB.angle", "BK"), [false; 2]);
    let ram = |slide: &str| {
        held(&format!(
            "slider ram(way) -> F {{ slide: {slide} }}
             rrr p(F), q(G) -> C {{ lengths: (0.31, 0.27), mode: left }} friction 0.1 at C radius 0.01;"
        ))
    };
    assert_eq!([ram("l"), ram("s")].concat(), [true, false]);
}
