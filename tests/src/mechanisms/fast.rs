//! Mechanisms under `numerics fast;`, and the same without, of which other formulas are made.

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
    /// The same without.
    pub struct PlainBars {
        input dx, dy: length;

        ground B(0, 0);
        point D at (dx, dy);
        rrr BC(B), DC(D) -> C { lengths: (0.625m, 1m), mode: left }

        output C, BC, DC;
    }
}

mechanism! {
    /// `FastBars`, 4096 times as small.
    pub struct FastSmallBars {
        numerics fast;
        input dx, dy: length;

        ground B(0, 0);
        point D at (dx, dy);
        rrr BC(B), DC(D) -> C { lengths: (0.000152587890625m, 0.000244140625m), mode: left }

        output C;
    }
}

mechanism! {
    /// Such bars of a length whose fourth power f32 does not hold.
    pub struct FastTinyBars {
        numerics fast;
        input dx, dy: length;

        ground B(0, 0);
        point D at (dx, dy);
        rrr BC(B), DC(D) -> C { lengths: (6.25e-12m, 1e-11m), mode: left }

        output C, BC, DC;
    }
}

mechanism! {
    /// Such bars, one a thousand times as long as the other.
    pub struct FastUnequalBars {
        numerics fast;
        input dx, dy: length;

        ground B(0, 0);
        point D at (dx, dy);
        rrr BC(B), DC(D) -> C { lengths: (1m, 1mm), mode: right }

        output C, BC, DC;
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
    /// A crank between whose toggles a short bar turns half a turn.
    pub struct FastShortBar {
        numerics fast;
        input theta: angle;

        ground A(0, 0), D(3, 0);
        crank AB(A) -> B        { length: 1m, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (3m, 3mm), mode: left }

        output C, BC, DC;
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

mechanism! {
    /// The same without.
    pub struct PlainTuned {
        input theta, phi: angle;
        param l = 0.9m;

        ground A(0, 0), D(1, 0);
        crank AB(A) -> B        { length: 0.3m, angle: theta }
        crank DE(D) -> E        { length: 0.2m, angle: phi }
        rrr   BC(B), EC(E) -> C { lengths: (l, 0.7m), mode: left }

        output C, BC;
    }
}

/// A mechanism with and without `fast`.
macro_rules! twins {
    ($(#[$what:meta])* $fast:ident, $plain:ident, { $($statements:tt)* }) => {
        mechanism! {
            $(#[$what])*
            pub struct $fast { numerics fast; $($statements)* }
        }
        mechanism! {
            $(#[$what])*
            pub struct $plain { $($statements)* }
        }
    };
}

twins! {
    /// Bars of one length, whose outer joints may meet.
    FastEqualBars, PlainEqualBars, {
        input dx, dy: length;

        ground B(0, 0);
        point D at (dx, dy);
        rrr BC(B), DC(D) -> C { lengths: (1m, 1m), mode: left }

        output C, BC, DC;
    }
}

twins! {
    /// A crank whose pin comes near to the other pivot: the square of their distance is that of a sum of
    /// squares, which the cosine alone would give with a thirtieth of the digits.
    FastClose, PlainClose, {
        input theta: angle;

        ground A(0, 0), D(1m, 0);
        crank AB(A) -> B        { length: 0.9375m, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (1m, 1.03125m), mode: left }

        output C;
    }
}

twins! {
    /// A crank that is longer than the base, with masses.
    FastDragLink, PlainDragLink, {
        input theta: angle;

        ground A(0, 0), D(62.5mm, 62.5mm);
        crank AB(A) -> B        { length: 0.3m, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (0.3m, 0.25m), mode: left }

        gravity (0, -9.81);
        mass 2kg on BC uniform;
        mass 3kg on DC at (0.1m, 0.05m) inertia 0.02(kg*m^2);

        output C, BC, DC, theta.drive, BC.B, DC.D;
    }
}

twins! {
    /// Two loops: between two cranks, and between a point that swings with one of them and the ground.
    FastFiveBar, PlainFiveBar, {
        input theta: angle;

        ground A(0, 0), D(0.5, 0.0625), F(0.25, -0.5);
        crank AB(A) -> B        { length: 0.125m, angle: theta }
        crank DE(D) -> E        { length: 0.1m, angle: 40deg - 2 * theta }
        rrr   BC(B), EC(E) -> C { lengths: (0.5m, 0.4375m), mode: left }
        point Q on DE at (0.0625m, 0.125m);
        rrr   QG(Q), FG(F) -> G { lengths: (0.375m, 0.4375m), mode: right }

        output C, G, BC, EC, QG, FG;
    }
}

twins! {
    /// Two loops: behind a crank whose pivot is aside of the rocker's, the longer bar first, and
    /// between a coupler's point and a rocker's.
    FastWatt, PlainWatt, {
        input theta: angle;

        ground A(0, 0), D(0.3, 0.125);
        crank AB(A) -> B        { length: 0.1m, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (0.25m, 0.2m), mode: left }
        point P on BC at (150mm, 50mm);
        point Q on DC at (50mm, -20mm);
        rrr   PE(P), QE(Q) -> E { lengths: (0.3m, 0.2m), mode: right }

        output P, C, E, BC, DC, PE, QE;
    }
}

twins! {
    /// Two loops: behind a crank whose pivot is on the level of the rocker's, the shorter bar first, and
    /// between a coupler's point and one of the ground.
    FastStephenson, PlainStephenson, {
        input theta: angle;

        ground A(0.1, -0.2), D(0.4, -0.2), F(0.1, 0.3);
        crank AB(A) -> B        { length: 0.1m, angle: 2 * theta + 10deg }
        rrr   BC(B), DC(D) -> C { lengths: (0.2m, 0.25m), mode: left }
        point P on BC at (50mm, 50mm);
        rrr   PE(P), FE(F) -> E { lengths: (0.35m, 0.3m), mode: left }

        output P, C, E, BC, DC, PE, FE;
    }
}

twins! {
    /// A crank that reaches both toggles aside of the other pivot: at both of them its angle tells how
    /// far the joints are apart.
    FastReach, PlainReach, {
        input theta: angle;

        ground A(0.25, -0.5), D(3.25, 0.25);
        crank AB(A) -> B        { length: 1m, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (0.5m, 2.75m), mode: right }

        output C, AB, BC, DC;
    }
}

twins! {
    /// A block on a crank's pin, the bar's pivot aside and outside of the crank's circle.
    FastBlock, PlainBlock, {
        input theta: angle;

        ground A(0.1, -0.2), D(0.3, 0.5);
        crank AB(A) -> B        { length: 0.4m, angle: theta }
        rpr   block(B), rod(D)  { mode: behind }
        point E on rod at (0.2, 0.1);

        output E, rod, block.slide;
    }
}

twins! {
    /// The bar's pivot within the circle.
    FastInnerBlock, PlainInnerBlock, {
        input theta: angle;

        ground A(0, 0), D(-0.03, 0.01);
        crank AB(A) -> B        { length: 0.1m, angle: theta }
        rpr   block(B), rod(D)  { mode: ahead }

        output rod, block.slide;
    }
}

mechanism! {
    /// A block that comes to a tenth of its farthest distance from the pivot.
    pub struct FastNearBlock {
        numerics fast;
        input theta: angle;

        ground A(0, 0), D(122mm, 0);
        crank AB(A) -> B        { length: 100mm, angle: theta }
        rpr   block(B), rod(D)  { mode: ahead }

        output rod, block.slide;
    }
}
