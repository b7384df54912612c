use linkage_core::mechanism;

mechanism! {
    pub struct Press {
        input theta: angle;
        ground A(0, 0);
        guide bed through (0, 0) along 0deg;
        crank AB(A) -> B { length: 80mm, angle: theta }
        rrp BC(B), ram(bed) -> C { length: 250mm, mode: ahead }
        stop end ram.slide between (0.2m, 0.3m) { stiffness: 2000(N/m) }
        output end.torque;
    }
}

fn main() {}
