use linkage_core::mechanism;

mechanism! {
    pub struct M {
        input theta: angle;
        ground A(0, 0);
        crank AB(A) -> B { length: pow(2m, 0.5), angle: theta }
    }
}

fn main() {
    let _ = M::new().position(0.3);
}
