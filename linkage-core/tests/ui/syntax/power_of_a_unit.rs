use linkage_core::mechanism;

mechanism! {
    pub struct M {
        input theta: angle;
        ground A(0, 0), D(750mm, 0);
        crank AB(A) -> B { length: 250mm, angle: theta }
        rrr BC(B), DC(D) -> C { lengths: (sqrt(260100mm^2), 500mm), mode: left }
    }
}

fn main() {
    let _ = M::new().position(0.3);
}
