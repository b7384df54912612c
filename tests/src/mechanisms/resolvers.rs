//! Cranks turned by a resolver, one for each group behind them.

use linkage_core::mechanism;

mechanism! {
    /// A four-bar of known lengths, whose squares of distances are affine in cosine and sine.
    pub struct KnownBars {
        input theta: angle;

        ground A(0, 0), D(304.8mm, 0);
        crank AB(A) -> B        { length: 101.6mm, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (254mm, 177.8mm), mode: left }

        output B, C, AB, BC, DC;
    }
}

mechanism! {
    /// The same with lengths to tune, with products carried to twice the width.
    pub struct TunedBars {
        numerics compensated;

        input theta: angle;
        param crank_length = 101.6mm;
        param coupler = 254mm;
        param rocker = 177.8mm;

        ground A(0, 0), D(304.8mm, 0);
        crank AB(A) -> B        { length: crank_length, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (coupler, rocker), mode: left }

        output B, C, AB, BC, DC;
    }
}

mechanism! {
    /// A slider-crank, and an inverted one on the same crank.
    pub struct SlidersOnACrank {
        input theta: angle;

        ground A(0, 0), D(-400mm, 50mm);
        guide rail through (0, 20mm) along 10deg;
        crank AB(A) -> B             { length: 100mm, angle: theta }
        rrp   BC(B), ram(rail) -> C  { length: 300mm, mode: ahead }
        rpr   block(B), bar(D)       { offset: 30mm }

        output B, C, AB, BC, ram.slide, bar, block.slide;
    }
}

mechanism! {
    /// At 0 the bars are stretched, and nowhere else long enough.
    pub struct Toggle {
        input theta: angle;

        ground A(0, 0), D(8, 0);
        crank AB(A) -> B        { length: 1m, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (4m, 3m), mode: left }

        output C, BC, DC;
    }
}
