//! The mechanism that C calls. Both the library and its build script, which writes the header, hold it.

use linkage_core::mechanism;

mechanism! {
    /// Strip-mill flying shear: a crank-rocker whose coupler carries the upper blade.
    pub struct FlyingShear {
        input theta: angle;

        /// Centre distance of the coupler's pins.
        param coupler = 632mm;
        param elbow: mode = right;

        ground A(0, 0), D(665.7mm, 0);

        crank AB(A) -> B        { length: 80mm, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (coupler, 374mm), mode: elbow }

        /// Cutting edge of the upper blade.
        point blade on BC at (500mm, -60mm);

        output blade, DC;

        export c;
    }
}
