//! The mechanisms whose outputs are put where they are wanted.

use linkage_core::mechanism;

mechanism! {
    /// A ram whose guide passes the shaft.
    pub struct SliderCrank {
        input theta: angle;
        param r = 80mm;
        param l = 250mm;
        param e = 30mm;
        ground A(0, 0);
        guide bed through (0, e) along 0deg;
        crank AB(A) -> B           { length: r, angle: theta }
        rrp   BC(B), ram(bed) -> C { length: l, mode: ahead }
        output ram.slide;
    }
}

mechanism! {
    /// A rocker driven by a crank.
    pub struct CrankRocker {
        input theta: angle;
        param r = 1m;
        param coupler = 3m;
        param rocker = 2.5m;
        param base = 3.5m;
        ground A(0, 0), D(base, 0);
        crank AB(A) -> B        { length: r, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (coupler, rocker), mode: left }
        output DC.angle;
    }
}
