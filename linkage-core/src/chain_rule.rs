//! Numbers that carry derivatives, as scalars: the dual numbers of `num-dual`, and the [`Jet`] that
//! following a motion computes with.
//!
//! A function of such a number is its value and its derivatives at the real part, put together by
//! the chain rule ([`Compose`]). A real part may itself carry derivatives.
//!
//! [`Jet`]: crate::clearance::Jet

use core::fmt::Debug;
use core::ops::{Add, Div, Mul, Neg, Sub};

use crate::scalar::{Sealed, lit};
use crate::{LibraryFunction, Real, Scalar};

/// A real part with derivatives that follow the chain rule, up to the third.
pub trait Compose:
    Copy
    + Debug
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + 'static
{
    /// The type of the real part and of the derivatives.
    type Part: Real;

    /// The highest derivative that is carried, 3 at most.
    const ORDER: usize;

    /// A number without derivatives.
    fn constant(part: Self::Part) -> Self;

    /// The real part.
    fn real(self) -> Self::Part;

    /// The same derivatives on another real part.
    fn with_real(self, part: Self::Part) -> Self;

    /// f(`self`), from f and its first three derivatives at the real part.
    fn compose(self, f: [Self::Part; 4]) -> Self;

    /// The derivatives of a·b + c on this real part.
    #[inline]
    fn fused(a: Self, b: Self, c: Self, part: Self::Part) -> Self {
        (a * b + c).with_real(part)
    }

    /// True if all derivatives pass the test.
    fn derivatives_all(self, test: impl Fn(Self::Part) -> bool) -> bool;

    /// True if no derivative is carried; for a type that always carries some, true if all are zero.
    ///
    /// A number that depends on something may have a derivative of zero, and √(x²) has none at
    /// zero all the same.
    fn has_no_derivative(self) -> bool {
        self.derivatives_all(is_zero)
    }
}

/// True if a part is zero, its own derivatives included.
fn is_zero<T: Real>(part: T) -> bool {
    part.value() == 0.0 && part.is_constant()
}

/// f(`x`) where the derivatives of f may be infinite: a constant does not meet them. The highest
/// is the first to leave the range.
fn compose_singular<D: Compose>(x: D, f: [D::Part; 4]) -> D {
    if !f[D::ORDER].is_finite() && x.has_no_derivative() { D::constant(f[0]) } else { x.compose(f) }
}

/// The components of (`x`, `y`) along and across its own real direction, in units of its real
/// length, and that length. In these units nothing leaves the range when it is squared.
fn along_and_across<D: Compose>(x: D, y: D) -> (D, D, D::Part) {
    let length = x.real().hypot(y.real());
    let inverse = D::constant(lit::<D::Part>(1.0) / length);
    let cos = D::constant(x.real() / length);
    let sin = D::constant(y.real() / length);
    // The real parts are exact: 1 and 0, whatever derivatives they carry themselves.
    let along = ((cos * x + sin * y) * inverse).with_real(lit(1.0));
    let across = ((cos * y - sin * x) * inverse).with_real(lit(0.0));
    (along, across, length)
}

fn are_constant<D: Compose>(x: D, y: D) -> bool {
    x.derivatives_all(is_zero) && y.derivatives_all(is_zero)
}

impl<D: Compose> Sealed for D {}

impl<D: Compose> Scalar for D {
    type Mask = bool;

    #[inline]
    fn lit(wide: f64, narrow: f32) -> Self {
        Self::constant(D::Part::lit(wide, narrow))
    }

    #[inline]
    fn sqrt(self) -> Self {
        let x = self.real();
        let f0 = x.sqrt();
        let f1 = lit::<D::Part>(0.5) / f0;
        let f2 = lit::<D::Part>(-0.5) * f1 / x;
        let f3 = if D::ORDER < 3 { f2 } else { lit::<D::Part>(-1.5) * f2 / x };
        compose_singular(self, [f0, f1, f2, f3])
    }

    #[inline]
    fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = self.real().sin_cos();
        (self.compose([sin, cos, -sin, -cos]), self.compose([cos, -sin, -cos, sin]))
    }

    #[inline]
    fn sin_cos_near(self) -> (Self, Self) {
        let (sin, cos) = self.real().sin_cos_near();
        (self.compose([sin, cos, -sin, -cos]), self.compose([cos, -sin, -cos, sin]))
    }

    #[inline]
    fn is_near(self) -> bool {
        self.real().is_near()
    }

    fn tan(self) -> Self {
        let t = self.real().tan();
        let square = t * t;
        let f1 = lit::<D::Part>(1.0) + square;
        let f2 = lit::<D::Part>(2.0) * t * f1;
        let f3 = f1 * (lit::<D::Part>(2.0) + lit::<D::Part>(6.0) * square);
        self.compose([t, f1, f2, f3])
    }

    fn asin(self) -> Self {
        let x = self.real();
        let (f1, f2, f3) = arc_sine_derivatives(x);
        compose_singular(self, [x.asin(), f1, f2, f3])
    }

    fn acos(self) -> Self {
        let x = self.real();
        let (f1, f2, f3) = arc_sine_derivatives(x);
        compose_singular(self, [x.acos(), -f1, -f2, -f3])
    }

    fn atan(self) -> Self {
        let x = self.real();
        let square = x * x;
        let f1 = lit::<D::Part>(1.0) / (lit::<D::Part>(1.0) + square);
        let f2 = lit::<D::Part>(-2.0) * x * f1 * f1;
        let f3 = (lit::<D::Part>(6.0) * square - lit::<D::Part>(2.0)) * f1 * f1 * f1;
        self.compose([x.atan(), f1, f2, f3])
    }

    /// The angle of the real parts, and the arc tangent of what the derivatives turn it by.
    fn atan2(self, x: Self) -> Self {
        let angle = self.real().atan2(x.real());
        if are_constant(x, self) {
            return Self::constant(angle);
        }
        let (along, across, _) = along_and_across(x, self);
        (across / along).compose([angle, lit(1.0), lit(0.0), lit(-2.0)])
    }

    /// The length along the real parts' direction, times √(1 + w²) for the slope w that the
    /// derivatives turn it by.
    fn hypot(self, other: Self) -> Self {
        if are_constant(self, other) {
            return Self::constant(self.real().hypot(other.real()));
        }
        let (along, across, length) = along_and_across(self, other);
        Self::constant(length)
            * along
            * (across / along).compose([lit(1.0), lit(0.0), lit(1.0), lit(0.0)])
    }

    fn apply(self, function: LibraryFunction) -> Self {
        let x = self.real();
        self.compose(function.derivatives(x, x.apply(function), lit))
    }

    /// The power by the real exponent, times what the exponent's derivatives make of it.
    fn pow(self, exponent: Self) -> Self {
        let (x, y) = (self.real(), exponent.real());
        let f0 = x.pow(y);
        let f1 = y * f0 / x;
        let f2 = (y - lit(1.0)) * f1 / x;
        let f3 = (y - lit(2.0)) * f2 / x;
        let power = compose_singular(self, [f0, f1, f2, f3]);
        if exponent.derivatives_all(is_zero) {
            return power;
        }
        power * (exponent.with_real(lit(0.0)) * self.ln()).exp()
    }

    #[inline]
    fn det(a: Self, b: Self, c: Self, d: Self) -> Self {
        (a * b - c * d).with_real(D::Part::det(a.real(), b.real(), c.real(), d.real()))
    }

    /// A rounding error is no function of the operands: it has no derivative.
    #[inline]
    fn mul_err(a: Self, b: Self) -> Self {
        Self::constant(D::Part::mul_err(a.real(), b.real()))
    }

    /// As for a product.
    #[inline]
    fn add_err(a: Self, b: Self) -> Self {
        Self::constant(D::Part::add_err(a.real(), b.real()))
    }

    #[inline]
    fn fused(a: Self, b: Self, c: Self) -> Self {
        Compose::fused(a, b, c, D::Part::fused(a.real(), b.real(), c.real()))
    }

    #[inline]
    fn ge(self, other: Self) -> bool {
        self.real().ge(other.real())
    }

    #[inline]
    fn gt(self, other: Self) -> bool {
        self.real().gt(other.real())
    }

    #[inline]
    fn is_finite(self) -> bool {
        self.real().is_finite() && self.derivatives_all(Scalar::is_finite)
    }

    #[inline]
    fn select(mask: bool, yes: Self, no: Self) -> Self {
        if mask { yes } else { no }
    }

    #[inline]
    fn smallest_square() -> Self {
        Self::constant(D::Part::smallest_square())
    }
}

impl<D: Compose> Real for D {
    const EPSILON: f64 = <D::Part as Real>::EPSILON;
    const ORDER: u32 = <D::Part as Real>::ORDER + <D as Compose>::ORDER as u32;

    #[inline]
    fn value(self) -> f64 {
        self.real().value()
    }

    #[inline]
    fn is_constant(self) -> bool {
        self.real().is_constant() && self.has_no_derivative()
    }

    type Plain = <D::Part as Real>::Plain;
    type Enclosing = <D::Part as Real>::Enclosing;

    /// Modes are a matter of values.
    fn enclosing(self, radius: Self) -> Self::Enclosing {
        self.real().enclosing(radius.real())
    }
}

/// The first three derivatives of the arc sine, which are infinite at ±1.
fn arc_sine_derivatives<T: Real>(x: T) -> (T, T, T) {
    let one = lit::<T>(1.0);
    let square = (one - x) * (one + x);
    let f1 = one / square.sqrt();
    let f2 = x * f1 / square;
    let f3 = (one + lit::<T>(2.0) * x * x) * f1 / (square * square);
    (f1, f2, f3)
}
