use linkage_core::mechanism;

mechanism! {
    pub struct M {
        input theta: angle;
        ground A(0, 0), D(4m, 0);
        crank AB(A) -> B { length: 1m, angle: theta }
        rrr BC(B), DC(D) -> C { lengths: (3m, 3m), mode: left }
    }
}

fn main() {
    let _ = M::new().acceleration(0.3, 1.0, 0.0);
}
