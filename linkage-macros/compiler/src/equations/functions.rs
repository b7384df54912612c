//! The functions of expressions: as jets, by the chain rule to second order, and their slopes.

use crate::equations::jet::Jet;
use crate::equations::symbol::Sym;
use crate::function::Function;

impl<'s> Jet<'s> {
    /// The function of these numbers, as many as it takes.
    pub fn of(function: Function, arguments: &[Self]) -> Self {
        let (a, b) = (arguments[0], arguments[arguments.len() - 1]);
        match function {
            Function::Sqrt => a.sqrt(),
            Function::Hypot => a.hypot(b),
            Function::Sin => a.sin_cos().0,
            Function::Cos => a.sin_cos().1,
            Function::Tan => a.tan(),
            Function::Asin => a.asin(),
            Function::Acos => a.acos(),
            Function::Atan => a.atan(),
            Function::Atan2 => a.atan2(b),
            Function::Abs => a.abs(),
            Function::Sign => Self::constant(a.value.sign_or(a.value.builder().zero())),
            Function::Min => a.min(b),
            Function::Max => -(-a).min(-b),
            Function::Exp => a.exp(),
            Function::Ln => a.ln(),
            Function::Tanh => a.tanh(),
            Function::Pow => a.pow(b),
        }
    }

    /// `x` where this value is at least as large as the other, `y` elsewhere.
    fn at_least(self, other: Self, x: Self, y: Self) -> Self {
        let choice = |x, y| self.value.at_least(other.value, x, y);
        Self {
            value: choice(x.value, y.value),
            rate: choice(x.rate, y.rate),
            accel: choice(x.accel, y.accel),
        }
    }

    /// At zero with the rates of the positive side.
    fn abs(self) -> Self {
        self.at_least(Self::zero(self.value.builder()), self, -self)
    }

    /// The lesser number, the first of equal ones. NaN in either operand gives NaN, by way of the sum.
    fn min(self, other: Self) -> Self {
        other.at_least(self, self, self.at_least(other, other, self + other))
    }

    /// From s² = a: 2 s ṡ = ȧ and 2 ṡ² + 2 s s̈ = ä.
    pub(crate) fn sqrt(self) -> Self {
        let value = self.value.sqrt();
        let rate = self.rate.half() / value;
        let accel = (self.accel.half() - rate.squared()) / value;
        Self { value, rate, accel }
    }

    /// Sine and cosine of the jet.
    pub(crate) fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = (self.value.sin(), self.value.cos());
        let square = self.rate.squared();
        let sine =
            Self { value: sin, rate: cos * self.rate, accel: cos * self.accel - sin * square };
        let cosine = Self {
            value: cos,
            rate: -(sin * self.rate),
            accel: -(sin * self.accel) - cos * square,
        };
        (sine, cosine)
    }

    /// With t' = 1 + t²: ṫ = t' ȧ and ẗ = t' (ä + 2 t ȧ²).
    fn tan(self) -> Self {
        let value = self.value.apply(Function::Tan);
        let slope = self.value.builder().integer(1) + value.squared();
        let rate = slope * self.rate;
        let accel = slope * (self.accel + (value * self.rate.squared()).twice());
        Self { value, rate, accel }
    }

    /// From sin v = a, with c = cos v = √((1 − a)(1 + a)): c v̇ = ȧ and c v̈ = ä + a v̇².
    fn asin(self) -> Self {
        let cosine = self.other_leg();
        let rate = self.rate / cosine;
        let accel = (self.accel + self.value * rate.squared()) / cosine;
        Self { value: self.value.apply(Function::Asin), rate, accel }
    }

    /// From cos v = a, with s = sin v = √((1 − a)(1 + a)): s v̇ = −ȧ and s v̈ = −(ä + a v̇²).
    fn acos(self) -> Self {
        let sine = self.other_leg();
        let rate = -(self.rate / sine);
        let accel = -((self.accel + self.value * rate.squared()) / sine);
        Self { value: self.value.apply(Function::Acos), rate, accel }
    }

    /// √(1 − a²) by factors, exact where a is near ±1.
    fn other_leg(self) -> Sym<'s> {
        let one = self.value.builder().integer(1);
        ((one - self.value) * (one + self.value)).sqrt()
    }

    /// From tan v = a: (1 + a²) v̇ = ȧ and (1 + a²) v̈ = ä − 2 a ȧ v̇.
    fn atan(self) -> Self {
        let slope = self.value.builder().integer(1) + self.value.squared();
        let rate = self.rate / slope;
        let accel = (self.accel - (self.value * self.rate * rate).twice()) / slope;
        Self { value: self.value.apply(Function::Atan), rate, accel }
    }

    /// The angle v of (x, y): r² v̇ = x ẏ − y ẋ and r² v̈ = x ÿ − y ẍ − 2 v̇ (x ẋ + y ẏ).
    pub(crate) fn atan2(self, x: Self) -> Self {
        let y = self;
        let square = x.value.squared() + y.value.squared();
        let rate = (x.value * y.rate - y.value * x.rate) / square;
        let moment = x.value * y.accel - y.value * x.accel;
        let radial = x.value * x.rate + y.value * y.rate;
        let accel = (moment - (rate * radial).twice()) / square;
        Self { value: y.value.apply2(Function::Atan2, x.value), rate, accel }
    }

    /// With v = eᵃ: v̇ = v ȧ and v̈ = v (ä + ȧ²).
    fn exp(self) -> Self {
        let value = self.value.apply(Function::Exp);
        let rate = value * self.rate;
        let accel = value * (self.accel + self.rate.squared());
        Self { value, rate, accel }
    }

    /// From eᵛ = a: v̇ = ȧ/a and v̈ = ä/a − v̇².
    fn ln(self) -> Self {
        let rate = self.rate / self.value;
        let accel = self.accel / self.value - rate.squared();
        Self { value: self.value.apply(Function::Ln), rate, accel }
    }

    /// With t' = 1 − t²: ṫ = t' ȧ and ẗ = t' (ä − 2 t ȧ²).
    fn tanh(self) -> Self {
        let value = self.value.apply(Function::Tanh);
        let slope = slope_of_tanh(value);
        let rate = slope * self.rate;
        let accel = slope * (self.accel - (value * self.rate.squared()).twice());
        Self { value, rate, accel }
    }

    /// xⁿ as products where n is a known integer. Elsewhere, with v = xʸ and w = v̇/v = ẏ ln x + y ẋ/x:
    /// v̈ = v (ẇ + w²) and ẇ = ÿ ln x + 2 ẏ ẋ/x + y (ẍ/x − (ẋ/x)²).
    fn pow(self, y: Self) -> Self {
        let x = self;
        if let Some(times) = y.value.constant_integer() {
            return x.integer_power(times);
        }
        let value = x.value.pow(y.value);
        let (log, share) = (x.value.apply(Function::Ln), x.rate / x.value);
        let growth = y.rate * log + y.value * share;
        let growth_rate = y.accel * log
            + (y.rate * share).twice()
            + y.value * (x.accel / x.value - share.squared());
        let accel = value * (growth_rate + growth.squared());
        Self { value, rate: value * growth, accel }
    }

    fn integer_power(self, times: i64) -> Self {
        let one = Self::constant(self.value.builder().integer(1));
        let power = by_squaring(self, times.unsigned_abs(), |a, b| a * b).unwrap_or(one);
        if times < 0 { one / power } else { power }
    }

    /// From h² = x² + y²: h ḣ = x ẋ + y ẏ and h ḧ = x ẍ + y ÿ + ẋ² + ẏ² − ḣ².
    pub(crate) fn hypot(self, y: Self) -> Self {
        let x = self;
        let value = x.value.hypot(y.value);
        let rate = (x.value * x.rate + y.value * y.rate) / value;
        let accel = (x.value * x.accel + y.value * y.accel + x.rate.squared() + y.rate.squared()
            - rate.squared())
            / value;
        Self { value, rate, accel }
    }
}

/// 1 − t² by factors.
fn slope_of_tanh(t: Sym<'_>) -> Sym<'_> {
    let one = t.builder().integer(1);
    (one - t) * (one + t)
}

/// The product of so many of the same, by repeated squaring; `None` for no factor.
pub(super) fn by_squaring<T: Copy>(
    mut base: T,
    mut times: u64,
    product: impl Fn(T, T) -> T,
) -> Option<T> {
    let mut result: Option<T> = None;
    while times > 0 {
        if times & 1 == 1 {
            result = Some(result.map_or(base, |result| product(result, base)));
        }
        times >>= 1;
        if times > 0 {
            base = product(base, base);
        }
    }
    result
}

/// y xʸ⁻¹ and xʸ ln x; of a constant exponent the second is read nowhere.
fn slopes_of_power<'s>(x: Sym<'s>, y: Sym<'s>) -> Vec<Sym<'s>> {
    match y.constant_integer() {
        Some(0) => vec![x.builder().zero(); 2],
        Some(times) => {
            let one_less = Jet::constant(x).integer_power(times - 1).value;
            vec![y * one_less, x.builder().zero()]
        }
        None => {
            let power = x.pow(y);
            vec![y * power / x, power * x.apply(Function::Ln)]
        }
    }
}

/// The partial derivatives of a function of these numbers.
pub(crate) fn slopes<'s>(function: Function, arguments: &[Sym<'s>]) -> Vec<Sym<'s>> {
    let (a, b) = (arguments[0], arguments[arguments.len() - 1]);
    let [zero, one] = [0, 1].map(|value| a.builder().integer(value));
    let leg = || ((one - a) * (one + a)).sqrt();
    match function {
        Function::Sqrt => vec![a.sqrt().twice().recip()],
        Function::Hypot => {
            let root = a.hypot(b);
            vec![a / root, b / root]
        }
        Function::Sin => vec![a.cos()],
        Function::Cos => vec![-a.sin()],
        Function::Tan => vec![one + a.apply(Function::Tan).squared()],
        Function::Asin => vec![leg().recip()],
        Function::Acos => vec![-leg().recip()],
        Function::Atan => vec![(one + a.squared()).recip()],
        Function::Atan2 => {
            let square = b.squared() + a.squared();
            vec![b / square, -(a / square)]
        }
        Function::Abs => vec![a.at_least(zero, one, -one)],
        Function::Sign => vec![zero],
        Function::Min => vec![b.at_least(a, one, zero), b.at_least(a, zero, one)],
        Function::Max => vec![a.at_least(b, one, zero), a.at_least(b, zero, one)],
        Function::Exp => vec![a.apply(Function::Exp)],
        Function::Ln => vec![a.recip()],
        Function::Tanh => vec![slope_of_tanh(a.apply(Function::Tanh))],
        Function::Pow => slopes_of_power(a, b),
    }
}
