//! `pin`, `link` and `drive`: a mechanism as it is drawn. The model cuts it into drivers and groups.

use proc_macro2::{Delimiter, Group as Delimited, Ident, TokenTree};

use super::tokens::{Parse, Parser};
use super::tree::{
    DrawnLink, DriveByStatement, DriveStatement, GroundStatement, GroupStatement, LinkStatement,
    PinStatement, StatementKind,
};

const LINK: &str =
    "a link is named with the pins through it, its first one in front: `link BC(B, C);`";
const LENGTH: &str = "write `link lift(F, G) { length: s }`";
const BY: &str = "a load that drives an input is named behind it: `drive theta by pull;`";
const DRIVE: &str = "a drive is `drive AB.angle = theta;`, `drive BC.angle - AB.angle = theta;` or \
                     `drive ram.slide = s;`";

impl Parser<'_> {
    /// `pin B(80mm, 0), C(600mm, 360mm);`: read like points of the ground.
    pub(super) fn pins(&mut self) -> Parse<StatementKind> {
        Ok(match self.ground("pin")? {
            StatementKind::Ground(GroundStatement { points }) => {
                StatementKind::Pin(PinStatement { points })
            }
            other => other,
        })
    }

    /// `link AB(A, B), block(Q) on slot;` or `link lift(F, G) { length: s }`
    pub(super) fn links(&mut self, keyword: &Ident) -> Parse<StatementKind> {
        let mut links = vec![self.drawn_link()?];
        while self.take_punct(',') && !self.is_punct(0, ';') && !self.at_end() {
            links.push(self.drawn_link()?);
        }
        let fields = match self.is_group(0, Delimiter::Brace) {
            true => {
                let mut fields = GroupStatement::without_links(keyword.clone(), self.end());
                self.fields_in_braces(&mut fields);
                Some(fields)
            }
            false if self.is_word(0, "length") => {
                return self.refuse_because("the length of a link stands in braces", LENGTH);
            }
            false => None,
        };
        Ok(StatementKind::Link(LinkStatement { links, fields }))
    }

    /// True if the statement that was just read ended with its braces.
    pub(super) fn ended_with_braces(&self) -> bool {
        matches!(self.previous(), Some(TokenTree::Group(group)) if group.delimiter() == Delimiter::Brace)
    }

    fn drawn_link(&mut self) -> Parse<DrawnLink> {
        if let Some((name, pins)) = self.link_of_hyphens() {
            return Ok(DrawnLink { name, pins, on: Vec::new() });
        }
        let name = self.new_name("a link")?;
        let mut pins = match self.take_group(Delimiter::Parenthesis) {
            Some(pins) => self.pins_of_a_link(&pins)?,
            None => match self.pins_behind_a_colon(&name) {
                Some(pins) => pins,
                None => {
                    let message = format!("write the pins of `{name}`: `{name}(B, C)`");
                    return self.refuse_because(&message, LINK);
                }
            },
        };
        self.pin_behind_an_arrow(&name, &mut pins);
        self.leave_out_mode();
        let mut on = Vec::new();
        if self.take_word("on") {
            on.push(self.name_of("a guide")?);
            while self.another_guide_follows() {
                self.take_punct(',');
                on.push(self.name_of("a guide")?);
            }
        }
        Ok(DrawnLink { name, pins, on })
    }

    fn pins_of_a_link(&mut self, group: &Delimited) -> Parse<Vec<Ident>> {
        let mut inner = self.inside(group);
        let mut pins = Vec::new();
        while !inner.at_end() {
            pins.push(inner.name_of("a pin")?);
            if !inner.take_punct(',') && !inner.at_end() {
                return inner.expected_because("`,` or `)`", LINK);
            }
        }
        Ok(pins)
    }

    /// True if a name that is no other link follows the comma.
    fn another_guide_follows(&self) -> bool {
        self.is_punct(0, ',')
            && self.peek_ident(1).is_some()
            && !self.is_group(2, Delimiter::Parenthesis)
    }

    /// `drive AB.angle - DC.angle = theta;` or `drive theta by pull;`
    pub(super) fn drive(&mut self) -> Parse<StatementKind> {
        if self.is_word(1, "by") {
            let input = self.name_of("an input")?;
            self.take_word("by");
            if self.peek_ident(0).is_none() {
                return self.expected_because("a load", BY);
            }
            return Ok(StatementKind::DriveBy(DriveByStatement {
                input,
                load: self.name_of("a load")?,
            }));
        }
        if let Some(drive) = self.drive_without_its_part() {
            return drive.map(StatementKind::Drive);
        }
        if let Some(quantity) = self.quantity_of_an_input() {
            return self.refuse_because(&quantity, "a `drive` gives an angle or a slide");
        }
        let (link, member) = self.driven()?;
        let to = match self.take_punct('-') {
            true => Some(self.driven()?),
            false => None,
        };
        if !self.take_punct('=') {
            return self.expected_because("`=`", DRIVE);
        }
        let value = self.expression()?;
        Ok(StatementKind::Drive(DriveStatement { link, member, to, value, written: None }))
    }

    /// `AB.angle`
    fn driven(&mut self) -> Parse<(Ident, Ident)> {
        let link = match self.peek_ident(0).cloned() {
            // `AB - DC` would be read as one name with a hyphen.
            Some(link) if self.is_punct(1, '.') => {
                self.take();
                link
            }
            _ => {
                self.name_of("a link")?;
                return self.expected_because("`.angle` or `.slide`", DRIVE);
            }
        };
        self.take_punct('.');
        Ok((link, self.word("`angle` or `slide`")?))
    }
}
