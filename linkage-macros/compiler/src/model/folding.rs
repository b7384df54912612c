//! Arithmetic on resolved expressions that keeps constants exact.
//!
//! Only constants are folded: what an expression of inputs and parameters can be simplified to is
//! the passes' business.

use crate::exact::Exact;
use crate::function::Function;

use super::mechanism::{AboveZero, Operator, Scalar};

impl Scalar {
    pub(crate) const fn is_constant(&self) -> bool {
        matches!(self, Self::Constant(_))
    }

    /// The value, where it is known when the mechanism is declared.
    pub(crate) fn constant(&self) -> Option<&Exact> {
        match self {
            Self::Constant(value) => Some(value),
            _ => None,
        }
    }

    pub fn zero() -> Self {
        Self::Constant(Exact::integer(0))
    }

    pub(crate) fn is_zero(&self) -> bool {
        self.constant().is_some_and(Exact::is_zero)
    }

    pub(super) fn negated(self) -> Self {
        match self {
            Self::Constant(value) => Self::Constant(value.neg()),
            Self::Negate(value) => *value,
            other => Self::Negate(Box::new(other)),
        }
    }

    /// The expression of the two; `None` for a division by the constant zero.
    pub(super) fn combined(self, operator: Operator, other: Self) -> Option<Self> {
        if operator == Operator::Div && other.is_zero() {
            return None;
        }
        if let (Self::Constant(a), Self::Constant(b)) = (&self, &other) {
            return Some(Self::Constant(match operator {
                Operator::Add => a.add(b),
                Operator::Sub => a.sub(b),
                Operator::Mul => a.mul(b),
                Operator::Div => a.div(b)?,
            }));
        }
        Some(match operator {
            Operator::Add if self.is_zero() => other,
            Operator::Sub if self.is_zero() => other.negated(),
            Operator::Add | Operator::Sub if other.is_zero() => self,
            _ => match self {
                Self::Chain(first, mut rest) => {
                    rest.push((operator, other));
                    Self::Chain(first, rest)
                }
                first => Self::Chain(Box::new(first), vec![(operator, other)]),
            },
        })
    }

    /// The sum.
    pub(super) fn plus(self, other: Self) -> Self {
        self.combined(Operator::Add, other).expect("only a quotient may have no value")
    }

    /// The difference.
    pub(super) fn minus(self, other: Self) -> Self {
        self.combined(Operator::Sub, other).expect("only a quotient may have no value")
    }

    /// The product, without factors of zero and one.
    pub(super) fn times(self, other: Self) -> Self {
        let is_one = |value: &Self| value.constant().is_some_and(Exact::is_one);
        match () {
            () if self.is_zero() || is_one(&other) => self,
            () if other.is_zero() || is_one(&self) => other,
            () => self.combined(Operator::Mul, other).expect("only a quotient may have no value"),
        }
    }

    /// True if this is true of any part that is neither a constant nor an operation.
    pub(super) fn any_leaf(&self, is: &dyn Fn(&Self) -> bool) -> bool {
        match self {
            Self::Constant(_) => false,
            Self::Negate(value) => value.any_leaf(is),
            Self::AboveZero(inner) => inner.value.any_leaf(is),
            Self::Chain(first, rest) => {
                first.any_leaf(is) || rest.iter().any(|(_, operand)| operand.any_leaf(is))
            }
            Self::Call(_, arguments) => arguments.iter().any(|argument| argument.any_leaf(is)),
            leaf => is(leaf),
        }
    }

    /// The expression with what is neither a constant nor an operation replaced; `None` where nothing replaces it, or a
    /// function of constants has no value.
    pub(super) fn with_leaves(&self, leaf: &mut dyn FnMut(&Self) -> Option<Self>) -> Option<Self> {
        match self {
            Self::Constant(_) => Some(self.clone()),
            Self::Negate(inner) => Some(inner.with_leaves(leaf)?.negated()),
            Self::Chain(first, rest) => {
                rest.iter().try_fold(first.with_leaves(leaf)?, |left, (operator, operand)| {
                    left.combined(*operator, operand.with_leaves(leaf)?)
                })
            }
            Self::Call(function, arguments) => {
                let arguments: Option<Vec<_>> =
                    arguments.iter().map(|argument| argument.with_leaves(leaf)).collect();
                Self::call(*function, arguments?)
            }
            Self::AboveZero(inner) => match inner.value.with_leaves(leaf)? {
                value @ Self::Constant(_) => Some(value),
                value => Some(Self::AboveZero(Box::new(AboveZero { value, ..(**inner).clone() }))),
            },
            _ => leaf(self),
        }
    }

    /// The function of the arguments; `None` where constants have no value.
    pub(super) fn call(function: Function, arguments: Vec<Self>) -> Option<Self> {
        let constants: Option<Vec<_>> = arguments.iter().map(Self::constant).collect();
        Some(match constants {
            Some(constants) => Self::Constant(Exact::of(function, &constants)?),
            None => Self::Call(function, arguments),
        })
    }
}

/// The value as messages print it: six significant digits.
pub(super) fn shown(value: &Exact) -> String {
    shown_f64(value.to_f64())
}

/// An angle as messages print it.
pub(super) fn shown_in_degrees(value: &Exact) -> String {
    shown_f64(value.to_f64().to_degrees())
}

pub fn shown_f64(value: f64) -> String {
    let short = format!("{value:.5e}");
    // Parsed back, `2.00000e0` prints as 2.
    short.parse::<f64>().map_or(short, |rounded| rounded.to_string())
}
