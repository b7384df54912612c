mechanism! {
    /// A crank-rocker. Drag the joints, type other numbers.
    pub struct FourBar {
        input theta: angle;
        param crank = 120mm;
        ground A(0, 0), D(400mm, 0);
        pin B(120mm, 0), C(333mm, 255mm), P(180mm, 200mm);
        link AB(A, B) { length: crank }
        link BC(B, C, P);
        link DC(D, C);
        drive AB.angle = theta;
    }
}
