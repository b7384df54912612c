//! Mechanisms with change points at any size: every length is a multiple of the parameter `unit`.

use linkage_core::mechanism;

mechanism! {
    /// Bars equal in pairs: a parallelogram or, after a change of mode, an antiparallelogram. The
    /// ground may miss the change point.
    pub struct ScaledPairs {
        input theta: angle;
        param unit = 1m;
        param base = 2m;
        param elbow: mode = left;

        ground A(0, 0), D(base, 0);
        crank AB(A) -> B        { length: unit, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (2 * unit, unit), mode: elbow }

        output C, BC, DC;
    }
}

mechanism! {
    /// Bars 4, 1, 2 and 3.
    pub struct ScaledFourBar {
        input theta: angle;
        param unit = 1m;
        param elbow: mode = left;

        ground A(0, 0), D(4 * unit, 0);
        crank AB(A) -> B        { length: unit, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (2 * unit, 3 * unit), mode: elbow }

        output C, BC, DC;
    }
}

mechanism! {
    /// Crank and rod of one length.
    pub struct ScaledSliderCrank {
        input theta: angle;
        param unit = 1m;
        param side: mode = ahead;

        ground A(0, 0);
        guide rail through (0, 0) along 0deg;
        crank AB(A) -> B              { length: unit, angle: theta }
        rrp   BC(B), block(rail) -> C { length: unit, mode: side }

        output C, BC;
    }
}

mechanism! {
    /// Crank and ground of one length: the moving pins meet the fixed one.
    pub struct ScaledKite {
        input theta: angle;
        param unit = 1m;
        param elbow: mode = left;

        ground A(0, 0), D(unit, 0);
        crank AB(A) -> B        { length: unit, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (2 * unit, 2 * unit), mode: elbow }

        output C, BC, DC;
    }
}

mechanism! {
    /// The crank's pin passes over the bar's pivot.
    pub struct ScaledPivot {
        input theta: angle;
        param unit = 1m;
        param side: mode = ahead;

        ground A(0, 0), D(-unit, 0);
        crank AB(A) -> B       { length: unit, angle: theta }
        rpr   block(B), bar(D) { mode: side }
        point C on bar at (unit, 0);

        output C, bar;
    }
}

mechanism! {
    /// The crank's pin comes as close to the pivot as the block's offset lets it.
    pub struct ScaledOffset {
        input theta: angle;
        param unit = 1m;
        param side: mode = ahead;

        ground A(0, 0), D(-1.5 * unit, 0);
        crank AB(A) -> B       { length: unit, angle: theta }
        rpr   block(B), bar(D) { offset: 0.5 * unit, mode: side }
        point C on bar at (unit, 0);

        output C, bar;
    }
}

mechanism! {
    /// A parallelogram whose rocker drives a slider-crank with change points of its own, a quarter
    /// of a turn away from the parallelogram's.
    pub struct ScaledChain {
        input theta: angle;
        param unit = 1m;
        param elbow: mode = left;
        param side: mode = ahead;

        ground A(0, 0), D(2 * unit, 0);
        guide rail through D along 0deg;
        crank AB(A) -> B              { length: unit, angle: theta }
        rrr   BC(B), DC(D) -> C       { lengths: (2 * unit, unit), mode: elbow }
        rrp   CE(C), block(rail) -> E { length: unit, mode: side }

        output E, DC, CE;
    }
}

mechanism! {
    /// Two four-bars with bars equal in pairs in a row, flat at once, the second turning up to nine
    /// times as fast as the crank where both are crossed; and a rod behind them.
    pub struct ScaledTwins {
        input theta: angle;
        param unit = 1m;
        param elbow: mode = right;
        param knee: mode = left;
        param side: mode = ahead;

        ground A(0, 0), D(2 * unit, 0), F(4 * unit, 0);
        guide rail through F along 30deg;
        crank AB(A) -> B              { length: unit, angle: theta }
        rrr   BC(B), DC(D) -> C       { lengths: (2 * unit, unit), mode: elbow }
        rrr   CE(C), FE(F) -> E       { lengths: (2 * unit, unit), mode: knee }
        rrp   EH(E), block(rail) -> H { length: 5 * unit, mode: side }

        output E, H, EH;
    }
}

mechanism! {
    /// Two four-bars in a row, flat at once where both grounds are of two metres.
    pub struct TwoGrounds {
        input theta: angle;
        param first = 2m;
        param second = 2m;
        param elbow: mode = left;
        param knee: mode = left;

        ground A(0, 0), D(first, 0), F(first + second, 0);
        crank AB(A) -> B        { length: 1m, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (2m, 1m), mode: elbow }
        rrr   CE(C), FE(F) -> E { lengths: (2m, 1m), mode: knee }

        output DC, FE;
    }
}

mechanism! {
    /// Short bars at the end of a long crank: what counts is a share of all lengths, the crank's and
    /// the ground's too.
    pub struct LongCrank {
        input theta: angle;
        param base = 1001m;
        param elbow: mode = left;

        ground A(0, 0), D(base, 0);
        crank AB(A) -> B        { length: 1000m, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (2m, 1m), mode: elbow }

        output DC;
    }
}

mechanism! {
    /// A block whose offset is short against crank and ground.
    pub struct LongCrankPivot {
        input theta: angle;
        param base = 1001m;
        param side: mode = ahead;

        ground A(0, 0), D(base, 0);
        crank AB(A) -> B       { length: 1000m, angle: theta }
        rpr   block(B), bar(D) { offset: 1m, mode: side }

        output bar;
    }
}
