//! The sides of groups in a pose, and what refuses one of another assembly.

use crate::codegen::c::c_identifiers::Width;
use crate::interface::carried_over::{Assembled, SideLine};

/// The functions that these sides are told by, of this stem.
pub(super) fn functions<'s>(
    stem: &str,
    sides: impl Iterator<Item = &'s Assembled> + Clone,
    is_compared: bool,
) -> String {
    let is_across = sides.clone().any(|side| matches!(side.line, SideLine::Towards(_)));
    let is_along = sides.clone().any(|side| matches!(side.line, SideLine::Along(_)));
    let is_told = is_across || is_along;
    let mut text = String::new();
    for (is_called, part) in [
        (is_told || is_compared, include_str!("../run/transfer/refused.c")),
        (is_told || is_compared, include_str!("../run/transfer/larger.c")),
        (is_told, include_str!("../run/transfer/told.c")),
        (is_across, include_str!("../run/transfer/unit.c")),
        (is_across, include_str!("../run/transfer/across.c")),
        (is_along, include_str!("../run/transfer/along.c")),
    ] {
        if is_called {
            text += part;
        }
    }
    text.replace("STEM", stem)
}

/// The least number with which one and it are not one.
pub(super) fn epsilon(width: Width) -> &'static str {
    match width {
        Width::Double => "DBL_EPSILON",
        Width::Single => "(LinkageWide)FLT_EPSILON",
    }
}
