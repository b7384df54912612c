//! Mechanisms under `numerics fast;`.

use linkage_core::mechanism;

mechanism! {
    /// Bars of known lengths between a joint of the ground and one that inputs put anywhere.
    pub struct FastBars {
        numerics fast;
        input dx, dy: length;

        ground B(0, 0);
        point D at (dx, dy);
        rrr BC(B), DC(D) -> C { lengths: (0.625m, 1m), mode: left }

        output C, BC, DC;
    }
}

mechanism! {
    /// One a thousand times as long.
    pub struct FastUnequalBars {
        numerics fast;
        input dx, dy: length;

        ground B(0, 0);
        point D at (dx, dy);
        rrr BC(B), DC(D) -> C { lengths: (1m, 1mm), mode: right }

        output C, BC, DC;
    }
}

macro_rules! twins {
    ($fast:ident, $plain:ident, { $($statements:tt)* }) => {
        mechanism! {
            /// Fast.
            pub struct $fast { numerics fast; $($statements)* }
        }
        mechanism! {
            /// The same without, of which other formulas are made.
            pub struct $plain { $($statements)* }
        }
    };
}

// Two loops: behind a crank whose pivot is on the level of the rocker's or aside of it, the shorter
// bar first or second; and between a coupler's point and a rocker's, or one of the ground.
twins! { FastWatt, PlainWatt, {
    input theta: angle;

    ground A(0, 0), D(0.3, 0.125);
    crank AB(A) -> B        { length: 0.1m, angle: theta }
    rrr   BC(B), DC(D) -> C { lengths: (0.25m, 0.2m), mode: left }
    point P on BC at (150mm, 50mm);
    point Q on DC at (50mm, -20mm);
    rrr   PE(P), QE(Q) -> E { lengths: (0.3m, 0.2m), mode: right }

    output P, C, E, BC, DC, PE, QE;
} }

twins! { FastStephenson, PlainStephenson, {
    input theta: angle;

    ground A(0.1, -0.2), D(0.4, -0.2), F(0.1, 0.3);
    crank AB(A) -> B        { length: 0.1m, angle: 2 * theta + 10deg }
    rrr   BC(B), DC(D) -> C { lengths: (0.2m, 0.25m), mode: left }
    point P on BC at (50mm, 50mm);
    rrr   PE(P), FE(F) -> E { lengths: (0.35m, 0.3m), mode: left }

    output P, C, E, BC, DC, PE, FE;
} }

// Blocks on a crank's pin: the bar's pivot aside and outside of the crank's circle, and within it.
twins! { FastBlock, PlainBlock, {
    input theta: angle;

    ground A(0.1, -0.2), D(0.3, 0.5);
    crank AB(A) -> B          { length: 0.4m, angle: theta }
    rpr   block(B), rod(D)    { mode: behind }
    point E on rod at (0.2, 0.1);

    output E, rod, block.slide;
} }

twins! { FastInnerBlock, PlainInnerBlock, {
    input theta: angle;

    ground A(0, 0), D(-0.03, 0.01);
    crank AB(A) -> B          { length: 0.1m, angle: theta }
    rpr   block(B), rod(D)    { mode: ahead }

    output rod, block.slide;
} }

mechanism! {
    /// A block that comes to a tenth of its farthest distance from the pivot.
    pub struct FastNearBlock {
        numerics fast;
        input theta: angle;

        ground A(0, 0), D(122mm, 0);
        crank AB(A) -> B          { length: 100mm, angle: theta }
        rpr   block(B), rod(D)    { mode: ahead }

        output rod, block.slide;
    }
}

mechanism! {
    /// A crank that reaches both toggles, the shorter bar first, next to the crank's pivot.
    pub struct FastRocker {
        numerics fast;
        input theta: angle;

        ground A(0, 0), D(3, 0);
        crank AB(A) -> B        { length: 1m, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (0.5m, 2.5m), mode: right }

        output C, AB, BC, DC;
    }
}

mechanism! {
    /// Two cranks, and a bar whose length is not known: what is fast is the sine alone.
    pub struct FastTuned {
        numerics fast;
        input theta, phi: angle;
        param l = 0.9m;

        ground A(0, 0), D(1, 0);
        crank AB(A) -> B        { length: 0.3m, angle: theta }
        crank DE(D) -> E        { length: 0.2m, angle: phi }
        rrr   BC(B), EC(E) -> C { lengths: (l, 0.7m), mode: left }

        output C, BC;
    }
}
