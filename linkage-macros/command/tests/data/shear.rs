linkage_core::mechanism! {
    /// A flying shear: its "blade" <cuts> a strip.
    pub struct Shear {
        input theta: angle;
        /// The crank's length.
        param crank = 80mm;
        param side: mode = right;
        /// At the blade, upwards.
        load cut: force;
        ground A(0, 0), D(665.7mm, 0);
        crank AB(A) -> B        { length: crank, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (632mm, 374mm), mode: side }
        point blade on BC at (500mm, -60mm);
        force (0, cut) on blade;
        output C, blade, theta.drive; // the torque }
    } /* and } here */
}

linkage_core::mechanism! {
    /// A cylinder lifts an arm.
    pub struct Lift {
        input s: length;
        ground A(0, 0), D(0.5m, 0);
        pin B(0.9m, 0.6m), P(1.4m, 0.9m);
        link arm(A, B, P);
        link ram(D, B) { length: s }
    }
}
