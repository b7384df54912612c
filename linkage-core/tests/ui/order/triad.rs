use linkage_core::mechanism;

mechanism! {
    pub struct M {
        input theta: angle;
        ground A(0, 0), D(4m, 0), F(2m, 3m);
        crank AB(A) -> B { length: 1m, angle: theta }
        rrr BE(B), body(C) -> E { lengths: (2m, 1m), mode: left }
        rrr DC(D), FC(E) -> C { lengths: (2m, 1m), mode: left }
    }
}

fn main() {
    let _ = M::new().position(0.3);
}
