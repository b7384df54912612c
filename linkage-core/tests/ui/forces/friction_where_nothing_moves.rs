use linkage_core::mechanism;

mechanism! {
    pub struct Press {
        input x: length;
        ground A(0, 0);
        guide bed through (0, x) along 0deg;
        crank AB(A) -> B { length: 80mm, angle: 30deg }
        rrp BC(B), ram(bed) -> C { length: 250mm, mode: ahead }
        force (-500N, 0) on C;
        friction 0.1 at A radius 8mm;
    }
}

fn main() {}
