//! All values that a formula takes while its input lies anywhere in a range.
//!
//! An [`Enclosure`] is a middle and a radius. Every operation gives a radius that covers what the
//! operands' radii allow and what rounding did to the middle (R. E. Moore, R. B. Kearfott and M. J.
//! Cloud, Introduction to Interval Analysis, in the form of middles and radii: S. M. Rump, Fast and
//! parallel interval arithmetic). Where an operation has no value for some operand, or the numbers
//! leave their range, the radius is infinite or no number: nothing is known.
//!
//! Generated code runs on it like on any other number. It enters no result.

use core::ops::{Add, Div, Mul, Neg, Sub};

use crate::{Float, Real, Scalar};

/// The numbers within `radius` of `middle`.
#[derive(Clone, Copy, Debug)]
pub struct Enclosure<T> {
    middle: T,
    radius: T,
}

fn lit<T: Scalar>(value: f32) -> T {
    T::lit(value.into(), value)
}

fn epsilon<T: Real>() -> T {
    T::lit(T::EPSILON, T::EPSILON as f32)
}

/// The smallest normal number: a square of full precision is larger by 1/ε².
fn smallest<T: Real>() -> T {
    T::smallest_square() * epsilon() * epsilon()
}

/// The smaller one; the second where the first is no number.
fn min<T: Float>(a: T, b: T) -> T {
    if b.ge(a) { a } else { b }
}

impl<T: Float> Enclosure<T> {
    /// The numbers between `middle` − |`radius`| and `middle` + |`radius`|.
    pub(crate) fn around(middle: T, radius: T) -> Self {
        Self { middle, radius: radius.magnitude() }
    }

    /// A rounded middle. It is off by half an ε of its size, and a radius of a few operations by as
    /// many halves of its own: ε of both covers the first and up to eight of the others. What
    /// underflows is off by no more than the smallest normal number.
    #[inline]
    fn rounded(middle: T, radius: T) -> Self {
        let lost = epsilon::<T>() * (middle.magnitude() + lit::<T>(4.0) * radius) + smallest();
        Self { middle, radius: radius + lost }
    }

    /// Nothing is known.
    fn unknown(middle: T) -> Self {
        Self { middle, radius: lit(f32::INFINITY) }
    }

    /// The largest magnitude.
    fn largest(self) -> T {
        let size = self.middle.magnitude();
        size + self.radius + epsilon::<T>() * size
    }

    /// The smallest magnitude; negative where the range holds zero.
    fn least(self) -> T {
        let size = self.middle.magnitude();
        (size - self.radius) - epsilon::<T>() * size
    }

    /// f(`self`) for a function that changes by no more than `slope` times what its operand does.
    fn mapped(self, middle: T, slope: T) -> Self {
        Self::rounded(middle, slope * self.radius)
    }
}

impl<T: Float> Add for Enclosure<T> {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        Self::rounded(self.middle + other.middle, self.radius + other.radius)
    }
}

impl<T: Float> Sub for Enclosure<T> {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        Self::rounded(self.middle - other.middle, self.radius + other.radius)
    }
}

impl<T: Float> Neg for Enclosure<T> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self { middle: -self.middle, radius: self.radius }
    }
}

impl<T: Float> Mul for Enclosure<T> {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        let radius = self.middle.magnitude() * other.radius + self.radius * other.largest();
        Self::rounded(self.middle * other.middle, radius)
    }
}

impl<T: Float> Div for Enclosure<T> {
    type Output = Self;
    /// |a/b − a₀/b₀| = |(a − a₀) − a₀/b₀ (b − b₀)|/|b|.
    #[inline]
    fn div(self, other: Self) -> Self {
        let middle = self.middle / other.middle;
        let least = other.least();
        if !least.gt(lit(0.0)) {
            return Self::unknown(middle);
        }
        Self::rounded(middle, (self.radius + middle.magnitude() * other.radius) / least)
    }
}

impl<T: Float> Scalar for Enclosure<T> {
    type Mask = bool;

    #[inline]
    fn lit(wide: f64, narrow: f32) -> Self {
        Self::rounded(T::lit(wide, narrow), lit(0.0))
    }

    /// |√x − √x₀| = |x − x₀|/(√x + √x₀).
    #[inline]
    fn sqrt(self) -> Self {
        let middle = self.middle.sqrt();
        let least = self.least();
        if !(self.middle.gt(lit(0.0)) & least.gt(lit(0.0))) {
            return Self::unknown(middle);
        }
        Self::rounded(middle, self.radius / (middle + least.sqrt()))
    }

    /// sin (x + δ) − sin x = cos x sin δ − sin x (1 − cos δ), and the like for the cosine; never
    /// more than δ, nor than two.
    #[inline]
    fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = self.middle.sin_cos();
        let delta = min(self.radius, lit(2.0));
        let half_square = lit::<T>(0.5) * delta * delta;
        let off = |along: T, across: T| {
            // The kernel's last place, where `rounded` counts on half of one.
            let error = epsilon::<T>() * across.magnitude();
            min(along.magnitude() * delta + across.magnitude() * half_square, delta) + error
        };
        (Self::rounded(sin, off(cos, sin)), Self::rounded(cos, off(sin, cos)))
    }

    #[inline]
    fn sin_cos_near(self) -> (Self, Self) {
        self.sin_cos()
    }

    #[inline]
    fn is_near(self) -> bool {
        self.middle.is_near()
    }

    fn tan(self) -> Self {
        let (sin, cos) = self.sin_cos();
        sin / cos
    }

    /// The slope 1/√(1 − x²) is largest where |x| is.
    fn asin(self) -> Self {
        let (one, most) = (lit::<T>(1.0), self.largest() + epsilon());
        let square = (one - most) * (one + most);
        if !square.gt(lit(0.0)) {
            return Self::unknown(self.middle.asin());
        }
        self.mapped(self.middle.asin(), one / square.sqrt())
    }

    fn acos(self) -> Self {
        let sine = self.asin();
        Self { middle: self.middle.acos(), radius: sine.radius + epsilon::<T>() }.widened()
    }

    fn atan(self) -> Self {
        self.mapped(self.middle.atan(), lit(1.0)).widened()
    }

    /// The angle is followed across ±π, as a link is that turns with it.
    ///
    /// Of a vector no shorter than ρ whose end moves by r < ρ the angle changes by arcsin r/ρ at
    /// most, which is at most (r/ρ)/√(1 − (r/ρ)²).
    fn atan2(self, x: Self) -> Self {
        let middle = self.middle.atan2(x.middle);
        let (length, off) = (self.middle.hypot(x.middle), self.radius.hypot(x.radius));
        let off = off + lit::<T>(4.0) * epsilon::<T>() * length;
        let square = (length - off) * (length + off);
        if !(length.gt(off) & square.gt(lit(0.0))) {
            return Self::unknown(middle);
        }
        Self::rounded(middle, off / square.sqrt()).widened()
    }

    fn hypot(self, other: Self) -> Self {
        let off = self.radius.hypot(other.radius);
        Self::rounded(self.middle.hypot(other.middle), off).widened()
    }

    #[inline]
    fn det(a: Self, b: Self, c: Self, d: Self) -> Self {
        a * b - c * d
    }

    /// Zero: of all numbers of a range the product is the product.
    #[inline]
    fn mul_err(_: Self, _: Self) -> Self {
        Self { middle: lit(0.0), radius: lit(0.0) }
    }

    /// As for a product.
    #[inline]
    fn add_err(_: Self, _: Self) -> Self {
        Self { middle: lit(0.0), radius: lit(0.0) }
    }

    #[inline]
    fn fused(a: Self, b: Self, c: Self) -> Self {
        a * b + c
    }

    #[inline]
    fn ge(self, other: Self) -> bool {
        self.middle.ge(other.middle)
    }

    #[inline]
    fn gt(self, other: Self) -> bool {
        self.middle.gt(other.middle)
    }

    #[inline]
    fn is_finite(self) -> bool {
        self.middle.is_finite() & self.radius.is_finite()
    }

    #[inline]
    fn select(mask: bool, yes: Self, no: Self) -> Self {
        if mask { yes } else { no }
    }

    #[inline]
    fn smallest_square() -> Self {
        Self { middle: T::smallest_square(), radius: lit(0.0) }
    }
}

impl<T: Float> Enclosure<T> {
    /// The error of a library function: a few last places, of which `rounded` has covered one half.
    fn widened(self) -> Self {
        let error = lit::<T>(4.0) * epsilon::<T>() * self.middle.magnitude();
        Self { radius: self.radius + error, ..self }
    }
}

impl<T: Float> Real for Enclosure<T> {
    const EPSILON: f64 = T::EPSILON;
    type Enclosing = Self;

    #[inline]
    fn value(self) -> f64 {
        self.middle.value()
    }

    #[inline]
    fn is_constant(self) -> bool {
        true
    }

    fn enclosing(self, radius: Self) -> Self {
        Self { radius: self.radius + radius.largest(), ..self }
    }

    #[inline]
    fn bounds(self) -> [f64; 2] {
        // Widening is exact; a difference of two narrow numbers may round by an ε of the wide one,
        // of wide ones by one of theirs: the radius holds half an ε more than it needs to.
        let (middle, radius) = (self.middle.value(), self.radius.value());
        [middle - radius, middle + radius]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use core::f64::consts::TAU;

    type Ball = Enclosure<f64>;

    fn contains(ball: Ball, value: f64) -> bool {
        let [low, high] = ball.bounds();
        low <= value && value <= high
    }

    /// Every function of one and two operands on ranges of many sizes: what it takes at the ends,
    /// in the middle and in between lies inside; and the range is not much larger than it must be.
    #[test]
    fn a_range_holds_every_value() {
        type One = (fn(Ball) -> Ball, fn(f64) -> f64);
        type Two = (fn(Ball, Ball) -> Ball, fn(f64, f64) -> f64);
        let ones: [One; 8] = [
            (Scalar::sqrt, f64::sqrt),
            (|x| x.sin_cos().0, f64::sin),
            (|x| x.sin_cos().1, f64::cos),
            (Scalar::tan, f64::tan),
            (Scalar::asin, f64::asin),
            (Scalar::acos, f64::acos),
            (Scalar::atan, f64::atan),
            (|x| -x, |x| -x),
        ];
        let twos: [Two; 6] = [
            (|x, y| x + y, |x, y| x + y),
            (|x, y| x - y, |x, y| x - y),
            (|x, y| x * y, |x, y| x * y),
            (|x, y| x / y, |x, y| x / y),
            (Scalar::atan2, f64::atan2),
            (Scalar::hypot, f64::hypot),
        ];
        let parts = [-1.0, -0.6, 0.0, 0.3, 1.0];
        let mut known = 0;
        for x in [0.01, 0.3, 0.7, 0.95] {
            for radius in [0.0, 1e-12, 1e-3, 0.04, 0.4] {
                let ball = Ball::around(x, radius);
                for (index, (of_range, of_number)) in ones.iter().enumerate() {
                    let range = of_range(ball);
                    known += usize::from(range.is_finite());
                    for part in parts {
                        let value = of_number(x + part * radius);
                        let inside = value.is_nan() || contains(range, value);
                        assert!(inside || !range.is_finite(), "{index} {x} {radius} {part}");
                    }
                }
                for y in [-0.9, 0.2, 0.5] {
                    let other = Ball::around(y, radius / 3.0);
                    for (index, (of_ranges, of_numbers)) in twos.iter().enumerate() {
                        let range = of_ranges(ball, other);
                        known += usize::from(range.is_finite());
                        for (p, q) in parts.iter().flat_map(|p| parts.map(|q| (*p, q))) {
                            let value = of_numbers(x + p * radius, y + q * radius / 3.0);
                            let turned = [value, value + TAU, value - TAU];
                            let inside = turned.map(|value| contains(range, value));
                            let is_angle = index == 4;
                            let inside = inside[0] || is_angle && (inside[1] || inside[2]);
                            let inside = inside || !range.is_finite();
                            assert!(inside, "{index} {x} {y} {radius}: {value:e} {range:?}");
                        }
                    }
                }
            }
        }
        // Of 20 ranges and 8 functions, and of 60 pairs and 6: unknown are few.
        assert!(known > (20 * 8 + 60 * 6) * 9 / 10, "{known}");
    }

    #[test]
    fn what_has_no_value_somewhere_is_unknown() {
        let across_zero = Ball::around(0.1, 0.2);
        let one = Ball::lit(1.0, 1.0);
        for unknown in [across_zero.sqrt(), one / across_zero, (one + across_zero).asin()] {
            assert!(!unknown.is_finite(), "{unknown:?}");
        }
        assert!(!across_zero.atan2(across_zero).is_finite());
        assert!(!Ball::around(f64::NAN, 0.0).sqrt().is_finite());
        assert!(!(Ball::around(1e308, 1.0) * Ball::around(1e308, 1.0)).is_finite());
    }

    /// Sin and cos near their extremes change with the square of the range.
    #[test]
    fn ranges_are_tight() {
        let radius = |ball: Ball| {
            let [low, high] = ball.bounds();
            (high - low) / 2.0
        };
        assert!(radius(Ball::around(0.0, 1e-3).sin_cos().1) < 1e-6);
        assert!(radius(Ball::around(0.0, 1e-3).sin_cos().0) < 1.001e-3);
        assert!(radius(Ball::around(5.0, 1e9).sin_cos().0) <= 2.1);
        assert!(radius(Ball::around(4.0, 1e-3).sqrt()) < 2.6e-4);
        assert!(radius(Ball::around(2.0, 0.0) * Ball::around(3.0, 0.0)) <= 8.0 * f64::EPSILON);
    }
}
