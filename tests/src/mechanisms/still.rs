//! Mechanisms with joints that rub and do not turn, or are just starting.

use linkage_core::mechanism;

mechanism! {
    /// A parallelogram whose coupler stays parallel to the ground; the pin P turns between it and a block in the slot of a
    /// yoke, and neither turns.
    pub struct RubbingParallelogram {
        input theta: angle;
        param mu = 0.2;
        param ground_length = 0.4m;
        load push: force;
        ground A(0.1m, 0.2m), D(0.1m + ground_length, 0.2m);
        guide rail through (0, -0.3m) along 0deg;
        crank AB(A) -> B { length: 0.15m, angle: theta }
        rrr BC(B), DC(D) -> C { lengths: (0.4m, 0.15m), mode: left }
        point P on BC at (0.2m, -0.05m);
        rpp block(P), yoke(rail) { slot: 90deg, offsets: (0, 0) }
        mass 5kg on yoke at (0, 0) inertia 0.01(kg*m^2);
        mass 1kg on BC at (0.2m, 0) inertia 0.01(kg*m^2);
        force (-push, 0) on P;
        friction mu on block at P radius 30mm;
        output theta.drive, BC.B, DC.D, block.P, block.P.friction, losses;
    }
}

mechanism! {
    /// Two parallelograms one on the other, the second by an input of its own, on a slope that constants round.
    pub struct RubbingLamp {
        input lower: angle;
        input upper: angle;
        param mu = 0.2;
        ground A(0.3m, 0.7m), D(0.3m + 0.4m * cos(20deg), 0.7m + 0.4m * sin(20deg));
        guide wall through (1m, 0) along 75deg;
        crank AB(A) -> B { length: 0.5m, angle: lower }
        rrr BC(B), DC(D) -> C { lengths: (0.4m, 0.5m), mode: left }
        crank BE(B) -> E { length: 0.3m, angle: upper }
        rrr EF(E), CF(C) -> F { lengths: (0.4m, 0.3m), mode: left }
        point P on EF at (0.2m, 0.1m);
        rpp block(P), yoke(wall) { slot: 90deg }
        gravity (0, -9.81);
        mass 2kg on EF at (0.2m, 0.1m) inertia 0.02(kg*m^2);
        mass 5kg on yoke at (0, 0) inertia 0.01(kg*m^2);
        friction mu on block at P radius 30mm;
        output lower.drive, upper.drive, block.P, block.P.friction, losses;
    }
}

mechanism! {
    /// A truss on a crank, two triangles and a rod with a shoe deep: all of it moves with BK.
    pub struct RubbingTruss {
        input theta: angle;
        param mu = 0.2;
        ground A(0, 0), D(0.9m, 0);
        crank AB(A) -> B { length: 0.3m, angle: theta }
        rrr BK(B), DK(D) -> K { lengths: (0.8m, 0.5m), mode: left }
        point E on BK at (0.5m, 0.1m);
        rrr p(B), q(E) -> C { lengths: (0.31m, 0.27m), mode: left }
        point F on p at (0.2m, 0.15m);
        point G on BK at (0.6m, -0.1m);
        rrr r(F), s(G) -> H { lengths: (0.4m, 0.45m), mode: right }
        guide way on s through (0, 0.1m) along 10deg;
        rrp rod(C), shoe(way) -> S { length: 0.9m, mode: ahead }
        gravity (0, -9.81);
        mass 2kg on p at (0.2m, 0.05m) inertia 0.01(kg*m^2);
        mass 5kg on r at (0.15m, 0.02m) inertia 0.01(kg*m^2);
        mass 2kg on s at (0.15m, 0.02m) inertia 0.01(kg*m^2);
        mass 1kg on rod uniform;
        friction mu on r at F radius 20mm;
        friction mu at H radius 20mm;
        friction mu on shoe;
        output theta.drive, r.H, r.H.friction, r.F.friction, shoe.way, shoe.way.friction, losses;
    }
}

mechanism! {
    /// A block whose sign is smooth.
    pub struct SmoothBlock {
        input x: length;
        guide bed through (0, 0) along 0deg;
        slider block(bed) -> P { slide: x }
        gravity (0, -9.81(m/s^2));
        mass 3kg on block at (0, 0) inertia 0.1(kg*m^2);
        friction 0.1 on block smooth 0.01(m/s);
        output x.drive, block.bed.friction, losses;
    }
}

mechanism! {
    /// A four-bar whose pins rub between links that move.
    pub struct RubbingPins {
        input theta: angle;
        ground A(0, 0), D(0.7m, 0);
        crank AB(A) -> B { length: 200mm, angle: theta }
        rrr BC(B), DC(D) -> C { lengths: (700mm, 400mm), mode: left }
        mass 2kg on BC at (0.35m, 0);
        torque -20(N*m) on DC;
        friction 0.1 at B radius 20mm;
        friction 0.1 at C radius 20mm;
        output theta.drive, losses;
    }
}
