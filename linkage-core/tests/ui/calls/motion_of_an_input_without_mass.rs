use linkage_core::mechanism;

mechanism! {
    pub struct M {
        input theta, phi: angle;
        ground A(0, 0), D(1m, 0);
        crank AB(A) -> B { length: 100mm, angle: theta }
        crank DC(D) -> C { length: 100mm, angle: phi }
        mass 1kg on AB uniform;
    }
}

fn main() {
    let _ = M::new().forward_dynamics([0.1, 0.2], [0.0; 2], [0.0; 2]);
}
