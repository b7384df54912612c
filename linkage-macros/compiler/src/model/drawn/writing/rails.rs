//! Guides that groups have links slide on, and links that are driven along one.

use proc_macro2::Ident;

use crate::chain::cutting::Dyad;
use crate::model::drawn::outline::frames::{DrawnFrame, Origin};
use crate::model::drawn::writing::writer::{Writer, offsets};
use crate::model::figures::{self, Figure};
use crate::model::mechanism::Dimension;
use crate::model::parts_of_groups::GroupNumbers;
use crate::model::statements::guides::made_guide;
use crate::syntax::tree::{Course, GuideAnchor};

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
        let frame = DrawnFrame { origin: self.frames.beginning(joint.body, &frame), ..frame };
        let through = frame.local(&guide.line.through);
        let along = self.frames.along_rail(slide);
        let line = (GuideAnchor::At(through), Course::Along(along));
        let made = made_guide(name.clone(), Some(known.clone()), line, true);
        self.put(self.bodies.link(link).statement, made);
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
        let given = GroupNumbers {
            slide: Some(self.slide(drive, body, slide)),
            offsets: pin.map_or(Vec::new(), |pin| offsets([self.frames.offset(guide, pin)])),
            ..GroupNumbers::default()
        };
        let rail = self.rail(slide, body);
        let new = pin.filter(|&pin| !self.made[pin]);
        let legs = vec![[self.frames.name(body).clone(), rail]];
        self.group("slider", (&[body], drive), legs, new, given);
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
        let written = &self.bodies.frames[yoke];
        let slot_of_yoke = &self.bodies.guides[guides[0]];
        let counted = self.frames.counted_on_rail(rail, yoke);
        let (angle, turned) = match (slot_of_yoke.along, lines[0].angle) {
            (Some(angle), Some(turned))
                if slot_of_yoke.on == yoke && written.points == lines[1].points =>
            {
                (Figure::written(angle.clone(), Some(Dimension::ANGLE)), turned)
            }
            _ => {
                let slot =
                    [figures::dot(&along[1], &along[0]), figures::cross(&along[1], &along[0])];
                let angle = Figure::turn_of(&slot, counted);
                let turned = angle.value;
                (angle, turned)
            }
        };
        // The yoke's frame begins on the rail: where it is written if that lies there.
        let origin = figures::minus(&written.origin, &lines[1].through);
        let is_on_rail = figures::cross(&along[1], &origin).is_zero()
            || written.begins == Origin::Guide(guides[0]);
        let frame = DrawnFrame {
            begins: if is_on_rail { written.begins } else { Origin::Guide(guides[1]) },
            points: lines[1].points,
            origin: if is_on_rail { written.origin.clone() } else { lines[1].through.clone() },
            axis: along[1].clone(),
        };
        let [_, offset] =
            figures::seen_from(&along[0], &figures::minus(self.frames.place(pin), &frame.origin));
        let given = GroupNumbers {
            slot: Some(angle),
            offsets: offsets([Figure::zero(), offset]),
            ..GroupNumbers::default()
        };
        self.write(dyad, None, given);
        self.settle(yoke, frame.clone(), counted);
        self.block_is_placed(block, pin, (guides[0], counted + turned));
        self.slide_is_made(rail, yoke, None);
        self.slide_is_made(slot, block, Some(self.frames.beginning(yoke, &frame)));
    }

    /// How far a driven link is along the guide. One that carries the guide goes the other way.
    fn slide(&self, drive: Option<usize>, body: usize, slide: usize) -> Figure {
        let value = self.value(drive, body);
        // The unknown is the slide of the driven link itself.
        let joint = self.bodies.machine.slides[slide];
        if joint.body == body || drive.is_none() {
            return value;
        }
        let line = &self.bodies.guides[self.frames.guide_of(slide)].line;
        let along = |body: usize| {
            let from = figures::minus(&self.bodies.frames[body].origin, &line.through);
            let [along, _] = figures::seen_from(&line.along, &from);
            along
        };
        along(body).plus(&along(joint.body)).plus(&value)
    }
}
