//! The rotary driver: a link that turns about a pivot by a given angle.
//!
//! Its direction is that of what it is relative to, turned by the angle; its frame has the pivot
//! as origin, and its pin lies at the crank's length on the frame's x. A constant angle makes a
//! link that is rigid with what it is relative to, which is how a parallelogram is declared that
//! must not change its assembly.
//!
//! # Error
//! Of a crank on the ground the direction's components are within 0.85 units in their last place,
//! with and without fused operations (`linkage-core`'s kernels hold that), the pin's offsets one
//! rounding more; on a moving link three roundings are added for turning one direction by another.

use crate::equations::jet::Jet;
use crate::equations::motion::{Direction, Frame, PointMotion};
use crate::equations::parts::{GroupScope, LinkMotion, Solved};

/// The crank, and its pin where it has a length.
pub(super) fn crank<'s>(
    scope: &GroupScope<'s>,
    pivot: PointMotion<'s>,
    direction: Direction<'s>,
    length: Option<Jet<'s>>,
) -> Solved<'s> {
    scope.call_vector("u", direction.u);
    let frame = Frame { origin: pivot, direction };
    let pin = length.map(|length| frame.place(length, Jet::zero(length.value.sheet())));
    if let Some(pin) = pin {
        scope.call_vector("r", pin.offset);
    }
    Solved { links: vec![LinkMotion { frame, slide: None }], pin, levers: None }
}
