use linkage_core::mechanism;

mechanism! {
    pub struct M {
        input theta: angle;
        param l = 250mm;
        ground A(0, 0), D(750mm, 0);
        crank AB(A) -> B { length: sqrt(l^2), angle: theta }
    }
}

fn main() {
    let _ = M::new().position(0.3);
}
