use linkage_core::mechanism;

mechanism! {
    pub struct M {
        input theta: angle;
        ground A(0, 0), D(750mm, 0);
        crank AB(A) -> B { length: 250mm, angle: theta }
        rrr BC(B), DC(D) -> C { lengths: (510mm, 500mm), mode: left }
        load f: force;
        point pad on DC at (200mm, 0);
        force f in DC (0, 1) on pad;
        output theta.drive;
    }
}

fn main() {}
