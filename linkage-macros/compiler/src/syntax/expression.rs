//! Expressions: `+ - * /`, unary minus, calls, members, numbers with units.

use proc_macro2::{Delimiter, Group, Ident, Span, TokenTree};

use super::aftermath::placeholder;
use super::number;
use super::tokens::{Parse, Parser, Reported};
use super::tree::{BinaryOp, Expr, ExprKind};
use super::words;

/// Deeper nesting is no formula; it would only exhaust the stack.
///
/// A level takes most in the parser of a compiler that is not optimised: 7 KiB (measured, rustc
/// 1.95), which is 700 KiB for all of them. The smallest stacks in use are those of an editor's
/// server, the 2 MiB that Rust gives a thread. The operands of a sum and the named expressions
/// stand side by side. They are walked in a loop and have no limit; `fuzz/large.rs` compiles both.
const DEEPEST: usize = 100;

/// Members that are easily taken for functions of a link.
const MEMBERS: [&str; 6] = ["angle", "slide", "margin", "transmission", "x", "y"];

const OPERAND: &str = "a number or a name";

/// Words under which a user may look for a rate among the members of a point.
pub(crate) const RATES: [&str; 7] = ["velocity", "acceleration", "speed", "rate", "vx", "vy", "v"];

/// Why no force reads a reaction, and what to write where friction is meant.
pub(crate) const FRICTION: &str = "a reaction follows from all forces, so none can depend on it; \
                                   `friction 0.1 at C radius 8mm` does, and `friction 0.1 on ram` of \
                                   what slides";

impl Parser<'_> {
    pub fn expression(&mut self) -> Parse<Expr> {
        let sum = self.chain(&[('+', BinaryOp::Add), ('-', BinaryOp::Sub)], |parser| {
            parser.chain(&[('*', BinaryOp::Mul), ('/', BinaryOp::Div)], Self::operand)
        })?;
        self.mark_expression();
        Ok(sum)
    }

    /// Operands joined by operators of one precedence, from left to right.
    fn chain(
        &mut self,
        operators: &[(char, BinaryOp)],
        operand: impl Fn(&mut Self) -> Parse<Expr>,
    ) -> Parse<Expr> {
        let first = self.here();
        let left = operand(self)?;
        let mut rest = Vec::new();
        while let Some(operator) = self.take_operator(operators) {
            rest.push((operator, operand(self)?));
        }
        if rest.is_empty() {
            return Ok(left);
        }
        if let Some(units) = self.units_without_parentheses(&left, &rest) {
            return Ok(Expr { kind: units, span: self.since(first) });
        }
        Ok(Expr { kind: ExprKind::Chain(Box::new(left), rest), span: self.since(first) })
    }

    fn take_operator(&mut self, operators: &[(char, BinaryOp)]) -> Option<BinaryOp> {
        let another = operators
            .iter()
            .any(|&(sign, _)| self.is_sign([sign, '=']) || self.is_sign([sign, '>']))
            || self.is_sign(['*', '*']);
        let &(sign, operator) = operators.iter().find(|&&(sign, _)| self.is_punct(0, sign))?;
        (!another && self.take_punct(sign)).then_some(operator)
    }

    fn operand(&mut self) -> Parse<Expr> {
        if self.depth > DEEPEST {
            return self.refuse_because(
                "name a part of this expression with `let`",
                "it is nested more than 100 deep",
            );
        }
        let first = self.here();
        if self.take_punct('-') {
            self.depth += 1;
            let operand = self.operand()?;
            self.depth -= 1;
            let kind = ExprKind::Negate(Box::new(operand));
            return Ok(Expr { kind, span: self.since(first) });
        }
        match self.peek(0).cloned() {
            Some(TokenTree::Literal(literal)) => self.number(&literal.to_string()),
            Some(TokenTree::Ident(name)) => self.named(name),
            Some(TokenTree::Group(group)) => self.parenthesised(&group),
            Some(TokenTree::Punct(punct)) => match punct.as_char() {
                '+' => self.expected_because(OPERAND, "a positive number has no sign"),
                '|' => self.expected_because(OPERAND, "a distance is written `distance(P, Q)`"),
                '.' => match self.bare_decimal() {
                    Some(Ok(())) | None => self.expected(OPERAND),
                    Some(Err(reported)) => Err(reported),
                },
                _ => self.expected(OPERAND),
            },
            _ => self.expected(OPERAND),
        }
    }

    fn number(&mut self, text: &str) -> Parse<Expr> {
        let first = self.here();
        let mut number = match number::number(text) {
            Ok(number) => number,
            Err((message, reason)) => return self.refuse_because(&message, reason),
        };
        self.take();
        if let Some(unit) = self.loose_unit(number.unit.is_some()) {
            let _ = self.refuse_because::<()>(
                &format!("drop the space: `{text}{unit}`"),
                "a unit stands directly behind its number",
            );
            self.take();
            number.unit = Some(unit);
        }
        if self.is_punct(0, '.') {
            return self.member_of_number(text);
        }
        let product = match &number.unit {
            None => self.unit_product()?,
            Some(unit) => self.power_of_unit(&number.digits, unit),
        };
        let span = self.since(first);
        let negative = number.negative;
        let kind = match product {
            Some(units) => ExprKind::Number { digits: number.digits, units },
            None => number.into_kind(),
        };
        let mut number = Expr { kind, span };
        if negative {
            number = Expr { kind: ExprKind::Negate(Box::new(number)), span };
        }
        Ok(number)
    }

    /// A unit that was written apart from its number.
    fn loose_unit(&self, has_unit: bool) -> Option<String> {
        let word = self.peek_ident(0)?.to_string();
        let is_field = self.is_punct(1, ':');
        let is_unit =
            words::UNITS.contains(&word.as_str()) && !words::LIKELY_NAMES.contains(&word.as_str());
        (!has_unit && !is_field && is_unit).then_some(word)
    }

    /// `5.mm` and `2.sqrt()`: Rust reads the point as that of a member.
    fn member_of_number(&mut self, number: &str) -> Parse<Expr> {
        let Some(member) = self.peek_ident(1).map(Ident::to_string) else {
            self.take_punct('.');
            return self.expected("a digit behind the decimal point");
        };
        let meant = match self.is_group(2, Delimiter::Parenthesis) {
            true => format!("{member}({number})"),
            false if words::UNITS.contains(&member.as_str()) => format!("{number}{member}"),
            false => return self.refuse("write a digit behind the decimal point"),
        };
        self.refuse_because(
            &format!("write `{meant}`"),
            "a point behind a number must be followed by a digit",
        )
    }

    fn parenthesised(&mut self, group: &Group) -> Parse<Expr> {
        if !matches!(group.delimiter(), Delimiter::Parenthesis | Delimiter::None) {
            return self.expected_because(OPERAND, "expressions are grouped by `(` and `)`");
        }
        self.take();
        let mut inner = self.inside(group);
        let value = inner.expression().and_then(|value| match inner.at_end() {
            true => Ok(value),
            false if inner.is_punct(0, ',') => inner.refuse_because(
                "write one number here, not a pair",
                "only coordinates and fields such as `lengths` take two",
            ),
            false => inner.expected("`)`"),
        });
        if value.is_err() {
            inner.give_up();
        }
        let span = group.span().into();
        Ok(Expr { kind: value.map_or(ExprKind::Mistake, |value| value.kind), span })
    }

    /// Parses an operand that begins with a name: the name alone, a member, a call.
    fn named(&mut self, name: Ident) -> Parse<Expr> {
        let (name, word) = match self.aftermath.was_refused(&name) {
            true => (placeholder(&name), String::new()),
            false => (name.clone(), name.to_string()),
        };
        if words::is_rust_keyword(&word) {
            return self.expected_because(OPERAND, &format!("`{word}` is a Rust keyword"));
        }
        if words::is_reserved(&word) {
            return self.expected_because(OPERAND, &format!("`{word}` is a reserved word"));
        }
        self.take();
        let first = name.span();
        if self.is_sign([':', ':']) {
            return self.path(first);
        }
        if self.take_punct('.') {
            return self.member(name);
        }
        let Some(group) = self.take_group(Delimiter::Parenthesis) else {
            return Ok(Expr { kind: ExprKind::Name(name), span: first.into() });
        };
        let arguments = self.arguments(&group);
        Ok(Expr { kind: ExprKind::Call(name, arguments), span: self.since(first) })
    }

    fn member(&mut self, link: Ident) -> Parse<Expr> {
        let first = link.span();
        let member = self.word("the name of a member, such as `angle`")?;
        if let Some(group) = self.take_group(Delimiter::Parenthesis) {
            let message =
                match group.stream().is_empty() && MEMBERS.iter().any(|&known| member == known) {
                    true => format!("write `{link}.{member}` without parentheses"),
                    false => format!("write `{member}({link})`"),
                };
            self.diagnostics.error_because(
                member.span(),
                message,
                "expressions have functions and members, but no methods",
            );
            return Err(Reported);
        }
        if self.is_punct(0, '.') {
            if let Some(part) = self.part_of_a_reaction(&member) {
                let kind = ExprKind::Part(Box::new([link, member, part]));
                return Ok(Expr { kind, span: self.since(first) });
            }
            if let Some((message, reason)) = self.member_of_member(&link, &member) {
                let is_told = reason == FRICTION
                    && std::mem::replace(&mut self.aftermath.reads_a_reaction, true);
                return match is_told {
                    true => Err(Reported),
                    false => self.refuse_because(&message, reason),
                };
            }
            return self.expected_because(
                "the end of a member",
                "a member is one name behind a link: `BC.angle`",
            );
        }
        Ok(Expr { kind: ExprKind::Member(link, member), span: self.since(first) })
    }

    /// The last name of `BC.C.x`, where results are asked for.
    fn part_of_a_reaction(&mut self, member: &Ident) -> Option<Ident> {
        let is_rate = |last: &Ident| ["rate", "velocity", "speed"].iter().any(|rate| last == rate);
        let is_whole = MEMBERS.iter().any(|known| member == known);
        let last = self.peek_ident(1).filter(|last| self.asks && !is_whole && !is_rate(last))?;
        let last = last.clone();
        self.take_punct('.');
        self.take();
        Some(last)
    }

    /// `H.y.rate`, `beam.S.x`: what is written in its place.
    fn member_of_member(&self, link: &Ident, member: &Ident) -> Option<(String, &'static str)> {
        let last = self.peek_ident(1)?.to_string();
        let is_coordinate = |name: &str| ["x", "y"].contains(&name);
        match last.as_str() {
            "rate" | "velocity" | "speed" => Some((
                format!("write `rate({link}.{member})`"),
                "in the values of forces and torques; of outputs, `velocity` gives the rates",
            )),
            // Any other member is a point of a link, or the reaction on the link there.
            _ if MEMBERS.iter().any(|known| member == known) => None,
            _ if is_coordinate(&last) => Some((
                format!(
                    "write `{member}.{last}` for the point; only an output reads the reaction \
                     `{link}.{member}`"
                ),
                FRICTION,
            )),
            "normal" | "couple" | "friction" => {
                Some((format!("only an output reads the reaction `{link}.{member}`"), FRICTION))
            }
            _ => None,
        }
    }

    /// `std::f64::consts::PI`, `Side::Left`.
    fn path(&mut self, first: Span) -> Parse<Expr> {
        const COMPUTED_ELSEWHERE: &str =
            "what Rust computes elsewhere is not known when the mechanism is compiled";
        let mut last = None;
        while self.take_sign([':', ':']) {
            last = self.word("a name")?.into();
        }
        let last = last.map(|last| last.to_string());
        let (message, reason) = match last.as_deref() {
            Some("PI") => ("write `pi`", COMPUTED_ELSEWHERE),
            Some("Left") => ("write `left`", "a mode is one word"),
            Some("Right") => ("write `right`", "a mode is one word"),
            Some("Ahead") => ("write `ahead`", "a mode is one word"),
            Some("Behind") => ("write `behind`", "a mode is one word"),
            _ => ("declare this number with `param` or `let`", COMPUTED_ELSEWHERE),
        };
        self.diagnostics.error_because(first, message, reason);
        Err(Reported)
    }

    fn arguments(&mut self, group: &Group) -> Vec<Expr> {
        let mut inner = self.inside(group);
        let mut arguments = Vec::new();
        while !inner.at_end() {
            let (first, span) = (inner.next, inner.here());
            let mut argument = inner.expression();
            if argument.is_ok() && !inner.at_end() && !inner.is_punct(0, ',') {
                argument = inner.expected("`,` or `)`");
            }
            if argument.is_err() {
                inner.skip_to_comma();
                inner.give_up_since(first);
            }
            // An argument that was read in part counts as a mistake.
            arguments.push(argument.unwrap_or(Expr::mistake(span)));
            inner.take_punct(',');
        }
        arguments
    }

    /// Two expressions in parentheses, written as `form`. Mistakes inside the parentheses stay
    /// inside.
    pub(super) fn pair(&mut self, form: &str) -> Parse<[Expr; 2]> {
        let Some(group) = self.take_group(Delimiter::Parenthesis) else {
            return self.expected(form);
        };
        let mut inner = self.inside(&group);
        let pair = inner.two(form);
        if pair.is_err() {
            inner.give_up();
        }
        Ok(pair.unwrap_or_else(|Reported| [(); 2].map(|()| Expr::mistake(group.span()))))
    }

    fn two(&mut self, form: &str) -> Parse<[Expr; 2]> {
        if self.at_end() {
            return self.expected_because("two values", &format!("write {form}"));
        }
        let first = self.expression();
        if first.is_err() {
            self.skip_to_comma();
        }
        if !self.take_punct(',') {
            first?;
            return match self.comma_follows() {
                true => self.expected("`,`"),
                false => self.expected_because("`,` and a second value", &format!("write {form}")),
            };
        }
        if self.at_end() {
            first?;
            return self.expected_because("a second value", &format!("write {form}"));
        }
        let second = self.expression()?;
        // Behind a mistake it is not known which value is the second.
        let first = first?;
        if self.at_end() || (self.take_punct(',') && self.at_end()) {
            return Ok([first, second]);
        }
        match self.reason() {
            Some(_) => self.expected("`)`"),
            None => self.expected_because("`)` after two values", &format!("write {form}")),
        }
    }

    /// True if a comma follows further on, so that none is missing here.
    fn comma_follows(&self) -> bool {
        (0..)
            .map_while(|ahead| self.peek(ahead))
            .any(|tree| matches!(tree, TokenTree::Punct(punct) if punct.as_char() == ','))
    }
}
