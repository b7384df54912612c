//! Cranks and sliders.

use crate::syntax::tree;

use super::Resolver;
use super::groups::Parts;
use super::mechanism::{Carrier, Expr, Length, Step};
use super::numbers::bare_name;

impl Resolver<'_> {
    pub(super) fn crank(&mut self, parts: &Parts) -> Option<Step> {
        let (link, pivot, pin) = (parts.link(0), parts.point(0), parts.pin);
        let name = &parts.group.legs[0].link;
        let length = parts.fields.one("length");
        let length = length.and_then(|length| self.bar_length(length, &name.to_string()));
        let angle = parts.fields.one("angle").and_then(|angle| self.turn(angle));
        let relative_to = match parts.fields.one("relative_to") {
            Some(value) => self.relative_to_is_a_body(value),
            None => parts.fields.is_left_out("relative_to").then_some(Carrier::Ground),
        };
        self.bar_is_made(parts, 0, length.as_ref());
        if let (Some(pivot), Some(pin), Some(Carrier::Ground), Some(angle), Some(length)) =
            (pivot, pin, relative_to, &angle, &length)
        {
            self.pin_of_a_fixed_crank(pivot, pin, angle, &length.value);
        }
        let pin = match &parts.group.pin {
            Some(_) => Some((pin?, length?)),
            None => None,
        };
        Some(Step::Crank {
            group: parts.id,
            link: link?,
            pivot: pivot?,
            pin,
            angle: angle?,
            relative_to: relative_to?,
        })
    }

    pub(super) fn slider(&mut self, parts: &Parts) -> Option<Step> {
        let (link, guide, pin) = (parts.link(0), parts.guide(0), parts.pin);
        let slide = parts.fields.one("slide").and_then(|slide| self.length(slide));
        let offset = self.offset(parts);
        if let (Some(link), Some(pin)) = (link, pin) {
            self.block_is_made(link, pin);
        }
        if let (Some(guide), Some(pin), Some(slide), Some(offset)) = (guide, pin, &slide, &offset) {
            self.pin_of_a_fixed_slider(guide, pin, slide, offset);
        }
        if parts.group.pin.is_some() && pin.is_none() {
            return None;
        }
        Some(Step::Slider {
            group: parts.id,
            link: link?,
            guide: guide?,
            pin,
            slide: slide?,
            offset: offset?,
        })
    }

    /// The length of a bar, positive as far as that is known.
    pub(super) fn bar_length(&mut self, expr: &tree::Expr, link: &str) -> Option<Length> {
        let value = self.length(expr)?;
        self.length_is_positive(expr, &value, &format!("the length of `{link}`"))?;
        let name = match bare_name(expr) {
            Some(name) => name.to_string(),
            None => format!("length of {link}"),
        };
        Some(Length { value, name })
    }

    /// The field `offset`, zero where it is not given.
    pub(super) fn offset(&mut self, parts: &Parts) -> Option<Expr> {
        match parts.fields.one("offset") {
            Some(offset) => self.length(offset),
            None => parts.fields.is_left_out("offset").then(Expr::zero),
        }
    }

    /// A crank's angle is relative to the ground or to a link.
    fn relative_to_is_a_body(&mut self, value: &tree::Expr) -> Option<Carrier> {
        match bare_name(value) {
            Some(name) if name == "ground" => Some(Carrier::Ground),
            Some(name) => self.link(name).map(Carrier::Link),
            None => {
                let message = "`relative_to` takes `ground` or the name of a link";
                self.diagnostics.error(value.span, message);
                None
            }
        }
    }
}
