//! Mechanisms with a property that holds exactly: a straight line, an ellipse, a closed formula.

use linkage_core::mechanism;

mechanism! {
    /// Peaucellier and Lipkin's inversor: P runs on x = 4.875 m. The crank's circle goes through
    /// O, and |OQ|·|OP| = 4² − 2.5².
    pub struct Peaucellier {
        input theta: angle;

        ground O(0, 0), M(1m, 0);

        crank MQ(M) -> Q          { length: 1m, angle: theta }
        rrr   QU(Q), OU(O) -> U   { lengths: (2.5m, 4m), mode: left }
        rrr   QL(Q), OL(O) -> L   { lengths: (2.5m, 4m), mode: right }
        rrr   UP(U), LP(L) -> P   { lengths: (2.5m, 2.5m), mode: right }

        output P;
    }
}

mechanism! {
    /// Scott Russell's isosceles slider-crank: P runs on x = 0.
    pub struct ScottRussell {
        input theta: angle;

        ground A(0, 0);
        guide rail through A along 0deg;

        crank AB(A) -> B              { length: 1.5m, angle: theta }
        rrp   BC(B), block(rail) -> C { length: 1.5m, mode: ahead }
        point P on BC at (-1.5m, 0);

        output P, block.slide;
    }
}

mechanism! {
    /// The trammel of Archimedes: P draws an ellipse with half axes 3 m and 2 m.
    pub struct Trammel {
        input x: length;

        guide across through (0, 0) along 0deg;
        guide up through (0, 0) along 90deg;

        slider shoe(across) -> B      { slide: x }
        rrp    BC(B), block(up) -> C  { length: 5m, mode: ahead }
        point P on BC at (2m, 0);
        point middle on BC at (2.5m, 0);

        output P, middle, block.slide;
    }
}

mechanism! {
    /// A crank-rocker 1, 3, 2.5, 4 for Freudenstein's equation.
    pub struct Freudenstein {
        input theta: angle;

        ground A(0, 0), D(4m, 0);

        crank AB(A) -> B        { length: 1m, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (3m, 2.5m), mode: left }

        output DC;
    }
}

mechanism! {
    /// Crank 1, coupler 2, rocker 1, ground 2: parallelogram or antiparallelogram by the mode.
    pub struct ChangePoint {
        input theta: angle;
        param elbow: mode = left;

        ground A(0, 0), D(2m, 0);

        crank AB(A) -> B        { length: 1m, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (2m, 1m), mode: elbow }

        output BC, DC;
    }
}

mechanism! {
    /// A parallelogram that turns fully: the second crank follows the first.
    pub struct Parallelogram {
        input theta: angle;

        ground A(0, 0), D(2m, 0);

        crank AB(A) -> B { length: 1m, angle: theta }
        crank DC(D) -> C { length: 1m, relative_to: AB, angle: 0 }

        output B, C, AB, DC;
    }
}

mechanism! {
    /// Roberts and Chebyshev: the coupler point of a four-bar, drawn by its cognate too.
    pub struct Cognates {
        input theta: angle;
        param elbow: mode = left;
        let stretch = hypot(1.9, 1.3) / 3.2;
        let lean = atan2(1.3, 1.9);

        ground A(0, 0), D(4m, 0), E(2.375m, 1.625m);

        crank AB(A) -> B          { length: 1m, angle: theta }
        rrr   BC(B), DC(D) -> C   { lengths: (3.2m, 2.6m), mode: left }
        point P on BC at (1.9m, 1.3m);

        crank AF(A) -> F          { length: 3.2m * stretch, relative_to: BC, angle: lean }
        rrr   FG(F), EG(E) -> G   { lengths: (1m * stretch, 2.6m * stretch), mode: elbow }
        point Q on FG at polar (1m, -lean);

        output P, Q;
    }
}

mechanism! {
    /// A Scotch yoke with an upright slot, and one with an oblique slot on the same crank.
    pub struct ScotchYokes {
        input theta: angle;

        ground A(0, 0);
        guide rail through A along 0deg;

        crank AB(A) -> B             { length: 0.8m, angle: theta }
        rpp   die(B), yoke(rail)     { slot: 90deg }
        rpp   shoe(B), wedge(rail)   { slot: 1.1rad }

        output yoke.slide, die.slide, wedge.slide, shoe.slide;
    }
}

mechanism! {
    /// A crank of 1 m and a bar that turns `depth` below its pivot: the bar swings where that is
    /// more than the crank's length, and turns (Whitworth) where it is less.
    pub struct Whitworth {
        input theta: angle;
        param depth = 2m;

        ground A(0, 0), D(0, -depth);

        crank AB(A) -> B       { length: 1m, angle: theta }
        rpr   block(B), bar(D) { mode: ahead }

        output bar, block.slide;
    }
}
