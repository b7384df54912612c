linkage_core::mechanism! {
    pub struct M {
        input x: length;
        ground A(0, 0);
        guide bed through (0, 0) along 0deg;
        unknown theta: angle between (10deg, 170deg);
        crank AB(A) -> B           { length: 80mm, angle: theta }
        rrp   BC(B), ram(bed) -> C { length: 250mm, mode: ahead }
        find theta { ram.slide = x, mode: falling }
    }
}

fn main() {}
