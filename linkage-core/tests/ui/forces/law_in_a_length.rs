use linkage_core::mechanism;

mechanism! {
    pub struct FourBar {
        input theta: angle;
        load cut: force;
        ground A(0, 0), D(750mm, 0);
        let law = cut - 20(N*s) * rate(theta);
        crank AB(A) -> B { length: 250mm, angle: theta }
        rrr BC(B), DC(D) -> C { lengths: (510mm, law / 1(kN/m)), mode: left }
        force (law, 0) on C;
    }
}

fn main() {}
