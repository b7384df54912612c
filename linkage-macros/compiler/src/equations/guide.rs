//! Guides: a line with an origin K and a direction u, fixed in the ground or in a moving link.
//!
//! Its frame is carried by its carrier; an angle that depends on an input turns it against the
//! carrier, so that a guide has an angular velocity of its own.

use crate::equations::jet::Jet;
use crate::equations::motion::{Direction, Frame, PointMotion};
use crate::equations::symbol::Vector;

/// The guide through K that goes from one place of its carrier to another.
///
/// With (x, y) from the first place to the second in the carrier's frame and r its length, the
/// direction in that frame is (x, y)/r and turns with (x ẏ − y ẋ)/r².
pub(super) fn towards<'s>(
    carrier: Frame<'s>,
    origin: PointMotion<'s>,
    from: [Jet<'s>; 2],
    to: [Jet<'s>; 2],
) -> Frame<'s> {
    let (x, y) = (to[0] - from[0], to[1] - from[1]);
    let length = x.value.hypot(y.value);
    let unit = Vector { x: x.value / length, y: y.value / length };
    // Its value would need an arc tangent that nothing asks for; the rates do without.
    let angle = y.atan2(x);
    let turned = carrier.direction.turned_by(angle, unit);
    Frame { origin, direction: Direction { turned: None, ..turned } }
}
