use linkage_core::mechanism;

mechanism! {
    pub struct M {
        input theta: angle;
        ground A(0, 0), D(750mm, 0);
        crank AB(A) -> B { length: 250mm, angle: theta }
        rrr BC(B), DC(D) -> C { lengths: (lbc, 500mm), mode: left }
        mass 1kg on BC uniform;
        output BC.B, BC.C, DC.D, DC.C, theta.drive;
    }
}

fn main() {
    let _ = M::new().forces(1.0, 2.0, 0.0).map(|f| f.BC.B.x + f.DC.D.y + f.theta.drive);
}
