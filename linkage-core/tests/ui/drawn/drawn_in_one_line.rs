use linkage_core::mechanism;

mechanism! {
    struct M {
        input theta: angle;
        ground A(0, 0), D(4m, 0);
        pin B(1m, 0), C(2m, 0);
        link AB(A, B), BC(B, C), DC(D, C);
        drive AB.angle = theta;
    }
}

fn main() {}
