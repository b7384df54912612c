use linkage_core::mechanism;

mechanism! {
    pub struct M {
        input theta: angle;
        ground A(0, 0), D(750mm, 0);
        crank AB(A) -> B { length: 250mm, angle: theta }
        rrr BC(B), DC(D) -> C { lengths: (510mm, 500mm), mode: left }
        mass 1kg on BC uniform;
        torque -0.1 * 20mm * hypot(DC.D.x, DC.D.y) on DC;
        output theta.drive;
    }
}

fn main() {
    let _ = M::new().forces(1.0, 2.0, 0.0).map(|f| f.theta.drive);
}
