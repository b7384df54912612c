use linkage_core::mechanism;

mechanism! {
    pub struct M {
        input theta; ground A(0, 0); crank AB(A) { angle: theta }
    }
}

fn main() {
    let _ = M::new().position(0.3);
}
