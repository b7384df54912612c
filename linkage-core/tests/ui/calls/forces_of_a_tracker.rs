use linkage_core::{Tracker, mechanism};

mechanism! {
    pub struct M {
        input theta: angle;
        ground A(0, 0), D(750mm, 0);
        crank AB(A) -> B { length: 250mm, angle: theta }
        rrr BC(B), DC(D) -> C { lengths: (510mm, 500mm), mode: left }
        mass 1kg on C;
    }
}

fn main() {
    let tracker = Tracker::new(M::new());
    let _ = tracker.forces(0.4, 1.0, 0.0);
}
