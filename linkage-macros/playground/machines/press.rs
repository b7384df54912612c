mechanism! {
    /// A press with friction in its pins and its way: the torque of the drive, and where it holds itself.
    pub struct Press {
        input theta: angle;
        load cut: force;
        param mu = 0.12;
        ground A(0, 0);
        guide bed through A along 90deg;
        crank AB(A) -> B { length: 60mm, angle: theta }
        rrp   BC(B), ram(bed) -> C { length: 240mm, mode: ahead }
        gravity (0, -9.81);
        mass 6kg on BC uniform;
        mass 40kg on ram at (0, 0);
        force (0, cut) on C;
        friction mu at A radius 40mm;
        friction mu at B radius 45mm;
        friction mu on BC at C radius 25mm;
        friction mu on ram length 200mm;
        output theta.drive, ram.slide, AB.A, losses;
    }
}
