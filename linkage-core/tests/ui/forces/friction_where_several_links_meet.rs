use linkage_core::mechanism;

mechanism! {
    pub struct SixBar {
        input theta: angle;
        ground A(0, 0), D(750mm, 0), G(900mm, 600mm);
        crank AB(A) -> B { length: 250mm, angle: theta }
        rrr BC(B), DC(D) -> C { lengths: (510mm, 500mm), mode: left }
        rrr CE(C), GE(G) -> E { lengths: (600mm, 500mm), mode: left }
        torque 5(N*m) on GE;
        friction 0.1 at C radius 8mm;
    }
}

fn main() {}
