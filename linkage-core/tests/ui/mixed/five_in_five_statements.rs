use linkage_core::mechanism;

mechanism! {
    pub struct M {
        input theta: angel;
        ground A(0, 0), D(665.7mm);
        crank AB(a) -> B { length: 80 mm, angle: theta }
        rrr BC(B), DC(D) -> C { lengths: (632mm, 374mm), mode: ahead }
        point blade on BC at (500mm, 60deg);
        output blade, DC.angle
    }
}

fn main() {
    let _ = M::new().position(0.3);
}
