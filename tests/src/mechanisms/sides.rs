//! One equation with its sides either way round.

use linkage_core::mechanism;

mechanism! {
    /// The distance from a crank's pin is the input: left less right is d − x.
    pub struct DistanceOnTheLeft {
        input x: length;
        unknown theta: angle between (-170deg, 170deg);
        ground A(0, 0), D(1m, 0);
        crank AB(A) -> B { length: 0.4m, angle: theta }
        solve theta { distance(B, D) = x, mode: rising }
        output theta;
    }
}

mechanism! {
    /// The same equation the other way round: x − d.
    pub struct DistanceOnTheRight {
        input x: length;
        unknown theta: angle between (-170deg, 170deg);
        ground A(0, 0), D(1m, 0);
        crank AB(A) -> B { length: 0.4m, angle: theta }
        solve theta { x = distance(B, D), mode: rising }
        output theta;
    }
}
