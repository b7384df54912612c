use linkage_core::mechanism;

mechanism! {
    pub struct M {
        input theta: angle;
        ground A(0, 0);
        crank AB(A) -> B { length: lenght * 2 + theta, angle: fi - 2m }
    }
}

fn main() {
    let _ = M::new().position(0.3);
}
