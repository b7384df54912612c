//! Angles of links in the drawing, with the whole turns that drivers and guides count.
//!
//! A link that is driven turns as its drive says. The angle of every other link lies within half a turn in the drawing,
//! whatever its group measures it from.

use proc_macro2::Ident;

use crate::chain::machine::GROUND;
use crate::chain::plane::Complex;

use crate::model::drawn::group_frames::GroupFrames;
use crate::model::figures::Figure;

impl GroupFrames<'_, '_> {
    /// The direction of an axis on a body, which nothing counts.
    pub(in crate::model::drawn) fn uncounted(&self, body: usize, [x, y]: &[Figure; 2]) -> f64 {
        let turn = self.bodies.displacements.get(body).map_or(0.0, |moved| moved.turn);
        Complex::new(x.value, y.value).angle() + turn
    }

    /// The angle of a link's frame as it is written.
    pub(in crate::model::drawn) fn counted_as_written(&self, body: usize) -> f64 {
        match self.counted[body] {
            Some(counted) => counted + self.turn_of(self.name(body)),
            None => self.bodies.drawn_angle(body),
        }
    }

    /// Those of all links that groups have made.
    pub(in crate::model::drawn) fn counted_angles(&self) -> Vec<(Ident, f64)> {
        let made = (0..self.counted.len()).filter(|&body| self.counted[body].is_some());
        made.map(|body| (self.name(body).clone(), self.counted_as_written(body))).collect()
    }

    /// The angle of the frame that a group has given a body by now.
    fn counted_of_group(&self, body: usize) -> f64 {
        self.counted[body].unwrap_or_else(|| self.bodies.drawn_angle(body))
    }

    /// The angle of the first of several bodies, each of which a drive turns against the next and the last one against a
    /// reference.
    pub(in crate::model::drawn) fn counted_by_drives(
        &self,
        drives: &[[usize; 2]],
        reference: usize,
    ) -> f64 {
        let from = if reference == GROUND { 0.0 } else { self.counted_as_written(reference) };
        drives.iter().fold(from, |angle, &[drive, body]| {
            let is_first = self.bodies.machine.drives[drive].bodies[0] == body;
            angle + if is_first { 1.0 } else { -1.0 } * self.bodies.driven[drive]
        })
    }

    /// The direction of a guide in the frame that the body on it has by now.
    pub(in crate::model::drawn) fn along_rail(&self, slide: usize) -> Figure {
        let joint = self.bodies.machine.slides[slide];
        let along = &self.bodies.guides[self.guide_of(slide)].line.along;
        let frame = self.own_frame(joint.body);
        Figure::turn_of(&frame.local_direction(along), self.counted_of_group(joint.body))
    }

    /// The angle of a body that a group lets slide.
    pub(in crate::model::drawn) fn counted_on_rail(&self, slide: usize, body: usize) -> f64 {
        let joint = self.bodies.machine.slides[slide];
        let line = &self.bodies.guides[self.guide_of(slide)].line;
        match line.angle {
            _ if joint.carrier == body => {
                self.counted_of_group(joint.body) + self.along_rail(slide).value
            }
            Some(angle) if joint.carrier == GROUND => angle,
            Some(angle) => self.counted_as_written(joint.carrier) + angle,
            None => self.uncounted(joint.carrier, &line.along),
        }
    }
}
