//! Two links that a drive holds together, between what moves each: a bar whose length the drive
//! gives. The bar takes part in a group, and both links are placed on it.

use proc_macro2::Ident;

use crate::chain::cutting::DyadLeg;
use crate::chain::machine::Held;
use crate::syntax::tree::{
    Expr, ExprKind, LetStatement, PointPlace, PointStatement, StatementKind,
};

use crate::model::drawn::outline::figures::{Figure, sum};
use crate::model::drawn::writing::bars::{DrawnBar, HeldBar};
use crate::model::drawn::writing::writer::Writer;

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
    fn is_a_bar(&mut self, body: usize, pins: [usize; 2]) {
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
        let [first, second] = links;
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
        let statements = [first, second].map(|body| self.bodies.link(body).statement);
        let drive = self.bodies.drives[held.drive].0;
        let behind = statements.into_iter().fold(drive, usize::max);
        let mut named = |ending: &str, value: Expr| {
            let name = self.names.made(format!("{name}_{ending}"), "_", name.span());
            self.put(behind, StatementKind::Let(LetStatement { name: name.clone(), value }));
            let span = name.span().into();
            Expr { kind: ExprKind::Name(name), span }
        };
        let turn = Figure::plain(named("turn", turn), f64::NAN, None);
        let x = named("x", pen.add(&a, &pen.mul(&b, &pen.cos(&turn))).text);
        let y = named("y", pen.mul(&b, &pen.sin(&turn)).text);
        let [x, y] = [x, y].map(|text| Figure::length(text, f64::NAN, None));
        let length = named("length", pen.hypot(&x, &y).text);
        let long = Figure::length(length.clone(), f64::NAN, None);
        let place = [x, pen.neg(&y)].map(|part| pen.mul(&a, &pen.div(&part, &long)).text);
        HeldBar { name, length, links, pins, pivot: held.pivot, place }
    }

    /// Writes both links behind the group of their bar.
    pub(in crate::model::drawn) fn held_links_follow(&mut self, bar: HeldBar) {
        let HeldBar { name, links: [first, second], pins: [from, to], pivot, place, .. } = bar;
        let behind = self.bodies.link(first).statement.max(self.bodies.link(second).statement);
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
}
