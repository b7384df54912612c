use linkage_core::mechanism;

mechanism! {
    pub struct M {
        input theta: angle;
        ground A(0, 0);
        guide bed through A along 0deg;
        crank AB(A) -> B { length: 80mm, angle: theta }
        rrp BC(B), ram(bed) -> C { length: 250mm, mode: ahead }
        mass 1kg on C;
        output total = theta.drive + ram.bed.normal;
    }
}

fn main() {}
