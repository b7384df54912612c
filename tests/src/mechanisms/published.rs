//! Mechanisms from published course work, with the dimensions printed there.

use linkage_core::mechanism;

mechanism! {
    /// A four-bar whose table every 5° is published.
    pub struct FourBar {
        input theta: angle;

        ground A(0, 0), D(304.8mm, 0);

        crank AB(A) -> B        { length: 101.6mm, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (254mm, 177.8mm), mode: left }

        output BC, DC;
    }
}

mechanism! {
    /// A crank whose pin slides in the upright slot of a yoke on a rail below.
    pub struct CrankRpp {
        input theta: angle;

        ground A(0, 0);
        guide rail through (0, -800mm) along 0deg;

        crank AB(A) -> B             { length: 400mm, angle: theta }
        rpp   block(B), yoke(rail)   { slot: 90deg }

        output B, block.slide, yoke.slide;
    }
}

mechanism! {
    /// A crank that swings a rod, whose end moves a ram along a rail above.
    pub struct SixBar {
        input theta: angle;

        ground A(0, 0), D(0, -1m);
        guide rail through (0, 0.8m) along 0deg;

        crank AB(A) -> B          { length: 0.4m, angle: theta }
        rpr   block(B), rod(D)    { offset: 0 }
        point E on rod at (1.6m, 0);
        rpp   pin(E), ram(rail)   { slot: 90deg }

        output E, rod, block.slide, ram.slide, pin.slide;
    }
}

mechanism! {
    /// A strip-mill flying shear: a crank-rocker whose coupler carries the upper blade.
    pub struct FlyingShear {
        input theta: angle;

        ground A(0, 0), D(665.7mm, 0);

        crank AB(A) -> B        { length: 80mm, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (632mm, 374mm), mode: right }
        point blade on BC at (500mm, -60mm);

        output B, C, blade, BC, DC;
    }
}

mechanism! {
    /// A crank-rocker whose rocker is to follow a parabola; lengths in crank lengths.
    pub struct FunctionGenerator {
        input theta: angle;
        param coupler = 4.128654m;
        param rocker = 2.322462m;

        ground A(0, 0), D(5m, 0);

        crank AB(A) -> B        { length: 1m, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (coupler, rocker), mode: left }

        output DC, fold = BC.angle - DC.angle;
    }
}
