//! Angles within half a turn.

use std::f64::consts::{PI, TAU};

use crate::model::as_drawn::whole_turns;

#[test]
fn half_a_turn_counts_forwards_whatever_its_last_digits() {
    let half = [PI, -PI, PI + 1e-9, 1e-9 - PI, -PI - 1e-9, 5.0 * PI, -7.0 * PI];
    for angle in half {
        assert!((angle + TAU * whole_turns(angle) - PI).abs() < 2e-9, "{angle}");
    }
    for (angle, turns) in
        [(0.0, 0.0), (3.0, 0.0), (-3.0, 0.0), (3.3, -1.0), (-3.3, 1.0), (9.5, -2.0)]
    {
        assert_eq!(whole_turns(angle), turns, "{angle}");
    }
}
