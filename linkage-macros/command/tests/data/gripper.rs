linkage_core::mechanism! {
    /// Two jaws that a cylinder closes by a plate and both arms: as a public file of PMKS+ has it.
    pub struct Gripper {
        input s: length;
        ground A(-46.84mm, 7.47mm), K(0, 96.96mm), L(0.9mm, -73.71mm), O(65.19mm, 98.62mm), P(66.82mm, -101.05mm);
        pin B(-0.81mm, 7.46mm), C(-17.01mm, 7.46mm), D(29.02mm, 7.45mm), G(43.11mm, 30.04mm), H(82.46mm, 30.04mm),
            I(43.11mm, -10.11mm), J(82.46mm, -10.11mm), M(0.2mm, 59.03mm), Q(65.52mm, 57.86mm), S(148.51mm, 43.2mm),
            T(0.7mm, -35.73mm), V(66.3mm, -37.16mm), X(148.51mm, -22.23mm);
        guide bore on AB through A towards B;
        guide left_bar through K towards L;
        guide right_bar through O towards P;
        link AB(A, B), CD(C, D) on bore, plate(D, G, H, I, J);
        link GM(G, M), HQ(H, Q), upper(M, Q, S), IT(I, T), JV(J, V), lower(T, V, X);
        link block_M(M) on left_bar, block_Q(Q) on right_bar, block_T(T) on left_bar, block_V(V) on right_bar;
        drive CD.slide = s;
    }
}
