use linkage_core::mechanism;

mechanism! {
    pub struct M {
        input theta: angle;
        ground A(0, 0), D(4m, 0)
        guide rail through D along 0deg;
        crank AB(A) -> B { length: 1m, angle: thetta }
        rrp BC(B), block(D) -> C { length: 5m, mode: ahead }
        rrr AE(A), DE(D) -> E { lengths: (1m, 2m), mode: left }
        rrr BF(B), DF(D) -> F { length: (3m, 3m), mode: up }
        point P on BC at (1m, theta);
        let unused = 2m / 0;
        output P, AB, F.angle;
    }
}

fn main() {
    let _ = M::new().position(0.3);
}
