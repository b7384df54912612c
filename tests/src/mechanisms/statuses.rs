//! Mechanisms whose answers are compared by what they say of themselves.

use linkage_core::mechanism;

mechanism! {
    /// A pin between a guide that turns and one that stands: its rates go through exact products.
    pub struct TurningGuide {
        input theta: angle;

        ground A(0, 0);
        crank arm(A) { angle: theta }
        guide spoke on arm through (0, 0) along 0deg;
        guide wall through (1m, 0) along 80deg;
        prp p(spoke), q(wall) -> C {}

        output q.slide;
    }
}

mechanism! {
    /// A rod behind a four-bar, both watched.
    pub struct WatchedChain {
        input theta: angle;
        param coupler = 1.9m;

        ground A(0, 0), D(2.2m, 0);
        guide rail through (0, 0.4m) along 0deg;
        crank AB(A) -> B            { length: 0.6m, angle: theta }
        rrr   BC(B), DC(D) -> C     { lengths: (coupler, 1.4m), mode: left }
        rrp   CE(C), ram(rail) -> E { length: 1.2m, mode: ahead }

        output DC.margin, CE.margin;
    }
}

mechanism! {
    /// The same with the four-bar alone watched.
    pub struct WatchedFront {
        input theta: angle;
        param coupler = 1.9m;

        ground A(0, 0), D(2.2m, 0);
        guide rail through (0, 0.4m) along 0deg;
        crank AB(A) -> B            { length: 0.6m, angle: theta }
        rrr   BC(B), DC(D) -> C     { lengths: (coupler, 1.4m), mode: left }
        rrp   CE(C), ram(rail) -> E { length: 1.2m, mode: ahead }

        output DC.margin, E;
    }
}

mechanism! {
    /// A table on two slides: its coefficients are the same everywhere.
    pub struct Table {
        input x, y: length;

        point P at (2 * x, 3 * y);

        output P;
    }
}

mechanism! {
    /// A rod that turns and grows.
    pub struct Spiral {
        input theta: angle;
        input s: length;

        ground A(0, 0);
        crank AB(A) -> B { length: 0.5m + s, angle: theta }

        output B;
    }
}

mechanism! {
    /// A point that a slide carries through the origin, and how far it is from there.
    pub struct Passing {
        input x: length;

        ground A(0, 0);
        point P at (x, 0);

        output P, reach = distance(A, P);
    }
}

mechanism! {
    /// A dyad between a driven point and the ground, and one behind it, with bars that are given.
    pub struct TwoDyads {
        input x, y: length;
        param l1 = 2m;
        param l2 = 2.5m;
        param l3 = 1m;

        ground D(4m, 0), F(3m, 3m);
        point B at (x, y);
        rrr BC(B), DC(D) -> C { lengths: (l1, l2), mode: left }
        rrr CE(C), FE(F) -> E { lengths: (l3, 2m), mode: left }

        output C, E, reach = distance(B, E);
    }
}
