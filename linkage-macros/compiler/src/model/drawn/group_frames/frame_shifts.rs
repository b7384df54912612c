//! Links whose group gave them another frame than their statement: what else is written in their frames stands in those
//! of the groups by the shifts between the two.

use std::collections::HashSet;

use proc_macro2::Ident;

use crate::chain::machine::GROUND;
use crate::exact::Exact;
use crate::syntax::tree::{Course, Expr, GuideAnchor, GuideStatement};

use crate::model::drawn::outline::bodies::{Bodies, GuideLine};
use crate::model::drawn::outline::figures::{Figure, Pen};
use crate::model::drawn::outline::frames::{DrawnFrame, Heading, Origin};
use crate::model::drawn_links::FrameFound;

/// The links of a drawing whose group gave them another frame.
pub(in crate::model::drawn) struct FrameShifts<'b, 't> {
    bodies: &'b Bodies<'t>,
    pen: Pen,
    /// Each with the angle of its frame against that of its group, in the drawing.
    turned: Vec<(FrameFound, f64)>,
    /// Links, each with a pin that their group gives them.
    joined: HashSet<[String; 2]>,
}

impl<'b, 't> FrameShifts<'b, 't> {
    pub(in crate::model::drawn) fn new(bodies: &'b Bodies<'t>, pen: &Pen) -> Self {
        Self { bodies, pen: pen.clone(), turned: Vec::new(), joined: HashSet::new() }
    }

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
        length: Option<&Expr>,
    ) {
        if written.is(own) {
            return;
        }
        let pen = self.pen.at(link.span());
        let is_reversed = match (written.points, own.points) {
            (Heading::Pins(a, b), Heading::Pins(c, d)) => (a, b) == (d, c),
            _ => false,
        };
        let (angle, axis) = match () {
            () if written.points == own.points => (None, pen.x_axis()),
            () if is_reversed => {
                let axis = pen.x_axis().map(|part| pen.neg(&part));
                (Some(pen.turn(&axis, counted)), axis)
            }
            () => {
                let along = own.local_direction(&pen, &written.axis);
                let size = pen.size(&along);
                let axis = along.each_ref().map(|part| pen.div(part, &size));
                (Some(pen.turn(&along, counted)), axis)
            }
        };
        let origin = match (length, written.points) {
            (Some(length), Heading::Pins(_, far)) if own.begins == Origin::Pin(far) => {
                self.near_end(&pen, length, &axis)
            }
            _ => own.local(&pen, &written.origin).map(|number| number.text),
        };
        let turn = angle.as_ref().map_or(0.0, |angle| angle.value);
        let (angle, axis) = (angle.map(|angle| angle.text), axis.map(|part| part.text));
        let found = FrameFound { link: link.clone(), angle, axis, origin, is_reversed };
        self.turned.push((found, turn));
    }

    /// The near end of a declared length, from the far end in a frame in which the link has this direction.
    pub(in crate::model::drawn) fn near_end(
        &self,
        pen: &Pen,
        length: &Expr,
        axis: &[Figure; 2],
    ) -> [Expr; 2] {
        let length = Figure::length(length.clone(), f64::NAN, None);
        match axis[0].exact.as_ref().and_then(Exact::to_integer) {
            Some(-1) => [length.text, pen.zero().text],
            Some(1) => [length.text.negated(), pen.zero().text],
            _ => axis.each_ref().map(|part| pen.neg(&pen.mul(&length, part)).text),
        }
    }

    /// Places and angles of a guide in place of points that the groups have not made of its body.
    pub(in crate::model::drawn) fn tell_places_in(&self, guide: &mut GuideStatement) {
        let (through, along) = (self.through(guide), self.along(guide));
        if let Some(through) = through {
            guide.through = GuideAnchor::At(through);
        }
        if let Some(along) = along {
            guide.course = Course::Along(along);
        }
    }

    fn through(&self, guide: &GuideStatement) -> Option<[Expr; 2]> {
        let GuideAnchor::Point(point) = &guide.through else { return None };
        let (body, GuideLine { line, through, .. }) = self.drawn_guide(guide, point)?;
        if guide.on.is_none() {
            return Some(line.through.clone().map(|number| number.text));
        }
        let (pen, link) = (self.pen.at(point.span()), self.bodies.link(body));
        Some(match (&link.length, &link.pins[..]) {
            // The far end is where the declared length puts it.
            (Some((length, _)), &[_, far]) if *through == Some(far) => {
                [(*length).clone(), pen.zero().text]
            }
            _ => self.bodies.frames[body].local(&pen, &line.through).map(|number| number.text),
        })
    }

    fn along(&self, guide: &GuideStatement) -> Option<Expr> {
        let Course::Towards(point) = &guide.course else { return None };
        let (body, GuideLine { line, .. }) = self.drawn_guide(guide, point)?;
        let pen = self.pen.at(point.span());
        let along = self.bodies.frames[body].local_direction(&pen, &line.along);
        Some(pen.angle(&along).text)
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
