use linkage_core::mechanism;

mechanism! {
    pub struct Pump {
        input theta: angle;
        load reach: force;
        ground A(0, 0);
        guide bore through A along 0deg;
        crank AB(A) -> B               { length: 50mm, angle: theta }
        rrp   BC(B), piston(bore) -> C { length: reach / 5(N/m), mode: ahead }
        mass 1kg on C;
    }
}

fn main() {}
