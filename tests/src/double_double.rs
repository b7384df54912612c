//! A number of two `f64`, some 31 digits, on which the generated code runs as on any other: what it
//! answers is the truth for a solver in `f64` or `f32`.
//!
//! Literals are taken as the narrower solver takes them, rounded once to its width, so that what
//! differs is the solver's own arithmetic. Near a limit the truth loses digits as the solver does,
//! half of its 31 at the worst, which leaves as many as are needed.

use core::ops::{Add, Div, Mul, Neg, Sub};
use linkage_core::private::Sealed;
use linkage_core::{LibraryFunction, Scalar};

/// High + low, with |low| at most half a unit in the last place of high. `NARROW` is the truth
/// for `f32`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DoubleDouble<const NARROW: bool = false> {
    pub high: f64,
    pub low: f64,
}

fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let part = sum - a;
    (sum, (a - (sum - part)) + (b - part))
}

fn quick_two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    (sum, b - (sum - a))
}

fn two_product(a: f64, b: f64) -> (f64, f64) {
    let product = a * b;
    if cfg!(target_feature = "fma") {
        return (product, a.mul_add(b, -product));
    }
    let split = |x: f64| {
        let scaled = 134_217_729.0 * x;
        let high = scaled - (scaled - x);
        (high, x - high)
    };
    let ((a1, a2), (b1, b2)) = (split(a), split(b));
    (product, ((a1 * b1 - product) + a1 * b2 + a2 * b1) + a2 * b2)
}

impl<const NARROW: bool> DoubleDouble<NARROW> {
    pub const fn new(high: f64) -> Self {
        Self { high, low: 0.0 }
    }

    /// The sum of two words that do not overlap.
    #[must_use]
    pub const fn pair(high: f64, low: f64) -> Self {
        Self { high, low }
    }

    fn of((high, low): (f64, f64)) -> Self {
        let (high, low) = quick_two_sum(high, low);
        Self { high, low }
    }

    /// Taylor's series of sine and cosine, for |x| ≤ π/4: at an eighth of the angle the terms fall
    /// below 2⁻¹¹⁰ before the 23rd power; then the angle is doubled three times.
    fn taylor(self) -> (Self, Self) {
        let x = self * Self::new(0.125);
        let square = x * x;
        let series = |start: u32, first: Self| {
            let mut term = first;
            (0..11).fold(first, |sum, step| {
                let power = f64::from(start + 2 * step);
                term = -(term * square) / Self::new((power + 1.0) * (power + 2.0));
                sum + term
            })
        };
        // 1 − cos rather than cos: doubling then loses nothing near zero.
        let mut sin = series(1, x);
        let mut below = -series(2, -(square * Self::new(0.5)));
        for _ in 0..3 {
            let cos = Self::new(1.0) - below;
            below = Self::new(2.0) * (sin * sin);
            sin = Self::new(2.0) * (sin * cos);
        }
        (sin, Self::new(1.0) - below)
    }

    /// eˣ − 1, without loss near zero, for |x| below 1 or so: Taylor's series of a 64th of x, whose terms fall
    /// below 2⁻¹¹⁰ before the 16th power, and (1 + y)² − 1 = y (2 + y) six times.
    fn small_exponential_less_one(self) -> Self {
        let x = self * Self::new(1.0 / 64.0);
        let mut term = x;
        let sum = (2..18).fold(x, |sum, power| {
            term = term * x / Self::new(f64::from(power));
            sum + term
        });
        (0..6).fold(sum, |y, _| y * (y + Self::new(2.0)))
    }

    fn exponential_less_one(self) -> Self {
        if self.high.abs() < 0.5 {
            return self.small_exponential_less_one();
        }
        self.exponential() - Self::new(1.0)
    }

    /// eˣ = 2ⁿ e^(x − n ln 2).
    fn exponential(self) -> Self {
        if self.high.is_nan() || self.high.abs() >= 700.0 {
            return Self::new(self.high.exp());
        }
        let twos = (self.high / LN_2[0]).round();
        let part = |word: f64| Self::of(two_product(twos, word));
        let rest = ((self - part(LN_2[0])) - part(LN_2[1])) - part(LN_2[2]);
        let scale = Self::new(twos.exp2());
        (rest.small_exponential_less_one() + Self::new(1.0)) * scale
    }
}

/// ln 2 to 160 bits.
const LN_2: [f64; 3] = [core::f64::consts::LN_2, 2.3190468138462996e-17, 5.707708438416212e-34];

/// π/2 to 160 bits.
const HALF_PI: [f64; 3] =
    [core::f64::consts::FRAC_PI_2, 6.123233995736766e-17, -1.4973849048591698e-33];

impl<const NARROW: bool> Add for DoubleDouble<NARROW> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let (high, error) = two_sum(self.high, other.high);
        let (low, rest) = two_sum(self.low, other.low);
        let (high, error) = quick_two_sum(high, error + low);
        Self::of((high, error + rest))
    }
}

impl<const NARROW: bool> Neg for DoubleDouble<NARROW> {
    type Output = Self;
    fn neg(self) -> Self {
        Self::pair(-self.high, -self.low)
    }
}

impl<const NARROW: bool> Sub for DoubleDouble<NARROW> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl<const NARROW: bool> Mul for DoubleDouble<NARROW> {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let (high, error) = two_product(self.high, other.high);
        Self::of((high, error + (self.high * other.low + self.low * other.high)))
    }
}

impl<const NARROW: bool> Div for DoubleDouble<NARROW> {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let first = self.high / other.high;
        let rest = self - other * Self::new(first);
        let second = rest.high / other.high;
        let rest = rest - other * Self::new(second);
        Self::of(two_sum(first, second)) + Self::new(rest.high / other.high)
    }
}

impl<const NARROW: bool> Sealed for DoubleDouble<NARROW> {}

impl<const NARROW: bool> Scalar for DoubleDouble<NARROW> {
    type Mask = bool;

    fn lit(wide: f64, narrow: f32) -> Self {
        Self::new(if NARROW { f64::from(narrow) } else { wide })
    }
    fn sqrt(self) -> Self {
        if self.high <= 0.0 {
            return Self::new(self.high.sqrt());
        }
        let root = Self::new(self.high.sqrt());
        let root = root + (self - root * root) / (root + root);
        root + (self - root * root) / (root + root)
    }
    fn sin_cos(self) -> (Self, Self) {
        let turns = (self.high / HALF_PI[0]).round();
        let part = |word: f64| Self::of(two_product(turns, word));
        let (sin, cos) =
            (((self - part(HALF_PI[0])) - part(HALF_PI[1])) - part(HALF_PI[2])).taylor();
        match turns.rem_euclid(4.0) as u8 {
            0 => (sin, cos),
            1 => (cos, -sin),
            2 => (-sin, -cos),
            _ => (-cos, sin),
        }
    }
    fn sin_cos_near(self) -> (Self, Self) {
        self.sin_cos()
    }
    fn is_near(self) -> bool {
        self.high.abs() < 1e6
    }
    fn tan(self) -> Self {
        let (sin, cos) = self.sin_cos();
        sin / cos
    }
    fn asin(self) -> Self {
        self.atan2(((Self::new(1.0) - self) * (Self::new(1.0) + self)).sqrt())
    }
    fn acos(self) -> Self {
        ((Self::new(1.0) - self) * (Self::new(1.0) + self)).sqrt().atan2(self)
    }
    fn atan(self) -> Self {
        self.atan2(Self::new(1.0))
    }
    /// The angle in `f64`, and what turning back by it leaves, which is below 2⁻⁵².
    fn atan2(self, x: Self) -> Self {
        let angle = Self::new((self.high + 0.0).atan2(x.high));
        let (sin, cos) = angle.sin_cos();
        angle + (self * cos - x * sin) / self.hypot(x)
    }
    fn hypot(self, other: Self) -> Self {
        (self * self + other * other).sqrt()
    }
    /// Logarithms by one step of Newton's method from the one in `f64`, hyperbolic tangents by exponentials.
    fn apply(self, function: LibraryFunction) -> Self {
        let one = Self::new(1.0);
        match function {
            LibraryFunction::Exp => self.exponential(),
            LibraryFunction::Ln => {
                let near = Self::new(self.high.ln());
                near + (self * (-near).exponential() - one)
            }
            // Where it is small, no digits cancel in the series of e^2x − 1.
            LibraryFunction::Tanh => {
                let below = (self + self).exponential_less_one();
                below / (below + Self::new(2.0))
            }
            other => panic!("no double words of {other:?}"),
        }
    }
    fn pow(self, exponent: Self) -> Self {
        (exponent * self.ln()).exponential()
    }
    fn det(a: Self, b: Self, c: Self, d: Self) -> Self {
        a * b - c * d
    }
    /// Nothing is lost that would matter.
    fn mul_err(_: Self, _: Self) -> Self {
        Self::new(0.0)
    }
    fn add_err(_: Self, _: Self) -> Self {
        Self::new(0.0)
    }
    fn fused(a: Self, b: Self, c: Self) -> Self {
        a * b + c
    }
    fn ge(self, other: Self) -> bool {
        (self - other).high >= 0.0
    }
    fn gt(self, other: Self) -> bool {
        (self - other).high > 0.0
    }
    fn is_finite(self) -> bool {
        self.high.is_finite()
    }
    fn select(mask: bool, yes: Self, no: Self) -> Self {
        if mask { yes } else { no }
    }
    fn smallest_square() -> Self {
        Self::new(1e-200)
    }
}
