//! Links whose group gave them another frame than their statement: what else is written in their frames stands in those
//! of the groups by the shifts between the two.

use proc_macro2::Ident;

use crate::chain::machine::GROUND;
use crate::exact::Exact;
use crate::syntax::tree::{Course, GuideAnchor, GuideStatement};

use crate::model::drawn::group_frames::GroupFrames;
use crate::model::drawn::outline::bodies::GuideLine;
use crate::model::drawn::outline::frames::{DrawnFrame, Heading, Origin};
use crate::model::drawn_links::FrameFound;
use crate::model::figures::{self, Figure};
use crate::model::statements::guides::{anchor_in_figures, course_in_figures, made_guide};
use crate::model::statements::made::MadeItem;

impl<'t> GroupFrames<'_, 't> {
    /// Remembers that a link's group gives it a pin.
    pub(in crate::model::drawn) fn join(&mut self, link: &Ident, pin: &Ident) {
        self.joined.insert([link.to_string(), pin.to_string()]);
    }

    /// The body of a guide of the drawing, where a point that its statement names is none of what the groups have made of
    /// that body: the drawing says where it is.
    fn drawn_guide(
        &self,
        guide: &GuideStatement,
        point: &Ident,
    ) -> Option<(usize, &GuideLine<'t>)> {
        let body = guide.on.as_ref().map_or(Some(GROUND), |on| self.bodies.body(on))?;
        let is_made = match &guide.on {
            None => {
                let pins = &self.bodies.machine.bodies[GROUND].pins;
                let pin = self.bodies.pin(point);
                pin.is_none_or(|pin| pins.contains(&pin))
            }
            Some(on) => self.joined.contains(&[on.to_string(), point.to_string()]),
        };
        let is_given = body != GROUND && self.bodies.link(body).is_given;
        let known = self.bodies.guides.iter().find(|known| known.name == &guide.name)?;
        (!is_made && !is_given).then_some((body, known))
    }

    /// Remembers a link whose group gave it this frame, at this angle in the drawing.
    pub(in crate::model::drawn) fn note(
        &mut self,
        link: &Ident,
        written: &DrawnFrame,
        (own, counted): (&DrawnFrame, f64),
        length: Option<&Figure>,
    ) {
        if written.is(own) {
            return;
        }
        let is_reversed = match (written.points, own.points) {
            (Heading::Pins(a, b), Heading::Pins(c, d)) => (a, b) == (d, c),
            _ => false,
        };
        let (angle, axis) = match () {
            () if written.points == own.points => (None, figures::x_axis()),
            () if is_reversed => {
                let axis = figures::x_axis().map(|part| part.negated());
                (Some(Figure::turn_of(&axis, counted)), axis)
            }
            () => {
                let along = own.local_direction(&written.axis);
                (Some(Figure::turn_of(&along, counted)), figures::unit_vector(&along))
            }
        };
        let origin = match (length, written.points) {
            (Some(length), Heading::Pins(_, far)) if own.begins == Origin::Pin(far) => {
                self.near_end(length, &axis)
            }
            _ => own.local(&written.origin),
        };
        let turn = angle.as_ref().map_or(0.0, |angle| angle.value);
        let found = FrameFound { link: link.clone(), angle, axis, origin, is_reversed };
        self.turned.push((found, turn));
    }

    /// The near end of a declared length, from the far end in a frame in which the link has this direction.
    pub(in crate::model::drawn) fn near_end(
        &self,
        length: &Figure,
        axis: &[Figure; 2],
    ) -> [Figure; 2] {
        match axis[0].exact().and_then(Exact::to_integer) {
            Some(-1) => [length.clone(), Figure::zero()],
            Some(1) => [length.negated(), Figure::zero()],
            _ => axis.each_ref().map(|part| length.times(part).negated()),
        }
    }

    /// A guide with its place and its angle in the drawing, where it names points that the groups have not made of its
    /// body; none where both are as written.
    pub(in crate::model::drawn) fn told(&self, guide: &GuideStatement) -> Option<MadeItem> {
        let (through, along) = (self.through(guide), self.along(guide));
        (through.is_some() || along.is_some()).then(|| {
            let through = through.map_or(anchor_in_figures(&guide.through), GuideAnchor::At);
            let course = along.map_or(course_in_figures(&guide.course), Course::Along);
            made_guide(guide.name.clone(), guide.on.clone(), (through, course), false)
        })
    }

    fn through(&self, guide: &GuideStatement) -> Option<[Figure; 2]> {
        let GuideAnchor::Point(point) = &guide.through else { return None };
        let (body, GuideLine { line, through, .. }) = self.drawn_guide(guide, point)?;
        if guide.on.is_none() {
            return Some(line.through.clone());
        }
        let link = self.bodies.link(body);
        Some(match (link.declared_length(), &link.pins[..]) {
            // The far end is where the declared length puts it.
            (Some(length), &[_, far]) if *through == Some(far) => [length, Figure::zero()],
            _ => self.bodies.frames[body].local(&line.through),
        })
    }

    fn along(&self, guide: &GuideStatement) -> Option<Figure> {
        let Course::Towards(point) = &guide.course else { return None };
        let (body, GuideLine { line, .. }) = self.drawn_guide(guide, point)?;
        let along = self.bodies.frames[body].local_direction(&line.along);
        Some(Figure::angle_of(&along))
    }

    /// The links whose frames are other ones.
    pub(in crate::model::drawn) fn found(self) -> Vec<FrameFound> {
        self.turned.into_iter().map(|(found, _)| found).collect()
    }

    /// The angle of a link's frame against that of its group, in the drawing.
    pub(in crate::model::drawn) fn turn_of(&self, link: &Ident) -> f64 {
        let turned = self.turned.iter().find(|(found, _)| found.link == *link);
        turned.map_or(0.0, |(_, turn)| *turn)
    }
}
