//! Guides in the statements of groups, and links that are driven along one.

use proc_macro2::Ident;

use crate::syntax::tree::{
    BinaryOp, Course, Expr, ExprKind, GroupFieldValue, GuideAnchor, GuideStatement, StatementKind,
};

use crate::model::drawn::figures::Figure;
use crate::model::drawn::frames::{DrawnFrame, Origin};
use crate::model::drawn::writer::{Writer, given};

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
        let name = self.names.made(format!("{}_on_{known}", guide.name), "_", guide.name.span());
        let frame = self.own_frame(joint.body);
        let pen = self.pen.at(guide.name.span());
        let frame = DrawnFrame { origin: self.beginning(&pen, joint.body, &frame), ..frame };
        let through = frame.local(&pen, &guide.line.through).map(|number| number.text);
        let along = pen.turn(&frame.local_direction(&pen, &guide.line.along)).text;
        let kind = StatementKind::Guide(GuideStatement {
            name: name.clone(),
            on: Some(known.clone()),
            through: GuideAnchor::At(through),
            course: Course::Along(along),
        });
        self.put(self.bodies.link(link).statement, kind);
        name
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
        let written = self.bodies.frames[body].clone();
        let (begins, origin) = match pin {
            Some(_) => (written.begins, written.origin),
            None => self.foot(guide, &written),
        };
        self.settle(body, DrawnFrame { begins, points, origin, axis });
        self.slide_is_made(slide, body, None);
        self.is_driven_by(drive, body);
    }

    /// Where a frame without a pin begins on its guide: the foot of its origin.
    fn foot(&self, guide: usize, written: &DrawnFrame) -> (Origin, [Figure; 2]) {
        let line = &self.bodies.guides[guide].line;
        let from = self.pen.minus(&written.origin, &line.through);
        let [along, across] = self.pen.seen_from(&line.along, &from);
        if across.is_zero() || written.begins == Origin::Guide(guide) {
            return (written.begins, written.origin.clone());
        }
        let way = self.pen.seen_in_ground(&line.along, &[along, self.pen.zero()]);
        (Origin::Guide(guide), self.pen.plus(&line.through, &way))
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
