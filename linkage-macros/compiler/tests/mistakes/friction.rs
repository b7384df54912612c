//! Mistakes in friction.

use super::{LEVERS, Slip, check, slip};

const FRICTION: &str = "friction 0.1 at A radius 10mm;";

const SLIPS: [Slip; 13] = [
    slip(FRICTION, "friction -0.1 at A radius 10mm;", "-0.1", "", FRICTION),
    slip(
        FRICTION,
        "friction 0.1 at C radius 10mm;",
        "C",
        "friction 0.1 on BC at C radius 8mm",
        "friction 0.1 on BC at C radius 8mm;",
    )
    .means(&[(FRICTION, "friction 0.1 on BC at C radius 8mm;")]),
    slip(
        FRICTION,
        "friction 0.1 at A;",
        "friction",
        "… radius 8mm",
        "friction 0.1 at A radius 8mm;",
    )
    .means(&[(FRICTION, "friction 0.1 at A radius 8mm;")]),
    slip(
        FRICTION,
        "friction 0.1 at A diameter 20mm;",
        "diameter",
        "radius 20mm / 2",
        "friction 0.1 at A radius 20mm / 2;",
    ),
    slip(FRICTION, "friction 0.1 on A radius 10mm;", "A", "at A", FRICTION),
    slip(
        FRICTION,
        "friction 0.1 on BC;",
        "BC",
        "friction 0.1 on BC at B radius 8mm",
        "friction 0.1 on BC at B radius 8mm;",
    )
    .means(&[(FRICTION, "friction 0.1 on BC at B radius 8mm;")]),
    slip(FRICTION, "friction 0.1 on bed;", "bed", "on ram", "friction 0.1 on ram;")
        .means(&[(FRICTION, "friction 0.1 on ram;")]),
    slip(FRICTION, "friction 10% at A radius 10mm;", "%", "0.1", FRICTION),
    slip(
        FRICTION,
        "friction 12 at A radius 10mm;",
        "12",
        "0.12",
        "friction 0.12 at A radius 10mm;",
    )
    .means(&[(FRICTION, "friction 0.12 at A radius 10mm;")]),
    slip(FRICTION, "friction 0.1 at T radius 10mm;", "T", "", FRICTION)
        .also(&[
            ("E(300mm, -200mm);", "E(300mm, -200mm), T(200mm, 200mm);"),
            ("link BC(B, C);", "link BC(B, C, T);"),
        ])
        .means(&[
            ("E(300mm, -200mm);", "E(300mm, -200mm), T(200mm, 200mm);"),
            ("link BC(B, C);", "link BC(B, C, T);"),
        ]),
    slip(FRICTION, "friction 0.1 at A radius 10mm", "10mm", "", FRICTION),
    slip(FRICTION, "friction 0.1 at A radius 10deg;", "10deg", "10mm", FRICTION),
    slip(
        FRICTION,
        "friction 0.1 on ram at E;",
        "friction",
        "… radius 8mm",
        "friction 0.1 on ram at E radius 8mm;",
    )
    .means(&[(FRICTION, "friction 0.1 on ram at E radius 8mm;")]),
];

#[test]
fn mistakes_about_friction_are_mended_by_what_is_proposed() {
    check(LEVERS, &SLIPS);
}

/// Friction in a machine that nothing presses.
#[test]
fn friction_without_a_load_is_told() {
    const BARE: &str = "pub struct M { input theta: angle; ground A(0, 0), D(300mm, 0);
        pin B(60mm, 40mm), C(330mm, 180mm); link AB(A, B), BC(B, C), DC(D, C); drive AB.angle = theta; }";
    let rubs = "drive AB.angle = theta; friction 0.1 at A radius 10mm;";
    check(
        BARE,
        &[slip("drive AB.angle = theta;", rubs, "friction", "", "drive AB.angle = theta;")],
    );
}
