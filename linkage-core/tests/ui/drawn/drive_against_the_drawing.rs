use linkage_core::mechanism;

mechanism! {
    struct GearedFiveBar {
        input theta: angle;
        ground A(0, 0), D(6m, 0);
        pin B(-1m, 1m), C(7m, 1m), P(3m, 5m);
        link AB(A, B), DC(D, C), BP(B, P), CP(C, P);
        drive AB.angle = theta;
        drive DC.angle = 170deg - AB.angle;
    }
}

fn main() {}
