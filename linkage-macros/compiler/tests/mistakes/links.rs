//! Mistakes in links and in what they slide on.

use super::{LEVERS, Slip, check, slip};

const SLIPS: [Slip; 24] = [
    slip("link CE(C, E);", "link CE(C);", "CE", "link CE(C, E)", "link CE(C, E);"),
    slip("link CE(C, E);", "link CE();", "CE", "link CE(C, E)", "link CE(C, E);"),
    slip("link BC(B, C);", "link BC(B, B);", "B#2", "", "link BC(B, C);"),
    slip("link BC(B, C);", "link BC: B, C;", ":", "link BC(B, C)", "link BC(B, C);"),
    slip("link BC(B, C);", "link B-C;", "B-C", "link BC(B, C)", "link BC(B, C);"),
    slip("link BC(B, C);", "link BC(B) -> C;", "-", "link BC(B, C)", "link BC(B, C);"),
    slip("link BC(B, C);", "link BC(B, C)", ")", ";", "link BC(B, C);"),
    slip("link BC(B, C);", "bar BC(B, C);", "bar", "", "link BC(B, C);"),
    slip("link DC(D, C);", "link ground(D, C);", "ground", "", "link DC(D, C);"),
    slip("link DC(D, C);", "link DC(D, C) { mode: left }", "mode", "", "link DC(D, C);"),
    slip("link DC(D, C);", "link DC(D, C) left;", "left", "", "link DC(D, C);"),
    slip("link DC(D, C);", "link DC(D, C, E) { length: 183mm }", "length", "", "link DC(D, C, E);")
        .means(&[("link DC(D, C);", "link DC(D, C, E);")])
        .also(&[
            ("link CE(C, E);", ""),
            ("link ram(E) on bed;", ""),
            ("drive AB.angle = theta;", "drive AB.angle = theta;"),
        ])
        .means(&[
            ("link DC(D, C);", "link DC(D, C, E);"),
            ("link CE(C, E);", ""),
            ("link ram(E) on bed;", ""),
        ]),
    slip(
        "link BC(B, C);",
        "link BC(B, C) { length: 30.4m }",
        "30.4m",
        "30.4cm",
        "link BC(B, C) { length: 30.4cm }",
    )
    .means(&[("link BC(B, C);", "link BC(B, C) { length: 30.4cm }")]),
    slip(
        "link CE(C, E);",
        "link CE(C, E) { length: 38mm }",
        "38mm",
        "38cm",
        "link CE(C, E) { length: 38cm }",
    )
    .means(&[("link CE(C, E);", "link CE(C, E) { length: 38cm }")]),
    slip("link BC(B, C);", "link BC(B, C) { length: 120mm }", "120mm", "", "link BC(B, C);"),
    slip(
        "link ram(E) on bed;",
        "link ram(E) on bed { offset: 10mm }",
        "offset",
        "",
        "link ram(E) on bed;",
    ),
    slip(
        "link ram(E) on bed;",
        "link ram(E);",
        "ram",
        "link ram(E) on bed;",
        "link ram(E) on bed;",
    ),
    slip("on bed;", "on rail;", "rail", "", "on bed;"),
    slip("link ram(E) on bed;", "link ram(E) on bed, bed;", "bed#2", "", "link ram(E) on bed;"),
    slip("link ram(E) on bed;", "piston ram(E) on bed;", "piston", "", "link ram(E) on bed;"),
    slip("along -90deg", "along -90mm", "-90mm", "-90deg", "along -90deg"),
    slip(
        "guide bed through (300mm, 0) along",
        "guide bed (300mm, 0) along",
        "(",
        "",
        "guide bed through (300mm, 0) along",
    ),
    slip("link BC(B, C);", "link BC(B, Q);", "Q", "", "link BC(B, C);"),
    slip("link BC(B, C);", "link BC(B, C) length 304mm;", "length", "", "link BC(B, C);"),
];

#[test]
fn mistakes_about_links_are_mended_by_what_is_proposed() {
    check(LEVERS, &SLIPS);
}

/// A block in a slot: the slot is declared by itself.
#[test]
fn a_link_that_slides_on_a_link_is_told_the_slot() {
    const SLOTTED: &str = "pub struct M { input theta: angle; ground A(0, 0), D(300mm, 0);
        pin B(60mm, 40mm), T(0, 50mm); link AB(A, B), DT(D, T); guide slot on DT through D towards T;
        link block(B) on slot; drive AB.angle = theta; }";
    let right = "guide slot on DT through D towards T;
        link block(B) on slot;";
    let proposed = "guide slot on DT through D towards T;";
    check(SLOTTED, &[slip(right, "link block(B) on DT;", "DT", proposed, right)]);
}
