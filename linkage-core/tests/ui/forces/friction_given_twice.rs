use linkage_core::mechanism;

mechanism! {
    pub struct FourBar {
        input theta: angle;
        ground A(0, 0), D(750mm, 0);
        crank AB(A) -> B { length: 250mm, angle: theta }
        rrr BC(B), DC(D) -> C { lengths: (510mm, 500mm), mode: left }
        torque 5(N*m) on DC;
        friction 0.1 on BC at C radius 8mm; friction 0.1 on DC at C radius 8mm;
    }
}

fn main() {}
