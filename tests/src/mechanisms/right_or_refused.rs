//! Mechanisms whose poses an attack found to be wrong inside `Ok`.

use linkage_core::mechanism;

mechanism! {
    /// A point whose distances from a bar's joints are given.
    pub struct Measured {
        input first, second: length;

        ground A(0, 0);
        crank AB(A) -> B { length: 1m, angle: 0deg }
        point P on AB at distances (first, second) left;

        output P;
    }
}

mechanism! {
    /// The same with distances to tune, from a bar that turns.
    pub struct Tuned {
        input theta: angle;
        param first = 0.6m;
        param second = 0.8m;
        param bar = 1m;

        ground A(0, 0);
        crank AB(A) -> B { length: bar, angle: theta }
        point P on AB at distances (first, second) right;

        output P;
    }
}

mechanism! {
    /// Bars of known lengths, one a thousand times as long.
    pub struct UnequalBars {
        input dx, dy: length;

        ground B(0, 0);
        point D at (dx, dy);
        rrr BC(B), DC(D) -> C { lengths: (1mm, 1m), mode: left }

        output C, BC, DC;
    }
}

mechanism! {
    /// A parallelogram: at 0 and 180° both modes are one.
    pub struct Parallelogram {
        input theta: angle;

        ground A(0, 0), D(2, 0);
        crank AB(A) -> B        { length: 1m, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (2m, 1m), mode: left }

        output C, DC;
    }
}

mechanism! {
    /// A block at its bar's offset, where it passes the foot of the bar's pivot.
    pub struct PassingBlock {
        input x: length;

        ground D(0, 0);
        point B at (0.5m, x);
        rpr block(B), bar(D) { offset: 0.5m, mode: ahead }

        output bar, block.slide;
    }
}

mechanism! {
    /// Bars that are stretched at x = 0 and nowhere assembled beside it.
    pub struct TouchingBars {
        input x: length;

        ground B(0, 0);
        point D at (5m + x * x / 1m, 0);
        rrr BC(B), DC(D) -> C { lengths: (3m, 2m), mode: left }

        output C;
    }
}

mechanism! {
    /// A stretched group that stands still behind a crank that does not.
    pub struct StandingLimit {
        input theta: angle;
        param reach = 5m;

        ground A(1, 1), B(0, 0), D(reach, 0);
        crank AF(A) -> F        { length: 1m, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (3m, 2m), mode: left }

        output C, F;
    }
}
