use linkage_core::mechanism;

mechanism! {
    pub struct M {
        input theta: angle;
        ground A(0, 0);
        guide rail through (0, 4m) along 0deg;
        crank AB(A) -> B { length: 1m, angle: theta }
        rrp BC(B), block(rail) -> C { length: 2m, mode: ahead }
    }
}

fn main() {
    let _ = M::new().position(0.3);
}
