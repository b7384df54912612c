//! One group each between joints and guides that the inputs put anywhere, so that any pose,
//! velocity and acceleration of the group can be asked for.

use linkage_core::mechanism;

mechanism! {
    /// Two bars between two driven points.
    pub struct DrivenRrr {
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
    /// A bar between a driven point and a guide on a driven body.
    pub struct DrivenRrp {
        input bx, by, kx, ky: length;
        input phi: angle;
        param l = 1m;
        param e = 0m;
        param side: mode = ahead;

        point B at (bx, by);
        point K at (kx, ky);
        crank frame(K) { angle: phi }
        guide rail on frame through (0, 0) along 0deg;

        rrp BC(B), block(rail) -> C { length: l, offset: e, mode: side }

        output C, BC, block;
    }
}

mechanism! {
    /// A bar about a driven point, sliding through a block on another.
    pub struct DrivenRpr {
        input bx, by, dx, dy: length;
        param e = 0m;
        param side: mode = ahead;

        point B at (bx, by);
        point D at (dx, dy);

        rpr block(B), bar(D) { offset: e, mode: side }

        output bar, block.slide;
    }
}

mechanism! {
    /// A pin between guides on two driven bodies.
    pub struct DrivenPrp {
        input kx, ky: length;
        input phi: angle;
        input jx, jy: length;
        input psi: angle;
        param e1 = 0m;
        param e2 = 0m;

        point K at (kx, ky);
        point J at (jx, jy);
        crank one(K) { angle: phi }
        crank two(J) { angle: psi }
        guide rail on one through (0, 0) along 0deg;
        guide way on two through (0, 0) along 0deg;

        prp p(rail), q(way) -> C { offsets: (e1, e2) }

        output C, p.slide, q.slide;
    }
}

mechanism! {
    /// A yoke on a driven body's guide, its slot on a driven point.
    pub struct DrivenRpp {
        input bx, by, kx, ky: length;
        input phi: angle;
        param slot = 90deg;
        param e1 = 0m;
        param e2 = 0m;

        point B at (bx, by);
        point K at (kx, ky);
        crank frame(K) { angle: phi }
        guide rail on frame through (0, 0) along 0deg;

        rpp block(B), yoke(rail) { slot: slot, offsets: (e1, e2) }

        output yoke.slide, block;
    }
}
