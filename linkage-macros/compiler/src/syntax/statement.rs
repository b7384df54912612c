//! Statements without braces.
//!
//! Each function begins behind its keyword and names its statement as early as it can: a mistake
//! behind the name leaves the statement in the tree, so that what it declares is not reported
//! as missing elsewhere.

use proc_macro2::{Delimiter, Ident, TokenStream, TokenTree};

use super::openings::{Ending, opening};
use super::tokens::{Parse, Parser, Reported};
use super::tree::{
    Course, CrateStatement, ExportStatement, Expr, GroundStatement, GuideAnchor, GuideStatement,
    LetStatement, NumericsStatement, OutputItem, OutputStatement, ParamStatement, PointPlace,
    PointStatement, StatementKind,
};

const COORDINATES: &str = "`(x, y)`";

impl Parser<'_> {
    /// The statement whose first word is `keyword`, which was taken; `None` where the word
    /// begins none of these.
    pub(super) fn plain_statement(&mut self, keyword: &Ident) -> Option<Parse<StatementKind>> {
        let opening = opening(&keyword.to_string())?;
        let parsed = (opening.parse)(self, keyword);
        let has_braces = match opening.ends {
            Ending::Semicolon => false,
            Ending::Braces(_) => true,
            Ending::Either => self.ended_with_braces(),
        };
        if parsed.is_ok() && !has_braces {
            self.semicolon();
        }
        Some(parsed)
    }

    pub(super) fn param(&mut self) -> Parse<StatementKind> {
        self.leave_out_mut();
        let name = self.new_name("a parameter")?;
        let kind = match self.take_punct(':') {
            true => {
                let kind = self.word("`mode`, `length`, `angle` or `number`");
                match kind {
                    Ok(kind) => Some(kind),
                    Err(Reported) => {
                        self.skip_statement();
                        None
                    }
                }
            }
            false => None,
        };
        let default = self.default_of_param(&name);
        let default = self.or_skip(default, mistake(&name));
        Ok(StatementKind::Param(ParamStatement { name, kind, default }))
    }

    fn default_of_param(&mut self, name: &Ident) -> Parse<Expr> {
        if self.is_skipped() {
            return Err(Reported);
        }
        if !self.take_punct('=') {
            return self.refuse_because(
                &format!("give `{name}` a default: `param {name} = …;`"),
                "`new()` sets every parameter to its default",
            );
        }
        self.expression()
    }

    pub(super) fn named_value(&mut self) -> Parse<StatementKind> {
        self.leave_out_mut();
        let name = self.new_name("a value")?;
        let value = match () {
            () if self.take_punct('=') => self.expression(),
            () if self.is_punct(0, ':') => self.refuse_because(
                &format!("write `let {name} = …;`"),
                "the kind of a value follows from its expression",
            ),
            () => self.expected("`=`"),
        };
        let value = self.or_skip(value, mistake(&name));
        Ok(StatementKind::Let(LetStatement { name, value }))
    }

    pub(super) fn ground(&mut self, word: &str) -> Parse<StatementKind> {
        let mut points = Vec::new();
        loop {
            let name = match self.new_name("a point") {
                Ok(name) => name,
                Err(Reported) if points.is_empty() => return Err(Reported),
                Err(Reported) => {
                    self.skip_statement();
                    break;
                }
            };
            if let Some(frame) = self.points_of_a_frame(word, &name) {
                return self.inside(&frame).ground(word);
            }
            if self.coordinates_that_are_meant(word, &name) {
                points.push((name.clone(), [mistake(&name), mistake(&name)]));
                if self.take_punct(',') {
                    continue;
                }
                break;
            }
            if !self.is_group(0, Delimiter::Parenthesis) {
                let _ = self.refuse::<()>(&format!("write `{name}(x, y)`"));
                points.push((name.clone(), [mistake(&name), mistake(&name)]));
                self.skip_statement();
                break;
            }
            let coordinates = self.pair(COORDINATES)?;
            points.push((name, coordinates));
            if self.is_group(1, Delimiter::Parenthesis) && self.missing_comma() {
                continue;
            }
            if !self.take_punct(',') || self.is_punct(0, ';') || self.at_end() {
                break;
            }
            if self.comma_ends_the_statement() {
                break;
            }
        }
        Ok(StatementKind::Ground(GroundStatement { points }))
    }

    pub(super) fn guide(&mut self) -> Parse<StatementKind> {
        let name = self.new_name("a guide")?;
        let mut on = None;
        let line = self.line(&mut on);
        let (through, course) = self.or_skip(line, (GuideAnchor::Mistake, Course::Mistake));
        Ok(StatementKind::Guide(GuideStatement { name, on, through, course }))
    }

    fn line(&mut self, on: &mut Option<Ident>) -> Parse<(GuideAnchor, Course)> {
        const FORM: &str = "a guide is a point and a direction: `through (x, y) along 0deg` or \
                            `through A towards D`";
        if self.take_word("on") {
            *on = Some(self.name_of("a link")?);
        }
        if !self.take_word("through") {
            return self.expected_because("`through`", FORM);
        }
        let through = match self.is_group(0, Delimiter::Parenthesis) {
            true => GuideAnchor::At(self.pair(COORDINATES)?),
            false if self.peek_ident(0).is_none() => {
                return self.expected_because("a point or `(x, y)`", FORM);
            }
            false => GuideAnchor::Point(self.name_of("a point")?),
        };
        let course = match () {
            () if self.take_word("along") => Course::Along(self.expression()?),
            () if self.take_word("towards") => Course::Towards(self.name_of("a point")?),
            () => return self.expected_because("`along` or `towards`", FORM),
        };
        Ok((through, course))
    }

    pub(super) fn point(&mut self) -> Parse<StatementKind> {
        let name = self.new_name("a point")?;
        let mut on = None;
        let place = self.place(&name, &mut on);
        let place = self.or_skip(place, PointPlace::Mistake);
        Ok(StatementKind::Point(PointStatement { name, on, place }))
    }

    fn place(&mut self, name: &Ident, on: &mut Option<Ident>) -> Parse<PointPlace> {
        const FORMS: &str = "a place is `at (x, y)`, `at polar (r, angle)` or \
                             `at distances (r1, r2) left`";
        if self.is_group(0, Delimiter::Parenthesis) {
            return self.refuse_because(
                &format!("write `point {name} on LINK at (x, y)`"),
                "a fixed point is declared by `ground`",
            );
        }
        if self.take_word("on") {
            *on = Some(self.name_of("a link")?);
        }
        if !self.take_word("at") {
            let what = if on.is_some() { "`at`" } else { "`on` or `at`" };
            return self.expected_because(what, FORMS);
        }
        if self.take_word("polar") {
            return Ok(PointPlace::Polar(self.pair("`(r, angle)`")?));
        }
        if self.take_word("distances") {
            let distances = self.pair("`(r1, r2)`")?;
            let side = match self.peek_ident(0).is_some() && !self.statement_begins() {
                true => self.word("`left` or `right`")?,
                false => {
                    return self.expected_because(
                        "`left` or `right`",
                        "two places have these distances, one on either side of the link",
                    );
                }
            };
            return Ok(PointPlace::Distances(distances, side));
        }
        match self.is_group(0, Delimiter::Parenthesis) {
            true => Ok(PointPlace::Cartesian(self.pair(COORDINATES)?)),
            false => self.expected_because("`(x, y)`, `polar` or `distances`", FORMS),
        }
    }

    pub(super) fn output(&mut self) -> Parse<StatementKind> {
        let mut items = Vec::new();
        while !self.is_punct(0, ';') && !self.at_end() {
            let first = self.next;
            if self.output_item(&mut items).is_err() {
                self.skip_item(first);
                if self.take_punct(',') {
                    continue;
                }
                self.skip_statement();
                break;
            }
            if !self.take_punct(',') && !self.missing_comma() {
                break;
            }
            if self.comma_ends_the_statement() {
                break;
            }
        }
        if items.is_empty() && !self.is_skipped() {
            return self.refuse_because(
                "name what to compute: `output blade, BC.angle;`",
                "without this statement every moving point and link is computed",
            );
        }
        Ok(StatementKind::Output(OutputStatement { items, is_beside: false }))
    }

    /// Reports a `,` that is missing in front of a name.
    pub(super) fn missing_comma(&mut self) -> bool {
        // Behind a number a `*` is missing, not a comma.
        let number = matches!(self.previous(), Some(TokenTree::Literal(_)));
        let missing = self.peek_ident(0).is_some() && !number && !self.statement_begins();
        if missing {
            let found = self.found();
            let _ = self.refuse::<()>(&format!("write `,` in front of {found}"));
        }
        missing
    }

    fn output_item(&mut self, items: &mut Vec<OutputItem>) -> Parse<()> {
        if self.is_word(0, "all") || self.is_punct(0, '*') {
            return self.refuse_because(
                "leave this statement out",
                "without `output` every moving point and link is computed",
            );
        }
        if let (Some(name), true) = (self.peek_ident(0).cloned(), self.is_punct(1, ':')) {
            self.take();
            let value = self.as_written(1, is_end_of_item);
            let reason = "the name of a number is the field of the result";
            return self.refuse_because(&format!("write `{name} = {value}`"), reason);
        }
        if self.peek_ident(0).is_none() || !self.is_punct(1, '=') {
            let value = self.expression()?;
            let renamed_at = self.is_word(0, "as").then(|| self.here());
            let name = match renamed_at {
                Some(_) => {
                    self.take();
                    Some(self.new_name("an output")?)
                }
                None => None,
            };
            items.push(OutputItem { name, renamed_at, value });
            return Ok(());
        }
        let name = self.new_name("an output")?;
        self.take_punct('=');
        let value = self.expression();
        let failed = value.is_err();
        let value = value.unwrap_or(mistake(&name));
        items.push(OutputItem { name: Some(name), renamed_at: None, value });
        if failed { Err(Reported) } else { Ok(()) }
    }

    /// Goes to the `,` or the end behind an output in error.
    fn skip_item(&mut self, first: usize) {
        while ![',', ';'].iter().any(|&sign| self.is_punct(0, sign))
            && !self.at_end()
            && !self.statement_begins()
        {
            self.take();
        }
        self.give_up_since(first);
    }

    pub(super) fn numerics(&mut self) -> Parse<StatementKind> {
        let mode = self.word("`compensated`")?;
        let is_another = self.peek_ident(0).is_some() && !self.statement_begins();
        if is_another || self.is_punct(0, ',') {
            return self
                .expected_because("`;`", "`numerics` takes one word, for numbers of any width");
        }
        Ok(StatementKind::Numerics(NumericsStatement { mode }))
    }

    pub(super) fn export(&mut self) -> Parse<StatementKind> {
        Ok(StatementKind::Export(ExportStatement { what: self.word("`c` or `assemblies`")? }))
    }

    pub(super) fn crate_path(&mut self) -> Parse<StatementKind> {
        const FORM: &str = "write the path of `linkage-core`: `crate = ::linkage_core;`";
        if !self.take_punct('=') {
            return self.refuse(FORM);
        }
        let span = self.here();
        let mut tokens = TokenStream::new();
        while !self.at_end() && !self.is_punct(0, ';') && !self.statement_begins() {
            match self.take() {
                Some(TokenTree::Group(group)) if group.delimiter() == Delimiter::None => {
                    tokens.extend(group.stream());
                }
                Some(TokenTree::Group(_)) | None => break,
                Some(tree) => tokens.extend([tree]),
            }
        }
        match syn::parse2(tokens) {
            Ok(path) if can_be_imported_from(&path) => {
                Ok(StatementKind::Crate(CrateStatement { path }))
            }
            _ => {
                self.diagnostics.error(span, FORM);
                Err(Reported)
            }
        }
    }
}

fn is_end_of_item(tree: &TokenTree) -> bool {
    matches!(tree, TokenTree::Punct(end) if [',', ';'].contains(&end.as_char()))
}

/// Stands for an expression of the statement `name` that was reported.
fn mistake(name: &Ident) -> Expr {
    Expr::mistake(name.span())
}

/// True if a path may stand in an import: it leads through modules, and names no type.
fn can_be_imported_from(path: &syn::Path) -> bool {
    let is_start = |word: &Ident| ["self", "super", "crate"].iter().any(|start| word == start);
    let rooted = path.leading_colon.is_some();
    path.segments.iter().enumerate().all(|(at, segment)| {
        let climbs = segment.ident == "super" && path.segments[0].ident != "crate" && !rooted;
        let is_in_place = !is_start(&segment.ident) || (at == 0 && !rooted) || climbs;
        segment.arguments.is_none() && segment.ident != "Self" && is_in_place
    })
}
