use linkage_core::mechanism;

mechanism! {
    pub struct M {
        load cut: force;
        input theta: angle;
        ground A(0, 0), D(750mm, 0);
        crank AB(A) -> B { length: 250mm, angle: theta }
        rrr BC(B), DC(D) -> C { lengths: (510mm, 500mm), mode: left }
        force (-cut, 0) on C;
        output theta.drive;
    }
}

fn main() {
    let _ = M::new().forward_dynamics(1.0, 2.0, 0.0, 1.0);
}
