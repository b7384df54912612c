use linkage_core::mechanism;

mechanism! {
    pub struct M {
        input theta: angle;
        ground A(0, 0), D(750mm, 0);
        crank AB(A) -> B { length: 250mm, angle: theta }
        rrr BC(B), DC(D) -> C { lengths: (510mm, 500mm), mode: left }
    }
}

fn main() {
    let _ = std::fs::write("m.html", M::new().page().to_html());
}
