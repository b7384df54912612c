//! The mechanisms of the hard poses: where a pin is to have any place, velocity and acceleration,
//! it stands on two stacked sliders.

use linkage_core::mechanism;

mechanism! {
    /// Two bars, the first pinned to a stack of sliders, the second to the ground.
    pub struct StackedRrr {
        input x, y: length;
        param dx = 1m;
        param dy = 0m;
        param l2 = 1m;
        param l3 = 1m;
        param elbow: mode = left;

        ground D(dx, dy);
        guide bed through (0, 0) along 0deg;
        slider saddle(bed) -> A { slide: x }
        guide column on saddle through A along 90deg;
        slider quill(column) -> B { slide: y }

        rrr BC(B), DC(D) -> C { lengths: (l2, l3), mode: elbow }

        output C, BC, DC;
    }
}

mechanism! {
    /// A crank-rocker with dimensions that are fields.
    pub struct ParamFourBar {
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
    /// Crank and rocker of one length, coupler and ground of one length, all constants.
    pub struct Parallelogram {
        input theta: angle;
        param elbow: mode = left;

        ground A(0, 0), D(2m, 0);
        crank AB(A) -> B        { length: 1m, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (2m, 1m), mode: elbow }

        output C, BC, DC;
    }
}

mechanism! {
    /// Crank and ground of one length, coupler and rocker of one length, all constants.
    pub struct Kite {
        input theta: angle;

        ground A(0, 0), D(1m, 0);
        crank AB(A) -> B        { length: 1m, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (2m, 2m), mode: left }

        output C, BC, DC;
    }
}

mechanism! {
    /// A slider-crank with dimensions that are fields.
    pub struct ParamSliderCrank {
        input theta: angle;
        param r = 50mm;
        param l = 210mm;
        param e = 0m;

        ground A(0, 0);
        guide rail through (0, 0) along 0deg;
        crank AB(A) -> B              { length: r, angle: theta }
        rrp   BC(B), block(rail) -> C { length: l, offset: e, mode: ahead }

        output BC, block;
    }
}

mechanism! {
    /// Two guides of which one stands on a stack of sliders and one in the ground.
    pub struct StackedPrp {
        input x, y: length;
        param phi1 = 0deg;
        param phi2 = 90deg;
        param kx = 0m;
        param ky = 0m;

        guide bed through (0, 0) along 90deg;
        slider saddle(bed) { slide: y }
        guide beam on saddle through (0, 0) along -90deg;
        slider carriage(beam) { slide: x }
        guide rail on carriage through (0, 0) along phi1;
        guide way through (kx, ky) along phi2;

        prp p(rail), q(way) -> C {}

        output C, p.slide, q.slide;
    }
}

mechanism! {
    /// A yoke on a fixed rail, its block on a stack of sliders.
    pub struct StackedRpp {
        input x, y: length;
        param phi = 0deg;
        param beta = 90deg;

        guide bed through (0, 0) along 0deg;
        slider saddle(bed) -> A { slide: x }
        guide column on saddle through A along 90deg;
        slider quill(column) -> B { slide: y }
        guide rail through (0, 0) along phi;

        rpp block(B), yoke(rail) { slot: beta }

        output yoke.slide, block.slide;
    }
}

mechanism! {
    /// A bar about a fixed pivot, its block on a stack of sliders.
    pub struct StackedRpr {
        input x, y: length;
        param dx = 0m;
        param dy = 0m;
        param e = 0m;

        ground D(dx, dy);
        guide bed through (0, 0) along 0deg;
        slider saddle(bed) -> A { slide: x }
        guide column on saddle through A along 90deg;
        slider quill(column) -> B { slide: y }

        rpr block(B), bar(D) { offset: e, mode: ahead }

        output bar, block.slide;
    }
}

mechanism! {
    /// The same without an offset, which is another formula.
    pub struct StackedCentricRpr {
        input x, y: length;
        param dx = 0m;
        param dy = 0m;

        ground D(dx, dy);
        guide bed through (0, 0) along 0deg;
        slider saddle(bed) -> A { slide: x }
        guide column on saddle through A along 90deg;
        slider quill(column) -> B { slide: y }

        rpr block(B), bar(D) { mode: ahead }

        output bar, block.slide;
    }
}

mechanism! {
    /// A four-bar whose crank cannot turn fully.
    pub struct DoubleRocker {
        input theta: angle;

        ground A(0, 0), D(12.5m, 0);
        crank AB(A) -> B        { length: 2.5m, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (8.4m, 5m), mode: left }

        output C, DC.margin;
    }
}
