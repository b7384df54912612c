//! The program of README that writes a page.

use linkage_core::mechanism;
mechanism! {
    struct Shear {
        input theta: angle;
        param crank = 80mm;
        ground A(0, 0), D(665.7mm, 0);
        pin  B(crank, 0), C(600mm, 360mm), blade(570mm, 90mm);
        link AB(A, B), BC(B, C, blade), DC(D, C);
        drive AB.angle = theta;
    }
}
fn main() -> Result<(), linkage_core::sketch::SketchError> {
    Shear::new().page().write_html("shear.html")
}
