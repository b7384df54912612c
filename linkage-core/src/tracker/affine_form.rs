//! All values that a formula takes while its inputs take a step.
//!
//! An [`AffineForm`] is a middle, what it changes by with the step, and a radius. Every operation gives a
//! radius that covers what the operands' radii allow, what is not linear in the step, and what rounding
//! did to the middle (R. E. Moore, R. B. Kearfott and M. J. Cloud, Introduction to Interval Analysis;
//! L. H. de Figueiredo and J. Stolfi, Affine arithmetic, with one symbol for the step). Where an
//! operation has no value for some operand, or the numbers leave their range, the radius is infinite or
//! no number: nothing is known.
//!
//! Generated code runs on it like on any other number. It enters no result.

use core::ops::{Add, Div, Mul, Neg, Sub};

use crate::scalar::lit;
use crate::{Float, LibraryFunction, Real, Scalar};

/// The numbers within `radius` of `middle` + `slope` s, where s runs from −1 to 1 over a step.
///
/// All numbers of a formula share the s of its step: what they have in common to first order cancels
/// where their difference is taken.
#[derive(Clone, Copy, Debug)]
pub struct AffineForm<T> {
    middle: T,
    slope: T,
    radius: T,
}

fn epsilon<T: Real>() -> T {
    T::lit(T::EPSILON, T::EPSILON as f32)
}

/// The smallest normal number: a square of full precision is larger by 1/ε².
fn smallest<T: Real>() -> T {
    T::smallest_square() * epsilon() * epsilon()
}

fn half<T: Scalar>(value: T) -> T {
    lit::<T>(0.5) * value
}

/// The smaller number; the second if the first is NaN.
fn min<T: Float>(a: T, b: T) -> T {
    if b.ge(a) { a } else { b }
}

impl<T: Float> AffineForm<T> {
    /// The range from `middle` − `radius` to `middle` + `radius`, proportional to the step taken.
    pub(crate) fn around(middle: T, radius: T) -> Self {
        // Places on the way are rounded, each for itself.
        Self { middle, slope: radius, radius: epsilon::<T>() * middle.magnitude() }
    }

    /// The numbers between `middle` − |`radius`| and `middle` + |`radius`|, whatever the step.
    fn anywhere(middle: T, radius: T) -> Self {
        Self::rounded(middle, lit(0.0), radius)
    }

    /// A rounded middle. It is off by half an ε of its size, and a radius of a few operations by as
    /// many halves of its own: ε of both covers the first and up to eight of the others. What
    /// underflows is off by no more than the smallest normal number.
    #[inline]
    fn rounded(middle: T, slope: T, radius: T) -> Self {
        let rest = lit::<T>(4.0) * (radius + slope.magnitude());
        let lost = epsilon::<T>() * (middle.magnitude() + rest) + smallest();
        Self { middle, slope, radius: radius + lost }
    }

    /// Nothing is known.
    fn unknown(middle: T) -> Self {
        Self { middle, slope: lit(0.0), radius: lit(f32::INFINITY) }
    }

    /// The largest distance from the middle.
    fn spread(self) -> T {
        self.slope.magnitude() + self.radius
    }

    /// The largest magnitude.
    fn largest(self) -> T {
        let size = self.middle.magnitude();
        size + self.spread() + epsilon::<T>() * size
    }

    /// The smallest magnitude; negative where the range holds zero.
    fn least(self) -> T {
        let size = self.middle.magnitude();
        (size - self.spread()) - epsilon::<T>() * size
    }

    /// f(`self`) for a function that changes by no more than `slope` times what its operand does.
    fn mapped(self, middle: T, slope: T) -> Self {
        Self::anywhere(middle, slope * self.spread())
    }
}

impl<T: Float> Add for AffineForm<T> {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        let slope = self.slope + other.slope;
        Self::rounded(self.middle + other.middle, slope, self.radius + other.radius)
    }
}

impl<T: Float> Sub for AffineForm<T> {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        let slope = self.slope - other.slope;
        Self::rounded(self.middle - other.middle, slope, self.radius + other.radius)
    }
}

impl<T: Float> Neg for AffineForm<T> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self { middle: -self.middle, slope: -self.slope, radius: self.radius }
    }
}

impl<T: Float> Mul for AffineForm<T> {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        let [a, b] = [self.middle.magnitude(), other.middle.magnitude()];
        let [p, q] = [self.slope.magnitude(), other.slope.magnitude()];
        // The slope's two products may cancel, and their rounding stays.
        let rounding = lit::<T>(2.0) * epsilon::<T>() * (a * q + p * b);
        let radius = self.radius * (b + other.spread()) + other.radius * (a + p) + p * q;
        let slope = self.middle * other.slope + self.slope * other.middle;
        Self::rounded(self.middle * other.middle, slope, radius + rounding)
    }
}

impl<T: Float> Div for AffineForm<T> {
    type Output = Self;
    /// a/b − a₀/b₀ = n/b with n = (a − a₀) − a₀/b₀ (b − b₀), and n/b = n/b₀ − n (b − b₀)/(b₀ b).
    #[inline]
    fn div(self, other: Self) -> Self {
        let middle = self.middle / other.middle;
        let least = other.least();
        if !least.gt(lit(0.0)) {
            return Self::unknown(middle);
        }
        let [size, divisor] = [middle.magnitude(), other.middle.magnitude()];
        let along = self.slope - middle * other.slope;
        let made_of = self.slope.magnitude() + size * other.slope.magnitude();
        let rest = self.radius + size * other.radius + lit::<T>(3.0) * epsilon::<T>() * made_of;
        let bent = along.magnitude() * other.spread() / divisor;
        Self::rounded(middle, along / other.middle, (rest + bent) / least)
    }
}

impl<T: Float> Scalar for AffineForm<T> {
    type Mask = bool;

    #[inline]
    fn lit(wide: f64, narrow: f32) -> Self {
        Self::anywhere(T::lit(wide, narrow), lit(0.0))
    }

    /// √x − √x₀ = δ/(√x + √x₀), which is δ/2√x₀ but for δ²/(2√x₀ (√x + √x₀)²).
    #[inline]
    fn sqrt(self) -> Self {
        let middle = self.middle.sqrt();
        let least = self.least();
        if !(self.middle.gt(lit(0.0)) & least.gt(lit(0.0))) {
            return Self::unknown(middle);
        }
        let (twice, part) = (middle + middle, self.spread() / (middle + least.sqrt()));
        Self::rounded(middle, self.slope / twice, (self.radius + part * part) / twice)
    }

    /// sin (x + δ) − sin x = cos x sin δ − sin x (1 − cos δ), and the like for the cosine: cos x δ but
    /// for |sin x| δ²/2 and |cos x| δ³/6. Never more than δ, nor than two.
    #[inline]
    fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = self.middle.sin_cos();
        let delta = min(self.spread(), lit(2.0));
        let half_square = lit::<T>(0.5) * delta * delta;
        let is_wide = delta.gt(lit(0.5));
        let of = |middle: T, along: T| {
            let (size, across) = (along.magnitude(), middle.magnitude());
            // The kernel's last place, where `rounded` counts on half of one, and that of the slope.
            let error = epsilon::<T>() * (across + delta);
            if is_wide {
                let off = min(size * delta + across * half_square, delta);
                return Self::rounded(middle, lit(0.0), off + error);
            }
            let cube = half_square * delta * lit(0.334);
            let off = size * (self.radius + cube) + across * half_square;
            Self::rounded(middle, along * self.slope, off + error)
        };
        (of(sin, cos), of(cos, -sin))
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
        Self::anywhere(self.middle.acos(), sine.radius + epsilon::<T>()).widened()
    }

    fn atan(self) -> Self {
        self.mapped(self.middle.atan(), lit(1.0)).widened()
    }

    /// The angle is followed across ±π, as a link is that turns with it.
    ///
    /// The end of a vector of length ℓ moves by at most r. Its angle changes by the transverse motion over ℓ,
    /// to within r²/2(ℓ − r)²: half the largest second derivative is 1/2(ℓ − r)².
    fn atan2(self, x: Self) -> Self {
        let middle = self.middle.atan2(x.middle);
        let (length, off) = (self.middle.hypot(x.middle), self.off(x));
        let least = length - off;
        if !least.gt(lit(0.0)) {
            return Self::unknown(middle);
        }
        let part = off / least;
        let slope = (x.middle / length) * (self.slope / length)
            - (self.middle / length) * (x.slope / length);
        let rest = self.radius.hypot(x.radius) / length;
        Self::rounded(middle, slope, rest + half(part * part)).widened()
    }

    /// The second derivatives are at most 1/(ℓ − r), as above.
    fn hypot(self, other: Self) -> Self {
        let (middle, off) = (self.middle.hypot(other.middle), self.off(other));
        let least = middle - off;
        if !least.gt(off) {
            return Self::anywhere(middle, off).widened();
        }
        let along = (self.middle / middle) * self.slope + (other.middle / middle) * other.slope;
        let rest = self.radius.hypot(other.radius) + half(off * (off / least));
        Self::rounded(middle, along, rest).widened()
    }

    /// f(x + δ) − f(x) is f'(x) δ but for half the largest curvature times δ².
    fn apply(self, function: LibraryFunction) -> Self {
        let (x, off) = (self.middle, self.largest() - self.middle.magnitude());
        let [middle, slope, ..] = function.derivatives(x, x.apply(function), lit);
        if !(x - off).apply(function).is_finite() {
            return Self::unknown(middle);
        }
        let bent = half(function.curvature(x - off, (x + off).apply(function), lit) * off * off);
        Self::rounded(middle, slope * self.slope, slope.magnitude() * self.radius + bent).widened()
    }

    /// For a base above zero alone; the rounding of y ln x counts as a change of it.
    fn pow(self, exponent: Self) -> Self {
        (exponent * self.ln()).exp()
    }

    #[inline]
    fn det(a: Self, b: Self, c: Self, d: Self) -> Self {
        a * b - c * d
    }

    /// Zero: of all numbers of a range the product is the product.
    #[inline]
    fn mul_err(_: Self, _: Self) -> Self {
        Self { middle: lit(0.0), slope: lit(0.0), radius: lit(0.0) }
    }

    /// As for a product.
    #[inline]
    fn add_err(_: Self, _: Self) -> Self {
        Self { middle: lit(0.0), slope: lit(0.0), radius: lit(0.0) }
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
        self.middle.is_finite() & self.slope.is_finite() & self.radius.is_finite()
    }

    #[inline]
    fn select(mask: bool, yes: Self, no: Self) -> Self {
        if mask { yes } else { no }
    }

    #[inline]
    fn smallest_square() -> Self {
        Self { middle: T::smallest_square(), slope: lit(0.0), radius: lit(0.0) }
    }
}

impl<T: Float> AffineForm<T> {
    /// The error of a library function: a few last places, of which `rounded` has covered one half.
    fn widened(self) -> Self {
        let error =
            lit::<T>(4.0) * epsilon::<T>() * (self.middle.magnitude() + self.slope.magnitude());
        Self { radius: self.radius + error, ..self }
    }

    /// The largest motion of the end of a vector of these components.
    fn off(self, x: Self) -> T {
        let (y, x) = (self, x);
        let off = y.spread().hypot(x.spread());
        off + lit::<T>(4.0) * epsilon::<T>() * (y.middle.hypot(x.middle) + off)
    }
}

impl<T: Float> Real for AffineForm<T> {
    const EPSILON: f64 = T::EPSILON;
    type Plain = Self;
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
        // Widening is exact; a sum of two narrow numbers may round by an ε of the wide one, of wide ones
        // by one of theirs: the radius holds half an ε more than it needs to.
        let (middle, spread) = (self.middle.value(), self.spread().value());
        [middle - spread, middle + spread]
    }

    fn joined(self, other: Self) -> Self {
        let apart = (self.middle - other.middle).magnitude();
        Self::anywhere(self.middle, apart + self.spread() + other.spread())
    }

    /// By the mean value theorem: where |f'| is at least s within r of a middle m, f has one root there
    /// if |f(m)| is at most s r, and it lies within |f(m)|/s.
    fn with_all_roots(self, mut f: impl FnMut(Self) -> [Self; 2]) -> Self {
        let exact = Self::anywhere(self.middle, lit(0.0));
        let [value, slope] = f(exact);
        let (miss, mut least) = (value.largest(), slope.least());
        for _ in 0..ROUNDS {
            if !least.gt(lit(0.0)) {
                break;
            }
            let within = Self::anywhere(self.middle, lit::<T>(1.25) * miss / least);
            let [_, slope] = f(within);
            least = slope.least();
            let needed = Self::anywhere(self.middle, miss / least);
            if least.gt(lit(0.0)) & within.radius.ge(needed.radius) {
                return needed;
            }
        }
        Self::unknown(self.middle)
    }
}

/// The number of times that a range for a root is widened: it needs as many as the slope varies in it.
const ROUNDS: usize = 4;

#[cfg(test)]
mod tests;
