use linkage_core::mechanism;

mechanism! {
    pub struct M {
        input theta: angle;
        input s: length;
        ground A(0, 0), D 4m, E(1m, 1m);
        crank AB(A) -> B { length 1m, angle: theta }
        slider (rail) -> P { slide: s }
        rrr BC(B) DC(D) -> C { lengths: (3m, 3m), mode: left }
        rrr PQ(P), CQ(C) -> Q { lengths: (3m, -3m), mode: left }
        point X on BC at polar (1m, 2m);
        output Q, X, DC.angle, Z;
    }
}

fn main() {
    let _ = M::new();
}
