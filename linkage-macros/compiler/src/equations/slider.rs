//! The linear driver: a block at a given slide along a guide and a constant or driven offset
//! from it.
//!
//! Its pin is the guide's point K + slide·u + offset·n; its frame has the pin as origin and the
//! guide's direction as x.

use crate::equations::jet::Jet;
use crate::equations::motion::Frame;
use crate::equations::parts::{GroupScope, LinkMotion, Solved};

pub(super) fn slider<'s>(
    scope: &GroupScope<'s>,
    guide: Frame<'s>,
    slide: Jet<'s>,
    offset: Jet<'s>,
) -> Solved<'s> {
    let pin = guide.place(slide, offset);
    scope.call_vector("r", pin.offset);
    let frame = Frame { origin: pin, direction: guide.direction };
    Solved { links: vec![LinkMotion { frame, slide: Some(slide) }], pin: Some(pin), levers: None }
}
