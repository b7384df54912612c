//! Mistakes in the places of pins, and in pins as such.

use super::{LEVERS, Slip, check, notes, slip};

const SLIPS: [Slip; 13] = [
    slip(
        "E(300mm, -200mm);",
        "E(300mm, -200mm), Z(1m, 1m);",
        "Z",
        "link CE(C, E, Z)",
        "E(300mm, -200mm), Z(1m, 1m);",
    )
    .and(&[("link CE(C, E)", "link CE(C, E, Z)")])
    .means(&[
        ("E(300mm, -200mm);", "E(300mm, -200mm), Z(1m, 1m);"),
        ("link CE(C, E)", "link CE(C, E, Z)"),
    ]),
    slip("pin B(60mm, 40mm)", "pin A(0, 0), B(60mm, 40mm)", "A", "", "pin B(60mm, 40mm)"),
    slip("C(330mm, 180mm)", "C(60mm, 40mm)", "C", "", "C(330mm, 180mm)"),
    slip("B(60mm, 40mm)", "B(0, 0)", "B", "", "B(60mm, 40mm)"),
    slip(
        "pin B(60mm, 40mm), C(330mm, 180mm), E(300mm, -200mm);",
        "pin B(60mm, 40mm), C(B + (270mm, 140mm)), E(300mm, -200mm);",
        "B + (270mm, 140mm)",
        "pin C(B.x + 270mm, B.y + 140mm);",
        "pin B(60mm, 40mm); pin C(B.x + 270mm, B.y + 140mm); pin E(300mm, -200mm);",
    )
    .means(&[(
        "pin B(60mm, 40mm), C(330mm, 180mm), E(300mm, -200mm);",
        "pin B(60mm, 40mm); pin C(B.x + 270mm, B.y + 140mm); pin E(300mm, -200mm);",
    )]),
    slip("B(60mm, 40mm)", "B(C.x, 40mm)", "C", "", "B(60mm, 40mm)"),
    slip("B(60mm, 40mm)", "B(60mm * cos(theta), 40mm)", "theta", "", "B(60mm, 40mm)"),
    slip(
        "B(60mm, 40mm)",
        "B polar(72mm, 34deg)",
        "polar",
        "B(72mm * cos(34deg), 72mm * sin(34deg))",
        "B(72mm * cos(34deg), 72mm * sin(34deg))",
    )
    .means(&[("B(60mm, 40mm)", "B(72mm * cos(34deg), 72mm * sin(34deg))")]),
    slip(
        "ground A(0, 0), D(300mm, 0);",
        "ground base(A(0, 0), D(300mm, 0));",
        "base",
        "ground A(0, 0), D(300mm, 0);",
        "ground A(0, 0), D(300mm, 0);",
    ),
    slip("link DC(D, C);", "link DC(D, C); joint C: revolute;", "joint", "", "link DC(D, C);"),
    slip("pin B(60mm, 40mm)", "hinge B(60mm, 40mm)", "hinge", "", "pin B(60mm, 40mm)"),
    slip("pin B(60mm, 40mm)", "pin B(60deg, 40mm)", "60deg", "60mm", "pin B(60mm, 40mm)"),
    slip("pin B(60mm, 40mm), C", "pin B(60mm, 40mm) C", "C", ",", "pin B(60mm, 40mm), C"),
];

/// It may be meant: the machine has this offset.
#[test]
fn a_pin_slightly_beside_its_guide_is_noted() {
    let beside = |place: &'static str| notes(LEVERS, &[("E(300mm, -200mm)", place)]);
    let noted = "E#1: `E` is drawn 10 mm beside `bed` / `ram` slides at this offset; draw the pin on the guide where none \
                 is meant";
    assert_eq!(beside("E(290mm, -200mm)"), noted);
    assert_eq!(beside("E(300mm, -200mm)"), "");
    // An offset that is clearly meant.
    assert_eq!(beside("E(240mm, -200mm)"), "");
}

#[test]
fn mistakes_about_pins_are_mended_by_what_is_proposed() {
    check(LEVERS, &SLIPS);
}
