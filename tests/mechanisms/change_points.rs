//! Four-bars whose longest and shortest bar are together as long as the other two: they pass
//! through poses in which all bars lie on one line.

use linkage_core::mechanism;

mechanism! {
    /// Bars equal in pairs: a parallelogram or, after a change of mode, an antiparallelogram.
    pub(crate) struct Parallelogram {
        input theta: angle;
        param elbow: mode = left;

        ground A(0, 0), D(2m, 0);
        crank AB(A) -> B        { length: 1m, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (2m, 1m), mode: elbow }

        output C, BC, DC;
    }
}

mechanism! {
    /// Bars 4, 1, 2 and 3: one change point a turn, two turns a period.
    pub(crate) struct FourOneTwoThree {
        input theta: angle;
        param elbow: mode = left;

        ground A(0, 0), D(4m, 0);
        crank AB(A) -> B        { length: 1m, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (2m, 3m), mode: elbow }

        output C, BC, DC;
    }
}
