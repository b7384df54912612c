use linkage_core::mechanism;

mechanism! {
    struct M {
        input theta: angle;
        ground A(-1m, 0), D(4m, 0), E(2m, 5m);
        pin B(0, 0), P(1m, 1m), Q(3m, 1m), R(2m, 3.5m);
        link AB(A, B), BP(B, P), plate(P, Q, R), DQ(D, Q), ER(E, R);
        drive AB.angle = theta;
    }
}

fn main() {}
