//! Guides in the statements of groups, and links that are driven along one.

use proc_macro2::Ident;
use quote::format_ident;

use crate::chain::machine::GROUND;
use crate::syntax::tree::{
    BinaryOp, Course, Expr, ExprKind, GroupFieldValue, GuideAnchor, GuideStatement, StatementKind,
};

use super::figures::Figure;
use super::frames::DrawnFrame;
use super::writer::{Writer, given};

impl Writer<'_, '_> {
    /// The guide of a slide.
    pub(super) fn guide_of(&self, slide: usize) -> usize {
        let earlier = &self.bodies.machine.slides[..slide];
        let body = self.bodies.machine.slides[slide].body;
        let nth = earlier.iter().filter(|other| other.body == body).count();
        self.bodies.link(body).on[nth]
    }

    /// The distance of a pin from the line of a guide.
    pub(super) fn offset(&self, guide: usize, pin: usize) -> Figure {
        let guide = &self.bodies.guides[guide];
        let pen = self.pen.at(self.bodies.pins[pin].name.span());
        let from = pen.minus(self.place(pin), &guide.line.through);
        let [_, offset] = pen.seen_from(&guide.line.along, &from);
        offset
    }

    /// The guide on which a group's link slides: that of the drawing, or, where the drawing has it on
    /// the link itself, the same line on the body that is known.
    pub(super) fn rail(&mut self, slide: usize, link: usize) -> Ident {
        let guide = &self.bodies.guides[self.guide_of(slide)];
        let joint = self.bodies.machine.slides[slide];
        if joint.carrier != link {
            return guide.name.clone();
        }
        let known = self.name(joint.body);
        let name = format_ident!("{}_on_{known}", guide.name, span = guide.name.span());
        let frame = self.own_frame(joint.body);
        let pen = self.pen.at(guide.name.span());
        let through = frame.local(&pen, &guide.line.through).map(|number| number.text);
        let along = pen.angle(&frame.local_direction(&pen, &guide.line.along)).text;
        let kind = StatementKind::Guide(GuideStatement {
            name: name.clone(),
            on: Some(known.clone()),
            through: GuideAnchor::At(through),
            course: Course::Along(along),
        });
        self.put(self.bodies.link(link).statement, kind);
        name
    }

    /// The frame of a body that is placed.
    fn own_frame(&self, body: usize) -> DrawnFrame {
        match &self.own[body] {
            Some(frame) if body != GROUND => frame.clone(),
            _ => self.bodies.frames[body].clone(),
        }
    }

    pub(super) fn slider(&mut self, drive: Option<usize>, body: usize, slide: usize) {
        let guide = self.guide_of(slide);
        let pin = self.bodies.link(body).pins.first().copied();
        let value = GroupFieldValue::One(self.slide(drive, body, slide));
        let mut fields = vec![("slide", value)];
        fields.extend(pin.and_then(|pin| given(self.offset(guide, pin))));
        let rail = self.rail(slide, body);
        let new = pin.filter(|&pin| !self.made[pin]);
        let name = self.name(body).clone();
        self.group("slider", &[(body, name, rail)], new, fields, drive);
        let line = &self.bodies.guides[guide].line;
        let (axis, points) = (line.along.clone(), line.points);
        self.settle(body, DrawnFrame { axis, points, ..self.bodies.frames[body].clone() });
    }

    /// How far a driven link is along the guide. One that carries the guide goes the other way.
    fn slide(&self, drive: Option<usize>, body: usize, slide: usize) -> Expr {
        let value = self.value(drive, body);
        // The unknown is the slide of the driven link itself.
        let joint = self.bodies.machine.slides[slide];
        if joint.body == body || drive.is_none() {
            return value;
        }
        let pen = self.pen.at(self.name(body).span());
        let line = &self.bodies.guides[self.guide_of(slide)].line;
        let along = |body: usize| {
            let from = pen.minus(&self.bodies.frames[body].origin, &line.through);
            let [along, _] = pen.seen_from(&line.along, &from);
            along
        };
        let drawn = pen.add(&along(body), &along(joint.body)).text;
        let rest = vec![(BinaryOp::Add, value)];
        Expr { span: drawn.span, kind: ExprKind::Chain(Box::new(drawn), rest) }
    }
}
