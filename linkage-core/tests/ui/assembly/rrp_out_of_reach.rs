use linkage_core::mechanism;

mechanism! {
    pub struct M {
        input theta: angle;
        ground A(0, 0), D(4m, 0);
        crank AB(A) -> B { length: 1m, angle: theta }
        guide far through (0, 9m) along 0deg;
        rrp AC(A), block(far) -> C { length: 8m, mode: ahead }
    }
}

fn main() {
    let _ = M::new().position(0.3);
}
