//! The clearance of every group, between joints and guides that the inputs put anywhere.

use linkage_core::mechanism;

mechanism! {
    /// Two bars between two driven points.
    pub struct MarginRrr {
        input bx, by, dx, dy: length;
        param l1 = 3m;
        param l2 = 2m;

        point B at (bx, by);
        point D at (dx, dy);
        rrr BC(B), DC(D) -> C { lengths: (l1, l2), mode: left }

        output BC, DC, DC.margin, DC.transmission;
    }
}

mechanism! {
    /// A bar between a driven point and a guide on a driven body.
    pub struct MarginRrp {
        input bx, by, turn: length;
        param l = 2m;
        param e = 0.3m;

        point B at (bx, by);
        point K on ground at (0.5m, -0.2m);
        crank frame(K) { angle: turn / 1m }
        guide rail on frame through (0, 0) along 0deg;
        rrp BC(B), block(rail) -> C { length: l, offset: e, mode: ahead }

        output BC, block, block.margin, block.transmission;
    }
}

mechanism! {
    /// A bar about a driven point, sliding through a block on another.
    pub struct MarginRpr {
        input bx, by, dx, dy: length;
        param e = 0.7m;

        point B at (bx, by);
        point D at (dx, dy);
        rpr block(B), bar(D) { offset: e, mode: ahead }

        output bar, block.slide, bar.margin, bar.transmission;
    }
}

mechanism! {
    /// The same without an offset.
    pub struct MarginCentricRpr {
        input bx, by: length;

        ground D(0.2m, 0.1m);
        point B at (bx, by);
        rpr block(B), bar(D) { mode: ahead }

        output bar, bar.margin, bar.transmission;
    }
}

mechanism! {
    /// A pin between a guide on a driven body and a fixed one.
    pub struct TransmissionPrp {
        input phi, psi: angle;

        ground K(0, 0), J(1m, 0.5m);
        crank one(K) { angle: phi }
        crank two(J) { angle: psi }
        guide rail on one through (0, 0) along 0deg;
        guide way on two through (0, 0) along 0deg;
        prp p(rail), q(way) -> C {}

        output C, q.transmission;
    }
}

mechanism! {
    /// A yoke on a fixed rail, its slot at an angle that is an input.
    pub struct TransmissionRpp {
        input slot: angle;

        ground B(1m, 0.5m);
        guide rail through (0, 0) along 20deg;
        rpp block(B), yoke(rail) { slot: slot }

        output yoke.slide, yoke.transmission;
    }
}

mechanism! {
    /// A crank-rocker with its margin, and one without.
    pub struct WatchedFourBar {
        input theta: angle;

        ground A(0, 0), D(3m, 0);
        crank AB(A) -> B        { length: 1m, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (2.5m, 2m), mode: left }

        output C, DC.margin, DC.transmission;
    }
}

mechanism! {
    /// The same without a margin.
    pub struct UnwatchedFourBar {
        input theta: angle;

        ground A(0, 0), D(3m, 0);
        crank AB(A) -> B        { length: 1m, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (2.5m, 2m), mode: left }

        output C;
    }
}

mechanism! {
    /// Three dyads behind a crank of any length: the second stands behind the first, the third does not.
    pub struct MarginChain {
        input theta: angle;
        param crank = 80mm;
        param coupler = 260mm;
        param lever = 140mm;

        ground A(0, 0), D(300mm, 0), G(150mm, 350mm), K(-200mm, 100mm);
        crank AB(A) -> B        { length: crank, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (coupler, 200mm), mode: left }
        point E on BC at (150mm, 110mm);
        rrr   EF(E), GF(G) -> F { lengths: (180mm, lever), mode: right }
        rrr   BL(B), KL(K) -> L { lengths: (240mm, 150mm), mode: left }

        output DC.margin, DC.transmission, GF.margin, GF.transmission, KL.margin;
    }
}

mechanism! {
    /// A dyad before a searched angle, one in its search and one behind it.
    pub struct MarginSearch {
        input x, y: length;
        param crank = 80mm;

        ground A(0, 0), G(100mm, 250mm), K(-300mm, 0);
        guide bed through (0, 0) along 0deg;
        point P at (y, 300mm);
        rrr   PL(P), KL(K) -> L    { lengths: (300mm, 250mm), mode: left }
        unknown theta: angle between (0, 180deg);
        crank AB(A) -> B           { length: crank, angle: theta }
        rrp   BC(B), ram(bed) -> C { length: 250mm, mode: ahead }
        solve theta { ram.slide = x, mode: falling }
        rrr   BF(B), GF(G) -> F    { lengths: (180mm, 120mm), mode: right }

        output KL.margin, ram.margin, GF.margin;
    }
}

mechanism! {
    /// The first dyad of that chain, and where the second begins.
    pub struct MarginAlone {
        input theta: angle;
        param crank = 80mm;
        param coupler = 260mm;
        param lever = 140mm;

        ground A(0, 0), D(300mm, 0);
        crank AB(A) -> B        { length: crank, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (coupler, 200mm), mode: left }
        point E on BC at (150mm, 110mm);

        output E, DC.margin, span = lever;
    }
}

mechanism! {
    /// The second dyad's margin alone.
    pub struct MarginBehind {
        input theta: angle;
        param crank = 80mm;
        param coupler = 260mm;
        param lever = 140mm;

        ground A(0, 0), D(300mm, 0), G(150mm, 350mm);
        crank AB(A) -> B        { length: crank, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (coupler, 200mm), mode: left }
        point E on BC at (150mm, 110mm);
        rrr   EF(E), GF(G) -> F { lengths: (180mm, lever), mode: right }

        output GF.margin;
    }
}
