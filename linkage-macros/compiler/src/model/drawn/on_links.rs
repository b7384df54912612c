//! Bars and pins of links whose group has no such bar, or makes the pin elsewhere.

use proc_macro2::Ident;

use crate::syntax::tree::{PointPlace, PointStatement, Statement, StatementKind};

use crate::model::drawn::figures::Figure;
use crate::model::drawn::frames::{Heading, Origin};
use crate::model::drawn::framing::is_left;
use crate::model::drawn::writer::Writer;
use crate::model::drawn_links::{BarFound, PinFound};
use crate::model::frames_of_groups::FramesOfGroups;

impl Writer<'_, '_> {
    /// The bars between the first two pins of links that no group has as such bars.
    pub(super) fn bars_between_pins(&self) -> Vec<BarFound> {
        let bodies = 1..self.bodies.machine.bodies.len();
        bodies.filter_map(|body| self.bar_between_pins(body)).collect()
    }

    /// The statement with distances from the first two pins of a link as coordinates in its frame, where no group has
    /// the link as a bar between them. With a, b from both and l between them, x = (l + (a − b)(a + b)/l)/2 and
    /// y² = (a − x)(a + x).
    pub(super) fn by_coordinates(&self, statement: &Statement) -> Option<Statement> {
        let StatementKind::Point(PointStatement { name, on: Some(on), place }) = &statement.kind
        else {
            return None;
        };
        let PointPlace::Distances(distances, side) = place else { return None };
        let body = self.bodies.body(on).filter(|body| !self.bars.contains(body))?;
        let link = self.bodies.link(body);
        let (&[first, second, ..], false) = (&link.pins[..], link.is_given) else { return None };
        let pen = self.pen.at(name.span());
        let [a, b, long] = [&distances[0], &distances[1], &self.length(body, first, second)]
            .map(|text| Figure::length(text.clone(), f64::NAN, None));
        let square = pen.mul(&pen.sub(&a, &b), &pen.add(&a, &b));
        let x = pen.div(&pen.add(&long, &pen.div(&square, &long)), &pen.whole(2));
        let y = pen.side(&pen.mul(&pen.sub(&a, &x), &pen.add(&a, &x)));
        let y = if is_left(side) { y } else { pen.neg(&y) };
        let place = PointPlace::Cartesian([x.text, y.text]);
        let kind = StatementKind::Point(PointStatement {
            name: name.clone(),
            on: Some(on.clone()),
            place,
        });
        Some(Statement { docs: statement.docs.clone(), kind })
    }

    /// The pins between links that no group has which is declared by hand.
    pub(super) fn joints(&self) -> Vec<Ident> {
        let machine = &self.bodies.machine;
        let is_joint = |pin: &usize| {
            let mut bodies = machine.at(*pin);
            bodies.all(|body| !machine.is_given(body)) && machine.at(*pin).count() > 1
        };
        let joints = (0..machine.pins.len()).filter(is_joint);
        joints.map(|pin| self.bodies.pins[pin].name.clone()).collect()
    }

    fn bar_between_pins(&self, body: usize) -> Option<BarFound> {
        let (link, own) = (self.bodies.link(body), self.own[body].as_ref()?);
        let (&[first, second, ..], false) = (&link.pins[..], link.is_given) else { return None };
        if self.bars.contains(&body) || matches!(link.length, Some((_, None))) {
            return None;
        }
        let pen = self.pen.at(link.name.span());
        let axis = pen.minus(self.place(second), self.place(first));
        let size = pen.size(&axis);
        let length = Figure::length(self.length(body, first, second), f64::NAN, None);
        let half = pen.div(&length, &pen.whole(2));
        let way = axis.map(|part| pen.mul(&half, &pen.div(&part, &size)));
        let begin = pen.minus(self.place(first), &self.beginning(&pen, body, own));
        let middle = pen.plus(&begin, &way);
        let middle = match own.points {
            Heading::X => middle,
            _ => pen.seen_from(&own.axis, &middle),
        };
        let middle = middle.map(|number| number.text);
        Some(BarFound { link: link.name.clone(), middle, length: length.text })
    }

    /// Remembers where a pin of a link is that its group makes elsewhere.
    pub(super) fn pin_is_elsewhere(&mut self, body: usize, pin: usize) {
        let (link, Some(own)) = (self.bodies.link(body), &self.own[body]) else { return };
        let pen = self.pen.at(link.name.span());
        let at = match (&link.length, &link.pins[..], own.points) {
            (Some((length, _)), &[near, far], Heading::Pins(from, to))
                if own.begins == Origin::Pin(from)
                    && to == pin
                    && [[near, far], [far, near]].contains(&[from, to]) =>
            {
                [self.turns.expr(length), pen.zero().text]
            }
            _ => own.local(&pen, self.place(pin)).map(|number| number.text),
        };
        let (link, pin) = (link.name.clone(), self.bodies.pins[pin].name.clone());
        self.links.pins.push(PinFound { link, pin, at });
    }
}
