//! Machines with an unknown whose motion is followed.

use linkage_core::mechanism;

mechanism! {
    /// A ram that goes where its twin goes, which a crank drives: at the outer dead point both roots of
    /// the equation meet, and the crank goes on to the other.
    pub struct TwinPress {
        input turn: angle;
        param way: mode = falling;
        ground A(0, 0), O(0, 1m);
        guide bed through (0, 0) along 0deg;
        guide upper through (0, 1m) along 0deg;
        crank lead(O) -> L             { length: 80mm, angle: turn }
        rrp   rod(L), twin(upper) -> M { length: 250mm, mode: ahead }
        unknown theta: angle between (-100deg, 100deg);
        crank AB(A) -> B           { length: 80mm, angle: theta }
        rrp   BC(B), ram(bed) -> C { length: 250mm, mode: ahead }
        solve theta { ram.slide = twin.slide, mode: way }
        output theta, AB, C;
    }
}

mechanism! {
    /// The same with a constant mode.
    pub struct StiffTwinPress {
        input turn: angle;
        ground A(0, 0), O(0, 1m);
        guide bed through (0, 0) along 0deg;
        guide upper through (0, 1m) along 0deg;
        crank lead(O) -> L             { length: 80mm, angle: turn }
        rrp   rod(L), twin(upper) -> M { length: 250mm, mode: ahead }
        unknown theta: angle between (-100deg, 100deg);
        crank AB(A) -> B           { length: 80mm, angle: theta }
        rrp   BC(B), ram(bed) -> C { length: 250mm, mode: ahead }
        solve theta { ram.slide = twin.slide, mode: falling }
        output theta, AB, C;
    }
}

mechanism! {
    /// A parallelogram behind what is searched: its mode changes where the crank lies along the base.
    pub struct Lifted {
        input y: length;
        param elbow: mode = left;
        ground A(0, 0), D(2m, 0);
        unknown theta: angle between (-80deg, 80deg);
        crank AB(A) -> B        { length: 1m, angle: theta }
        point P on AB at (0.5m, 0);
        solve theta { P.y = y, mode: rising }
        rrr   BC(B), DC(D) -> C { lengths: (2m, 1m), mode: elbow }
        output theta, DC, C;
    }
}

mechanism! {
    /// The parallelogram's own rocker is where it is wanted.
    pub struct Inside {
        input psi: angle;
        param elbow: mode = left;
        ground A(0, 0), D(2m, 0);
        unknown theta: angle between (-80deg, 80deg);
        crank wanted(A)         { angle: psi }
        crank AB(A) -> B        { length: 1m, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (2m, 1m), mode: elbow }
        solve theta { DC.angle = wanted.angle, mode: rising }
        output theta, DC, C;
    }
}

mechanism! {
    /// The angle of a crank for a rocker's.
    pub struct ByRocker {
        input psi: angle;
        param from = 10deg;
        param to = 170deg;
        param crank = 80mm;
        param coupler = 632mm;
        param rocker = 374mm;
        param base = 665.7mm;
        unknown theta: angle between (from, to);
        ground A(0, 0), D(base, 0);
        crank pointer(D)        { angle: psi }
        crank AB(A) -> B        { length: crank, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (coupler, rocker), mode: right }
        solve theta { DC.angle = pointer.angle, mode: falling }
        output theta, C, DC.angle;
    }
}

mechanism! {
    /// An equation with two roots of each trend.
    pub struct Waves {
        input x: length;
        param way: mode = falling;
        ground A(0, 0);
        unknown theta: angle between (0, 235deg);
        crank AB(A) -> B { length: 1m, angle: theta }
        solve theta { sin(3 * theta) + theta / 8 = x / 1m, mode: way }
        output theta, B;
    }
}

mechanism! {
    /// Two cranks whose pins a rod joins: the equation's dead point moves with the input.
    pub struct Rodded {
        input psi: angle;
        ground A(0, 0), D(3m, 0);
        unknown theta: angle between (-40deg, 150deg);
        crank DE(D) -> E { length: 0.8m, angle: psi }
        crank AB(A) -> B { length: 1m, angle: theta }
        solve theta { distance(B, E) = 2.9m, mode: rising }
        output theta, B, E;
    }
}
