linkage_core::mechanism! {
    /// Seven links on the pin of a crank, two dyads behind the unknown: ten assemblies where it is drawn, of at most fourteen.
    pub struct Seven {
        input t: angle;
        export assemblies;
        ground O(0.05, 0.3), P1(0.689, 0.524);
        pin P0(0.21, 0.438), P2(0.866, 0.95), P3(0.796, 0.13), P4(0.501, 0.78), P5(0.193, 0.044),
            P6(0.975, 0.719), P7(0.844, 0.825), P8(0.572, 0.267);
        link crank(O, P0), l1(P2, P3), l2(P0, P2, P4), l3(P4, P5, P6), l4(P1, P5, P7), l5(P3, P6, P8),
            l6(P7, P8);
        drive crank.angle = t;
    }
}
