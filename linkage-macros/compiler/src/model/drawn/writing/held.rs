//! Links that drives hold between bars. Two links that a drive holds together, between what moves each, are a bar whose length
//! the drive gives: the bar takes part in a group, and both links are placed on it. A link of given angle between two bars
//! is moved without being turned: the bars are a dyad, one of them shifted.

use proc_macro2::Ident;

use crate::chain::cutting::{Carried, Dyad, DyadLeg, Found, Pair};
use crate::chain::limits::sine;
use crate::chain::machine::{GROUND, Held};
use crate::syntax::tree::{
    Expr, GroupFieldValue, LetStatement, PointPlace, PointStatement, StatementKind,
};

use crate::model::drawn::outline::figures::{Figure, sum};
use crate::model::drawn::outline::frames::{DrawnFrame, Heading, Origin};
use crate::model::drawn::writing::bars::{DrawnBar, HeldBar};
use crate::model::drawn::writing::group_statement::{group_of, named};
use crate::model::drawn::writing::writer::{Writer, side};

impl Writer<'_, '_> {
    /// The bar between a joint outside and the one between both legs.
    pub(in crate::model::drawn) fn bar(&mut self, leg: &DyadLeg, pins: [usize; 2]) -> DrawnBar {
        match (&leg.bodies[..], leg.held) {
            (&[first, second], Some(held)) => {
                DrawnBar::Held(Box::new(self.held_bar([first, second], held, pins)))
            }
            _ => {
                let body = leg.bodies[0];
                DrawnBar::Link { body, pins, length: self.frames.length(body, pins[0], pins[1]) }
            }
        }
    }

    pub(in crate::model::drawn) fn bar_name(&self, bar: &DrawnBar) -> Ident {
        match bar {
            DrawnBar::Link { body, .. } => self.frames.name(*body).clone(),
            DrawnBar::Held(bar) => bar.name.clone(),
        }
    }

    /// Goes on from a bar that its group has placed.
    pub(in crate::model::drawn) fn settle_bar(&mut self, bar: DrawnBar) {
        match bar {
            DrawnBar::Link { body, pins: [from, to], .. } => {
                self.bar_is_placed(body, from, to);
                self.is_a_bar(body, [from, to]);
            }
            DrawnBar::Held(bar) => self.held_links_follow(*bar),
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
    pub(in crate::model::drawn) fn held_bar(
        &mut self,
        links: [usize; 2],
        held: Held,
        pins: [usize; 2],
    ) -> HeldBar {
        let [_, second] = links;
        let name = self.free_bar_name(links);
        let pen = self.frames.pen.at(name.span());
        let places = [pins[0], held.pivot, pins[1]].map(|pin| self.frames.place(pin).clone());
        let vectors = [pen.minus(&places[1], &places[0]), pen.minus(&places[2], &places[1])];
        let [a, b] = vectors.each_ref().map(|vector| pen.size(vector));
        let angles = [0, 1].map(|i| {
            let frame = &self.bodies.frames[links[i]];
            pen.angle(&frame.local_direction(&pen, &vectors[i]))
        });
        let between = pen.sub(&angles[1], &angles[0]);
        let value = self.value(Some(held.drive), second);
        let turn = if between.is_zero() { value } else { sum(value, between.text) };
        let behind = self.behind(links, Some(held.drive));
        let mut number = |ending: &str, value: Expr| {
            let name = self.names.made(format!("{name}_{ending}"), "_", name.span());
            let number = named(&name);
            self.put(behind, StatementKind::Let(LetStatement { name, value }));
            number
        };
        let turn = Figure::plain(number("turn", turn), f64::NAN, None);
        let x = number("x", pen.add(&a, &pen.mul(&b, &pen.cos(&turn))).text);
        let y = number("y", pen.mul(&b, &pen.sin(&turn)).text);
        let [x, y] = [x, y].map(|text| Figure::length(text, f64::NAN, None));
        let length = number("length", pen.hypot(&x, &y).text);
        let long = Figure::length(length.clone(), f64::NAN, None);
        let place = [x, pen.neg(&y)].map(|part| pen.mul(&a, &pen.div(&part, &long)).text);
        HeldBar { name, length, links, pins, pivot: held.pivot, place }
    }

    /// Writes both links behind the group of their bar.
    pub(in crate::model::drawn) fn held_links_follow(&mut self, bar: HeldBar) {
        let HeldBar { name, links: [first, second], pins: [from, to], pivot, place, .. } = bar;
        let behind = self.behind([first, second], None);
        let joint = self.bodies.pins[pivot].name.clone();
        let kind = StatementKind::Point(PointStatement {
            name: joint.clone(),
            on: Some(name),
            place: PointPlace::Cartesian(place),
        });
        self.made[pivot] = true;
        self.put(behind, kind);
        for (link, from, to) in [(first, from, pivot), (second, pivot, to)] {
            self.rod(behind, (self.frames.name(link).clone(), link), [from, to]);
            self.bar_is_placed(link, from, to);
            self.pin_is_elsewhere(link, to);
        }
        self.holds_links = true;
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
        let lengths = bars.map(|(body, [from, to])| self.frames.length(body, from, to));
        let mode = side(sine(&self.bodies.machine, dyad));
        let fields = vec![("lengths", GroupFieldValue::Pair(lengths)), self.mode(a, mode)];
        let first = (a, self.frames.name(a).clone(), self.bodies.pins[u].name.clone());
        self.group(&dyad.letters(), &[first, (b, shifted.clone(), at)], Some(v), fields, None);
        self.bar_is_placed(a, u, v);
        self.is_a_bar(a, [u, v]);
        dyad.carried.iter().for_each(|carried| self.carried_link(carried));
        self.alongside(b, &shifted, [w, tip]);
    }

    /// The angle of a link by its drives, and what it is measured from.
    fn angle_by_drives(&self, carried: &Carried) -> Vec<(&'static str, GroupFieldValue)> {
        let values = carried.drives.iter().map(|&[drive, body]| self.value(Some(drive), body));
        let Some(angle) = values.reduce(sum) else { return Vec::new() };
        let reference = (carried.reference != GROUND).then(|| self.frames.name(carried.reference));
        let against = reference.map(|name| ("relative_to", GroupFieldValue::One(named(name))));
        [("angle", GroupFieldValue::One(angle))].into_iter().chain(against).collect()
    }

    /// A link that turns as a carried one about a point, and the point where that one then ends: the vector between its
    /// pins in front of the point. The name of the new point.
    fn shifted(&mut self, carried: &Carried, at: Ident) -> Ident {
        let (body, [from, to]) = (carried.body, carried.pins);
        let name = self.names.made(format!("{}_at_{at}", self.frames.name(body)), "_", at.span());
        self.hide(name.clone(), &[body]);
        let drive = carried.drives.first().map(|[drive, _]| *drive);
        let fields = self.angle_by_drives(carried);
        self.group("crank", &[(body, name.clone(), at.clone())], None, fields, drive);
        let pen = self.frames.pen.at(name.span());
        let frame = &self.bodies.frames[body];
        let back = pen.minus(self.frames.place(from), self.frames.place(to));
        let local = match (&self.bodies.link(body).length, frame.points) {
            (Some((length, _)), Heading::Pins(near, _)) => {
                let length = Figure::length((*length).clone(), f64::NAN, None);
                let along = if near == to { length } else { pen.neg(&length) };
                [along, pen.zero()]
            }
            (_, Heading::X) => back,
            _ => pen.seen_from(&frame.axis, &back),
        };
        let point = self.names.made(format!("{at}_shifted"), "_", name.span());
        let place = PointPlace::Cartesian(local.map(|number| number.text));
        let on = Some(name);
        let behind = self.bodies.link(body).statement;
        self.put(behind, StatementKind::Point(PointStatement { name: point.clone(), on, place }));
        point
    }

    /// A carried link at the pin where the bar in front of it ends.
    fn carried_link(&mut self, carried: &Carried) {
        let (body, [pivot, _]) = (carried.body, carried.pins);
        if let [[drive, _]] = carried.drives[..] {
            let (drive, reference) = (Some(drive), carried.reference);
            return self.step(&Found::Crank { drive, body, reference, pivot });
        }
        let fields = self.angle_by_drives(carried);
        let drive = carried.drives.first().map(|[drive, _]| *drive);
        let leg = (body, self.frames.name(body).clone(), self.bodies.pins[pivot].name.clone());
        self.group("crank", &[leg], None, fields, drive);
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
        let zero = self.frames.pen.at(self.frames.name(body).span()).float(0.0, "rad");
        let fields = vec![
            ("angle", GroupFieldValue::One(zero)),
            ("relative_to", GroupFieldValue::One(named(shifted))),
        ];
        let leg = (self.frames.name(body).clone(), self.bodies.pins[from].name.clone());
        self.frames.turns.join(&leg.0, &leg.1);
        let behind = self.bodies.link(body).statement;
        self.put(behind, StatementKind::Group(group_of("crank", vec![leg], None, fields)));
        self.bar_is_placed(body, from, to);
        self.pin_is_elsewhere(body, to);
    }
}
