use linkage_core::mechanism;

mechanism! {
    pub struct M {
        input theta: angle;
        ground A(0, 0), D(4m, 0);
        crank AB(A) -> B { length: 1m, angle: theta }
        crank DE(D) -> E { length: 3yd, angle: theta }
    }
}

fn main() {
    let _ = M::new().position(0.3);
}
