//! Groups behind others whose limit is approached, and groups with carried products.

use linkage_core::mechanism;

mechanism! {
    /// A press: behind a crank-rocker, a rod that stands almost square to its guide.
    pub struct ChainedPress {
        input theta: angle;
        param rod = 1m;
        param dx = 2.2m;
        param dy = -0.3m;
        param kx = 1.5m;
        param ky = 0.4m;
        param slope = 1.1rad;
        param crank_length = 0.6m;
        param coupler = 1.9m;
        param rocker = 1.4m;
        param ex = 1.1m;
        param ey = 0.3m;
        param e = 0.1m;

        ground A(0, 0), D(dx, dy);
        guide rail through (kx, ky) along slope;

        crank AB(A) -> B              { length: crank_length, angle: theta }
        rrr   BC(B), DC(D) -> C       { lengths: (coupler, rocker), mode: left }
        point E on DC at (ex, ey);
        rrp   EF(E), ram(rail) -> F   { length: rod, offset: e, mode: ahead }

        output C, E, EF, ram.slide;
    }
}

mechanism! {
    /// A second four-bar on the rocker of a first, its bars almost stretched.
    pub struct ChainedBars {
        input theta: angle;
        param l1 = 1m;
        param l2 = 1m;
        param dx = 2.2m;
        param dy = -0.3m;
        param gx = 4.1m;
        param gy = 0.7m;
        param crank_length = 0.6m;
        param coupler = 1.9m;
        param rocker = 1.4m;

        ground A(0, 0), D(dx, dy), G(gx, gy);

        crank AB(A) -> B        { length: crank_length, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (coupler, rocker), mode: left }
        rrr   CE(C), GE(G) -> E { lengths: (l1, l2), mode: right }

        output C, CE, GE;
    }
}

mechanism! {
    /// Two bars between two driven points, with products carried to twice the width.
    pub struct CompensatedRrr {
        numerics compensated;

        input bx, by, dx, dy: length;
        param l1 = 1m;
        param l2 = 1m;
        param elbow: mode = left;

        point B at (bx, by);
        point D at (dx, dy);
        rrr BC(B), DC(D) -> C { lengths: (l1, l2), mode: elbow }

        output C, BC, DC;
    }
}

mechanism! {
    /// A bar between a driven point and a guide along x, with products carried to twice the width.
    pub struct CompensatedRrp {
        numerics compensated;

        input bx, by: length;
        param l = 1m;
        param e = 0m;

        guide rail through (0, 0) along 0deg;
        point B at (bx, by);
        rrp BC(B), block(rail) -> C { length: l, offset: e, mode: ahead }

        output C, BC, block.slide;
    }
}

mechanism! {
    /// The same without.
    pub struct LevelRrp {
        input bx, by: length;
        param l = 1m;
        param e = 0m;

        guide rail through (0, 0) along 0deg;
        point B at (bx, by);
        rrp BC(B), block(rail) -> C { length: l, offset: e, mode: ahead }

        output C, BC, block.slide;
    }
}
