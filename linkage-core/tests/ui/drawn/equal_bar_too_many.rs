use linkage_core::mechanism;

mechanism! {
    struct M {
        input theta: angle;
        ground A(0, 0), D(4m, 0), E(1m, 0);
        pin B(0, 1m), C(4m, 1m), F(1m, 1m);
        link AB(A, B), BC(B, C, F), DC(D, C), EF(E, F);
        drive AB.angle = theta;
    }
}

fn main() {}
