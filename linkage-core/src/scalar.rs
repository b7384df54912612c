//! The numbers a solver runs on.
//!
//! Generated code is generic over [`Scalar`]: `f32`, `f64`, lanes of them, and (feature `ad`)
//! the dual numbers of `num-dual`. [`Real`] adds the operations of a single number, which decides
//! with a plain `bool` whether a pose is at the limit.

use core::fmt::Debug;
use core::ops::{Add, BitAnd, Div, Mul, Neg, Sub};

use crate::LibraryFunction;

/// A supertrait that keeps [`Scalar`] and [`Mask`] to this crate. Hidden, and not private: tests compute with numbers
/// of their own.
pub trait Sealed {}

/// Calls a macro with the elementary functions, each before its kernel's name: behind the macro's first tokens
/// those of one number, then those of two. Whatever only passes them on is written by such a macro, so that
/// one more function is a word here.
macro_rules! elementary {
    ($write:ident $($first:tt)*) => {
        $write! {
            $($first)*
            tan tan_kernel asin asin_kernel acos acos_kernel atan atan_kernel;
            atan2 atan2_kernel
        }
    };
}
pub(crate) use elementary;

/// The answer of a comparison: `bool` for a single number, one `bool` a lane for lanes. Implemented by this crate
/// alone.
pub trait Mask: Copy + BitAnd<Output = Self> + Sealed {
    /// The answer yes everywhere.
    const ALL: Self;
    /// True if the answer is yes everywhere.
    fn all(self) -> bool;

    /// The answer together with a condition of the formulas.
    #[doc(hidden)]
    #[inline(always)]
    #[must_use]
    fn and_condition(self, met: Self) -> Self {
        self & met
    }

    /// The answer behind a condition that has no more comparisons.
    #[doc(hidden)]
    #[inline(always)]
    #[must_use]
    fn behind_condition(self) -> Self {
        self
    }

    /// The answer behind a group that is certain to be out of reach where `is_beyond` says so, for a mask
    /// that tells why its answer is no.
    #[doc(hidden)]
    #[inline(always)]
    #[must_use]
    fn behind_reach(self, _is_beyond: impl FnOnce() -> Self) -> Self {
        self
    }
}

impl Sealed for bool {}

impl Mask for bool {
    const ALL: Self = true;
    #[inline]
    fn all(self) -> bool {
        self
    }
}

/// A number that generated code can compute with: `f32`, `f64`, [`Lanes`](crate::Lanes) of them,
/// and, with the feature `ad`, the dual numbers of `num-dual` over `f32` or `f64`. Implemented by this crate alone, so
/// that it can ask more of a number without a break.
pub trait Scalar:
    Copy
    + Debug
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + Sealed
    + 'static
{
    /// The answer of a comparison.
    type Mask: Mask;

    /// A literal, rounded once from the exact value to each width.
    fn lit(wide: f64, narrow: f32) -> Self;

    /// A literal that rounds to the nearest `f32` by way of `f64`, as all but one of some 10⁹ do.
    #[inline(always)]
    #[must_use]
    fn num(value: f64) -> Self {
        Self::lit(value, value as f32)
    }

    /// The square root.
    #[must_use]
    fn sqrt(self) -> Self;

    /// Sine and cosine of any angle in radians, with a correct reduction of large arguments.
    #[must_use]
    fn sin_cos(self) -> (Self, Self);

    /// Sine and cosine by the branch-free kernel; right only where [`is_near`](Self::is_near) says yes, a
    /// meaningless number elsewhere. Each is within one unit in the last place, and of an `f64` where
    /// operations are fused within 1.7 units or 10⁻²⁷, in two thirds of the operations.
    #[must_use]
    fn sin_cos_near(self) -> (Self, Self);

    /// True if the argument lies within the range of [`sin_cos_near`](Self::sin_cos_near):
    /// ±1 048 576 rad (2²⁰) for `f64`, ±51 471 rad (8192 turns) for `f32`.
    #[must_use]
    fn is_near(self) -> Self::Mask;

    /// The tangent.
    #[must_use]
    fn tan(self) -> Self;

    /// The arc sine, in [−π/2, π/2].
    #[must_use]
    fn asin(self) -> Self;

    /// The arc cosine, in [0, π].
    #[must_use]
    fn acos(self) -> Self;

    /// The arc tangent, in [−π/2, π/2].
    #[must_use]
    fn atan(self) -> Self;

    /// The angle of the vector (`x`, `self`), in (−π, π].
    #[must_use]
    fn atan2(self, x: Self) -> Self;

    /// √(`self`² + `other`²) without intermediate overflow.
    #[must_use]
    fn hypot(self, other: Self) -> Self;

    /// A function of one number that a library computes, of lanes one by one.
    #[must_use]
    fn apply(self, function: LibraryFunction) -> Self;

    /// `self` to a power, of lanes one by one; not a number below zero, unless the exponent is an integer.
    #[must_use]
    fn pow(self, exponent: Self) -> Self;

    /// e to this power.
    #[inline(always)]
    #[must_use]
    fn exp(self) -> Self {
        self.apply(LibraryFunction::Exp)
    }

    /// The natural logarithm; −∞ at zero, and not a number below.
    #[inline(always)]
    #[must_use]
    fn ln(self) -> Self {
        self.apply(LibraryFunction::Ln)
    }

    /// The hyperbolic tangent.
    #[inline(always)]
    #[must_use]
    fn tanh(self) -> Self {
        self.apply(LibraryFunction::Tanh)
    }

    /// √(`self`² + `other`²) and whether it may be used: of single numbers and lanes the root of the squares
    /// as they are, within 1.5 units in the last place where their sum is at least `least`, which is at least
    /// [`smallest_square`](Self::smallest_square), and no more than the largest number; of others,
    /// [`hypot`](Self::hypot).
    #[inline(always)]
    #[must_use]
    fn hypot_near(self, other: Self, _least: Self) -> (Self, Self::Mask) {
        (self.hypot(other), Self::Mask::ALL)
    }

    /// a·b − c·d, with the error of a single rounding or two (Kahan's difference of products), in
    /// the range of [`mul_err`](Self::mul_err).
    #[must_use]
    fn det(a: Self, b: Self, c: Self, d: Self) -> Self;

    /// The rounding error of `a` · `b`: exact product minus rounded product. Exact unless the
    /// product underflows; where the operation is not fused, not a number for factors beyond 2⁹⁹⁶
    /// (`f32`: 2¹¹⁵). A dual number's has no derivative.
    #[must_use]
    fn mul_err(a: Self, b: Self) -> Self;

    /// The rounding error of `a` + `b`: exact sum minus rounded sum.
    #[must_use]
    fn add_err(a: Self, b: Self) -> Self;

    /// a·b + c, with one rounding where the number has a fused operation, with two elsewhere.
    /// Never a library call.
    #[must_use]
    fn fused(a: Self, b: Self, c: Self) -> Self;

    /// `self` ≥ `other`; no where either is not a number.
    #[must_use]
    fn ge(self, other: Self) -> Self::Mask;

    /// `self` > `other`; no where either is not a number.
    #[must_use]
    fn gt(self, other: Self) -> Self::Mask;

    /// |`self`| ≤ `bound`, which is not negative; no where either is not a number.
    #[inline(always)]
    #[must_use]
    fn is_within(self, bound: Self) -> Self::Mask {
        bound.ge(self) & self.ge(-bound)
    }

    /// `wide` of an `f64`, `narrow` of an `f32`, and no of a number that carries more than its
    /// value: whether what is known of the values of one width holds for all of this number.
    #[inline(always)]
    #[must_use]
    fn plain(_wide: bool, _narrow: bool) -> bool {
        false
    }

    /// True if the number and every derivative it carries are finite.
    #[must_use]
    fn is_finite(self) -> Self::Mask;

    /// `yes` where the mask says yes, `no` elsewhere.
    #[must_use]
    fn select(mask: Self::Mask, yes: Self, no: Self) -> Self;

    /// The smallest squared length whose square root still carries full precision: below it the
    /// square has left the number's normal range.
    #[must_use]
    fn smallest_square() -> Self;
}

/// [`Scalar::hypot_near`] of numbers that carry their value alone.
///
/// Underflow takes less from a square than its rounding where the sum is at least the smallest square.
/// Two roundings of ε/2 come under the root, which halves them, and it is rounded itself.
#[inline(always)]
pub(crate) fn root_of_squares<T: Scalar>(x: T, y: T, least: T) -> (T, T::Mask) {
    let square = T::fused(x, x, y * y);
    let largest = T::lit(f64::MAX, f32::MAX);
    (square.sqrt(), square.ge(least) & largest.ge(square))
}

/// A literal that is the same in both widths.
pub(crate) fn lit<T: Scalar>(value: f32) -> T {
    T::lit(value.into(), value)
}

/// True if the sum of a result's numbers is finite, and so each of them. A `plain` number needs no check:
/// the compiler has shown that it must be finite.
#[inline(always)]
pub fn is_finite_unless<T: Scalar>(plain: bool, sum: T) -> T::Mask {
    if plain { T::Mask::ALL } else { sum.is_finite() }
}

/// A single number: comparisons answer with a plain `bool`, so `position` and its kin can return
/// a `Result`.
pub trait Real: Scalar<Mask = bool> {
    /// The distance from 1 to the next number of this width.
    const EPSILON: f64;

    /// The order of the derivatives that are carried.
    const ORDER: u32 = 0;

    /// The value without derivatives, widened.
    #[must_use]
    fn value(self) -> f64;

    /// True if no derivative is carried; for a type that always carries some, if all are zero.
    #[must_use]
    fn is_constant(self) -> bool;

    /// Numbers of this width that carry no derivative: what a search runs on.
    #[doc(hidden)]
    type Plain: Real;

    /// The value without derivatives.
    #[doc(hidden)]
    #[inline]
    #[must_use]
    fn plain_value(self) -> Self::Plain {
        // Widened and narrowed again, nothing is lost.
        Self::Plain::num(self.value())
    }

    /// Ranges of numbers of this width, for following a motion.
    #[doc(hidden)]
    type Enclosing: Real;

    /// The numbers no farther than `radius` from this one.
    #[doc(hidden)]
    #[must_use]
    fn enclosing(self, radius: Self) -> Self::Enclosing;

    /// The lower and upper bound of this number. They differ only for a range.
    #[doc(hidden)]
    #[must_use]
    fn bounds(self) -> [f64; 2] {
        [self.value(); 2]
    }

    /// The smallest range that holds this and the other; of single numbers the first.
    #[doc(hidden)]
    #[must_use]
    fn joined(self, _other: Self) -> Self {
        self
    }

    /// The roots of f near this number, for all values of the ranges in f, which gives value and slope.
    /// For a number that is no range: the number itself.
    #[doc(hidden)]
    #[must_use]
    fn with_all_roots(self, _f: impl FnMut(Self) -> [Self; 2]) -> Self {
        self
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The square root is within its bound for numbers of every size whose squares are in range. The error of
    /// its square, against double words, is measured in units of the root's last place.
    #[test]
    fn a_root_of_squares_is_within_its_bound() {
        use crate::kernels::double_word::DoubleWord;
        let (mut state, mut worst) = (7_u64, 0.0_f64);
        let mut unit = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            (state >> 11) as f64 / (1_u64 << 53) as f64
        };
        for _ in 0..100_000 {
            let size = ((unit() - 0.5) * 900.0).exp2();
            let (x, y) = (size * (1.0 + unit()), size * (1.0 + unit()) * (-9.0 * unit()).exp2());
            let (found, is_near) = x.hypot_near(y, f64::smallest_square());
            assert!(is_near);
            let square = DoubleWord::product(x, x) + DoubleWord::product(y, y);
            let off = (square - DoubleWord::product(found, found)).high / (2.0 * found);
            worst = worst.max(off.abs() / (found.next_up() - found));
            let (narrow, is_near) = (x as f32).hypot_near(y as f32, 1e-20);
            let truth = f64::from(x as f32).hypot(f64::from(y as f32));
            let is_in_range = (2e-10..1.8e19).contains(&truth);
            assert!(is_near || !is_in_range, "{x:e} {y:e}");
            let ulp = f64::from((truth as f32).next_up() - truth as f32);
            assert!(!is_near || (f64::from(narrow) - truth).abs() <= 1.5 * ulp, "{x:e} {y:e}");
        }
        assert!(worst <= 1.5, "{worst}");
    }

    #[test]
    fn a_root_of_squares_out_of_range_is_not_used() {
        let is_near = |x: f64, y: f64, least: f64| x.hypot_near(y, least).1;
        assert!(is_near(3.0, 4.0, 25.0) && !is_near(3.0, 4.0, 25.1));
        assert!(is_near(1e154, 0.0, 1.0) && !is_near(1e155, 0.0, 1.0));
        for none in [f64::NAN, f64::INFINITY] {
            assert!(!is_near(none, 1.0, 0.5) && !is_near(1.0, none, 0.5));
        }
    }

    #[test]
    fn what_is_shown_to_be_finite_is_not_asked() {
        for (plain, sum, expected) in [
            (true, 1.0, true),
            (true, f64::NAN, true),
            (false, 1.0, true),
            (false, f64::NAN, false),
            (false, f64::INFINITY, false),
        ] {
            assert_eq!(is_finite_unless(plain, sum), expected, "{plain} {sum}");
        }
    }
}
