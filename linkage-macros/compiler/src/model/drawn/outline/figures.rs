//! Numbers of the drawing: how each is written in the declaration of the groups, and its value.
//!
//! Where a number is an exact decimal it is written as one, in the unit of the drawing; where it is
//! not, it stays an expression of what the user has written, so that a parameter in a pin is a
//! parameter of the solver.

use std::f64::consts::TAU;

use proc_macro2::{Ident, Span};

use crate::exact::Exact;
use crate::syntax::tree::{BinaryOp, Expr, ExprKind};

use crate::model::as_drawn::whole_turns;
use crate::model::units::unit;

/// A number of the drawing.
#[derive(Clone)]
pub(in crate::model::drawn) struct Figure {
    pub text: Expr,
    pub value: f64,
    /// The value without error, where no parameter is in it.
    pub exact: Option<Exact>,
    /// The power of metres in it.
    power: i32,
}

impl Figure {
    pub(in crate::model::drawn) fn length(text: Expr, value: f64, exact: Option<Exact>) -> Self {
        Self { text, value, exact, power: 1 }
    }

    pub(in crate::model::drawn) fn plain(text: Expr, value: f64, exact: Option<Exact>) -> Self {
        Self { text, value, exact, power: 0 }
    }

    /// Zero whatever the parameters are.
    pub(in crate::model::drawn) fn is_zero(&self) -> bool {
        self.exact.as_ref().is_some_and(Exact::is_zero)
    }

    /// The number one, no length of a metre.
    fn is_one(&self) -> bool {
        self.power == 0 && self.exact.as_ref().and_then(Exact::to_integer) == Some(1)
    }
}

/// Writes numbers in the unit of the drawing, with the place that messages about them point to.
#[derive(Clone)]
pub(in crate::model::drawn) struct Pen {
    /// The unit of lengths; bare numbers where there is none.
    pub unit: Option<String>,
    pub at: Span,
}

/// A constant of the arithmetic below.
fn folded<T>(a: &Figure, b: &Figure, f: impl FnOnce(&Exact, &Exact) -> T) -> Option<T> {
    Some(f(a.exact.as_ref()?, b.exact.as_ref()?))
}

impl Pen {
    pub(in crate::model::drawn) fn at(&self, at: Span) -> Self {
        Self { at, ..self.clone() }
    }

    fn expr(&self, kind: ExprKind) -> Expr {
        Expr { kind, span: self.at.into() }
    }

    fn chain(&self, a: &Figure, operator: BinaryOp, b: &Figure) -> Expr {
        let rest = vec![(operator, b.text.clone())];
        self.expr(ExprKind::Chain(Box::new(a.text.clone()), rest))
    }

    fn call(&self, function: &str, arguments: &[&Figure]) -> Expr {
        let arguments = arguments.iter().map(|argument| argument.text.clone()).collect();
        self.expr(ExprKind::Call(Ident::new(function, self.at), arguments))
    }

    /// The number as a decimal, where it is one.
    fn decimal(&self, value: &Exact, power: i32) -> Option<Expr> {
        let (mut scaled, mut units) = (value.clone(), Vec::new());
        if let (Some(name), true) = (&self.unit, power != 0) {
            let (_, factor) = unit(name)?;
            for _ in 0..power.unsigned_abs() {
                scaled = if power > 0 { scaled.div(&factor)? } else { scaled.mul(&factor) };
            }
            units.push((name.clone(), power));
        }
        self.literal(&scaled, units)
    }

    fn literal(&self, value: &Exact, units: Vec<(String, i32)>) -> Option<Expr> {
        let text = value.to_string();
        let digits = text.strip_prefix('-').unwrap_or(&text);
        if !digits.bytes().all(|digit| digit.is_ascii_digit() || digit == b'.') {
            return None;
        }
        let number = self.expr(ExprKind::Number { digits: digits.to_string(), units });
        Some(match text.starts_with('-') {
            true => self.expr(ExprKind::Negate(Box::new(number))),
            false => number,
        })
    }

    fn made(
        &self,
        (value, power): (f64, i32),
        exact: Option<Exact>,
        text: impl FnOnce() -> Expr,
    ) -> Figure {
        if let Some(long) = exact.as_ref().filter(|exact| exact.is_too_long()) {
            return self.rounded(long, (value, power));
        }
        let decimal = exact.as_ref().and_then(|exact| self.decimal(exact, power));
        Figure { text: decimal.unwrap_or_else(text), value, exact, power }
    }

    /// A number that has more digits than one that is written may have, to about 32 of them: the sum of two floats.
    fn rounded(&self, long: &Exact, (value, power): (f64, i32)) -> Figure {
        let units = match (&self.unit, power) {
            (None, _) | (_, 0) => Vec::new(),
            _ => vec![("m".to_string(), power)],
        };
        let part = |value: f64| {
            let digits = format!("{:?}", value.abs());
            let exact = Exact::decimal(&digits).unwrap_or_else(|| Exact::integer(0));
            let text = self.expr(ExprKind::Number { digits, units: units.clone() });
            match value < 0.0 {
                true => (exact.neg(), self.expr(ExprKind::Negate(Box::new(text)))),
                false => (exact, text),
            }
        };
        let (first, text) = part(long.to_f64());
        let (second, rest) = part(long.sub(&first).to_f64());
        Figure { text: sum(text, rest), value, exact: Some(first.add(&second)), power }
    }

    /// The number written as a decimal, where it is one.
    pub(in crate::model::drawn) fn as_decimal(&self, number: Figure) -> Figure {
        let Figure { text, value, exact, power } = number;
        self.made((value, power), exact, || text)
    }

    pub(in crate::model::drawn) fn zero(&self) -> Figure {
        let digits = "0".to_string();
        let text = self.expr(ExprKind::Number { digits, units: Vec::new() });
        Figure { text, value: 0.0, exact: Some(Exact::integer(0)), power: 1 }
    }

    /// The direction of the x of a frame in that frame.
    pub(in crate::model::drawn) fn x_axis(&self) -> [Figure; 2] {
        [1, 0].map(|value| self.whole(value))
    }

    /// A whole number, of no unit.
    pub(in crate::model::drawn) fn whole(&self, value: i64) -> Figure {
        let exact = Exact::integer(value);
        self.as_decimal(Figure::plain(self.zero().text, value as f64, Some(exact)))
    }

    pub(in crate::model::drawn) fn add(&self, a: &Figure, b: &Figure) -> Figure {
        match (a.is_zero(), b.is_zero()) {
            (true, _) => b.clone(),
            (_, true) => a.clone(),
            _ => self.made((a.value + b.value, a.power), folded(a, b, Exact::add), || {
                self.chain(a, BinaryOp::Add, b)
            }),
        }
    }

    pub(in crate::model::drawn) fn sub(&self, a: &Figure, b: &Figure) -> Figure {
        match (a.is_zero(), b.is_zero()) {
            (true, _) => self.neg(b),
            (_, true) => a.clone(),
            _ => self.made((a.value - b.value, a.power), folded(a, b, Exact::sub), || {
                self.chain(a, BinaryOp::Sub, b)
            }),
        }
    }

    pub(in crate::model::drawn) fn neg(&self, a: &Figure) -> Figure {
        if a.is_zero() {
            return a.clone();
        }
        self.made((-a.value, a.power), a.exact.as_ref().map(Exact::neg), || {
            self.expr(ExprKind::Negate(Box::new(a.text.clone())))
        })
    }

    pub(in crate::model::drawn) fn mul(&self, a: &Figure, b: &Figure) -> Figure {
        let power = a.power + b.power;
        if a.is_zero() || b.is_zero() {
            return Figure { power, ..self.zero() };
        }
        match (a.is_one(), b.is_one()) {
            (true, _) => b.clone(),
            (_, true) => a.clone(),
            _ => self.made((a.value * b.value, power), folded(a, b, Exact::mul), || {
                self.chain(a, BinaryOp::Mul, b)
            }),
        }
    }

    /// The quotient; the divisor is no zero.
    pub(in crate::model::drawn) fn div(&self, a: &Figure, b: &Figure) -> Figure {
        let power = a.power - b.power;
        if a.is_zero() {
            return Figure { power, ..self.zero() };
        }
        let exact = folded(a, b, Exact::div).flatten();
        self.made((a.value / b.value, power), exact, || self.chain(a, BinaryOp::Div, b))
    }

    pub(in crate::model::drawn) fn hypot(&self, a: &Figure, b: &Figure) -> Figure {
        let value = a.value.hypot(b.value);
        self.made((value, a.power), folded(a, b, Exact::hypot), || self.call("hypot", &[a, b]))
    }

    pub(in crate::model::drawn) fn cos(&self, angle: &Figure) -> Figure {
        let exact = angle.exact.as_ref().map(Exact::cos);
        self.made((angle.value.cos(), 0), exact, || self.call("cos", &[angle]))
    }

    pub(in crate::model::drawn) fn sin(&self, angle: &Figure) -> Figure {
        let exact = angle.exact.as_ref().map(Exact::sin);
        self.made((angle.value.sin(), 0), exact, || self.call("sin", &[angle]))
    }

    /// The angle of a vector, in degrees where that is a decimal.
    pub(in crate::model::drawn) fn angle(&self, [x, y]: &[Figure; 2]) -> Figure {
        let exact = folded(y, x, Exact::atan2).flatten();
        if let Some(long) = exact.as_ref().filter(|exact| exact.is_too_long()) {
            return self.rounded(long, (y.value.atan2(x.value), 0));
        }
        let decimal = exact.as_ref().and_then(|angle| self.in_degrees(angle));
        let text = decimal.unwrap_or_else(|| self.call("atan2", &[y, x]));
        Figure { text, value: y.value.atan2(x.value), exact, power: 0 }
    }

    fn in_degrees(&self, angle: &Exact) -> Option<Expr> {
        let (_, degree) = unit("deg")?;
        self.literal(&angle.div(&degree)?, vec![("deg".into(), 1)])
    }

    /// The angle of a direction from an axis that is at an angle itself: as many turns on as bring the sum of both to
    /// within half a turn.
    pub(in crate::model::drawn) fn turn(&self, along: &[Figure; 2], from: f64) -> Figure {
        let angle = self.angle(along);
        let turns = whole_turns(from + angle.value);
        if turns == 0.0 || !turns.is_finite() {
            return angle;
        }
        let exact = Exact::pi().mul(&Exact::integer(2 * turns as i64));
        let whole = Figure::plain(self.float(turns, "turn"), TAU * turns, Some(exact));
        let sum = self.add(&angle, &whole);
        let decimal = sum.exact.as_ref().and_then(|angle| self.in_degrees(angle));
        Figure { text: decimal.unwrap_or(sum.text), ..sum }
    }

    /// A length of the drawing that is known as a float only: its shortest decimal.
    pub(in crate::model::drawn) fn drawn(&self, value: f64) -> Figure {
        let exact = Exact::decimal(&format!("{:?}", value.abs()));
        let exact = exact.map(|exact| if value < 0.0 { exact.neg() } else { exact });
        self.as_decimal(Figure::length(self.float(value, "m"), value, exact))
    }

    /// An angle of the drawing that is known as a float only.
    pub(in crate::model::drawn) fn float(&self, value: f64, unit: &str) -> Expr {
        let digits = format!("{:?}", value.abs());
        let number = self.expr(ExprKind::Number { digits, units: vec![(unit.to_string(), 1)] });
        match value < 0.0 {
            true => self.expr(ExprKind::Negate(Box::new(number))),
            false => number,
        }
    }
}

/// Vectors of numbers.
impl Pen {
    pub(in crate::model::drawn) fn minus(&self, a: &[Figure; 2], b: &[Figure; 2]) -> [Figure; 2] {
        [self.sub(&a[0], &b[0]), self.sub(&a[1], &b[1])]
    }

    pub(in crate::model::drawn) fn plus(&self, a: &[Figure; 2], b: &[Figure; 2]) -> [Figure; 2] {
        [self.add(&a[0], &b[0]), self.add(&a[1], &b[1])]
    }

    pub(in crate::model::drawn) fn size(&self, a: &[Figure; 2]) -> Figure {
        match (a[0].is_zero(), a[1].is_zero()) {
            (true, _) if a[1].value > 0.0 && a[1].exact.is_some() => a[1].clone(),
            (_, true) if a[0].value > 0.0 && a[0].exact.is_some() => a[0].clone(),
            _ => self.hypot(&a[0], &a[1]),
        }
    }

    pub(in crate::model::drawn) fn dot(&self, a: &[Figure; 2], b: &[Figure; 2]) -> Figure {
        self.add(&self.mul(&a[0], &b[0]), &self.mul(&a[1], &b[1]))
    }

    pub(in crate::model::drawn) fn cross(&self, a: &[Figure; 2], b: &[Figure; 2]) -> Figure {
        self.sub(&self.mul(&a[0], &b[1]), &self.mul(&a[1], &b[0]))
    }

    /// The vector in axes whose x has this direction.
    pub(in crate::model::drawn) fn seen_from(
        &self,
        axis: &[Figure; 2],
        vector: &[Figure; 2],
    ) -> [Figure; 2] {
        let size = self.size(axis);
        let part = |number: Figure| if size.is_one() { number } else { self.div(&number, &size) };
        [part(self.dot(axis, vector)), part(self.cross(axis, vector))]
    }

    /// The vector whose coordinates in these axes are given.
    pub(in crate::model::drawn) fn seen_in_ground(
        &self,
        axis: &[Figure; 2],
        local: &[Figure; 2],
    ) -> [Figure; 2] {
        let mirrored = [axis[0].clone(), self.neg(&axis[1])];
        self.seen_from(&mirrored, local)
    }
}

/// The sum of two expressions.
pub(in crate::model::drawn) fn sum(first: Expr, second: Expr) -> Expr {
    let span = first.span;
    Expr { kind: ExprKind::Chain(Box::new(first), vec![(BinaryOp::Add, second)]), span }
}

/// The square root of an expression.
pub(in crate::model::drawn) fn root_of(square: Expr, at: Span) -> Expr {
    Expr { kind: ExprKind::Call(Ident::new("sqrt", at), vec![square]), span: at.into() }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::*;

    #[test]
    fn half_a_turn_counts_forwards_whatever_its_last_digits() {
        let half = [PI, -PI, PI + 1e-9, 1e-9 - PI, -PI - 1e-9, 5.0 * PI, -7.0 * PI];
        for angle in half {
            assert!((angle + TAU * whole_turns(angle) - PI).abs() < 2e-9, "{angle}");
        }
        for (angle, turns) in
            [(0.0, 0.0), (3.0, 0.0), (-3.0, 0.0), (3.3, -1.0), (-3.3, 1.0), (9.5, -2.0)]
        {
            assert_eq!(whole_turns(angle), turns, "{angle}");
        }
    }
}
