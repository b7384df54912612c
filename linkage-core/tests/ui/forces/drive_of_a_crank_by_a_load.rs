use linkage_core::mechanism;

mechanism! {
    pub struct Pump {
        input theta: angle;
        load pull: force;
        ground A(0, 0);
        guide bore through A along 0deg;
        crank AB(A) -> B             { length: 50mm, angle: theta }
        rrp   BC(B), piston(bore) -> C { length: 200mm, mode: ahead }
        mass 1kg on C;
        force (pull, 0) on C;
        drive theta by pull;
        output pull, AB.drive;
    }
}

fn main() {}
