//! The five dyads.

use super::Resolver;
use super::folding::shown_in_degrees;
use super::groups::Parts;
use super::mechanism::{Expr, Length, Step};

impl Resolver<'_> {
    pub(super) fn rrr(&mut self, parts: &Parts) -> Option<Step> {
        let lengths = self.bar_lengths(parts);
        let mode = self.mode(parts.group, parts.anatomy, &parts.fields);
        for (i, length) in lengths.iter().enumerate() {
            self.bar_is_made(parts, i, length.as_ref());
        }
        let [first, second] = lengths;
        let (outer, lengths) = ([parts.point(0)?, parts.point(1)?], [first?, second?]);
        self.bars_meet(parts, outer, &lengths)?;
        self.constants_say(parts.id, outer, &lengths);
        Some(Step::Rrr {
            group: parts.id,
            links: parts.both_links()?,
            outer,
            pin: parts.pin?,
            lengths,
            mode: mode?,
        })
    }

    pub(super) fn rrp(&mut self, parts: &Parts) -> Option<Step> {
        let length = parts.fields.one("length");
        let bar = parts.group.legs[0].link.to_string();
        let length = length.and_then(|length| self.bar_length(length, &bar));
        let offset = self.offset(parts);
        let mode = self.mode(parts.group, parts.anatomy, &parts.fields);
        self.bar_is_made(parts, 0, length.as_ref());
        if let (Some(link), Some(pin)) = (parts.link(1), parts.pin) {
            self.block_is_made(link, pin);
        }
        let (outer, guide) = (parts.point(0)?, parts.guide(1)?);
        let (length, offset) = (length?, offset?);
        self.bar_reaches_the_guide(parts, outer, guide, &length, &offset)?;
        Some(Step::Rrp {
            group: parts.id,
            links: parts.both_links()?,
            outer,
            guide,
            pin: parts.pin?,
            length,
            offset,
            mode: mode?,
        })
    }

    pub(super) fn rpr(&mut self, parts: &Parts) -> Option<Step> {
        let offset = self.offset(parts);
        let mode = self.mode(parts.group, parts.anatomy, &parts.fields);
        for i in 0..2 {
            if let (Some(link), Some(joint)) = (parts.link(i), parts.point(i)) {
                self.block_is_made(link, joint);
            }
        }
        let outer = [parts.point(0)?, parts.point(1)?];
        let offset = offset?;
        self.offset_is_within_reach(parts, outer, &offset)?;
        Some(Step::Rpr { group: parts.id, links: parts.both_links()?, outer, offset, mode: mode? })
    }

    pub(super) fn prp(&mut self, parts: &Parts) -> Option<Step> {
        let offsets = self.offsets(parts);
        for i in 0..2 {
            if let (Some(link), Some(pin)) = (parts.link(i), parts.pin) {
                self.block_is_made(link, pin);
            }
        }
        let guides = [parts.guide(0)?, parts.guide(1)?];
        self.guides_cross(parts, guides)?;
        Some(Step::Prp {
            group: parts.id,
            links: parts.both_links()?,
            guides,
            pin: parts.pin?,
            offsets: offsets?,
        })
    }

    pub(super) fn rpp(&mut self, parts: &Parts) -> Option<Step> {
        let slot = parts.fields.one("slot");
        let turn = slot.and_then(|slot| self.turn(slot));
        let offsets = self.offsets(parts);
        if let (Some(link), Some(joint)) = (parts.link(0), parts.point(0)) {
            self.block_is_made(link, joint);
        }
        let turn = turn?;
        // A slot along the rail fixes nothing across it.
        if turn.links.is_empty() && turn.rest.constant().is_some_and(|slot| slot.sin().is_zero()) {
            let slot = slot?;
            let angle = turn.rest.constant().map(shown_in_degrees).unwrap_or_default();
            let message = format!("a slot at {angle}° lies along the rail; turn it away");
            let reason = "slot and rail must cross for the group to be determined";
            self.diagnostics.error_because(slot.span, message, reason);
            return None;
        }
        Some(Step::Rpp {
            group: parts.id,
            links: parts.both_links()?,
            outer: parts.point(0)?,
            guide: parts.guide(1)?,
            slot: turn,
            offsets: offsets?,
        })
    }

    /// The two lengths of an rrr.
    fn bar_lengths(&mut self, parts: &Parts) -> [Option<Length>; 2] {
        let Some(values) = parts.fields.pair("lengths") else {
            return [None, None];
        };
        [0, 1].map(|i| self.bar_length(&values[i], &parts.group.legs[i].link.to_string()))
    }

    /// The field `offsets`, zero where it is not given.
    fn offsets(&mut self, parts: &Parts) -> Option<[Expr; 2]> {
        match parts.fields.pair("offsets") {
            Some(offsets) => self.lengths(offsets),
            None => parts.fields.is_left_out("offsets").then(|| [Expr::zero(), Expr::zero()]),
        }
    }
}
