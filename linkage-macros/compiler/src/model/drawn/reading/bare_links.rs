//! Checks that links go through pins, that the two pins of a bar are drawn apart, and that what slides is drawn on its
//! guide or clearly beside it.

use proc_macro2::Ident;

use crate::syntax::tree::{GuideStatement, PointStatement, StatementKind};

use crate::chain::plane::Complex;
use crate::diagnostics::Diagnostics;
use crate::model::drawn::outline::bodies::Bodies;
use crate::model::drawn::outline::lengths::in_words;
use crate::model::drawn::outline::loose;
use crate::model::drawn::reading::reader::Reader;

impl Reader<'_, '_, '_> {
    /// Reports a link that goes through no pin, and carries none and no guide.
    pub(in crate::model::drawn) fn link_has_joints(&mut self, link: &Ident) {
        let carries = self.tree.statements.iter().any(|statement| match &statement.kind {
            StatementKind::Guide(GuideStatement { on, .. })
            | StatementKind::Point(PointStatement { on, .. }) => on.as_ref() == Some(link),
            _ => false,
        });
        if carries {
            return;
        }
        let named = loose::pins_in_the_name(&self.pins, link);
        let pins = named.map_or("P, Q".to_string(), |pins| loose::listed_names(&pins));
        let message = format!("`{link}` goes through no pin");
        self.report(link, message, format!("name those that it joins: `link {link}({pins})`"));
    }

    /// Reports bars whose two pins are drawn at one place, at the pin that was drawn last.
    pub(in crate::model::drawn) fn bars_have_lengths(&mut self) {
        let mut told = Vec::new();
        for link in self.links.iter().filter(|link| !link.is_given) {
            let &[first, second] = &link.pins[..] else { continue };
            let [p, q] = [first, second].map(|pin| &self.pins[pin]);
            let is_declared_elsewhere = p.on.is_some() || q.on.is_some();
            let are_apart = (0..2).any(|axis| p.at[axis].value != q.at[axis].value);
            if first != second && !are_apart && !is_declared_elsewhere {
                told.push((first.max(second), first.min(second), link.name.clone()));
            }
        }
        for (last, other, link) in told {
            let [last, other] = [last, other].map(|pin| self.pins[pin].name.clone());
            let message =
                format!("`{last}` is drawn where `{other}` is, and `{link}` has no length");
            let reason = "draw the two pins about as far apart as the link is long";
            self.report(&last, message, reason.to_string());
        }
    }
}

/// The part of the machine's size below which a pin beside its guide looks like a slip of the pen.
const SLIGHTLY: f64 = 0.05;
/// The part of it below which the distance is one of rounding.
const ROUNDING: f64 = 1e-9;

/// Notes pins that are drawn slightly beside the guide that their link slides on: the distance is an offset.
pub(in crate::model::drawn) fn note_slight_offsets(
    bodies: &Bodies<'_>,
    diagnostics: &mut Diagnostics,
) {
    let size = bodies.machine.size();
    for link in bodies.links.iter().filter(|link| !link.is_given) {
        let (Some(&pin), Some(&guide)) = (link.pins.first(), link.on.first()) else { continue };
        let line = &bodies.guides[guide].line;
        let [through, along] =
            [&line.through, &line.along].map(|[x, y]| Complex::new(x.value, y.value));
        let from = bodies.machine.pins[pin] - through;
        let across = along.unit().cross(from).abs();
        if across <= ROUNDING * size || across >= SLIGHTLY * size {
            continue;
        }
        let (name, guide) = (&bodies.pins[pin].name, bodies.guides[guide].name);
        let message = format!("`{name}` is drawn {} beside `{guide}`", in_words(across));
        let reason = format!(
            "`{}` slides at this offset; draw the pin on the guide where none is meant",
            link.name
        );
        diagnostics.note_because(name.span(), message, reason);
    }
}
