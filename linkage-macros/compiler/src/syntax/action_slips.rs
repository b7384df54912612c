//! Habits in statements about forces and searches, each told with the numbers and names that were written.

use proc_macro2::{Delimiter, TokenTree};

use super::drawn_slips::{parts, written};
use super::tokens::{Parse, Parser};
use super::words;

impl Parser<'_> {
    /// `friction 10% at A`, behind the number.
    pub(super) fn percentage(&mut self) -> Option<Parse<()>> {
        let Some(TokenTree::Literal(percent)) = self.previous() else { return None };
        let value: f64 = percent.to_string().parse().ok().filter(|_| self.is_punct(0, '%'))?;
        let message = format!("write `{}` in place of `{percent}%`", value / 100.0);
        Some(self.refuse_because(&message, "a coefficient is a number"))
    }

    /// `friction 0.1 at A diameter 20mm`, behind the pin.
    pub(super) fn diameter(&mut self) -> Option<Parse<()>> {
        if !self.is_word(0, "diameter") {
            return None;
        }
        let message = format!("write `radius {} / 2`", self.rest_of_statement(1));
        Some(self.refuse_because(&message, "the couple is coefficient × radius × load"))
    }

    /// `between E and (0, 0)`, in front of an end.
    pub(super) fn end_without_a_name(&mut self) -> Option<Parse<()>> {
        let Some(TokenTree::Group(group)) = self.peek(0) else { return None };
        let [x, y] = &parts(group)[..] else { return None };
        let message = format!("name a point here, and declare it: `ground P({x}, {y});`");
        let reason = "an end is a point or a link, by its name";
        let is_pair = group.delimiter() == Delimiter::Parenthesis;
        is_pair.then(|| self.refuse_because(&message, reason))
    }

    /// `damper d between E and A { … }`: the spring that is meant.
    pub(super) fn spring_for_a_damper(&self) -> Option<String> {
        let is_braces = |tree: &TokenTree| matches!(tree, TokenTree::Group(own) if own.delimiter() == Delimiter::Brace);
        let ends = self.as_written(1, is_braces);
        let braces = self.trees.iter().skip(self.next).find(|tree| is_braces(tree));
        let (true, Some(braces)) = (ends.contains("between"), braces) else {
            return words::built_by("damper").map(str::to_string);
        };
        let fields = written([braces.clone()]);
        Some(format!("a damper is a spring without stiffness: `spring {ends} {fields}`"))
    }

    /// `force f along bed on P`, behind the value, which stood at `value`.
    pub(super) fn force_along_a_line(&mut self, value: &str) -> Option<Parse<()>> {
        let along = self.peek_ident(1).filter(|_| self.is_word(0, "along"))?;
        let message = format!("write `force ({value}, 0) in {along} on P`");
        let reason = "behind `in` stands the link or guide along whose axes the components lie, and behind `on` a point";
        Some(self.refuse_because(&message, reason))
    }

    /// `unknown theta: angle from 0 to 90deg`, behind the kind.
    pub(super) fn interval_of_words(&mut self, form: &str) -> Option<Parse<()>> {
        if !self.is_word(0, "from") && !self.is_word(0, "in") {
            return None;
        }
        let is_to = |tree: &TokenTree| matches!(tree, TokenTree::Ident(word) if word == "to");
        let first = self.as_written(1, is_to);
        let rest = self.rest_of_statement(1);
        let second = rest.strip_prefix(&first)?.trim().strip_prefix("to")?.trim().to_string();
        let message = format!("write `between ({first}, {second})`");
        Some(self.refuse_because(&message, form))
    }
}
