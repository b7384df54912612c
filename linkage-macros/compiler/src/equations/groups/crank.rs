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

use crate::equations::groups::Formulas;
use crate::equations::jet::Jet;
use crate::equations::kinematics::Kinematics;
use crate::equations::motion::{Direction, Frame, PointMotion};
use crate::equations::parts::{GroupScope, LinkMotion, Solved};
use crate::model::mechanism::{Drive, Group};

pub(super) struct Crank;

impl Formulas for Crank {
    fn solve<'s>(&self, known: &Kinematics<'s>, group: &'s Group) -> Solved<'s> {
        let Some(Drive::Angle { angle, relative_to }) = &group.outer[0].drive else {
            unreachable!("a crank is driven by its angle")
        };
        let direction = known.turned(known.carrier(*relative_to).direction, angle);
        let length = group.lengths[0].as_ref().map(|length| known.length(length, group.id.0));
        crank(&known.scope(group), known.stands_on(group, 0), direction, length)
    }
}

/// The crank, and its pin where it has a length.
fn crank<'s>(
    scope: &GroupScope<'s>,
    pivot: PointMotion<'s>,
    direction: Direction<'s>,
    length: Option<Jet<'s>>,
) -> Solved<'s> {
    scope.call_vector("u", direction.u);
    let frame = Frame { origin: pivot, direction };
    let pin = length.map(|length| frame.place(length, Jet::zero(length.value.builder())));
    if let Some(pin) = pin {
        scope.call_vector("r", pin.offset);
    }
    let bars = length.map(|length| frame.vector(length.value, scope.builder.zero()));
    let links = vec![LinkMotion { frame, slide: None }];
    Solved { links, pin, bars: bars.into_iter().collect(), levers: None }
}
