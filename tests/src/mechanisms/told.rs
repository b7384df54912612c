//! Mechanisms of which some inputs are told and the others follow, and one that rubs by signs of both kinds.

use linkage_core::mechanism;

mechanism! {
    /// A load on a rope of 3 m under a trolley.
    pub struct Trolley {
        input x: length;
        input sway: angle;
        guide rail through (0, 0) along 0deg;
        slider trolley(rail) -> T { slide: x }
        crank rope(T) -> L { length: 3m, angle: sway - 90deg }
        gravity (0, -9.81(m/s^2));
        mass 200kg on T;
        mass 80kg on L;
        output x.drive, sway.drive;
    }
}

mechanism! {
    /// A chain of five bars, each turned against the one before, its hand loaded.
    pub struct Chain {
        input a, b, c, d, e: angle;
        param tip = 0.5kg;
        load hand: force;
        ground O(0, 0);
        crank A(O) -> P { length: 0.5m, angle: a }
        crank B(P) -> Q { length: 0.4m, angle: b, relative_to: A }
        crank C(Q) -> R { length: 0.3m, angle: c, relative_to: B }
        crank D(R) -> S { length: 0.3m, angle: d, relative_to: C }
        crank E(S) -> T { length: 0.2m, angle: e, relative_to: D }
        gravity (0, -9.81(m/s^2));
        mass 3kg on A uniform;
        mass 2kg on B uniform;
        mass 1.5kg on C uniform;
        mass 1kg on D uniform;
        mass tip on E at (0.1m, 20mm) inertia 0.02(kg*m^2);
        force (hand, -hand / 2) on T;
        torque -0.5(N*m*s) * rate(C.angle) on C;
        output a.drive, b.drive, c.drive, d.drive, e.drive;
    }
}

mechanism! {
    /// Two bars with one mass at the end: stretched, they move it alike.
    pub struct TwoBars {
        input first, second: angle;
        ground O(0, 0);
        crank K(O) -> P { length: 1m, angle: first }
        crank L(P) -> Q { length: 1m, angle: second, relative_to: K }
        mass 2kg on Q;
        output first.drive, second.drive;
    }
}

mechanism! {
    /// A slider-crank whose pin on the ground has a smooth sign, and its block a dry one.
    pub struct HalfSmooth {
        input q: angle;
        param pin = 0.1;
        ground A(0, 0);
        guide bed through A along 0deg;
        crank AB(A) -> B { length: 0.1m, angle: q }
        rrp BC(B), block(bed) -> C { length: 0.3m, mode: ahead }
        gravity (0, -9.81(m/s^2));
        mass 2kg on block at (0, 0) inertia 0.01(kg*m^2);
        inertia 0.02(kg*m^2) on AB;
        friction pin at A radius 20mm smooth 0.1(rad/s);
        friction 0.25 on block;
    }
}
