//! Links that drives hold between bars. Two links that a drive holds together, between what moves each, are a bar whose length
//! the drive gives: the bar takes part in a group, and both links are placed on it. A link of given angle between two bars
//! is moved without being turned: the bars are a dyad, one of them shifted.

use proc_macro2::Ident;

use crate::chain::cutting::{Carried, Dyad, DyadLeg, Found, Pair};
use crate::chain::machine::Held;
use crate::model::drawn::outline::frames::{DrawnFrame, Heading, Origin};
use crate::model::drawn::writing::bars::{DrawnBar, LinksOfBar};
use crate::model::drawn::writing::modes_as_drawn::mode_of;
use crate::model::drawn::writing::writer::Writer;
use crate::model::figures::{self, Figure};
use crate::model::mechanism::Dimension;
use crate::model::parts_of_groups::GroupNumbers;
use crate::model::statements::named::made_let;
use crate::model::statements::points::made_point;

impl Writer<'_, '_> {
    /// The bar between a joint outside and the one between both legs.
    pub(in crate::model::drawn) fn bar(&mut self, leg: &DyadLeg, pins: [usize; 2]) -> DrawnBar {
        match (&leg.bodies[..], leg.held) {
            (&[first, second], Some(held)) => self.held_bar([first, second], held, pins),
            _ => {
                let body = leg.bodies[0];
                let length = self.frames.length(body, pins[0], pins[1]);
                let (name, links) = (self.frames.name(body).clone(), LinksOfBar::One(body));
                DrawnBar { name, length, pins, links }
            }
        }
    }

    /// Goes on from a bar that its group has placed.
    pub(in crate::model::drawn) fn settle_bar(&mut self, bar: DrawnBar) {
        let DrawnBar { name, pins: [from, to], links, .. } = bar;
        match links {
            LinksOfBar::One(body) => {
                self.bar_is_placed(body, from, to);
                self.is_a_bar(body, [from, to]);
            }
            LinksOfBar::Held { links, pivot, place } => {
                self.held_links_follow((name, [from, to]), links, (pivot, place));
            }
        }
    }

    /// Remembers a link that a group has as a bar.
    pub(super) fn is_a_bar(&mut self, body: usize, pins: [usize; 2]) {
        let between = self.bodies.link(body).pins.get(..2);
        if between.is_some_and(|ends| pins.iter().all(|pin| ends.contains(pin))) {
            self.bars.push(body);
        }
    }

    /// Writes the length of the bar that two links are. With A and B the lengths from pin to pivot
    /// and from pivot to pin, and δ the angle between, its far pin is at (A + B cos δ, B sin δ) in
    /// the frame along A.
    fn held_bar(&mut self, links: [usize; 2], held: Held, pins: [usize; 2]) -> DrawnBar {
        let [_, second] = links;
        let name = self.free_bar_name(links);
        let places = [pins[0], held.pivot, pins[1]].map(|pin| self.frames.place(pin).clone());
        let vectors =
            [figures::minus(&places[1], &places[0]), figures::minus(&places[2], &places[1])];
        let [a, b] = vectors.each_ref().map(figures::size);
        let angles = [0, 1].map(|i| {
            let frame = &self.bodies.frames[links[i]];
            Figure::angle_of(&frame.local_direction(&vectors[i]))
        });
        let between = angles[1].minus(&angles[0]);
        let turn = self.value(Some(held.drive), second).plus(&between);
        let behind = self.behind(links, Some(held.drive));
        let mut number = |ending: &str, value: Figure, of: Dimension| {
            let name = self.names.made(format!("{name}_{ending}"), "_", name.span());
            let number = Figure::named(&name);
            self.put(behind, made_let(name, value, of));
            number
        };
        let turn = number("turn", turn, Dimension::ANGLE);
        let x = number("x", a.plus(&b.times(&turn.cos())), Dimension::LENGTH);
        let y = number("y", b.times(&turn.sin()), Dimension::LENGTH);
        let length = number("length", x.hypot(&y), Dimension::LENGTH);
        let place = [x, y.negated()].map(|part| a.times(&part.over(&length)));
        let links = LinksOfBar::Held { links, pivot: held.pivot, place };
        DrawnBar { name, length, pins, links }
    }

    /// Writes both links behind the group of their bar.
    fn held_links_follow(
        &mut self,
        (name, [from, to]): (Ident, [usize; 2]),
        [first, second]: [usize; 2],
        (pivot, place): (usize, [Figure; 2]),
    ) {
        let behind = self.behind([first, second], None);
        let joint = self.bodies.pins[pivot].name.clone();
        self.made[pivot] = true;
        self.put(behind, made_point(joint, name, place));
        for (link, from, to) in [(first, from, pivot), (second, pivot, to)] {
            self.rod(behind, (self.frames.name(link).clone(), link), [from, to]);
            self.bar_is_placed(link, from, to);
            self.pin_is_elsewhere(link, to);
        }
        self.links.holds_links = true;
    }

    /// A name for the bar that nothing has.
    fn free_bar_name(&mut self, links: [usize; 2]) -> Ident {
        let [first, second] = links.map(|body| self.frames.name(body));
        let name = self.names.made(format!("{first}_{second}"), "_bar", first.span());
        self.hide(name.clone(), &links);
        name
    }

    /// Writes a dyad with links of given angle between its bars: the group of both bars with the outer pin of the second one
    /// shifted, and the links and that bar behind it.
    pub(in crate::model::drawn) fn carried_dyad(&mut self, dyad: &Dyad) {
        let [Pair::Pin(u), Pair::Pin(v), Pair::Pin(w)] =
            [dyad.legs[0].outer, dyad.inner, dyad.legs[1].outer]
        else {
            return;
        };
        let ([a, b], [_, tip]) = (self.bars(dyad), dyad.tips(v));
        let mut at = self.bodies.pins[w].name.clone();
        for carried in dyad.carried.iter().rev() {
            at = self.shifted(carried, at);
        }
        let shifted = self.names.made(format!("{}_shifted", self.frames.name(b)), "_", at.span());
        let all: Vec<_> = [b].into_iter().chain(dyad.carried_bodies()).collect();
        self.hide(shifted.clone(), &all);
        let bars = [(a, [u, v]), (b, [w, tip])];
        let given = GroupNumbers {
            lengths: bars.map(|(body, [from, to])| self.frames.length(body, from, to)).into(),
            mode: Some(mode_of(&self.bodies.machine, dyad)),
            ..GroupNumbers::default()
        };
        let legs = vec![self.leg(a, u), [shifted.clone(), at]];
        self.group(&dyad.letters(), (&[a, b], None), legs, Some(v), given);
        self.bar_is_placed(a, u, v);
        self.is_a_bar(a, [u, v]);
        dyad.carried.iter().for_each(|carried| self.carried_link(carried));
        self.alongside(b, &shifted, [w, tip]);
    }

    /// The angle of a link by its drives, and what it is measured from.
    fn angle_by_drives(&self, carried: &Carried) -> GroupNumbers {
        let values = carried.drives.iter().map(|&[drive, body]| self.value(Some(drive), body));
        let (angle, relative_to) =
            (values.reduce(|all, next| all.plus(&next)), self.turns_against(carried.reference));
        GroupNumbers { angle, relative_to, ..GroupNumbers::default() }
    }

    /// A link that turns as a carried one about a point, and the point where that one then ends: the vector between its
    /// pins in front of the point. The name of the new point.
    fn shifted(&mut self, carried: &Carried, at: Ident) -> Ident {
        let (body, [from, to]) = (carried.body, carried.pins);
        let name = self.names.made(format!("{}_at_{at}", self.frames.name(body)), "_", at.span());
        self.hide(name.clone(), &[body]);
        let drive = carried.drives.first().map(|[drive, _]| *drive);
        let given = self.angle_by_drives(carried);
        self.group("crank", (&[body], drive), vec![[name.clone(), at.clone()]], None, given);
        let frame = &self.bodies.frames[body];
        let back = figures::minus(self.frames.place(from), self.frames.place(to));
        let local = match (self.bodies.link(body).declared_length(), frame.points) {
            (Some(length), Heading::Pins(near, _)) => {
                let along = if near == to { length } else { length.negated() };
                [along, Figure::zero()]
            }
            (_, Heading::X) => back,
            _ => figures::seen_from(&frame.axis, &back),
        };
        let point = self.names.made(format!("{at}_shifted"), "_", name.span());
        let (on, at) = (name, local);
        let behind = self.bodies.link(body).statement;
        self.put(behind, made_point(point.clone(), on, at));
        point
    }

    /// A carried link at the pin where the bar in front of it ends.
    fn carried_link(&mut self, carried: &Carried) {
        let (body, [pivot, _]) = (carried.body, carried.pins);
        if let [[drive, _]] = carried.drives[..] {
            let (drive, reference) = (Some(drive), carried.reference);
            return self.step(&Found::Crank { drive, body, reference, pivot });
        }
        let given = self.angle_by_drives(carried);
        let drive = carried.drives.first().map(|[drive, _]| *drive);
        self.group("crank", (&[body], drive), vec![self.leg(body, pivot)], None, given);
        let counted = self.frames.counted_by_drives(&carried.drives, carried.reference);
        self.settle_about(body, pivot, counted);
    }

    /// The frame of a link as it is written, at a pin that is made.
    pub(super) fn settle_about(&mut self, body: usize, pivot: usize, counted: f64) {
        let (begins, origin) = (Origin::Pin(pivot), self.frames.place(pivot).clone());
        let written = self.bodies.frames[body].clone();
        self.settle(body, DrawnFrame { begins, origin, ..written }, counted);
    }

    /// A bar at its outer pin, along the one that stands for it in the group.
    fn alongside(&mut self, body: usize, shifted: &Ident, [from, to]: [usize; 2]) {
        let given = GroupNumbers {
            angle: Some(Figure::zero()),
            relative_to: Some(shifted.clone()),
            ..GroupNumbers::default()
        };
        let legs = vec![self.leg(body, from)];
        self.put_group(self.bodies.link(body).statement, "crank", legs, None, given);
        self.bar_is_placed(body, from, to);
        self.pin_is_elsewhere(body, to);
    }
}
