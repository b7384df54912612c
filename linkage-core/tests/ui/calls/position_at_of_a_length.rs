use linkage_core::mechanism;

mechanism! {
    pub struct M {
        input s: length;
        ground A(0, 0);
        guide rail through A along 0deg;
        slider ram(rail) -> P { slide: s }
    }
}

fn main() {
    let _ = M::new().position_at(1.0, 0.0);
}
