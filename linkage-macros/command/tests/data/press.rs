use linkage_core::mechanism;

mechanism! {
    /// A slider-crank press with a counterweight, a load on the ram and friction of its own in the crank.
    pub struct Press {
        input theta: angle;
        param counterweight = 2kg;
        param rod = 400mm;
        load work: force;

        ground A(0, 0);
        guide way through (0, 0) along -90deg;

        crank AB(A) -> B          { length: 100mm, angle: theta }
        rrp   BC(B), ram(way) -> C { length: rod, mode: ahead }

        gravity (0, -9.81);
        mass counterweight on AB at (-100mm, 0);
        mass 3kg on BC uniform;
        mass 8kg on ram at (0, 0);
        force (0, work) on C;
        torque -0.2(N*m*s) * rate(theta) on AB;

        output C, BC, theta.drive, BC.C, ram.way, energy;
    }
}
