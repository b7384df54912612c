//! Statements with braces: `rrr BC(B), DC(D) -> C { lengths: (632mm, 374mm), mode: left }`.
//!
//! Whether the keyword is one, and which legs and fields it takes, is decided by the model.

use proc_macro2::{Delimiter, Group as Delimited, Ident, TokenTree};

use super::tokens::{Parse, Parser, Reported};
use super::tree::{Field, FieldValue, Group, Leg};
use super::words;

impl Parser<'_> {
    /// Whether what comes next reads `link(joint)`.
    fn is_leg(&self) -> bool {
        let Some(TokenTree::Group(joint)) = self.peek(1) else { return false };
        let mut content = joint.stream().into_iter();
        self.peek_ident(0).is_some()
            && joint.delimiter() == Delimiter::Parenthesis
            && matches!(content.next(), Some(TokenTree::Ident(_)))
            && content.next().is_none()
    }

    /// The group behind its keyword.
    pub(super) fn group(&mut self, keyword: Ident) -> Group {
        let mut group =
            Group { keyword, legs: Vec::new(), pin: None, fields: Vec::new(), end: self.end() };
        let head = self.head(&mut group);
        if head.is_err() {
            self.skip_to_braces();
        }
        match self.take_group(Delimiter::Brace) {
            Some(braces) => {
                group.end = braces.span_close();
                group.fields = self.fields(&braces);
            }
            None => {
                if head.is_ok() {
                    self.missing_braces(&group.keyword);
                }
                self.skip_statement();
            }
        }
        if self.take_skipped() {
            self.take_punct(';');
        }
        group
    }

    /// Legs and pin.
    fn head(&mut self, group: &mut Group) -> Parse<()> {
        loop {
            let link = self.new_name("a link")?;
            let joint = self.joint(&link);
            // A leg in error is its own joint: the link keeps its place in the tree.
            let failed = joint.is_err();
            group.legs.push(Leg { joint: joint.unwrap_or(link.clone()), link });
            if failed {
                return Err(Reported);
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
            group.pin = self.new_name("a pin").ok();
        }
        Ok(())
    }

    fn joint(&mut self, link: &Ident) -> Parse<Ident> {
        let Some(group) = self.take_group(Delimiter::Parenthesis) else {
            return self.refuse_because(
                &format!("write what `{link}` stands on: `{link}(JOINT)`"),
                "an outer joint is a point where the letter says R, a guide where it says P",
            );
        };
        let mut inner = self.inside(&group);
        let joint = inner.joint_name();
        // Inside the parentheses a mistake is contained; the legs go on behind them.
        Ok(joint.unwrap_or_else(|Reported| link.clone()))
    }

    fn joint_name(&mut self) -> Parse<Ident> {
        const REASON: &str = "points are declared by `ground` or made by groups, guides by `guide`";
        if self.peek_ident(0).is_none() {
            return self.expected_because("the name of a point or a guide", REASON);
        }
        let joint = self.name_of("a point or a guide")?;
        self.take_punct(',');
        match self.at_end() {
            true => Ok(joint),
            false => self.expected_because("`)`", "a leg is one link and its one outer joint"),
        }
    }

    fn missing_braces(&mut self, keyword: &Ident) {
        let fields = match keyword.to_string().as_str() {
            "crank" => "{ length: …, angle: … }",
            "slider" => "{ slide: … }",
            "rrr" => "{ lengths: (…, …), mode: … }",
            "rrp" => "{ length: …, mode: … }",
            "prp" => "{ }",
            "rpp" => "{ slot: … }",
            _ => "{ … }",
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
    }

    fn fields(&mut self, braces: &Delimited) -> Vec<Field> {
        let mut inner = self.inside(braces);
        let mut fields = Vec::new();
        while !inner.at_end() {
            match inner.field() {
                Ok(field) => fields.push(field),
                Err(Reported) => {
                    inner.skip_field();
                    inner.take_punct(',');
                    continue;
                }
            }
            if inner.at_end() || inner.take_punct(',') {
                continue;
            }
            if inner.field_begins() {
                let found = inner.found();
                let _ = inner.refuse::<()>(&format!("write `,` in front of {found}"));
                continue;
            }
            let _ = match inner.is_punct(0, ';') {
                true => inner.refuse_because::<()>("write `,`", "fields are separated by commas"),
                false => inner.expected("`,` or `}`"),
            };
            inner.take_punct(';');
            inner.skip_field();
            inner.take_punct(',');
        }
        fields
    }

    fn field_begins(&self) -> bool {
        self.peek_ident(0).is_some() && self.is_punct(1, ':')
    }

    /// Goes to the `,` behind a field in error, or in front of the next field.
    fn skip_field(&mut self) {
        while !self.at_end() && !self.is_punct(0, ',') && !self.field_begins() {
            self.take();
        }
    }

    fn field(&mut self) -> Parse<Field> {
        let name = self.word("the name of a field")?;
        if !self.is_punct(0, ':') || self.is_sign([':', ':']) {
            if self.at_end() || self.is_punct(0, ',') {
                self.diagnostics.error(name.span(), format!("write `{name}: …`"));
                return Err(Reported);
            }
            return self.refuse(&format!("write `:` after `{name}`"));
        }
        self.take_punct(':');
        let value = match self.pair_begins() {
            true => FieldValue::Pair(self.pair("`(first, second)`")?),
            false if self.at_end() || self.is_punct(0, ',') => {
                return self.expected(&format!("the value of `{name}`"));
            }
            false => FieldValue::One(self.expression()?),
        };
        Ok(Field { name, value })
    }

    /// Whether the next token is parentheses around a comma.
    fn pair_begins(&self) -> bool {
        let Some(TokenTree::Group(group)) = self.peek(0) else { return false };
        let comma = |tree| matches!(tree, TokenTree::Punct(punct) if punct.as_char() == ',');
        group.delimiter() == Delimiter::Parenthesis && group.stream().into_iter().any(comma)
    }

    /// Whether `word` is a keyword of a group, or is used like one: in front of `link(joint)`
    /// and braces.
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
