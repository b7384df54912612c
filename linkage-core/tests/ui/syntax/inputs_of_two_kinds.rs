use linkage_core::mechanism;

mechanism! {
    pub struct M {
        input s: length, t: angle; ground A(0, 0); crank AB(A) -> B { angle: t, length: s }
    }
}

fn main() {
    let _ = M::new();
}
