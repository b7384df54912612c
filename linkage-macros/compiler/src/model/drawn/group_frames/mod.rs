//! The frames that groups give the links of a drawing, as far as they are placed.

mod counted;
mod frame_shifts;
mod on_links;
mod slides;

use proc_macro2::Ident;

use crate::syntax::tree::Expr;

use crate::model::drawn::group_frames::frame_shifts::FrameShifts;
use crate::model::drawn::outline::bodies::Bodies;
use crate::model::drawn::outline::figures::{Figure, Pen};
use crate::model::drawn::outline::frames::{DrawnFrame, Origin};

/// The frames that groups have given links so far.
pub(in crate::model::drawn) struct GroupFrames<'b, 't> {
    pub(in crate::model::drawn) bodies: &'b Bodies<'t>,
    pub(in crate::model::drawn) pen: Pen,
    /// Those that are other ones than the links are written in.
    pub(in crate::model::drawn) turns: FrameShifts<'b, 't>,
    pub(in crate::model::drawn) own: Vec<Option<DrawnFrame>>,
    /// The angles of these frames in the drawing, as drivers and guides count them.
    pub(in crate::model::drawn) counted: Vec<Option<f64>>,
}

impl<'b, 't> GroupFrames<'b, 't> {
    pub(in crate::model::drawn) fn new(bodies: &'b Bodies<'t>, pen: &Pen) -> Self {
        let (turns, count) = (FrameShifts::new(bodies, pen), bodies.machine.bodies.len());
        Self { bodies, pen: pen.clone(), turns, own: vec![None; count], counted: vec![None; count] }
    }

    pub(in crate::model::drawn) fn name(&self, body: usize) -> &'t Ident {
        self.bodies.link(body).name
    }

    pub(in crate::model::drawn) fn place(&self, pin: usize) -> &'b [Figure; 2] {
        &self.bodies.pins[pin].at
    }

    /// The length of a bar between two pins: as declared, or as drawn.
    pub(in crate::model::drawn) fn length(&self, body: usize, from: usize, to: usize) -> Expr {
        let link = self.bodies.link(body);
        if let Some((length, _)) = &link.length
            && [from, to].iter().all(|pin| link.pins.contains(pin))
        {
            return (*length).clone();
        }
        let pen = self.pen.at(self.name(body).span());
        pen.size(&pen.minus(self.place(to), self.place(from))).text
    }

    /// The guide of a slide.
    pub(in crate::model::drawn) fn guide_of(&self, slide: usize) -> usize {
        let earlier = &self.bodies.machine.slides[..slide];
        let body = self.bodies.machine.slides[slide].body;
        let nth = earlier.iter().filter(|other| other.body == body).count();
        self.bodies.link(body).on[nth]
    }

    /// The distance of a pin from the line of a guide.
    pub(in crate::model::drawn) fn offset(&self, guide: usize, pin: usize) -> Figure {
        let guide = &self.bodies.guides[guide];
        let pen = self.pen.at(self.bodies.pins[pin].name.span());
        let from = pen.minus(self.place(pin), &guide.line.through);
        let [_, offset] = pen.seen_from(&guide.line.along, &from);
        offset
    }

    /// Where a frame without a pin begins on its guide: the foot of its origin.
    pub(in crate::model::drawn) fn foot(
        &self,
        guide: usize,
        written: &DrawnFrame,
    ) -> (Origin, [Figure; 2]) {
        let line = &self.bodies.guides[guide].line;
        let from = self.pen.minus(&written.origin, &line.through);
        let [along, across] = self.pen.seen_from(&line.along, &from);
        if across.is_zero() || written.begins == Origin::Guide(guide) {
            return (written.begins, written.origin.clone());
        }
        let way = self.pen.seen_in_ground(&line.along, &[along, self.pen.zero()]);
        (Origin::Guide(guide), self.pen.plus(&line.through, &way))
    }
}
