use linkage_core::mechanism;

mechanism! {
    pub struct M {
        input theta: angle;
        ground A(0, 0), D(665.7, 0);
        crank AB(A) -> B { length: 80, angle: theta }
        rrr BC(B), DC(D) -> C { lengths: (632, 374), mode: left }
    }
}

fn main() {
    let _ = M::new().position(0.3);
}
