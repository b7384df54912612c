use linkage_core::mechanism;

mechanism! {
    pub struct M {
        input theta: angle;
        ground A(0, 0);
        guide bed through A along 0deg;
        crank AB(A) -> B { length: 80mm, angle: theta }
        rrp BC(B), ram(rail) -> C { length: 250mm, mode: ahead }
        mass 1kg on ram at C;
        output ram.rail, ram.slide, theta.drive;
    }
}

fn main() {
    let _ = M::new().forces(1.0, 2.0, 0.0).map(|f| f.ram.rail.normal);
}
