//! Mechanisms that can be assembled over a part of their input only.

use linkage_core::mechanism;

mechanism! {
    /// Any four-bar.
    pub struct FourBar {
        input theta: angle;
        param crank = 1m;
        param coupler = 3m;
        param rocker = 2.5m;
        param base = 3.5m;
        param elbow: mode = left;
        ground A(0, 0), D(base, 0);
        crank AB(A) -> B        { length: crank, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (coupler, rocker), mode: elbow }
        output C, DC;
    }
}

mechanism! {
    /// A four-bar whose rocker pulls a second one, and that a ram.
    pub struct Chain {
        input theta: angle;
        param crank = 1m;
        param coupler = 3m;
        param rocker = 2.5m;
        param base = 3.5m;
        param link = 2m;
        param lever = 1.5m;
        param post = 5m;
        param rod = 2m;
        param elbow: mode = left;
        param knee: mode = left;
        ground A(0, 0), D(base, 0), G(post, 1m);
        guide rail through (0, 3m) along 0deg;
        crank AB(A) -> B          { length: crank, angle: theta }
        rrr   BC(B), DC(D) -> C   { lengths: (coupler, rocker), mode: elbow }
        rrr   CF(C), GF(G) -> F   { lengths: (link, lever), mode: knee }
        rrp   FH(F), ram(rail) -> H { length: rod, mode: ahead }
        output ram.slide;
    }
}

mechanism! {
    /// A boom on a hydraulic cylinder.
    pub struct Boom {
        input lift: length;
        ground D(0, 0), A(0.5m, 2m);
        rrr cyl(D), boom(A) -> C { lengths: (lift, 1.5m), mode: right }
        output boom;
    }
}

mechanism! {
    /// A bar on a crank as long as the input says, and a block with an offset that its pin must
    /// not come nearer to the pivot than.
    pub struct Telescope {
        input s: length;
        ground A(0, 0), D(1m, 0);
        crank AB(A) -> B        { length: s, angle: 0 }
        rpr   block(B), bar(D)  { offset: 0.25m }
        output bar;
    }
}

mechanism! {
    /// A crank geared up eight times, whose coupler is too short for a whole turn of it.
    pub struct Geared {
        input theta: angle;
        param coupler = 2.2m;
        ground A(0, 0), D(3m, 0);
        crank AB(A) -> B        { length: 1m, angle: 8 * theta }
        rrr   BC(B), DC(D) -> C { lengths: (coupler, 1.5m), mode: left }
        output DC;
    }
}

mechanism! {
    /// Guides only.
    pub struct Guides {
        input theta: angle;
        ground A(0, 0);
        guide rail through (1m, 0) along 90deg;
        crank AB(A)                { angle: theta }
        guide arm on AB through (0, 0) along 0deg;
        prp p(rail), q(arm) -> C   { }
        output C;
    }
}
