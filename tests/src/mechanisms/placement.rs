//! Mechanisms whose parameters put them anywhere, at any size, and guides along the axes.

use linkage_core::mechanism;

mechanism! {
    /// Two stacked sliders that put a point at (x, y).
    pub struct StackedSliders {
        input x, y: length;

        guide bed through (0, 0) along 0deg;
        slider saddle(bed) { slide: x }
        guide column on saddle through (0, 0) along 90deg;
        slider quill(column) -> Q { slide: y }

        output Q, quill.angle;
    }
}

mechanism! {
    /// The same against the axes' directions, three quarters of a turn further.
    pub struct TurnedSliders {
        input x, y: length;

        guide bed through (0, 0) along 180deg;
        slider saddle(bed) { slide: x }
        guide column on saddle through (0, 0) along 90deg;
        slider quill(column) -> Q { slide: y }

        output Q, quill.angle;
    }
}

mechanism! {
    /// A crank-rocker with a coupler point, of any size.
    pub struct AnySize {
        input theta: angle;
        param size = 1m;

        ground A(0, 0), D(3 * size, size / 4);

        crank AB(A) -> B        { length: size, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (2.5 * size, 2 * size), mode: left }
        point P on BC at (1.25 * size, 0.5 * size);

        output P, BC, DC;
    }
}

mechanism! {
    /// A slider-crank, a swinging bar and a yoke on one crank, of any size.
    pub struct AnySizeGuides {
        input theta: angle;
        param size = 1m;

        ground A(0, 0), D(-size / 2, -2 * size);
        guide rail through (0, size / 8) along 15deg;
        guide way through (size, -size) along 30deg;

        crank AB(A) -> B              { length: size, angle: theta }
        rrp   BC(B), block(rail) -> C { length: 3 * size, offset: size / 4, mode: ahead }
        rpr   sleeve(B), bar(D)       { offset: size / 8, mode: ahead }
        rpp   shoe(B), yoke(way)      { slot: 75deg, offsets: (size / 16, -size / 8) }
        guide arm on bar through D along 10deg;
        prp   p(arm), q(rail) -> E    { offsets: (size / 4, size / 2) }

        output C, BC, bar, E, block.slide, sleeve.slide, shoe.slide, yoke.slide, p.slide, q.slide;
    }
}

mechanism! {
    /// A crank-rocker far from the origin.
    pub struct FarAway {
        input theta: angle;
        param east = 0m;
        param north = 0m;

        ground A(east, north), D(3m + east, 0.25m + north);

        crank AB(A) -> B        { length: 1m, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (2.5m, 2m), mode: left }

        output C, BC, DC;
    }
}
