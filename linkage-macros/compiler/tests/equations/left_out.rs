//! Forces in groups of class III: what the bar or the block carries that the declaration has left out.

use super::forces::{check, loaded};

/// A plate on a crank's bar, on a bar and on a third leg, which is the equation.
const PLATE: &str = "ground A(-1, 0), D(4, 0), E(2, 5); crank AB(A) -> B { length: 0.8, angle: t } \
                     unknown phi: angle between (135deg, 170deg); \
                     crank DQ(D) -> Q { length: 1.56, angle: phi } \
                     rrr BP(B), plate(Q) -> P { lengths: (1.42, 2.2), mode: left } \
                     point R on plate at (1.1, -1.9);";

fn agrees(name: &str, inputs: &str, statements: &str, values: &[[f64; 3]]) {
    check(name, &loaded(&format!("pub struct M {{ {inputs} {statements} }}")), values);
}

/// The bar as it stands behind `solve`, from either end, with a length that an input drives, with what stands on it.
#[test]
fn a_bar_carries_what_stands_on_it_and_the_push() {
    let bars = [
        ("nobody draws it", "distance(E, R) = 2.05", ""),
        ("from the ground", "distance(E, R) = 2.05", "rpr end(R), ER(E) { mode: ahead }"),
        ("from the plate", "distance(R, E) = 2.05", "rpr end(E), ER(R) { mode: ahead }"),
        ("backwards", "2.05 = distance(E, R)", "rpr end(R), ER(E) { mode: behind }"),
        (
            "with a dyad on it",
            "distance(E, R) = 2.05",
            "rpr end(R), ER(E) { mode: ahead } point T on ER at (0.7, 0.3); ground G(5, 4); \
             rrr TU(T), UG(G) -> U { lengths: (2.5, 2), mode: left }",
        ),
        (
            "with a crank by the unknown",
            "distance(E, R) = 2.05",
            "rpr end(R), ER(E) { mode: ahead } crank far(E) -> F { length: 0.3, angle: 2 * phi + t }",
        ),
    ];
    for (name, equation, behind) in bars {
        let mode = if name == "backwards" { "falling" } else { "rising" };
        let solved = format!("{PLATE} solve phi {{ {equation}, mode: {mode} }} {behind}");
        agrees(name, "input t: angle;", &solved, &[[0.9, 0.7, -1.2]]);
    }
    let cylinder = format!(
        "{PLATE} solve phi {{ distance(E, R) = s + 0.1m * cos(t), mode: rising }} \
         rpr end(R), ER(E) {{ mode: ahead }}"
    );
    let values = [[0.9, 0.7, -1.2], [2.0, 0.2, 0.4]];
    agrees("a cylinder", "input t: angle; input s: length;", &cylinder, &values);
}

/// Another dyad between the same two points is no bar, and stands in front of the one that is.
#[test]
fn a_dyad_beside_the_bar_does_not_hold_the_equation() {
    let solved = format!("{PLATE} solve phi {{ distance(E, R) = 2.05, mode: rising }}");
    for (name, behind) in [
        ("alone", "rrr a(E), b(R) -> U { lengths: (2.5, 2), mode: left }"),
        (
            "in front of the bar",
            "rrr a(E), b(R) -> U { lengths: (2.5, 2), mode: left } rpr end(R), ER(E) { mode: ahead }",
        ),
        (
            "a block beside the bar's line, and the bar",
            "rpr skew(R), rod(E) { offset: 0.3, mode: ahead } rpr end(R), ER(E) { mode: ahead }",
        ),
    ] {
        agrees(name, "input t: angle;", &format!("{solved} {behind}"), &[[0.9, 0.7, -1.2]]);
    }
}

/// A place on the plate inside the search that moves with the unknown, along either axis.
#[test]
fn a_place_that_moves_with_the_unknown_loads_the_equation() {
    for place in ["(0.3 + 0.1m * phi, 0.2)", "(0.3, 0.2 - 0.15m * phi)", "polar (0.4, 0.3 * phi)"] {
        let solved = format!(
            "{PLATE} point S on plate at {place}; solve phi {{ distance(E, R) = 2.05, mode: rising }} \
             rpr end(R), ER(E) {{ mode: ahead }}"
        );
        agrees(place, "input t: angle;", &solved, &[[0.9, 0.7, -1.2]]);
    }
}

/// The block that stands on a rail of the ground, and on one of a crank.
#[test]
fn a_block_carries_what_stands_on_it_and_the_push() {
    let machine = |rail: &str, equation: &str, behind: &str| {
        format!(
            "ground A(-1, 0), D(4, 0); crank AB(A) -> B {{ length: 0.8, angle: t }} {rail} \
             guide low through (0, 1) along -10deg; unknown phi: angle between (-8deg, 15deg); \
             crank BQ(B) -> Q {{ length: 3.5, angle: phi }} \
             rrp plate(Q), bp(low) -> P {{ length: 2.28, offset: 0.34, mode: behind }} \
             point R on plate at (2.19, -3.86); solve phi {{ {equation} }} {behind}"
        )
    };
    let ground = "guide rail through (0, 4) along 10deg;";
    let crank = "guide rail on AB through (0.1, 3.2) along -42deg;";
    let block = "rpp end(R), block(rail) { slot: 90deg, offsets: (0.56, 0) }";
    let skew = "rpp end(R), block(rail) { slot: 70deg, offsets: (0.1, 0.3) }";
    let geared = "rpp end(R), block(rail) { slot: 90deg, offsets: (0.56, 0) } \
                  crank far(A) -> F { length: 0.3, angle: t + bp.slide / 2m }";
    let [rising, turned] =
        ["offset(R, rail) = 0.56, mode: rising", "0.56 = offset(R, rail), mode: falling"];
    let [far, moved] =
        ["offset(R, rail) = 1.9, mode: rising", "offset(R, rail) = 1.85 + 0.05m * t, mode: rising"];
    for (name, rail, equation, behind) in [
        ("nobody draws it", ground, rising, ""),
        ("on the ground", ground, rising, block),
        ("on the ground, turned", ground, turned, block),
        ("on a crank", crank, far, block),
        ("an offset that moves", crank, moved, block),
        ("another yoke beside it", ground, rising, skew),
        ("a crank by a slide inside", ground, rising, geared),
    ] {
        agrees(name, "input t: angle;", &machine(rail, equation, behind), &[[0.9, 0.7, -1.2]]);
    }
}
