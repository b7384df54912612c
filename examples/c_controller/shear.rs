//! The mechanism of the controller beside this file: `linkage export c shear.rs -o solver --only motion,f32` has printed
//! it.

use linkage_core::mechanism;

mechanism! {
    /// A strip-mill flying shear: a crank-rocker whose coupler carries the upper blade.
    pub struct FlyingShear {
        input theta: angle;
        ground A(0, 0), D(665.7mm, 0);
        crank AB(A) -> B        { length: 80mm, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (632mm, 374mm), mode: right }
        point blade on BC at (500mm, -60mm);
        output blade;
    }
}
