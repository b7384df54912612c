//! Numbers of a drawing: exact where they are constants, else expressions of what the user has written, so that a
//! parameter in the place of a pin is a parameter of the solver.

use std::f64::consts::TAU;

use proc_macro2::{Ident, Span};

use crate::diagnostics::Extent;
use crate::exact::Exact;
use crate::function::Function;
use crate::syntax::tree::{Expr, ExprKind};

use crate::model::as_drawn::whole_turns;
use crate::model::dimension::Dimension;
use crate::model::expr::{Operator, Scalar};
use crate::model::ids::LetId;
use crate::model::units::unit;

/// A number of the drawing.
#[derive(Clone)]
pub struct Figure {
    /// A named expression in it stands for one of the leaves, by its place.
    pub(super) number: Scalar,
    pub(super) leaves: Vec<WrittenPart>,
    /// The value at the defaults of the parameters, as far as it was reckoned.
    pub value: f64,
}

/// An expression that is written.
#[derive(Clone)]
pub(super) struct WrittenPart {
    pub written: Expr,
    /// The dimension that belongs where it is written.
    pub wanted: Option<Dimension>,
}

impl Figure {
    pub(super) fn constant(exact: Exact, value: f64) -> Self {
        Self { number: Scalar::Constant(exact), leaves: Vec::new(), value }
    }

    pub(super) fn zero() -> Self {
        Self::constant(Exact::integer(0), 0.0)
    }

    pub(super) fn whole(value: i64) -> Self {
        Self::constant(Exact::integer(value), value as f64)
    }

    /// A number that is known as a float only: its shortest decimal.
    pub(super) fn float(value: f64) -> Self {
        Self::constant(decimal(value), value)
    }

    /// The same to ten digits behind the point.
    pub(super) fn to_ten_digits(value: f64) -> Self {
        Self::constant(signed(&format!("{:.10}", value.abs()), value), value)
    }

    /// An angle in degrees that is known as a float only.
    pub(super) fn degrees(value: f64) -> Self {
        let degree = unit("deg").map_or(Exact::integer(1), |(_, degree)| degree);
        Self::constant(decimal(value).mul(&degree), value.to_radians())
    }

    /// A number that is written, whose value is not known.
    pub(super) fn written(written: Expr, wanted: Option<Dimension>) -> Self {
        let number = Scalar::Let(LetId(0));
        Self { number, leaves: vec![WrittenPart { written, wanted }], value: f64::NAN }
    }

    /// A named number.
    pub(super) fn named(name: &Ident) -> Self {
        Self::written(Expr { kind: ExprKind::Name(name.clone()), span: name.span().into() }, None)
    }

    /// A resolved number whose parts are figures where they are no constants; none where one is not known.
    pub(super) fn of(
        resolved: &Scalar,
        value: f64,
        part: &dyn Fn(&Scalar) -> Option<Self>,
    ) -> Option<Self> {
        let mut figure = Self { value, ..Self::zero() };
        figure.number = resolved.with_leaves(&mut |leaf| Some(figure.taken(&part(leaf)?)))?;
        Some(figure)
    }

    /// The parts that are written.
    pub(super) fn parts(&self) -> impl Iterator<Item = &Expr> {
        self.leaves.iter().map(|leaf| &leaf.written)
    }

    /// The name that it is.
    pub(super) fn name(&self) -> Option<&Ident> {
        match (&self.number, &self.leaves[..]) {
            (
                Scalar::Let(_),
                [WrittenPart { written: Expr { kind: ExprKind::Name(name), .. }, .. }],
            ) => Some(name),
            _ => None,
        }
    }

    /// The place where messages about it stand: where it is written, or this.
    pub(super) fn at(&self, other: Span) -> Extent {
        match (&self.number, &self.leaves[..]) {
            (Scalar::Let(_), [leaf]) => leaf.written.span,
            _ => other.into(),
        }
    }

    /// The value without error, where no parameter is in it.
    pub(super) fn exact(&self) -> Option<&Exact> {
        self.number.constant()
    }

    /// Zero whatever the parameters are.
    pub(super) fn is_zero(&self) -> bool {
        self.number.is_zero()
    }

    fn is_one(&self) -> bool {
        self.exact().is_some_and(Exact::is_one)
    }

    /// The number of another figure, whose leaves become its own.
    fn taken(&mut self, other: &Self) -> Scalar {
        let before = self.leaves.len() as u32;
        self.leaves.extend(other.leaves.iter().cloned());
        let number = other.number.with_leaves(&mut |leaf| match leaf {
            Scalar::Let(LetId(own)) => Some(Scalar::Let(LetId(own + before))),
            _ => None,
        });
        number.unwrap_or_else(Scalar::zero)
    }

    fn joined(&self, operator: Operator, other: &Self, value: f64) -> Self {
        let mut joined = Self { value, ..self.clone() };
        let other = joined.taken(other);
        let number = std::mem::replace(&mut joined.number, Scalar::zero());
        joined.number = number.combined(operator, other).unwrap_or_else(Scalar::zero);
        joined.rounded()
    }

    fn call(function: Function, arguments: &[&Self], value: f64) -> Self {
        let mut called = Self { value, ..Self::zero() };
        let arguments = arguments.iter().map(|argument| called.taken(argument)).collect();
        called.number = Scalar::call(function, arguments).unwrap_or_else(Scalar::zero);
        called.rounded()
    }

    /// To about 32 digits where it has more digits than a number that is written may have: the sum of two floats.
    fn rounded(mut self) -> Self {
        if let Some(long) = self.exact().filter(|exact| exact.is_too_long()) {
            let first = decimal(long.to_f64());
            let second = decimal(long.sub(&first).to_f64());
            self.number = Scalar::Constant(first.add(&second));
        }
        self
    }
}

/// The shortest decimal of a float.
fn decimal(value: f64) -> Exact {
    signed(&format!("{:?}", value.abs()), value)
}

/// These digits with the sign of a number.
fn signed(digits: &str, number: f64) -> Exact {
    let size = Exact::decimal(digits).unwrap_or_else(|| Exact::integer(0));
    if number < 0.0 { size.neg() } else { size }
}

/// Arithmetic.
impl Figure {
    pub(super) fn plus(&self, other: &Self) -> Self {
        self.joined(Operator::Add, other, self.value + other.value)
    }

    pub(super) fn minus(&self, other: &Self) -> Self {
        self.joined(Operator::Sub, other, self.value - other.value)
    }

    pub(super) fn negated(&self) -> Self {
        if self.is_zero() {
            return self.clone();
        }
        Self { number: self.number.clone().negated(), value: -self.value, ..self.clone() }
    }

    /// The product, without factors of zero and one.
    pub(super) fn times(&self, other: &Self) -> Self {
        match () {
            () if self.is_zero() || other.is_zero() => Self::zero(),
            () if self.is_one() => other.clone(),
            () if other.is_one() => self.clone(),
            () => self.product(other),
        }
    }

    /// The product with all factors: of what is fitted, so that fits of one kind are one expression.
    pub(super) fn product(&self, other: &Self) -> Self {
        self.joined(Operator::Mul, other, self.value * other.value)
    }

    /// The quotient; the divisor is no zero.
    pub(super) fn over(&self, other: &Self) -> Self {
        match self.is_zero() {
            true => self.clone(),
            false => self.joined(Operator::Div, other, self.value / other.value),
        }
    }

    pub(super) fn cos(&self) -> Self {
        Self::call(Function::Cos, &[self], self.value.cos())
    }

    pub(super) fn sin(&self) -> Self {
        Self::call(Function::Sin, &[self], self.value.sin())
    }

    pub(super) fn root(&self) -> Self {
        Self::call(Function::Sqrt, &[self], self.value.sqrt())
    }

    pub(super) fn hypot(&self, other: &Self) -> Self {
        Self::call(Function::Hypot, &[self, other], self.value.hypot(other.value))
    }

    /// The angle of a vector.
    pub(super) fn angle_of([x, y]: &[Self; 2]) -> Self {
        Self::call(Function::Atan2, &[y, x], y.value.atan2(x.value))
    }

    /// The angle of a direction from an axis that is at an angle itself: as many turns on as bring the sum of both to
    /// within half a turn.
    pub(super) fn turn_of(along: &[Self; 2], from: f64) -> Self {
        let angle = Self::angle_of(along);
        let turns = whole_turns(from + angle.value);
        if turns == 0.0 || !turns.is_finite() {
            return angle;
        }
        let exact = Exact::pi().mul(&Exact::integer(2 * turns as i64));
        angle.plus(&Self::constant(exact, TAU * turns))
    }
}

/// The direction of the x of a frame in that frame.
pub(super) fn x_axis() -> [Figure; 2] {
    [1, 0].map(Figure::whole)
}

pub(super) fn minus(a: &[Figure; 2], b: &[Figure; 2]) -> [Figure; 2] {
    [a[0].minus(&b[0]), a[1].minus(&b[1])]
}

pub(super) fn plus(a: &[Figure; 2], b: &[Figure; 2]) -> [Figure; 2] {
    [a[0].plus(&b[0]), a[1].plus(&b[1])]
}

/// The vector of a length along a direction.
pub(super) fn along(length: &Figure, direction: &[Figure; 2]) -> [Figure; 2] {
    unit_vector(direction).map(|part| length.times(&part))
}

/// The vector of length one in a direction.
pub(super) fn unit_vector(direction: &[Figure; 2]) -> [Figure; 2] {
    let size = size(direction);
    direction.each_ref().map(|part| part.over(&size))
}

pub(super) fn size(a: &[Figure; 2]) -> Figure {
    match (a[0].is_zero(), a[1].is_zero()) {
        (true, _) if a[1].value > 0.0 && a[1].exact().is_some() => a[1].clone(),
        (_, true) if a[0].value > 0.0 && a[0].exact().is_some() => a[0].clone(),
        _ => a[0].hypot(&a[1]),
    }
}

pub(super) fn dot(a: &[Figure; 2], b: &[Figure; 2]) -> Figure {
    a[0].times(&b[0]).plus(&a[1].times(&b[1]))
}

pub(super) fn cross(a: &[Figure; 2], b: &[Figure; 2]) -> Figure {
    a[0].times(&b[1]).minus(&a[1].times(&b[0]))
}

/// The vector in axes whose x has this direction.
pub(super) fn seen_from(axis: &[Figure; 2], vector: &[Figure; 2]) -> [Figure; 2] {
    let size = size(axis);
    let part = |number: Figure| if size.is_one() { number } else { number.over(&size) };
    [part(dot(axis, vector)), part(cross(axis, vector))]
}

/// The vector whose coordinates in these axes are given.
pub(super) fn seen_in_ground(axis: &[Figure; 2], local: &[Figure; 2]) -> [Figure; 2] {
    let mirrored = [axis[0].clone(), axis[1].negated()];
    seen_from(&mirrored, local)
}
