use linkage_core::mechanism;

mechanism! {
    struct M {
        input theta: angle;
        ground A(0, 0);
        guide bed through A along 0deg;
        pin C(1m, 0);
        link ram(C) on bed;
        drive ram.angle = theta;
    }
}

fn main() {}
