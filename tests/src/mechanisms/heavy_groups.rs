//! The groups of `driven_groups` with masses and forces, for their reactions. What is not measured
//! about is a power of two's multiple, so that both widths hold it.

use linkage_core::mechanism;

mechanism! {
    /// See `DrivenRrr`.
    pub struct HeavyRrr {
        input bx, by, dx, dy: length;
        param l1 = 1m;
        param l2 = 1m;
        param elbow: mode = left;

        point B at (bx, by);
        point D at (dx, dy);

        rrr BC(B), DC(D) -> C { lengths: (l1, l2), mode: elbow }

        gravity (0, -9.75);
        mass 1.5kg on BC at (0.25m, 0.125m) inertia 0.25(kg*m^2);
        mass 0.75kg on DC at (0.5m, -0.125m) inertia 0.125(kg*m^2);
        mass 0.25kg on C;
        force (3N, -2N) on C;

        output BC.B, BC.C, DC.C, DC.D;
    }
}

mechanism! {
    /// See `DrivenRrp`.
    pub struct HeavyRrp {
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

        gravity (0, -9.75);
        mass 1.5kg on BC at (0.25m, 0.125m) inertia 0.25(kg*m^2);
        mass 0.75kg on block at (0.125m, -0.25m) inertia 0.125(kg*m^2);
        force (3N, -2N) on C;

        output BC.B, BC.C, block.rail;
    }
}

mechanism! {
    /// See `DrivenRpr`.
    pub struct HeavyRpr {
        input bx, by, dx, dy: length;
        param e = 0m;
        param side: mode = ahead;

        point B at (bx, by);
        point D at (dx, dy);

        rpr block(B), bar(D) { offset: e, mode: side }

        gravity (0, -9.75);
        mass 1.5kg on block at (0.25m, 0.125m) inertia 0.25(kg*m^2);
        mass 0.75kg on bar at (0.5m, -0.125m) inertia 0.125(kg*m^2);
        torque 2(N*m) on bar;

        output block.B, block.bar, bar.D;
    }
}

mechanism! {
    /// See `DrivenPrp`.
    pub struct HeavyPrp {
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

        gravity (0, -9.75);
        mass 1.5kg on p at (0.25m, 0.125m) inertia 0.25(kg*m^2);
        mass 0.75kg on q at (0.5m, -0.125m) inertia 0.125(kg*m^2);
        force (3N, -2N) on C;

        output p.C, p.rail, q.C, q.way;
    }
}

mechanism! {
    /// See `DrivenRpp`.
    pub struct HeavyRpp {
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

        gravity (0, -9.75);
        mass 1.5kg on block at (0.25m, 0.125m) inertia 0.25(kg*m^2);
        mass 0.75kg on yoke at (0.5m, -0.125m) inertia 0.125(kg*m^2);
        torque 2(N*m) on yoke;

        output block.B, block.yoke, yoke.rail;
    }
}
