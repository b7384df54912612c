//! `unknown` and `solve`: a number that an equation fixes.

use super::anatomy::Modes;
use proc_macro2::{Delimiter, Ident};

use super::tokens::{Parse, Parser};
use super::tree::{Expr, Solve, StatementKind, UnknownStatement};

const UNKNOWN: &str = "an unknown is `unknown theta: angle between (10deg, 170deg);`";
const SOLVE: &str = "it reads `solve theta { ram.slide = x, mode: falling }`";

impl Parser<'_> {
    pub(super) fn unknown(&mut self) -> Parse<StatementKind> {
        let name = self.new_name("an unknown")?;
        let mut kind = None;
        let between = self.ends_of_unknown(&name, &mut kind).map(Some);
        let between = self.or_skip(between, None);
        Ok(StatementKind::Unknown(UnknownStatement { name, kind, between }))
    }

    /// `: angle between (…, …)`
    fn ends_of_unknown(&mut self, name: &Ident, kind: &mut Option<Ident>) -> Parse<[Expr; 2]> {
        if !self.take_punct(':') {
            return self.refuse_because(
                &format!("say what `{name}` is: `unknown {name}: angle between (…, …)`"),
                "its kind tells radians from metres",
            );
        }
        *kind = Some(self.word("`angle` or `length`")?);
        if let Some(told) = self.interval_of_words(UNKNOWN) {
            told?;
        }
        if !self.take_word("between") {
            return self.expected_because("`between (…, …)`", UNKNOWN);
        }
        if !self.is_group(0, Delimiter::Parenthesis) {
            return self.expected_because("`(from, to)`", UNKNOWN);
        }
        let ends = self.pair("`(from, to)`")?;
        if self.is_punct(0, ',') && self.is_word(1, "near") {
            self.take();
            return self.refuse_because(
                &format!("write `near: …` in `solve {name} {{ … }}`"),
                "where a search begins may depend on what stands between the two",
            );
        }
        Ok(ends)
    }

    /// `solve theta { … }`, behind its first word.
    pub(super) fn solve(&mut self) -> Parse<StatementKind> {
        let unknown = self.name_of("an unknown")?;
        let Some(braces) = self.take_group(Delimiter::Brace) else {
            return self.expected_because("`{`", SOLVE);
        };
        let (equation, mode, near) = (None, None, None);
        let end = braces.span_close();
        let mut solve = Solve { unknown, equation, mode, near, end, is_read: true };
        let mut inner = self.inside(&braces);
        while !inner.at_end() {
            let first = inner.next;
            if inner.part_of_solve(&mut solve).is_err() {
                inner.skip_to_comma();
                inner.give_up_since(first);
                solve.is_read = false;
            }
            if !inner.take_punct(',') && !inner.at_end() {
                let _ = inner.expected::<()>("`,` or `}`");
                solve.is_read = false;
                inner.give_up();
            }
        }
        self.take_punct(';');
        Ok(StatementKind::Solve(solve))
    }

    /// The equation or a field.
    fn part_of_solve(&mut self, solve: &mut Solve) -> Parse<()> {
        let unknown = solve.unknown.clone();
        if let Some(field) = self.peek_ident(0).cloned()
            && self.is_punct(1, ':')
            && !self.is_sign_behind_a_name()
        {
            return self.field_of_solve(&field, solve);
        }
        if let Some(word) = self.peek_ident(0).map(ToString::to_string)
            && Modes::Trend.words().contains(&&word[..])
            && (self.is_punct(1, ',') || self.peek(1).is_none())
        {
            return self.refuse(&format!("write `mode: {word}`"));
        }
        let at = self.here();
        let left = self.expression()?;
        if self.is_sign(['=', '=']) {
            return self.refuse("write `=`: it is an equation, not a comparison");
        }
        if !self.take_punct('=') {
            return self.expected_because("`=`", SOLVE);
        }
        let right = self.expression()?;
        if solve.equation.is_some() {
            let message = format!("one equation fixes `{unknown}`; remove this one");
            self.diagnostics.error_because(at, message, "each unknown has an equation of its own");
            return Ok(());
        }
        solve.equation = Some([left, right]);
        Ok(())
    }

    /// `a::b`
    fn is_sign_behind_a_name(&self) -> bool {
        self.is_punct(1, ':') && self.is_punct(2, ':')
    }

    fn field_of_solve(&mut self, field: &Ident, solve: &mut Solve) -> Parse<()> {
        let text = field.to_string();
        let is_given = match &text[..] {
            "mode" => solve.mode.is_some(),
            "near" => solve.near.is_some(),
            _ => {
                return self.refuse_because(
                    &format!("`solve` has no field `{text}`"),
                    "its fields are `mode`, `rising` or `falling`, and `near`, where to begin",
                );
            }
        };
        if is_given {
            return self.refuse(&format!("the field `{text}` is given twice; remove one"));
        }
        self.take();
        self.take_punct(':');
        match &text[..] {
            "mode" => {
                let word = self.word("`rising` or `falling`")?;
                // Also where it is wrong, it is not missing.
                solve.mode = Some(word);
            }
            _ => solve.near = Some(self.expression()?),
        }
        Ok(())
    }
}
