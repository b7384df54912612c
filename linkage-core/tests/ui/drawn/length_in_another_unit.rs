use linkage_core::mechanism;

mechanism! {
    struct M {
        input theta: angle;
        ground A(0, 0), D(4m, 0);
        pin B(0.5m, 0.9m), C(3.2m, 2.6m);
        link AB(A, B), DC(D, C);
        link BC(B, C) { length: 3.19mm }
        drive AB.angle = theta;
    }
}

fn main() {}
