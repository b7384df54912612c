//! `input`: the numbers that a machine is driven by, plain ones of a kind and quantities of a drawing.

use proc_macro2::{Delimiter, Group, Ident};

use super::tokens::{Parse, Parser, Reported};
use super::tree::{Expr, InputSetStatement, InputStatement, SetCoordinate, StatementKind};

impl Parser<'_> {
    /// `input s, x: length;` or `input a = AB.angle, x = tool.x;`
    pub(super) fn input(&mut self) -> Parse<StatementKind> {
        if self.is_group(0, Delimiter::Brace) {
            let reason = "a set of inputs has a name: `input motors { … }`";
            return self.expected_because("the name of an input", reason);
        }
        let mut names = vec![self.new_name("an input")?];
        if let Some(braces) = self.take_group(Delimiter::Brace) {
            let coordinates = self.coordinates_of_a_set(&names[0], &braces);
            return Ok(StatementKind::InputSet(InputSetStatement {
                name: names.remove(0),
                coordinates,
            }));
        }
        if self.is_punct(0, '=') {
            let of = self.quantities(&mut names);
            return Ok(StatementKind::Input(InputStatement { names, kind: None, of }));
        }
        while self.take_punct(',') || (!self.is_punct(1, ';') && self.missing_comma()) {
            if self.peek_ident(0).is_none() {
                break;
            }
            names.extend(self.new_name("an input"));
        }
        let first = names[0].clone();
        let kind = self.kind_of_input(&first).map(Some);
        let kind = self.or_skip(kind, None);
        Ok(StatementKind::Input(InputStatement { names, kind, of: Vec::new() }))
    }

    /// The quantities that inputs are, from the `=` behind the first name on; names are added as they are read.
    fn quantities(&mut self, names: &mut Vec<Ident>) -> Vec<Expr> {
        let mut of = Vec::new();
        while let Some(name) = names.get(of.len()).cloned() {
            let quantity = self.quantity_of(&name);
            of.push(self.or_skip(quantity, Expr::mistake(name.span())));
            if self.is_skipped() || !self.take_punct(',') || self.is_punct(0, ';') || self.at_end()
            {
                break;
            }
            match self.new_name("an input") {
                Ok(name) => names.push(name),
                Err(Reported) => self.skip_statement(),
            }
        }
        of
    }

    /// `x = tool.x, y` in the braces of a set.
    fn coordinates_of_a_set(&mut self, set: &Ident, braces: &Group) -> Vec<SetCoordinate> {
        let mut inner = self.inside(braces);
        let mut coordinates = Vec::new();
        while !inner.at_end() {
            match inner.coordinate_of_a_set() {
                Ok(coordinate) => coordinates.push(coordinate),
                Err(Reported) => {
                    inner.give_up();
                    return coordinates;
                }
            }
        }
        if coordinates.is_empty() {
            let message = format!("say what `{set}` drives: `input {set} {{ x = tool.x }}`");
            self.diagnostics.error(set.span(), message);
        }
        coordinates
    }

    fn coordinate_of_a_set(&mut self) -> Parse<SetCoordinate> {
        let name = self.new_name("an input")?;
        let of = match self.take_punct('=') {
            true => Some(self.expression()?),
            false => None,
        };
        if !self.take_punct(',') && !self.at_end() {
            return self.expected_because("`,` or `}`", "a set is `{ x = tool.x, y = tool.y }`");
        }
        Ok(SetCoordinate { name, of })
    }

    fn quantity_of(&mut self, name: &Ident) -> Parse<Expr> {
        if !self.take_punct('=') {
            return self.refuse_because(
                &format!("say what `{name}` is: `{name} = tool.x`"),
                "inputs of a kind, without a quantity, have a statement of their own",
            );
        }
        self.expression()
    }

    fn kind_of_input(&mut self, name: &Ident) -> Parse<Ident> {
        if !self.take_punct(':') {
            return self.refuse_because(
                &format!("say what `{name}` is: `input {name}: angle;` or `input {name}: length;`"),
                "its kind tells radians from metres",
            );
        }
        let kind = self.word("`angle` or `length`")?;
        match () {
            () if self.is_punct(0, ',') => self.refuse_because(
                "end this statement with `;`",
                "inputs of another kind have a statement of their own",
            ),
            () if self.is_punct(0, '/') => self.refuse_because(
                &format!("end this statement behind `{kind}`"),
                "rates are no inputs of their own: `velocity` and `motion` take them",
            ),
            () if self.is_punct(0, '=') => self.refuse_because(
                "write `param` for a number with a default",
                "an input is an argument of every call",
            ),
            () => Ok(kind),
        }
    }
}
