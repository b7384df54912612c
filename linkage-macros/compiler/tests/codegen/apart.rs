//! The numbers of the slow path's result, which the optimiser is kept from pairing.

use super::{expand, four_bar, function, squeezed};

/// All numbers of a position, and the rates of a motion, which has seven numbers of positions.
#[test]
fn what_comes_last_is_kept_apart() {
    let text = expand(&four_bar());
    for (entry, first) in [("position_at", 0), ("velocity_at", 0), ("motion_at", 7)] {
        let body = squeezed(function(&text, entry));
        assert!(body.contains("private::apart(private::from_circle("), "{body}");
        assert!(body.contains(&format!("), {first}) }}")), "{body}");
    }
}
