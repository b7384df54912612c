//! Statements with braces: `rrr BC(B), DC(D) -> C { lengths: (632mm, 374mm), mode: left }`.
//!
//! The model decides if the keyword names a group, and which legs and fields the group takes.

use proc_macro2::{Delimiter, Group as Delimited, Ident, TokenTree};

use super::anatomy::GroupSpec;
use super::openings::{Ending, opening};
use super::tokens::{Parse, Parser, Reported};
use super::tree::{Expr, GroupField, GroupFieldValue, GroupStatement, Leg};
use super::words;

impl Parser<'_> {
    /// True if the next tokens read `link(joint)`.
    fn is_leg(&self) -> bool {
        let Some(TokenTree::Group(joint)) = self.peek(1) else { return false };
        let mut content = joint.stream().into_iter();
        self.peek_ident(0).is_some()
            && joint.delimiter() == Delimiter::Parenthesis
            && matches!(content.next(), Some(TokenTree::Ident(_)))
            && content.next().is_none()
    }

    /// The group behind its keyword.
    pub(super) fn group(&mut self, keyword: Ident) -> GroupStatement {
        let mut group = GroupStatement::without_links(keyword, self.end());
        if self.head(&mut group).is_err() {
            group.head_is_read = false;
            self.skip_to_braces();
        }
        self.fields_in_braces(&mut group);
        group
    }

    /// Reads the fields behind the head of a statement with braces.
    pub(super) fn fields_in_braces(&mut self, group: &mut GroupStatement) {
        match self.take_group(Delimiter::Brace) {
            Some(braces) => {
                group.end = braces.span_close();
                if group.legs.len() > 2 && words::GROUPS.iter().any(|&word| group.keyword == word) {
                    // Fields for three links would be reported a second time.
                    group.fields_are_read = false;
                    self.inside(&braces).give_up();
                } else {
                    self.fields(&braces, group);
                }
            }
            None => {
                if group.head_is_read {
                    self.missing_braces(&group.keyword);
                }
                // Where the braces would be, more legs or a pin may stand.
                (group.head_is_read, group.fields_are_read) = (false, false);
                self.skip_statement();
            }
        }
        if self.take_skipped() {
            self.take_punct(';');
        }
    }

    /// Legs and pin.
    fn head(&mut self, group: &mut GroupStatement) -> Parse<()> {
        loop {
            let link = self.new_name("a link")?;
            let joint = self.joint(&link);
            let failed = joint.is_err();
            group.legs.push(Leg { joint: joint.unwrap_or(None), link });
            if failed {
                return Err(Reported);
            }
            if self.is_leg() {
                let found = self.found();
                let _ = self.refuse::<()>(&format!("write `,` in front of {found}"));
                continue;
            }
            let joins = ['+', '&', '|'].iter().any(|&sign| self.is_punct(0, sign));
            if joins && self.peek_ident(1).is_some() && self.is_group(2, Delimiter::Parenthesis) {
                let _ = self.refuse::<()>("write `,` between the links");
                self.take();
                continue;
            }
            if !self.take_punct(',') || self.is_sign(['-', '>']) {
                break;
            }
        }
        if self.take_sign(['-', '>']) {
            group.pin = Some(self.new_name("a pin")?);
            if self.is_punct(0, ',') {
                return self.expected_because("`{`", "a group has one inner joint");
            }
        } else if self.is_sign(['=', '>']) || self.is_punct(0, '>') {
            let _ = self.refuse_because::<()>("write `->`", "it points to the pin that is made");
            let _ = self.take_sign(['=', '>']) || self.take_punct('>');
            group.pin = Some(self.new_name("a pin")?);
        }
        Ok(())
    }

    /// In parentheses; a mistake inside them is contained, and the legs go on behind.
    fn joint(&mut self, link: &Ident) -> Parse<Option<Ident>> {
        let Some(group) = self.take_group(Delimiter::Parenthesis) else {
            return self.refuse_because(
                &format!("write what `{link}` stands on: `{link}(JOINT)`"),
                "an outer joint is a point where the letter says R, a guide where it says P",
            );
        };
        let mut inner = self.inside(&group);
        let joint = inner.joint_name();
        if joint.is_err() {
            inner.give_up();
        }
        Ok(joint.ok())
    }

    fn joint_name(&mut self) -> Parse<Ident> {
        const REASON: &str = "points are declared by `ground` or made by groups, guides by `guide`";
        if self.peek_ident(0).is_none() {
            return self.expected_because("the name of a point or a guide", REASON);
        }
        let joint = self.name_of("a point or a guide")?;
        if self.is_punct(0, '.')
            && let Some(point) = self.peek_ident(1)
        {
            let message = format!("write the joint without its link: `{point}`");
            return self.refuse_because(&message, "points, links and guides have one name space");
        }
        self.take_punct(',');
        match self.at_end() {
            true => Ok(joint),
            false => self.expected_because("`)`", "a leg is one link and its one outer joint"),
        }
    }

    fn missing_braces(&mut self, keyword: &Ident) {
        let fields = match GroupSpec::of(&keyword.to_string()) {
            Some(anatomy) => anatomy.braces(),
            None => match opening(&keyword.to_string()).map(|opening| &opening.ends) {
                Some(Ending::Braces(fields)) => fields.to_string(),
                _ => "{ … }".to_string(),
            },
        };
        let message = match self.is_group(0, Delimiter::Parenthesis)
            || self.is_group(0, Delimiter::Bracket)
        {
            true => "write the fields in braces".to_string(),
            false => format!("write the fields of `{keyword}` in braces: `{fields}`"),
        };
        let _ = self.expected_because::<()>("`{`", &message);
    }

    /// Goes to the fields of a group whose head is in error.
    fn skip_to_braces(&mut self) {
        while !self.at_end()
            && !self.is_group(0, Delimiter::Brace)
            && !self.is_punct(0, ';')
            && !self.statement_begins()
        {
            self.take();
        }
        self.give_up_since(self.start);
    }

    fn fields(&mut self, braces: &Delimited, group: &mut GroupStatement) {
        let mut inner = self.inside(braces);
        while !inner.at_end() {
            let first = inner.next;
            let Ok(name) = inner.field_name() else {
                group.fields_are_read = false;
                inner.skip_field(first);
                continue;
            };
            let span = inner.here();
            let mistake = GroupFieldValue::One(Expr::mistake(span));
            let value = inner.field_value(&name);
            let failed = value.is_err();
            let mut field = GroupField { name, value: value.unwrap_or(mistake.clone()) };
            if failed {
                inner.skip_field(first);
            } else if inner.decimal_comma() || inner.bare_pair(&field.name) || !inner.field_ends() {
                field.value = mistake;
                inner.skip_field(first);
            }
            group.fields.push(field);
        }
    }

    /// Goes behind the comma or to the end behind a field; false where something else follows.
    fn field_ends(&mut self) -> bool {
        if self.at_end() || self.take_punct(',') {
            return true;
        }
        if self.field_begins() {
            let found = self.found();
            let _ = self.refuse::<()>(&format!("write `,` in front of {found}"));
            return true;
        }
        if self.is_punct(0, ';') {
            let _ = self.refuse_because::<()>("write `,`", "fields are separated by commas");
            self.take_punct(';');
            return true;
        }
        let _ = self.expected::<()>("`,` or `}`");
        false
    }

    fn field_begins(&self) -> bool {
        self.peek_ident(0).is_some() && self.is_punct(1, ':')
    }

    /// Goes in front of what may be the next field after one in error.
    fn skip_field(&mut self, first: usize) {
        while !self.at_end() && !self.field_begins() {
            let comma = self.take_punct(',');
            if comma && self.peek_ident(0).is_some() {
                break;
            }
            if !comma {
                self.take();
            }
        }
        self.give_up_since(first);
    }

    fn field_name(&mut self) -> Parse<Ident> {
        match self.peek(0) {
            Some(TokenTree::Literal(_)) if !self.is_punct(1, ':') => {
                self.expected_because("the name of a field", "decimals stand behind a point: `0.1`")
            }
            _ => self.word("the name of a field"),
        }
    }

    fn field_value(&mut self, name: &Ident) -> Parse<GroupFieldValue> {
        if !self.is_punct(0, ':') || self.is_sign([':', ':']) {
            if self.at_end() || self.is_punct(0, ',') {
                self.diagnostics.error(name.span(), format!("write `{name}: …`"));
                return Err(Reported);
            }
            return self.refuse(&format!("write `:` after `{name}`"));
        }
        self.take_punct(':');
        if name == "mode" {
            // The model says what is written in place of `+1` and `-1` alike.
            self.take_punct('+');
        }
        if let Some(TokenTree::Group(brackets)) = self.peek(0)
            && brackets.delimiter() == Delimiter::Bracket
        {
            return self.refuse_because(
                "write `(` and `)` in place of the brackets",
                "two values of a field stand in parentheses",
            );
        }
        match self.pair_begins() {
            true => Ok(GroupFieldValue::Pair(self.pair("`(first, second)`")?)),
            false if self.at_end() || self.is_punct(0, ',') => {
                self.expected(&format!("the value of `{name}`"))
            }
            false => Ok(GroupFieldValue::One(self.expression()?)),
        }
    }

    /// True if the next token is parentheses around a comma.
    fn pair_begins(&self) -> bool {
        let Some(TokenTree::Group(group)) = self.peek(0) else { return false };
        let comma = |tree| matches!(tree, TokenTree::Punct(punct) if punct.as_char() == ',');
        group.delimiter() == Delimiter::Parenthesis && group.stream().into_iter().any(comma)
    }

    /// True if `word` is a keyword of a group, or is used like one: in front of `link(joint)` and
    /// braces.
    pub(super) fn is_group_keyword(&self, word: &str) -> bool {
        let braces = |ahead| match self.peek(ahead) {
            Some(TokenTree::Group(group)) => {
                (group.delimiter() == Delimiter::Brace).then_some(true)
            }
            Some(TokenTree::Punct(punct)) if punct.as_char() == ';' => Some(false),
            Some(_) => None,
            None => Some(false),
        };
        words::GROUPS.contains(&word) || self.is_leg() && (0..).find_map(braces).unwrap_or_default()
    }
}
