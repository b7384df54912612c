//! Groups whose hard poses have exact inputs, so that only the solver's own roundings count.

use linkage_core::mechanism;

mechanism! {
    /// A four-bar of any lengths, with products carried to twice the width.
    pub struct CompensatedFourBar {
        numerics compensated;

        input theta: angle;
        param crank = 1m;
        param base = 2m;
        param rocker = 1m;
        param coupler = 2m;
        param elbow: mode = left;

        ground A(0, 0), D(base, 0);

        crank AB(A) -> B        { length: crank, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (coupler, rocker), mode: elbow }

        output C, BC, DC;
    }
}

mechanism! {
    /// A slot at a constant angle of 0.1 mrad to its rail.
    pub struct NarrowSlot {
        input x, y: length;

        guide rail through (0, 0) along 0.2rad;
        point B at (x, y);
        rpp   block(B), yoke(rail) { slot: 0.0001rad }

        output yoke.slide, block.slide;
    }
}

mechanism! {
    /// A slider-crank of any lengths, for angles of a million turns.
    pub struct SliderCrank {
        input theta: angle;
        param crank = 1m;
        param rod = 3m;

        ground A(0, 0);
        guide rail through A along 0deg;

        crank AB(A) -> B              { length: crank, angle: theta }
        rrp   BC(B), block(rail) -> C { length: rod, mode: ahead }

        output block.slide;
    }
}
