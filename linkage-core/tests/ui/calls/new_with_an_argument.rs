use linkage_core::mechanism;

mechanism! {
    pub struct M {
        param l = 0.25m;
        input theta: angle;
        ground A(0, 0), D(750mm, 0);
        crank AB(A) -> B { length: l, angle: theta }
        rrr BC(B), DC(D) -> C { lengths: (510mm, 500mm), mode: left }
    }
}

fn main() {
    let _ = M::new(0.3).position(1.0);
}
