//! A load that drives an input and does no work on it.

linkage_core::mechanism! {
    struct Press {
        input theta: angle;
        ground A(0, 0);
        crank AB(A) -> B { length: 80mm, angle: theta }
        guide column through A along 90deg;
        rrp BC(B), ram(column) -> C { length: 250mm, mode: ahead }
        load push: force;
        mass 2kg on C;
        force (push, 0N) on C;
        drive theta by push;
    }
}

fn main() {
    let press = Press::new();
    let forces = press.forces(0.3, 1.0, 0.0);
    println!("{forces:?}");
}
