//! Mechanisms whose lengths are constants, and the same with parameters in place of them, of which other
//! formulas are made.

use linkage_core::mechanism;

/// A mechanism of constant lengths, and of parameters.
macro_rules! twins {
    ($(#[$what:meta])* $constant:ident, $tuned:ident, [$($length:ident = $value:tt),*], { $($statements:tt)* }) => {
        mechanism! {
            $(#[$what])*
            pub struct $constant { $(let $length = $value;)* $($statements)* }
        }
        mechanism! {
            $(#[$what])*
            pub struct $tuned { $(param $length = $value;)* $($statements)* }
        }
    };
}

twins! {
    /// Bars between a joint of the ground and one that inputs put anywhere.
    ConstantBars, TunedBars, [bc = 0.625m, dc = 1m], {
        input dx, dy: length;

        ground B(0, 0);
        point D at (dx, dy);
        rrr BC(B), DC(D) -> C { lengths: (bc, dc), mode: left }

        output C, BC, DC;
    }
}

mechanism! {
    /// `ConstantBars`, 4096 times as small.
    pub struct ConstantSmallBars {
        input dx, dy: length;

        ground B(0, 0);
        point D at (dx, dy);
        rrr BC(B), DC(D) -> C { lengths: (0.000152587890625m, 0.000244140625m), mode: left }

        output C;
    }
}

mechanism! {
    /// Such bars of a length whose fourth power f32 does not hold.
    pub struct ConstantTinyBars {
        input dx, dy: length;

        ground B(0, 0);
        point D at (dx, dy);
        rrr BC(B), DC(D) -> C { lengths: (6.25e-12m, 1e-11m), mode: left }

        output C, BC, DC;
    }
}

twins! {
    /// Such bars, one a thousand times as long as the other.
    ConstantUnequalBars, TunedUnequalBars, [bc = 1m, dc = 1mm], {
        input dx, dy: length;

        ground B(0, 0);
        point D at (dx, dy);
        rrr BC(B), DC(D) -> C { lengths: (bc, dc), mode: right }

        output C, BC, DC;
    }
}

mechanism! {
    /// A crank that reaches both toggles, the shorter bar first, next to the crank's pivot.
    pub struct ConstantRocker {
        input theta: angle;

        ground A(0, 0), D(3, 0);
        crank AB(A) -> B        { length: 1m, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (0.5m, 2.5m), mode: right }

        output C, AB, BC, DC;
    }
}

mechanism! {
    /// A crank between whose toggles a short bar turns half a turn.
    pub struct ConstantShortBar {
        input theta: angle;

        ground A(0, 0), D(3, 0);
        crank AB(A) -> B        { length: 1m, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (3m, 3mm), mode: left }

        output C, BC, DC;
    }
}

twins! {
    /// Two cranks, and two bars between them.
    ConstantCranks, TunedCranks, [l = 0.9m], {
        input theta, phi: angle;

        ground A(0, 0), D(1, 0);
        crank AB(A) -> B        { length: 0.3m, angle: theta }
        crank DE(D) -> E        { length: 0.2m, angle: phi }
        rrr   BC(B), EC(E) -> C { lengths: (l, 0.7m), mode: left }

        output C, BC;
    }
}

twins! {
    /// Bars of one length, whose outer joints may meet.
    ConstantEqualBars, TunedEqualBars, [bc = 1m, dc = 1m], {
        input dx, dy: length;

        ground B(0, 0);
        point D at (dx, dy);
        rrr BC(B), DC(D) -> C { lengths: (bc, dc), mode: left }

        output C, BC, DC;
    }
}

twins! {
    /// A crank whose pin comes near to the other pivot: the square of their distance is that of a sum of
    /// squares, which the cosine alone would give with a thirtieth of the digits.
    ConstantClose, TunedClose, [ab = 0.9375m, bc = 1m, dc = 1.03125m], {
        input theta: angle;

        ground A(0, 0), D(1m, 0);
        crank AB(A) -> B        { length: ab, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (bc, dc), mode: left }

        output C;
    }
}

twins! {
    /// A crank that is longer than the base, with masses.
    ConstantDragLink, TunedDragLink, [ab = 0.3m, bc = 0.3m, dc = 0.25m], {
        input theta: angle;

        ground A(0, 0), D(62.5mm, 62.5mm);
        crank AB(A) -> B        { length: ab, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (bc, dc), mode: left }

        gravity (0, -9.81);
        mass 2kg on BC uniform;
        mass 3kg on DC at (0.1m, 0.05m) inertia 0.02(kg*m^2);

        output C, BC, DC, theta.drive, BC.B, DC.D;
    }
}

twins! {
    /// Two loops: between two cranks, and between a point that swings with one of them and the ground.
    ConstantFiveBar, TunedFiveBar, [ab = 0.125m, bc = 0.5m, ec = 0.4375m, qg = 0.375m, fg = 0.4375m], {
        input theta: angle;

        ground A(0, 0), D(0.5, 0.0625), F(0.25, -0.5);
        crank AB(A) -> B        { length: ab, angle: theta }
        crank DE(D) -> E        { length: 0.1m, angle: 40deg - 2 * theta }
        rrr   BC(B), EC(E) -> C { lengths: (bc, ec), mode: left }
        point Q on DE at (0.0625m, 0.125m);
        rrr   QG(Q), FG(F) -> G { lengths: (qg, fg), mode: right }

        output C, G, BC, EC, QG, FG;
    }
}

twins! {
    /// Two loops: behind a crank whose pivot is aside of the rocker's, the longer bar first, and
    /// between a coupler's point and a rocker's.
    ConstantWatt, TunedWatt, [ab = 0.1m, bc = 0.25m, dc = 0.2m, pe = 0.3m, qe = 0.2m], {
        input theta: angle;

        ground A(0, 0), D(0.3, 0.125);
        crank AB(A) -> B        { length: ab, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (bc, dc), mode: left }
        point P on BC at (150mm, 50mm);
        point Q on DC at (50mm, -20mm);
        rrr   PE(P), QE(Q) -> E { lengths: (pe, qe), mode: right }

        output P, C, E, BC, DC, PE, QE;
    }
}

twins! {
    /// Two loops: behind a crank whose pivot is on the level of the rocker's, the shorter bar first, and
    /// between a coupler's point and one of the ground.
    ConstantStephenson, TunedStephenson, [ab = 0.1m, bc = 0.2m, dc = 0.25m, pe = 0.35m, fe = 0.3m], {
        input theta: angle;

        ground A(0.1, -0.2), D(0.4, -0.2), F(0.1, 0.3);
        crank AB(A) -> B        { length: ab, angle: 2 * theta + 10deg }
        rrr   BC(B), DC(D) -> C { lengths: (bc, dc), mode: left }
        point P on BC at (50mm, 50mm);
        rrr   PE(P), FE(F) -> E { lengths: (pe, fe), mode: left }

        output P, C, E, BC, DC, PE, FE;
    }
}

twins! {
    /// A crank that reaches both toggles aside of the other pivot: at both of them its angle tells how
    /// far the joints are apart.
    ConstantReach, TunedReach, [ab = 1m, bc = 0.5m, dc = 2.75m], {
        input theta: angle;

        ground A(0.25, -0.5), D(3.25, 0.25);
        crank AB(A) -> B        { length: ab, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (bc, dc), mode: right }

        output C, AB, BC, DC;
    }
}

twins! {
    /// A block on a crank's pin, the bar's pivot aside and outside of the crank's circle.
    ConstantBlock, TunedBlock, [ab = 0.4m], {
        input theta: angle;

        ground A(0.1, -0.2), D(0.3, 0.5);
        crank AB(A) -> B        { length: ab, angle: theta }
        rpr   block(B), rod(D)  { mode: behind }
        point E on rod at (0.2, 0.1);

        output E, rod, block.slide;
    }
}

twins! {
    /// The bar's pivot within the circle.
    ConstantInnerBlock, TunedInnerBlock, [ab = 0.1m], {
        input theta: angle;

        ground A(0, 0), D(-0.03, 0.01);
        crank AB(A) -> B        { length: ab, angle: theta }
        rpr   block(B), rod(D)  { mode: ahead }

        output rod, block.slide;
    }
}

mechanism! {
    /// A block that comes to a tenth of its farthest distance from the pivot.
    pub struct ConstantNearBlock {
        input theta: angle;

        ground A(0, 0), D(122mm, 0);
        crank AB(A) -> B        { length: 100mm, angle: theta }
        rpr   block(B), rod(D)  { mode: ahead }

        output rod, block.slide;
    }
}
