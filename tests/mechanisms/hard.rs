//! Mechanisms of the hard poses whose driver is a crank; all their dimensions are parameters.

use linkage_core::mechanism;

mechanism! {
    /// A four-bar of any lengths, for change points and for a kite that collapses.
    pub(crate) struct AnyFourBar {
        input theta: angle;
        param crank = 1m;
        param ground = 2m;
        param rocker = 1m;
        param coupler = 2m;
        param elbow: mode = left;

        ground A(0, 0), D(ground, 0);

        crank AB(A) -> B        { length: crank, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (coupler, rocker), mode: elbow }

        output C, BC, DC;
    }
}

mechanism! {
    /// A slider-crank of any lengths.
    pub(crate) struct AnySliderCrank {
        input theta: angle;
        param crank = 1m;
        param rod = 3m;
        param e = 0m;

        ground A(0, 0);
        guide rail through A along 0deg;

        crank AB(A) -> B              { length: crank, angle: theta }
        rrp   BC(B), block(rail) -> C { length: rod, offset: e, mode: ahead }

        output BC, block.slide;
    }
}
