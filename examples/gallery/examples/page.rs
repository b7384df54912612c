//! The program of README that writes a page.

use linkage_core::mechanism;

mechanism! {
    /// A flying shear: a crank-rocker whose coupler carries the blade.
    struct Shear {
        input theta: angle;
        param crank = 80mm;
        param coupler = 632mm;
        param elbow: mode = right;
        ground A(0, 0), D(665.7mm, 0);
        crank AB(A) -> B        { length: crank, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (coupler, 374mm), mode: elbow }
        point blade on BC at (500mm, -60mm);
    }
}

fn main() -> Result<(), linkage_core::sketch::SketchError> {
    Shear::new().page().write_html("shear.html")
}
