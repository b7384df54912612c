//! Slides of the drawing by the joints of groups: a link slides as its statement says, the origin of its frame along its
//! guide, whichever of the two bodies the group has placed on the other.

use crate::chain::machine::GROUND;

use crate::model::drawn::group_frames::GroupFrames;
use crate::model::drawn::outline::frames::{DrawnFrame, Origin};
use crate::model::drawn_links::SlideFound;
use crate::model::figures::{self, Figure};

impl GroupFrames<'_, '_> {
    /// The place in the drawing where the frame begins that a group gave a link. The far end of a declared length is
    /// where that puts it.
    pub(in crate::model::drawn) fn beginning(&self, body: usize, own: &DrawnFrame) -> [Figure; 2] {
        if body == GROUND {
            return own.origin.clone();
        }
        let link = self.bodies.link(body);
        match (link.declared_length(), &link.pins[..]) {
            (Some(length), &[near, far]) if own.begins == Origin::Pin(far) => {
                let (near, far) = (self.place(near), self.place(far));
                figures::plus(near, &figures::along(&length, &figures::minus(far, near)))
            }
            _ => own.origin.clone(),
        }
    }

    /// The frame that a body has by now.
    pub(in crate::model::drawn) fn own_frame(&self, body: usize) -> DrawnFrame {
        match &self.own[body] {
            Some(frame) if body != GROUND => frame.clone(),
            _ => self.bodies.frames[body].clone(),
        }
    }

    /// The point of a guide in the drawing, where its link has its declared length.
    fn point_of_guide(&self, guide: usize) -> [Figure; 2] {
        let guide = &self.bodies.guides[guide];
        let origin = guide.line.through.clone();
        match guide.through {
            Some(pin) => {
                let frame = &self.bodies.frames[guide.on];
                let at = DrawnFrame { begins: Origin::Pin(pin), origin, ..frame.clone() };
                self.beginning(guide.on, &at)
            }
            None => origin,
        }
    }

    /// The joint of a group that is a slide of the drawing. The group measures it from a place on the other body, in the
    /// drawing `from`; `None` where that is the point of the guide.
    pub(in crate::model::drawn) fn slide_found(
        &self,
        slide: usize,
        by: usize,
        from: Option<[Figure; 2]>,
    ) -> SlideFound {
        let joint = self.bodies.machine.slides[slide];
        let guide = &self.bodies.guides[self.guide_of(slide)];
        let (body, line) = (joint.body, &guide.line);
        let through = self.point_of_guide(self.guide_of(slide));
        let seen =
            |place: &[Figure; 2]| figures::seen_from(&line.along, &figures::minus(place, &through));
        let (written, own) = (&self.bodies.frames[body], self.own_frame(by));
        let start = from.map_or(Figure::zero(), |from| seen(&from)[0].clone());
        let is_reversed = by != body;
        let begins_alike = !is_reversed && written.begins == own.begins;
        let (shift, arm) = if begins_alike {
            (start, [Figure::zero(), Figure::zero()])
        } else {
            let [along, across] = seen(&written.origin);
            let [by_along, by_across] = seen(&self.beginning(by, &own));
            let by_slide = by_along.minus(&start);
            let across = by_across.minus(&across);
            match is_reversed {
                true => (along.plus(&by_slide), [start.minus(&along), across]),
                false => (along.minus(&by_slide), [by_along.minus(&along), across]),
            }
        };
        SlideFound {
            link: self.name(body).clone(),
            guide: guide.name.clone(),
            carrier: (joint.carrier != GROUND).then(|| self.name(joint.carrier).clone()),
            by: self.name(by).clone(),
            is_reversed,
            shift,
            arm,
            is_first: self.bodies.link(body).on[0] == self.guide_of(slide),
        }
    }

    /// Where the bar of a group begins from which it measures a slide; `None` where that is the guide's point.
    pub(in crate::model::drawn) fn start_on_bar(
        &self,
        slide: usize,
        bar: usize,
    ) -> Option<[Figure; 2]> {
        let guide = &self.bodies.guides[self.guide_of(slide)];
        let own = self.own_frame(bar);
        let is_the_point = guide.through.map(Origin::Pin) == Some(own.begins);
        (!is_the_point).then(|| self.beginning(bar, &own))
    }
}
