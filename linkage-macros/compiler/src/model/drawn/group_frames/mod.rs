//! The frames that groups give the links of a drawing, as far as they are placed.

mod counted;
mod frame_shifts;
mod on_links;
mod slides;

use std::collections::HashSet;

use proc_macro2::Ident;

use crate::model::drawn::outline::bodies::Bodies;
use crate::model::drawn::outline::frames::{DrawnFrame, Origin};
use crate::model::drawn_links::FrameFound;
use crate::model::figures::{self, Figure};

/// The frames that groups have given links so far.
pub(in crate::model::drawn) struct GroupFrames<'b, 't> {
    pub(in crate::model::drawn) bodies: &'b Bodies<'t>,
    /// Those that are other ones than the links are written in, each with its angle against the written one.
    turned: Vec<(FrameFound, f64)>,
    /// Links, each with a pin that their group gives them.
    joined: HashSet<[String; 2]>,
    pub(in crate::model::drawn) own: Vec<Option<DrawnFrame>>,
    /// The angles of these frames in the drawing, as drivers and guides count them.
    pub(in crate::model::drawn) counted: Vec<Option<f64>>,
}

impl<'b, 't> GroupFrames<'b, 't> {
    pub(in crate::model::drawn) fn new(bodies: &'b Bodies<'t>) -> Self {
        let (turned, joined) = (Vec::new(), HashSet::new());
        let count = bodies.machine.bodies.len();
        Self { bodies, turned, joined, own: vec![None; count], counted: vec![None; count] }
    }

    pub(in crate::model::drawn) fn name(&self, body: usize) -> &'t Ident {
        self.bodies.link(body).name
    }

    pub(in crate::model::drawn) fn place(&self, pin: usize) -> &'b [Figure; 2] {
        &self.bodies.pins[pin].at
    }

    /// The length of a bar between two pins: as declared, or as drawn.
    pub(in crate::model::drawn) fn length(&self, body: usize, from: usize, to: usize) -> Figure {
        let link = self.bodies.link(body);
        if let Some(length) = link.declared_length()
            && [from, to].iter().all(|pin| link.pins.contains(pin))
        {
            return length;
        }
        figures::size(&figures::minus(self.place(to), self.place(from)))
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
        let from = figures::minus(self.place(pin), &guide.line.through);
        let [_, offset] = figures::seen_from(&guide.line.along, &from);
        offset
    }

    /// Where a frame without a pin begins on its guide: the foot of its origin.
    pub(in crate::model::drawn) fn foot(
        &self,
        guide: usize,
        written: &DrawnFrame,
    ) -> (Origin, [Figure; 2]) {
        let line = &self.bodies.guides[guide].line;
        let from = figures::minus(&written.origin, &line.through);
        let [along, across] = figures::seen_from(&line.along, &from);
        if across.is_zero() || written.begins == Origin::Guide(guide) {
            return (written.begins, written.origin.clone());
        }
        let way = figures::seen_in_ground(&line.along, &[along, Figure::zero()]);
        (Origin::Guide(guide), figures::plus(&line.through, &way))
    }
}
