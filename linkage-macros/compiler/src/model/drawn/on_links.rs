//! Masses on links of a drawing whose group has no such bar, or no such point: bars that a search left out, and bars that
//! lie in the frame of their statement.

use proc_macro2::Ident;

use crate::model::acting::{Magnitude, Mass, MassPlace};
use crate::model::mechanism::{LinkId, Operator, Scalar};
use crate::model::scope::Scope;
use crate::syntax::tree::Expr;

use super::figures::Figure;
use super::frames::{Heading, Origin};
use super::joints::{BarFound, PinFound};
use super::writer::Writer;
use crate::model::{numbers, uses};

impl Writer<'_, '_> {
    /// The bars between the first two pins of links that no group has as such bars.
    pub(super) fn bars_between_pins(&self) -> Vec<BarFound> {
        let bodies = 1..self.bodies.machine.bodies.len();
        bodies.filter_map(|body| self.bar_between_pins(body)).collect()
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

/// A link of a drawing as a bar, where its group has no such bar.
pub(in crate::model) fn bar_as_drawn<'d>(scope: &Scope<'d>, link: &Ident) -> Option<&'d BarFound> {
    scope.drawn?.bars.iter().find(|bar| bar.link == *link)
}

/// The place on a link of a pin that its group makes elsewhere.
pub(in crate::model) fn place_as_drawn<'d>(
    scope: &Scope<'d>,
    link: &Ident,
    pin: &Ident,
) -> Option<&'d [Expr; 2]> {
    let mut pins = scope.drawn?.pins.iter();
    pins.find(|found| found.link == *link && found.pin == *pin).map(|found| &found.at)
}

/// A uniform bar: its mass in the middle, and m l²/12.
pub(in crate::model) fn uniform_as_drawn(
    scope: &mut Scope<'_>,
    name: &Ident,
    mass: Magnitude,
    bar: &BarFound,
) -> Option<Mass> {
    let link: LinkId = uses::link(scope, name)?;
    let (middle, length) =
        (numbers::lengths(scope, &bar.middle)?, numbers::length(scope, &bar.length)?);
    let twelve = Scalar::Constant(crate::exact::Exact::integer(12));
    let inertia =
        [(Operator::Mul, length.clone()), (Operator::Mul, length), (Operator::Div, twelve)];
    let inertia = inertia
        .into_iter()
        .try_fold(mass.value.clone(), |product, (operator, by)| product.combined(operator, by))?;
    let inertia = Magnitude { value: inertia, name: format!("inertia on {name}") };
    Some(Mass { place: MassPlace::At(link, middle), mass, inertia })
}
