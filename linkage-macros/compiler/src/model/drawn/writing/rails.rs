//! Guides in the statements of groups, and links that are driven along one.

use proc_macro2::Ident;

use crate::chain::cutting::Dyad;
use crate::syntax::tree::{
    Course, Expr, GroupFieldValue, GuideAnchor, GuideStatement, StatementKind,
};

use crate::model::drawn::outline::figures::{Figure, sum};
use crate::model::drawn::outline::frames::{DrawnFrame, Origin};
use crate::model::drawn::writing::writer::{Writer, given};

impl Writer<'_, '_> {
    /// The guide on which a group's link slides: that of the drawing, or, where the drawing has it on
    /// the link itself, the same line on the body that is known.
    pub(in crate::model::drawn) fn rail(&mut self, slide: usize, link: usize) -> Ident {
        let guide = &self.bodies.guides[self.frames.guide_of(slide)];
        let joint = self.bodies.machine.slides[slide];
        if joint.carrier != link {
            return guide.name.clone();
        }
        let known = self.frames.name(joint.body);
        let name = self.names.made(format!("{}_on_{known}", guide.name), "_", guide.name.span());
        let frame = self.frames.own_frame(joint.body);
        let pen = self.frames.pen.at(guide.name.span());
        let frame = DrawnFrame { origin: self.frames.beginning(&pen, joint.body, &frame), ..frame };
        let through = frame.local(&pen, &guide.line.through).map(|number| number.text);
        let along = self.frames.along_rail(&pen, slide).text;
        let kind = StatementKind::Guide(GuideStatement {
            name: name.clone(),
            on: Some(known.clone()),
            through: GuideAnchor::At(through),
            course: Course::Along(along),
        });
        self.links.placed.insert(name.clone());
        self.put(self.bodies.link(link).statement, kind);
        name
    }

    pub(in crate::model::drawn) fn slider(
        &mut self,
        drive: Option<usize>,
        body: usize,
        slide: usize,
    ) {
        let guide = self.frames.guide_of(slide);
        let pin = self.bodies.link(body).pins.first().copied();
        let value = GroupFieldValue::One(self.slide(drive, body, slide));
        let mut fields = vec![("slide", value)];
        fields.extend(pin.and_then(|pin| given(self.frames.offset(guide, pin))));
        let rail = self.rail(slide, body);
        let new = pin.filter(|&pin| !self.made[pin]);
        let name = self.frames.name(body).clone();
        self.group("slider", &[(body, name, rail)], new, fields, drive);
        let line = &self.bodies.guides[guide].line;
        let (axis, points) = (line.along.clone(), line.points);
        let written = self.bodies.frames[body].clone();
        let (begins, origin) = match pin {
            Some(_) => (written.begins, written.origin),
            None => self.frames.foot(guide, &written),
        };
        let counted = self.frames.counted_on_rail(slide, body);
        self.settle(body, DrawnFrame { begins, points, origin, axis }, counted);
        self.slide_is_made(slide, body, None);
        self.is_driven_by(drive, body);
    }

    /// The field `offsets`, none where both are zero.
    pub(in crate::model::drawn) fn offsets(
        &self,
        offsets: [Figure; 2],
    ) -> Vec<(&'static str, GroupFieldValue)> {
        match offsets.iter().all(Figure::is_zero) {
            true => Vec::new(),
            false => vec![("offsets", GroupFieldValue::Pair(offsets.map(|offset| offset.text)))],
        }
    }

    /// A block in the slot of a yoke on a rail.
    pub(in crate::model::drawn) fn yoke(
        &mut self,
        dyad: &Dyad,
        pin: usize,
        slot: usize,
        rail: usize,
    ) {
        let [block, yoke] = self.bars(dyad);
        let guides = [slot, rail].map(|slide| self.frames.guide_of(slide));
        let lines = guides.map(|guide| self.bodies.guides[guide].line.clone());
        let along = lines.each_ref().map(|line| line.along.clone());
        let pen = self.frames.pen.at(self.frames.name(yoke).span());
        let written = &self.bodies.frames[yoke];
        let slot_of_yoke = &self.bodies.guides[guides[0]];
        let counted = self.frames.counted_on_rail(rail, yoke);
        let (angle, turned) = match (slot_of_yoke.along, lines[0].angle) {
            (Some(angle), Some(turned))
                if slot_of_yoke.on == yoke && written.points == lines[1].points =>
            {
                (angle.clone(), turned)
            }
            _ => {
                let slot = [pen.dot(&along[1], &along[0]), pen.cross(&along[1], &along[0])];
                let Figure { text, value, .. } = pen.turn(&slot, counted);
                (text, value)
            }
        };
        // The yoke's frame begins on the rail: where it is written if that lies there.
        let origin = pen.minus(&written.origin, &lines[1].through);
        let is_on_rail =
            pen.cross(&along[1], &origin).is_zero() || written.begins == Origin::Guide(guides[0]);
        let frame = DrawnFrame {
            begins: if is_on_rail { written.begins } else { Origin::Guide(guides[1]) },
            points: lines[1].points,
            origin: if is_on_rail { written.origin.clone() } else { lines[1].through.clone() },
            axis: along[1].clone(),
        };
        let [_, offset] =
            pen.seen_from(&along[0], &pen.minus(self.frames.place(pin), &frame.origin));
        let mut fields = vec![("slot", GroupFieldValue::One(angle))];
        fields.extend(self.offsets([pen.zero(), offset]));
        self.write(dyad, None, fields);
        self.settle(yoke, frame.clone(), counted);
        self.block_is_placed(block, pin, (guides[0], counted + turned));
        self.slide_is_made(rail, yoke, None);
        self.slide_is_made(slot, block, Some(self.frames.beginning(&pen, yoke, &frame)));
    }

    /// How far a driven link is along the guide. One that carries the guide goes the other way.
    fn slide(&self, drive: Option<usize>, body: usize, slide: usize) -> Expr {
        let value = self.value(drive, body);
        // The unknown is the slide of the driven link itself.
        let joint = self.bodies.machine.slides[slide];
        if joint.body == body || drive.is_none() {
            return value;
        }
        let pen = self.frames.pen.at(self.frames.name(body).span());
        let line = &self.bodies.guides[self.frames.guide_of(slide)].line;
        let along = |body: usize| {
            let from = pen.minus(&self.bodies.frames[body].origin, &line.through);
            let [along, _] = pen.seen_from(&line.along, &from);
            along
        };
        let drawn = pen.add(&along(body), &along(joint.body)).text;
        sum(drawn, value)
    }
}
