//! One group on one crank, with oblique guides, offsets and points on every link; all dimensions
//! are constants.

use linkage_core::mechanism;

mechanism! {
    /// RRR with a point of each bar placed by each kind of coordinates.
    pub struct CouplerFourBar {
        input theta: angle;
        param elbow: mode = left;

        ground A(0.1m, -0.2m), D(3.1m, 0.4m);

        crank AB(A) -> B        { length: 1.1m, angle: theta + 0.2rad }
        rrr   BC(B), DC(D) -> C { lengths: (3.2m, 2.4m), mode: elbow }
        point P on BC at (1.7m, -0.4m);
        point Q on DC at polar (1.3m, 35deg);
        point R on BC at distances (2.1m, 1.9m) right;
    }
}

mechanism! {
    /// RRP on an inclined rail, the pin beside it.
    pub struct InclinedSliderCrank {
        input theta: angle;
        param side: mode = ahead;

        ground A(0, 0);
        guide rail through (0.5m, 0.3m) along 0.15rad;

        crank AB(A) -> B              { length: 1m, angle: theta }
        rrp   BC(B), block(rail) -> C { length: 3.1m, offset: 0.22m, mode: side }
        point P on BC at (1.2m, 0.5m);
        point Q on block at polar (0.3m, 50deg);
    }
}

mechanism! {
    /// RPR with the pin beside the bar.
    pub struct OffsetQuickReturn {
        input theta: angle;
        param side: mode = ahead;

        ground A(0, 0), D(-0.3m, -2.1m);

        crank AB(A) -> B       { length: 1m, angle: theta }
        rpr   block(B), bar(D) { offset: 0.35m, mode: side }
        point E on bar at (3.7m, -0.4m);
        point F on block at (0.2m, 0.3m);
    }
}

mechanism! {
    /// PRP between a guide on the crank and a fixed one.
    pub struct CrossedGuides {
        input theta: angle;

        ground A(0, 0);
        guide post through (2.5m, 0) along 80deg;

        crank AB(A) -> B { length: 1m, angle: theta }
        guide arm on AB through B along 70deg;
        prp   shoe(arm), block(post) -> C { offsets: (0.1m, -0.2m) }
        point W on shoe at (0.2m, 0.1m);
    }
}

mechanism! {
    /// RPP with an oblique slot on an inclined rail.
    pub struct ObliqueYoke {
        input theta: angle;

        ground A(0, 0);
        guide rail through (-1m, -0.8m) along 5deg;

        crank AB(A) -> B           { length: 0.4m, angle: theta }
        rpp   block(B), yoke(rail) { slot: 75deg, offsets: (0.05m, -0.07m) }
        point W on yoke at (0.3m, 0.2m);
        point V on block at (0.1m, -0.05m);
    }
}
