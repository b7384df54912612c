//! Numbers that move while the inputs go along a straight line: how clearances come to their rates.

use core::ops::{Add, Div, Mul, Neg, Sub};

use crate::Real;
use crate::chain_rule::Compose;

/// A number with its first two rates.
///
/// Formulas of a pose run on it as they are. Most of what they read stands still, dimensions and what
/// is made of them, and the compiler sees which: nothing is computed with rates of zero, and no zero
/// meets a range of which nothing is known.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Jet<T> {
    pub(crate) value: T,
    pub(crate) rate: T,
    pub(crate) second_rate: T,
    moves: bool,
}

impl<T: Real> Jet<T> {
    /// An input on its way at a constant rate.
    #[inline]
    pub(crate) fn along(value: T, rate: T) -> Self {
        Self { value, rate, second_rate: T::lit(0.0, 0.0), moves: true }
    }

    /// A parameter, with derivatives of its own if it has any.
    #[inline]
    pub(crate) fn standing(value: T) -> Self {
        Self::constant(value)
    }

    /// Another value at these rates, each made of the old one.
    #[inline(always)]
    fn with(self, value: T, rate: impl Fn(T) -> T) -> Self {
        if !self.moves {
            return Self::constant(value);
        }
        let [first, second] = [self.rate, self.second_rate].map(rate);
        Self { value, rate: first, second_rate: second, moves: true }
    }
}

impl<T: Real> Compose for Jet<T> {
    type Part = T;

    const ORDER: usize = 2;

    #[inline]
    fn constant(value: T) -> Self {
        let zero = T::lit(0.0, 0.0);
        Self { value, rate: zero, second_rate: zero, moves: false }
    }

    #[inline]
    fn real(self) -> T {
        self.value
    }

    #[inline]
    fn with_real(self, value: T) -> Self {
        Self { value, ..self }
    }

    /// ḟ = f′ẋ and f̈ = f′ẍ + f″ẋ².
    #[inline]
    fn compose(self, [f0, f1, f2, _]: [T; 4]) -> Self {
        if !self.moves {
            return Self::constant(f0);
        }
        let second_rate = f1 * self.second_rate + f2 * (self.rate * self.rate);
        Self { value: f0, rate: f1 * self.rate, second_rate, moves: true }
    }

    /// Only rates are made of the product.
    #[inline]
    fn fused(a: Self, b: Self, c: Self, value: T) -> Self {
        Self::sum(Self::product(a, b, value), c, value)
    }

    #[inline]
    fn derivatives_all(self, test: impl Fn(T) -> bool) -> bool {
        test(self.rate) && test(self.second_rate)
    }

    #[inline]
    fn has_no_derivative(self) -> bool {
        !self.moves
    }
}

impl<T: Real> Add for Jet<T> {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        Self::sum(self, other, self.value + other.value)
    }
}

impl<T: Real> Neg for Jet<T> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        self.with(-self.value, |rate| -rate)
    }
}

impl<T: Real> Sub for Jet<T> {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        Self::sum(self, -other, self.value - other.value)
    }
}

impl<T: Real> Mul for Jet<T> {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        Self::product(self, other, self.value * other.value)
    }
}

impl<T: Real> Div for Jet<T> {
    type Output = Self;
    /// With q = a/b: a = qb, so ȧ = q̇b + qḃ and ä = q̈b + 2q̇ḃ + qb̈.
    #[inline]
    fn div(self, other: Self) -> Self {
        let (a, b, value) = (self, other, self.value / other.value);
        let inverse = T::lit(1.0, 1.0) / b.value;
        if !b.moves {
            return a.with(value, |rate| rate * inverse);
        }
        let carried = value * b.rate;
        let rate = (if a.moves { a.rate - carried } else { -carried }) * inverse;
        let mixed = rate * b.rate;
        let bent = value * b.second_rate + (mixed + mixed);
        let bent = if a.moves { a.second_rate - bent } else { -bent };
        Self { value, rate, second_rate: bent * inverse, moves: true }
    }
}

/// Which of two numbers move is known where they are read, once these choices are part of the formulas.
impl<T: Real> Jet<T> {
    /// a + b, whose value is known.
    #[inline(always)]
    fn sum(a: Self, b: Self, value: T) -> Self {
        match (a.moves, b.moves) {
            (true, true) => Self {
                value,
                rate: a.rate + b.rate,
                second_rate: a.second_rate + b.second_rate,
                moves: true,
            },
            (true, false) => a.with_real(value),
            (false, _) => b.with_real(value),
        }
    }

    /// a·b, whose value is known.
    #[inline(always)]
    fn product(a: Self, b: Self, value: T) -> Self {
        match (a.moves, b.moves) {
            (true, true) => Self::rates_of_product(a, b, value),
            (true, false) => a.with(value, |rate| rate * b.value),
            (false, _) => b.with(value, |rate| a.value * rate),
        }
    }

    /// The second rate of a product is äb + 2ȧḃ + ab̈.
    fn rates_of_product(a: Self, b: Self, value: T) -> Self {
        let mixed = a.rate * b.rate;
        let bent = a.second_rate * b.value + a.value * b.second_rate;
        let rate = a.rate * b.value + a.value * b.rate;
        Self { value, rate, second_rate: bent + (mixed + mixed), moves: true }
    }
}
