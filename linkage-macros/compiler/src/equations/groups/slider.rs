//! The linear driver: a block at a given slide along a guide and a constant or driven offset
//! from it.
//!
//! Its pin is the guide's point K + slide·u + offset·n; its frame has the pin as origin and the
//! guide's direction as x.

use crate::equations::groups::Formulas;
use crate::equations::jet::Jet;
use crate::equations::kinematics::Kinematics;
use crate::equations::motion::Frame;
use crate::equations::parts::{GroupScope, LinkMotion, Solved};
use crate::model::mechanism::{Drive, Group};

pub(super) struct Slider;

impl Formulas for Slider {
    fn solve<'s>(&self, known: &Kinematics<'s>, group: &'s Group) -> Solved<'s> {
        let Some(Drive::Slide(slide)) = &group.outer[0].drive else {
            unreachable!("a slider is driven by its slide")
        };
        let (slide, offset) = (known.jet(slide), known.offset_in(&group.outer[0]));
        slider(&known.scope(group), known.slides_on(group, 0), slide, offset)
    }
}

fn slider<'s>(
    scope: &GroupScope<'s>,
    guide: Frame<'s>,
    slide: Jet<'s>,
    offset: Jet<'s>,
) -> Solved<'s> {
    let pin = guide.place(slide, offset);
    scope.call_vector("r", pin.offset);
    let frame = Frame { origin: pin, direction: guide.direction };
    let links = vec![LinkMotion { frame, slide: Some(slide) }];
    Solved { links, pin: Some(pin), bars: Vec::new(), levers: None }
}
