use linkage_core::mechanism;

mechanism! {
    pub struct Press {
        input h: length;
        ground A(0, 0);
        guide bed through (0, 0) along 0deg;
        unknown theta: angle between (10deg, 170deg);
        crank AB(A) -> B { length: 80mm, angle: theta }
        rrp BC(B), ram(bed) -> C { length: 250mm, mode: ahead }
        solve theta { ram.slide = h, mode: falling }
        force (-500N, 0) on C;
        friction 0.1 on ram;
    }
}

fn main() {}
