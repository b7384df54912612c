use linkage_core::mechanism;

mechanism! {
    pub struct M {
        input theta: angle;
        ground A(0, 0), D(4m, 0);
        crank AB(A) -> B { length: 1m, angle: theta }
    }
}

mechanism! {
    pub struct M {
        input s: length;
        ground A(0, 0);
        guide rail through A along 0deg;
        slider ram(rail) -> P { slide: s }
    }
}

fn main() {
    let _ = M::new().position(0.3);
}
