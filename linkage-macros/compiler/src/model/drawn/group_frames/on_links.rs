//! Bars and pins of links whose group has no such bar, or makes the pin elsewhere.

use proc_macro2::Ident;

use crate::model::drawn::group_frames::GroupFrames;
use crate::model::drawn::outline::frames::{Heading, Origin};
use crate::model::drawn_links::{BarFound, PinFound};
use crate::model::figures::{self, Figure};

impl GroupFrames<'_, '_> {
    /// The bars between the first two pins of links that no group has as such bars.
    pub(in crate::model::drawn) fn bars_between_pins(&self, bars: &[usize]) -> Vec<BarFound> {
        let bodies = 1..self.bodies.machine.bodies.len();
        let others = bodies.filter(|body| !bars.contains(body));
        let bars = others.filter_map(|body| {
            let link = self.bodies.link(body);
            let (&[first, second, ..], false) = (&link.pins[..], link.is_given) else {
                return None;
            };
            let (pins, length) = ([first, second], self.length(body, first, second));
            let middle = self.middle_between_pins(body, pins, &length);
            Some(BarFound { link: link.name.clone(), middle, length })
        });
        bars.collect()
    }

    /// The pins between links that no group has which is declared by hand.
    pub(in crate::model::drawn) fn joints(&self) -> Vec<Ident> {
        let machine = &self.bodies.machine;
        let is_joint = |pin: &usize| {
            let mut bodies = machine.at(*pin);
            bodies.all(|body| !machine.is_given(body)) && machine.at(*pin).count() > 1
        };
        let joints = (0..machine.pins.len()).filter(is_joint);
        joints.map(|pin| self.bodies.pins[pin].name.clone()).collect()
    }

    fn middle_between_pins(
        &self,
        body: usize,
        [first, second]: [usize; 2],
        length: &Figure,
    ) -> Option<[Figure; 2]> {
        let (link, own) = (self.bodies.link(body), self.own[body].as_ref()?);
        if matches!(link.length, Some((_, None))) {
            return None;
        }
        let axis = figures::minus(self.place(second), self.place(first));
        let way = figures::along(&length.over(&Figure::whole(2)), &axis);
        let begin = figures::minus(self.place(first), &self.beginning(body, own));
        let middle = figures::plus(&begin, &way);
        Some(match own.points {
            Heading::X => middle,
            _ => figures::seen_from(&own.axis, &middle),
        })
    }

    /// Where a pin of a link is that its group makes elsewhere.
    pub(in crate::model::drawn) fn pin_elsewhere(
        &self,
        body: usize,
        pin: usize,
    ) -> Option<PinFound> {
        let (link, own) = (self.bodies.link(body), self.own[body].as_ref()?);
        let at = match (link.declared_length(), &link.pins[..], own.points) {
            (Some(length), &[near, far], Heading::Pins(from, to))
                if own.begins == Origin::Pin(from)
                    && to == pin
                    && [[near, far], [far, near]].contains(&[from, to]) =>
            {
                [length, Figure::zero()]
            }
            _ => own.local(self.place(pin)),
        };
        let (link, pin) = (link.name.clone(), self.bodies.pins[pin].name.clone());
        Some(PinFound { link, pin, at })
    }
}
