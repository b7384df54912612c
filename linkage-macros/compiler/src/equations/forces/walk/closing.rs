//! The push that holds the equation of an unknown.
//!
//! A bar or a block without mass keeps left − right at zero. It exerts Λ ∂(left − right)/∂x on all x that the
//! equation reads, and so has the power Λ f_θ where the unknown θ moves at a unit rate and the inputs stand
//! still. Nothing drives θ, so that with P the power of all else that acts there,
//!
//! ```text
//! P + Λ f_θ = 0
//! ```
//!
//! The walk comes from behind: where it reaches the equation, the loads on all that moves with θ are complete but for Λ. f_θ
//! is zero at a dead point of the equation, which is refused where the root is found.

use super::Walk;
use crate::equations::kinematics::Kinematics;
use crate::equations::symbol::{Sym, Vector};
use crate::model::acting::Effort;
use crate::model::mechanism::{
    Equation, Group, GuideId, Joint, LinkId, PointId, Scalar, UnknownId,
};

impl<'s> Walk<'_, 's> {
    /// Puts the push of an equation on what it reads.
    pub(super) fn close(&mut self, id: UnknownId) {
        let kinematics = self.kinematics;
        let power = self.power(&kinematics.while_one_is_sought(id)) - self.sought[id.index()];
        let push = -(power / kinematics.slopes[id.index()]);
        let mechanism = kinematics.mechanism;
        let left_out = mechanism.left_out(id);
        // The bar or the block pushes as a joint does.
        let put = self.put.clone();
        match &mechanism.unknowns[id.index()].equation {
            Equation::Difference([left, right]) => {
                self.transmit(left, -push);
                self.transmit(right, push);
                for (side, push) in [(left, push), (right, -push)] {
                    if let Scalar::Offset(point, guide) = side {
                        self.note_block(left_out, (*point, *guide), push);
                    }
                }
            }
            Equation::Turn(turn) => self.transmit_turn(turn, -push),
            Equation::Distance { points, length, is_left } => {
                let push = if *is_left { push } else { -push };
                self.transmit(&Scalar::Distance(*points), -push);
                self.transmit(&length.value, push);
                self.note_bar(left_out, *points, push);
            }
        }
        self.put = put;
    }

    /// A bar that pushes its ends apart is pressed together by its pins.
    fn note_bar(&mut self, bar: Option<&Group>, points: [PointId; 2], push: Sym<'s>) {
        let [p, q] = points.map(|point| self.kinematics.point(point));
        let line = p.to(q);
        let on_first = (push / line.x.hypot(line.y)) * line;
        for (point, force) in points.into_iter().zip([on_first, -on_first]) {
            let joint = bar.and_then(|bar| bar.outer.iter().find(|own| own.point() == Some(point)));
            self.note_more(joint.map(Joint::link), point, force);
        }
    }

    /// A block that pushes its pin along the guide's normal is pushed back by it, and held by the guide.
    fn note_block(
        &mut self,
        block: Option<&Group>,
        (point, guide): (PointId, GuideId),
        push: Sym<'s>,
    ) {
        let normal = self.kinematics.guide(guide).direction.n();
        self.note_more(block.map(|block| block.links[0]), point, -(push * normal));
        let Some(link) = block.map(|block| block.links[1]) else { return };
        if let Some([by_guide, _]) =
            self.found.get_mut(&Effort::Guide(link)).map(|found| &mut found[..])
        {
            *by_guide = *by_guide + push;
        }
    }

    /// Adds to the force of a pin on what stands on it, a link of the declaration or not.
    fn note_more(&mut self, link: Option<LinkId>, point: PointId, force: Vector<'s>) {
        let found = link.and_then(|link| self.found.get_mut(&Effort::Pin(link, point)));
        if let Some([x, y]) = found.map(|found| &mut found[..]) {
            (*x, *y) = (*x + force.x, *y + force.y);
        }
        let zero = self.builder().zero_vector();
        let sum = self.standing.entry(point).or_insert(zero);
        *sum = *sum - force;
    }

    pub(in crate::equations::forces) fn add_sought(&mut self, unknown: UnknownId, effort: Sym<'s>) {
        let sum = &mut self.sought[unknown.index()];
        *sum = *sum + effort;
    }

    /// The power of the loads that are gathered, in another motion of the same pose: of what it has placed.
    fn power(&self, unit: &Kinematics<'s>) -> Sym<'s> {
        let mut power = self.builder().zero();
        for (motion, load) in unit.links.iter().zip(&self.links) {
            let Some(motion) = motion else { continue };
            let frame = motion.frame;
            power =
                power + load.force.dot(frame.origin.velocity) + load.moment * frame.direction.omega;
        }
        for (motion, force) in unit.points.iter().zip(&self.points) {
            let Some(motion) = motion else { continue };
            power = power + force.dot(motion.velocity);
        }
        for (motion, load) in unit.guides.iter().zip(&self.guides) {
            let Some(frame) = motion else { continue };
            power =
                power + load.force.dot(frame.origin.velocity) + load.moment * frame.direction.omega;
        }
        for (motion, link) in unit.links.iter().zip((0..).map(LinkId)) {
            let Some(slide) = motion.as_ref().and_then(|motion| motion.slide) else { continue };
            power = power + self.slide(link) * slide.rate;
        }
        // An effort is what a drive exerts, a load its opposite.
        let mut places: Vec<_> = unit.coordinates.iter().collect();
        places.sort_by_key(|(place, _)| **place);
        for (&(carrier, point), at) in places {
            let [x, y] = self.driven(carrier, point);
            power = power - (x * at[0].rate + y * at[1].rate);
        }
        power
    }
}
