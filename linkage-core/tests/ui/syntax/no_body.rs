use linkage_core::mechanism;

mechanism! {
    pub struct M;
}

fn main() {
    let _ = M::new().position(0.3);
}
