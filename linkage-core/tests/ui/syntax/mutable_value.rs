use linkage_core::mechanism;

mechanism! {
    pub struct M {
        let mut half = 0.5m;
        input theta: angle;
        ground A(0, 0);
        crank AB(A) -> B { length: half, angle: theta }
    }
}

fn main() {
    let _ = M::new().position(0.3);
}
