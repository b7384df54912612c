//! Unknowns: what an equation fixes.

use linkage_core::{SolveError, mechanism};

mechanism! {
    /// A press: the crank's angle for a wanted ram.
    pub struct Press {
        input x: length;
        unknown theta: angle between (10deg, 170deg);
        param seed: near = 60deg;
        ground A(0, 0);
        guide rail through (0, 0) along 0deg;
        crank AB(A) -> B           { length: 80mm, angle: theta }
        rrp   BC(B), ram(rail) -> C { length: 250mm, mode: ahead }
        solve theta { ram.slide = x, mode: falling, near: seed }
    }
}

#[test]
fn a_press_stands_where_it_is_wanted() {
    let press = Press::new();
    for x in [0.18, 0.25, 0.3, 0.32] {
        let m = press.motion(x, 1.0, 0.5).unwrap();
        assert!((m.position.C.x - x).abs() < 1e-15, "{m:?}");
        assert!((m.velocity.ram.slide - 1.0).abs() < 1e-13, "{m:?}");
        assert!((m.acceleration.ram.slide - 0.5).abs() < 1e-12, "{m:?}");
    }
    assert!(matches!(press.position(0.4), Err(SolveError::NoSolution { unknown: "theta", .. })));
    println!("{}", Press::COST);
}
