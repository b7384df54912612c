linkage_core::mechanism! {
    /// An arm with one set of inputs.
    pub struct Arm {
        ground A(0, 0);
        pin B(30mm, 40mm);
        link AB(A, B);
        input motor { a = AB.angle }
    }
}
