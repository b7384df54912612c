use linkage_core::mechanism;

mechanism! {
    pub struct M {
        param elbow: mode = left;
        input theta: angle;
        ground A(0, 0), D(4m, 0);
        crank AB(A) -> B { length: 1m, angle: theta }
        rrr BC(B), DC(D) -> C { lengths: (3m, 3m), mode: elbow }
    }
}

fn main() {
    let mut m = M::new();
    m.elbow = left;
}
