//! Products of units behind a number: `15(N/m)`, `0.1(kg*m^2)`, `2(1/s)`.
//!
//! They are read from left to right. A `*` behind a `/` is refused: `N/m*s` is ambiguous.

use proc_macro2::{Delimiter, Group, Span, TokenTree};

use super::tokens::{Parse, Parser};
use super::tree::{BinaryOp, Expr, ExprKind, UnitPower};
use super::words::UNITS;

/// No quantity of mechanics has a higher power of a unit, and powers of powers must not overflow.
const HIGHEST_POWER: i32 = 9;

/// True if the parentheses hold units and no other names.
fn holds_units(group: &Group) -> bool {
    let mut names = group.stream().into_iter().filter_map(|tree| match tree {
        TokenTree::Ident(name) => Some(name.to_string()),
        TokenTree::Group(_) => Some(String::new()),
        _ => None,
    });
    let is_unit = |name: String| UNITS.contains(&name.as_str());
    names.next().is_some_and(is_unit) && names.all(is_unit)
}

impl Parser<'_> {
    /// The product of units that stands next, if one does.
    pub(super) fn unit_product(&mut self) -> Parse<Option<Vec<UnitPower>>> {
        let Some(TokenTree::Group(group)) = self.peek(0) else { return Ok(None) };
        if group.delimiter() != Delimiter::Parenthesis || !holds_units(group) {
            return Ok(None);
        }
        let group = group.clone();
        self.take();
        let mut inner = self.inside(&group);
        let units = inner.units();
        if units.is_err() {
            inner.give_up();
        }
        units.map(Some)
    }

    /// `100mm^2`, behind its unit: the area that is meant, and how it is written.
    pub(super) fn power_of_unit(&mut self, digits: &str, unit: &str) -> Option<Vec<UnitPower>> {
        let Some(TokenTree::Literal(power)) = self.peek(1).filter(|_| self.is_punct(0, '^')) else {
            return None;
        };
        let power: i32 = power.to_string().parse().ok()?;
        if !(1..=HIGHEST_POWER).contains(&power) || !UNITS.contains(&unit) {
            return None;
        }
        let _ = self.refuse_because::<()>(
            &format!("write `{digits}({unit}^{power})`"),
            "a unit's power stands in parentheses with it; that of a quantity is `x * x` or `pow(x, 2)`",
        );
        self.take();
        self.take();
        Some(vec![(unit.to_string(), power)])
    }

    /// `120kg*m^2`, at the power, which no name has: the quantity that is meant, and how it is written.
    pub(super) fn units_without_parentheses(
        &mut self,
        first: &Expr,
        rest: &[(BinaryOp, Expr)],
    ) -> Option<ExprKind> {
        if let ExprKind::Negate(inner) = &first.kind {
            let (kind, span) = (self.units_without_parentheses(inner, rest)?, first.span);
            return Some(ExprKind::Negate(Box::new(Expr { kind, span })));
        }
        let ExprKind::Number { digits, units } = &first.kind else { return None };
        let mut units = units.clone();
        for (operator, operand) in rest {
            let sign = if *operator == BinaryOp::Div { -1 } else { 1 };
            let ExprKind::Name(name) = &operand.kind else { return None };
            units.push((name.to_string(), sign));
        }
        let are_units = units.iter().all(|(name, _)| UNITS.contains(&name.as_str()));
        if !are_units || units.len() <= rest.len() {
            return None;
        }
        let power = self.power_of_last(&mut units)?;
        let written = units.iter().enumerate().map(|(nth, (name, power))| {
            let sign = ["", if *power < 0 { "/" } else { "*" }][usize::from(nth > 0)];
            let power = power.abs();
            format!("{sign}{name}{}", if power > 1 { format!("^{power}") } else { String::new() })
        });
        let message = format!("write `{digits}({})`", written.collect::<String>());
        let at = first.span.to(power.into());
        self.diagnostics.error_because(at, message, "a product of units stands in parentheses");
        Some(ExprKind::Number { digits: digits.clone(), units })
    }

    /// Takes `^2`, for the last of the units; where it stands.
    fn power_of_last(&mut self, units: &mut [UnitPower]) -> Option<Span> {
        let Some(TokenTree::Literal(literal)) = self.peek(1).filter(|_| self.is_punct(0, '^'))
        else {
            return None;
        };
        let (power, at) = (literal.to_string().parse::<i32>().ok()?, literal.span());
        let (_, last) = units.last_mut().filter(|_| (1..=HIGHEST_POWER).contains(&power))?;
        *last *= power;
        self.take();
        self.take();
        Some(at)
    }

    fn units(&mut self) -> Parse<Vec<UnitPower>> {
        let mut units = Vec::new();
        let mut sign = 1;
        if self.is_number("1") {
            self.take();
            if !self.is_punct(0, '/') {
                return self.expected_because("`/`", "a leading `1` is divided by a unit: `(1/s)`");
            }
        } else {
            units.push(self.unit_power(sign)?);
        }
        while !self.at_end() {
            if self.take_punct('/') {
                sign = -1;
            } else if self.is_punct(0, '*') && sign < 0 {
                return self.refuse_because(
                    "write every `*` in front of the first `/`",
                    "units are read from left to right, and `N/m*s` could mean two things",
                );
            } else if !self.take_punct('*') {
                return self.expected_because("`*`, `/` or `)`", "units are joined by `*` and `/`");
            }
            units.push(self.unit_power(sign)?);
        }
        Ok(units)
    }

    /// `m^2`
    fn unit_power(&mut self, sign: i32) -> Parse<UnitPower> {
        let unit = match self.peek_ident(0).map(ToString::to_string) {
            Some(unit) => unit,
            None => return self.expected("a unit"),
        };
        self.take();
        if !self.take_punct('^') {
            return Ok((unit, sign));
        }
        let negative = self.take_punct('-');
        let power = match self.peek(0) {
            Some(TokenTree::Literal(literal)) => literal.to_string().parse::<i32>().ok(),
            _ => None,
        };
        match power.filter(|power| (1..=HIGHEST_POWER).contains(power)) {
            Some(power) => {
                self.take();
                Ok((unit, if negative { -power } else { power } * sign))
            }
            None => self.expected_because("a whole number from 1 to 9", "as in `m^2`"),
        }
    }

    fn is_number(&self, text: &str) -> bool {
        matches!(self.peek(0), Some(TokenTree::Literal(literal)) if literal.to_string() == text)
    }
}
