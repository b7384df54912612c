use linkage_core::mechanism;

mechanism! {
    pub struct M {
        input left_angle, right_angle: angle;
        ground A(0, 0), D(4m, 0);
        crank AB(A) -> B { length: 2m, angle: left_angle }
        crank DE(D) -> E { length: 2m, angle: right_angle }
        rrr BC(B), EC(E) -> C { lengths: (3m, 3m), mode: left }
    }
}

fn main() {
    let _ = M::new().position(1.0, 2.0);
}
