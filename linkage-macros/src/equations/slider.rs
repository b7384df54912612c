//! The linear driver: a block at a given slide along a guide and a constant or driven offset
//! from it.
//!
//! Its pin is the guide's point K + slide·u + offset·n; its frame has the pin as origin and the
//! guide's direction as x.

use crate::equations::jet::Jet;
use crate::equations::motion::{Frame, PointMotion};

/// The block's frame and its pin.
pub(super) fn slider<'s>(
    guide: Frame<'s>,
    slide: Jet<'s>,
    offset: Jet<'s>,
) -> (Frame<'s>, PointMotion<'s>) {
    let pin = guide.place(slide, offset);
    (Frame { origin: pin, direction: guide.direction }, pin)
}
