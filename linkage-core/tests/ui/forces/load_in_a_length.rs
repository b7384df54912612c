use linkage_core::mechanism;

mechanism! {
    pub struct FourBar {
        input theta: angle;
        ground A(0, 0), D(750mm, 0);
        crank AB(A) -> B { length: 250mm, angle: theta }
        rrr BC(B), DC(D) -> C { lengths: (510mm, 500mm), mode: left }
        load cut: force; point P on BC at (cut / 1(N/m), 0); force (0, -cut) on C;
    }
}

fn main() {}
