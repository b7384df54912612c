//! Slides whose pins and limits are known without rounding.

use linkage_core::mechanism;

mechanism! {
    /// Two guides along the axes, the first through (0, y), the second through (x, far away).
    pub struct CrossedAxes {
        input s: length;
        param x = 0.7m;
        param y = 0.3m;
        param away = 3000.7m;

        guide level through (0, y) along 0deg;
        guide post through (x, away) along 90deg;
        guide rail through (0, 0) along 0deg;
        slider ram(rail) { slide: s }
        prp p(level), q(post) -> C {}

        output C, ram.slide;
    }
}

mechanism! {
    /// The same the other way round: the first guide through (x, 0), the second through (far, y).
    pub struct AxesCrossed {
        input s: length;
        param x = 0.7m;
        param y = 0.3m;
        param away = 3000.7m;

        guide level through (away, y) along 0deg;
        guide post through (x, 0) along 90deg;
        guide rail through (0, 0) along 0deg;
        slider ram(rail) { slide: s }
        prp p(post), q(level) -> C {}

        output C, ram.slide;
    }
}

mechanism! {
    /// A slope, and behind it an upright guide.
    pub struct RampAndPost {
        input s: length;
        param x = 0.7m;
        param away = 3000.7m;

        guide ramp through (0, 0) along 30deg;
        guide post through (x, away) along 90deg;
        guide rail through (0, 0) along 0deg;
        slider ram(rail) { slide: s }
        prp p(ramp), q(post) -> C {}

        output C, ram.slide;
    }
}

mechanism! {
    /// A slope, and behind it a level guide.
    pub struct RampAndLevel {
        input s: length;
        param y = 0.3m;
        param away = 3000.7m;

        guide ramp through (0, 0) along 30deg;
        guide level through (away, y) along 0deg;
        guide rail through (0, 0) along 0deg;
        slider ram(rail) { slide: s }
        prp p(ramp), q(level) -> C {}

        output C, ram.slide;
    }
}

mechanism! {
    /// A guide on a body that turns about a pivot a kilometre away, and one on the ground.
    pub struct FarPivot {
        input theta: angle;

        ground A(1000m, 0);
        guide rail through (0.2, 0.1) along 20deg;
        crank arm(A) { angle: theta }
        guide spoke on arm through (0, 0) along 0deg;
        prp p(spoke), q(rail) -> C {}

        output C;
    }
}

mechanism! {
    /// A bar and an offset that are sums, on a guide along x.
    pub struct SummedRrp {
        numerics compensated;

        input bx, by: length;
        param l1 = 1m;
        param l2 = 0.2m;
        param e1 = 0.1m;
        param e2 = 0.05m;

        guide rail through (0, 0) along 0deg;
        point B at (bx, by);
        rrp BC(B), block(rail) -> C { length: l1 + l2, offset: e1 + e2, mode: ahead }

        output C, BC, block.slide;
    }
}
