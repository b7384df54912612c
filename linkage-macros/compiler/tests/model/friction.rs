//! Friction: which joint it is of, and what it is made of.

use super::*;

const WRITTEN: &str = "at one of its pins friction is `friction 0.1 on";

/// A joint of a drawing with a load is a body of its own, and each of its links is pressed by another force.
#[test]
fn friction_at_a_loaded_joint_of_a_drawing_is_that_of_the_link_that_stands_there() {
    const DRAWN: &str = "input t: angle; ground A(0, 0), D(4m, 0); pin B(0, 1m), C(3m, 2m); \
                         link AB(A, B), BC(B, C), DC(D, C); drive AB.angle = t; mass 1kg on B;";
    check(&[
        (DRAWN, "friction 0.1 on BC at B radius 8mm;", ""),
        (
            DRAWN,
            "friction 0.1 at B radius 8mm;",
            "B: something is put on `B` itself: say which link turns on it / as in `friction 0.1 on BC at B \
             radius 8mm`",
        ),
        (
            DRAWN,
            "friction 0.1 on AB at B radius 8mm;",
            "B: something is put on `B` itself: let `BC` rub / as in `friction 0.1 on BC at B radius 8mm`",
        ),
        (DRAWN, "friction 0.1 at C radius 8mm;", ""),
    ]);
}

/// Several links meet at a pin that others stand on.
#[test]
fn friction_names_one_joint() {
    check(&[
        (SIX_BAR, "force (1N, 0) on E; friction 0.1 at B radius 8mm;", ""),
        (
            SIX_BAR,
            "force (1N, 0) on E; friction 0.1 at C radius 8mm;",
            "C: several links meet at `C`: say which turns / as in `friction 0.1 on BC at C radius 8mm`; \
             there meet `BC`, `DC` and `CE`",
        ),
        (
            SIX_BAR,
            "force (1N, 0) on E; friction 0.1 on CE at C radius 8mm;",
            "CE: say against which link `CE` turns at `C` / `friction 0.1 between CE and BC at C radius \
             8mm`; `C` joins `BC` and `DC`",
        ),
        (
            SIX_BAR,
            "force (1N, 0) on E; friction 0.1 between CE and AB at C radius 8mm;",
            "C: `CE` and `AB` do not turn on each other at `C` / friction is between a link that stands \
             on the pin and one that has it",
        ),
        (
            SIX_BAR,
            "force (1N, 0) on E; friction 0.1 on DC at B radius 8mm;",
            "DC: `DC` does not turn at `B` / there turn `BC`",
        ),
        (
            CRANK,
            "rrr BC(B), DC(D) -> C { lengths: (3m, 3m), mode: left } mass 1kg on C; \
             friction 0.1 at C radius 8mm;",
            "C#3: something is put on `C` itself: say which link turns on it / as in `friction 0.1 on BC \
             at C radius 8mm`",
        ),
        (
            CRANK,
            "force (1N, 0) on B; friction 0.1 at D radius 8mm;",
            "D: no link turns at `D` / a pin's friction stands at a joint, and a slide's is `friction 0.1 \
             on ram`",
        ),
        (
            SIX_BAR,
            "force (1N, 0) on E; friction 0.1 on A;",
            "A: `A` is a point: write `at A` / a pin's friction is `friction 0.1 at C radius 8mm`",
        ),
        (
            SIX_BAR,
            "force (1N, 0) on E; friction 0.1 on BC;",
            &format!("BC: `BC` does not slide / {WRITTEN} BC at B radius 8mm`"),
        ),
        (
            SIX_BAR,
            "force (1N, 0) on E; friction 0.1 on BC at C radius 8mm; friction 0.1 on DC at C radius 8mm;",
            "friction#2: the friction of `DC.C` is given twice; remove one",
        ),
    ]);
}

#[test]
fn friction_is_of_what_moves() {
    check(&[
        (
            "input x: length; ground A(0, 0); guide bed through (0, x) along 0deg;",
            "crank AB(A) -> B { length: 80mm, angle: 30deg } \
             rrp BC(B), ram(bed) -> C { length: 250mm, mode: ahead } force (1N, 0) on C; \
             friction 0.1 at A radius 8mm;",
            "friction: nothing moves at `AB.A`, and nothing rubs",
        ),
        (
            "input h: length; ground A(0, 0); guide bed through A along 0deg; \
             unknown q: angle between (10deg, 170deg); crank AB(A) -> B { length: 80mm, angle: q } \
             rrp BC(B), ram(bed) -> C { length: 250mm, mode: ahead } \
             solve q { ram.slide = h, mode: falling }",
            "force (1N, 0) on C; friction 0.1 on ram;",
            "friction: beside an unknown no joint has friction / what holds the equation of `solve` \
             follows from reactions, friction among them, and friction from it",
        ),
    ]);
}

#[test]
fn friction_has_a_coefficient_and_a_radius() {
    const LENGTH: &str = "`length` is that of a block that touches its guide at both ends";
    for (friction, expected) in [
        ("-0.1 on block;", "-0.1: a coefficient of friction of -0.1; make it zero or greater"),
        (
            "0.1 at B;",
            "friction: a pin's friction needs its radius: `… radius 8mm` / the couple is coefficient × \
             radius × load; of what slides, write `friction 0.1 on ram`",
        ),
        (
            "0.1 on block radius 8mm;",
            &format!("8mm: what slides has no radius; leave it out / {LENGTH}"),
        ),
        (
            "0.1 on BC at C radius 8mm length 60mm;",
            &format!("60mm: a pin has a `radius` and no length / {LENGTH}"),
        ),
        (
            "0.1 on block smooth 0(m/s);",
            "0(m/s): a rate to smooth by of 0; make it greater than zero",
        ),
    ] {
        check(&[(SIX_BAR, &format!("force (1N, 0) on E; friction {friction}"), expected)]);
    }
}
