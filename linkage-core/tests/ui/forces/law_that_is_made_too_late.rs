use linkage_core::mechanism;

mechanism! {
    pub struct Pump {
        input theta: angle;
        ground A(0, 0);
        guide bore through A along 0deg;
        crank AB(A) -> B               { length: 50mm, angle: theta }
        rrp   BC(B), piston(bore) -> C { length: brake, mode: ahead }
        let brake = 200mm - 0.1(s) * rate(piston.slide);
        mass 1kg on C;
    }
}

fn main() {}
