//! Reads the guides of a drawing, and the links that slide on them.

use proc_macro2::Ident;

use crate::chain::machine::GROUND;
use crate::syntax::tree::{Course, GuideAnchor, GuideStatement, StatementKind};

use crate::model::drawn::outline::bodies::GuideLine;
use crate::model::drawn::outline::frames::DrawnLine;
use crate::model::drawn::reading::reader::{Reader, drawn_links};
use crate::model::figures::Figure;

impl Reader<'_, '_, '_> {
    pub(in crate::model::drawn) fn read_guides(&mut self) {
        for statement in &self.tree.statements {
            let StatementKind::Guide(GuideStatement { name, on, through, course }) =
                &statement.kind
            else {
                continue;
            };
            let body = match on {
                Some(on) => self.body(on),
                None => Some(GROUND),
            };
            let along = match course {
                Course::Along(angle) => Some(angle),
                Course::Towards(_) | Course::Mistake => None,
            };
            let through = match through {
                GuideAnchor::Point(point) => self.pin_of.get(&point.to_string()).copied(),
                GuideAnchor::At(_) | GuideAnchor::Mistake => None,
            };
            let Some(on) = body else { continue };
            self.guide_of.insert(name.to_string(), self.guides.len());
            self.guides.push(GuideLine {
                name,
                on,
                along,
                through,
                line: DrawnLine::unknown(Figure::zero()),
            });
        }
    }

    /// The guides that links slide on.
    pub(in crate::model::drawn) fn guides_of_links(&mut self) {
        let tree = self.tree;
        for (index, link) in tree.statements.iter().flat_map(drawn_links).enumerate() {
            for guide in &link.on {
                match self.guide_of.get(&guide.to_string()).copied() {
                    Some(guide) if self.guides[guide].on == index + 1 => {
                        let message = format!("`{}` slides on a guide of itself", link.name);
                        let guide = &link.on[0];
                        self.report(guide, message, "a guide is on another body".to_string());
                    }
                    Some(known) if self.links[index].on.contains(&known) => {
                        let message = format!("`{guide}` is named twice; remove one");
                        let reason = format!("`{}` slides on it once", link.name);
                        self.report(guide, message, reason);
                    }
                    Some(guide) => self.links[index].on.push(guide),
                    None if self.link_of.contains_key(&guide.to_string()) => {
                        let message = format!("`{guide}` is a link; a link slides on a guide");
                        let [through, towards] = self.two_pins(guide);
                        let reason = format!(
                            "declare the slot, `guide slot on {guide} through {through} towards {towards};`, and write `on slot`"
                        );
                        self.report(guide, message, reason);
                    }
                    None => {
                        let message = format!("no guide named `{guide}`");
                        let reason = format!(
                            "declare it: `guide {guide} through A along 0deg;`, or `guide {guide} \
                             on LINK …` for a slot"
                        );
                        self.report(guide, message, reason);
                    }
                }
            }
        }
    }

    /// Two pins of a link, in words where it has fewer.
    fn two_pins(&self, link: &Ident) -> [String; 2] {
        let pins = self.link_of.get(&link.to_string()).map(|&link| &self.links[link].pins[..]);
        match pins {
            Some(&[first, second, ..]) => {
                [first, second].map(|pin| self.pins[pin].name.to_string())
            }
            _ => ["P", "Q"].map(str::to_string),
        }
    }
}
