mechanism! {
    /// A platform that a cylinder lifts. The page finds how far.
    pub struct Lift {
        input s: length;
        ground A(0, 0), D(500mm, 0);
        pin B(900mm, 300mm), P(1400mm, 500mm);
        link arm(A, B, P);
        link ram(D, B) { length: s }
    }
}
