use linkage_core::mechanism;

mechanism! {
    pub struct M {
        input theta: angle;
        ground A(0, 0), D(750mm, 0);
        crank AB(A) -> B { length: 250mm, angle: theta }
        rrr BC(B), DC(D) -> C { lengths: (510mm, 500mm), mode: left }
    }
}

fn main() {
    let _ = M::new().sketch(0.1).map(|sketch| sketch.to_svg());
}
