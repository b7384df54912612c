//! The bounds of a dyad, whose links close a loop.

use super::{ErrorBounds, Rounded, SlipRounding, Turning};
use crate::equations::jet::Jet;
use crate::equations::kinematics::Kinematics;
use crate::equations::symbol::Sym;
use crate::model::mechanism::{Carrier, Group, Joint, LinkId, Opposite};

impl<'s> SlipRounding<'s> {
    pub(super) fn take_dyad(&mut self, state: &Kinematics<'s>, group: &Group) {
        if let Some(opposite) = group.opposite() {
            return self.take_parallel(state, group, opposite);
        }
        let gains = state.levers(group.id).gains().map(Sym::magnitude);
        let none = self.ground.origin;
        let turning = |link: &LinkId| (*link, Turning::of(state.link(*link).frame.direction, none));
        let mut turnings: Vec<_> = group.links.iter().map(turning).collect();
        let mut slides = vec![none; turnings.len()];
        let sliding = |link: LinkId| {
            group.joints().find(|joint| joint.link() == link && joint.slideway().is_some())
        };
        for order in 0..3 {
            let open = self.open(state, group, (&turnings, &slides), order);
            for (k, link) in group.links.iter().enumerate() {
                let bound = match sliding(*link) {
                    Some(_) => &mut slides[k][order],
                    None => &mut turnings[k].1.bounds[order],
                };
                *bound = gains[k] * open;
            }
            for k in 0..turnings.len() {
                if let Some(joint) = sliding(turnings[k].0) {
                    turnings[k].1.bounds[order] = self.way(state, joint, &turnings).bounds[order];
                }
            }
        }
        self.set_dyad(state, group, &turnings, &slides);
    }

    /// Each bar of a parallelogram turns with the body of its opposite side.
    fn take_parallel(&mut self, state: &Kinematics<'s>, group: &Group, opposite: Opposite) {
        let turnings = [0, 1].map(|bar| {
            let (link, body) = (group.links[bar], self.body(opposite.carriers[bar]).turning);
            (link, body.turned(&[], state.link(link).frame.direction))
        });
        self.set_dyad(state, group, &turnings, &[self.ground.origin; 2]);
    }

    /// The sum of what the terms of the group's loop may be off by.
    fn open(
        &self,
        state: &Kinematics<'s>,
        group: &Group,
        (turnings, slides): (&[(LinkId, Turning<'s>)], &[ErrorBounds<'s>]),
        order: usize,
    ) -> Sym<'s> {
        let feet = group.outer.iter().filter_map(Joint::point);
        let mut sum = feet.fold(state.builder.zero(), |sum, foot| sum + self.points[&foot][order]);
        for joint in group.joints().filter(|joint| joint.slideway().is_some()) {
            let index = group.links.iter().position(|link| *link == joint.link());
            let slide = slides[index.expect("the group makes the link")];
            sum = sum + self.along(state, joint, (self.way(state, joint, turnings), slide), order);
        }
        for ((_, turning), length) in turnings.iter().zip(&group.lengths) {
            if let Some(length) = length {
                let length = state.jet(&length.value);
                sum = sum + length.value * turning.swing(order) + turning.relative(order, length);
            }
        }
        sum
    }

    fn set_dyad(
        &mut self,
        state: &Kinematics<'s>,
        group: &Group,
        turnings: &[(LinkId, Turning<'s>)],
        slides: &[ErrorBounds<'s>],
    ) {
        let mut pins = Vec::new();
        for (k, &(link, turning)) in turnings.iter().enumerate() {
            let joint = &group.outer[k];
            let origin = match joint.point() {
                Some(point) => self.points[&point],
                None => [0, 1, 2].map(|k2| self.along(state, joint, (turning, slides[k]), k2)),
            };
            self.links.insert(link, Rounded { origin, turning });
            self.slides.insert(link, slides[k]);
            let zero = Jet::zero(state.builder);
            match &group.lengths[k] {
                Some(length) => {
                    let at = [state.jet(&length.value), zero];
                    pins.insert(0, self.placed(state, Carrier::Link(link), at));
                }
                None => pins.push(origin),
            }
        }
        if let Some(pin) = group.pin {
            self.points.insert(pin, pins[0]);
        }
    }
}
