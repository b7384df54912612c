//! Dimensions of quantities, and their arithmetic.
//!
//! A number without a unit is bare: it is SI and fits wherever it stands. Beside a quantity that
//! has a dimension it takes that dimension in a sum and counts as a plain number in a product.

/// Powers of metre, kilogram and second; an angle counts as a number, except that `angle` remembers
/// that it is one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Dimension {
    pub length: i32,
    pub mass: i32,
    pub time: i32,
    pub angle: bool,
}

impl Dimension {
    pub const NUMBER: Self = Self { length: 0, mass: 0, time: 0, angle: false };
    pub const ANGLE: Self = Self { angle: true, ..Self::NUMBER };
    pub const LENGTH: Self = Self { length: 1, ..Self::NUMBER };
    pub const MASS: Self = Self { mass: 1, ..Self::NUMBER };
    pub const TIME: Self = Self { time: 1, ..Self::NUMBER };
    /// A newton: kg m/s².
    pub const FORCE: Self = Self { length: 1, mass: 1, time: -2, angle: false };

    pub(crate) const TORQUE: Self = Self { length: 2, ..Self::FORCE };
    /// A watt.
    pub(crate) const POWER: Self = Self { time: -3, ..Self::TORQUE };
    pub(crate) const INERTIA: Self = Self { length: 2, mass: 1, ..Self::NUMBER };

    /// True for a number or an angle, which counts as one.
    pub(super) fn is_plain(self) -> bool {
        self.length == 0 && self.mass == 0 && self.time == 0
    }

    /// The dimension of a product with a power of the other. An angle stays one beside numbers.
    pub fn times(self, other: Self, power: i32) -> Self {
        let sum = |mine: i32, its: i32| mine.saturating_add(its.saturating_mul(power));
        let length = sum(self.length, other.length);
        let mass = sum(self.mass, other.mass);
        let time = sum(self.time, other.time);
        let product = Self { length, mass, time, angle: false };
        let is_angle = match power > 0 {
            true => self.angle != other.angle,
            false => self.angle && !other.angle,
        };
        Self { angle: is_angle && product.is_plain(), ..product }
    }

    /// The unit as it stands behind a number: `N`, `(N*s/m)`. `None` if no usual one exists.
    pub fn unit(self) -> Option<&'static str> {
        Some(match (self.length, self.mass, self.time) {
            (1, 0, 0) => "m",
            (0, 1, 0) => "kg",
            (0, 0, 1) => "s",
            (2, 0, 0) => "(m^2)",
            (1, 0, -1) => "(m/s)",
            (1, 0, -2) => "(m/s^2)",
            (0, 0, -1) => "(1/s)",
            (-1, 0, 0) => "(1/m)",
            (1, 1, -2) => "N",
            (2, 1, -2) => "(N*m)",
            (0, 1, -2) => "(N/m)",
            (0, 1, -1) => "(N*s/m)",
            (2, 1, -1) => "(N*m*s)",
            (1, 1, -1) => "(N*s)",
            (-1, 1, 0) => "(N*s^2/m^2)",
            (2, 1, 0) => "(kg*m^2)",
            _ => return None,
        })
    }

    /// The quantity with its article, for messages.
    pub fn words(self) -> String {
        let Self { length, mass, time, .. } = self;
        let known = match (length, mass, time) {
            (0, 0, 0) if self.angle => "an angle",
            (0, 0, 0) => "a number",
            (1, 0, 0) => "a length",
            (2, 0, 0) => "an area",
            (3, 0, 0) => "a volume",
            (0, 1, 0) => "a mass",
            (2, 1, 0) => "a moment of inertia",
            (0, 0, 1) => "a time",
            (0, 0, -1) => "a rate (1/s)",
            (1, 0, -1) => "a speed",
            (1, 0, -2) => "an acceleration",
            (1, 1, -2) => "a force",
            (2, 1, -2) => "a torque",
            (0, 1, -2) => "a force over a length (N/m)",
            (0, 1, -1) => "a force over a speed (N*s/m)",
            (2, 1, -1) => "a torque over an angular velocity (N*m*s)",
            _ => "",
        };
        if !known.is_empty() {
            return known.into();
        }
        let unit = |name: &str, power: i32| match power {
            0 => None,
            1 => Some(name.to_string()),
            _ => Some(format!("{name}^{power}")),
        };
        let units = [unit("m", length), unit("kg", mass), unit("s", time)];
        let units: Vec<_> = units.into_iter().flatten().collect();
        format!("a quantity in {}", units.join(" "))
    }
}

/// The dimension of an expression, as far as it is known.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Measure {
    /// Made of numbers without a unit alone.
    Bare,
    Known(Dimension),
}

impl Measure {
    pub const NUMBER: Self = Self::Known(Dimension::NUMBER);
    pub const ANGLE: Self = Self::Known(Dimension::ANGLE);
    pub const LENGTH: Self = Self::Known(Dimension::LENGTH);

    /// The dimension, a bare number being a number.
    pub fn dimension(self) -> Dimension {
        match self {
            Self::Bare => Dimension::NUMBER,
            Self::Known(dimension) => dimension,
        }
    }

    /// True if the quantity may stand where `wanted` belongs. Angles and numbers stand for each
    /// other, so that a ratio of lengths is an angle.
    pub fn fits(self, wanted: Dimension) -> bool {
        match self {
            Self::Bare => true,
            Self::Known(found) => found == wanted || (found.is_plain() && wanted.is_plain()),
        }
    }

    /// The measure of a sum, if the two can be added.
    pub fn sum(self, other: Self) -> Option<Self> {
        match (self, other) {
            (Self::Bare, known) | (known, Self::Bare) => Some(known),
            (Self::Known(a), Self::Known(b)) if other.fits(a) => {
                Some(Self::Known(Dimension { angle: a.angle || b.angle, ..a }))
            }
            _ => None,
        }
    }

    /// The measure of a product. A bare factor may carry the unit of a plain ratio
    /// (`0.08 * cos(theta)` may be a length); an angle keeps what it is (`2 * theta`).
    pub fn product(self, other: Self) -> Self {
        match (self, other) {
            (Self::Bare, Self::Bare | Self::NUMBER) | (Self::NUMBER, Self::Bare) => Self::Bare,
            (Self::Bare, known) | (known, Self::Bare) => known,
            (Self::Known(a), Self::Known(b)) => Self::Known(a.times(b, 1)),
        }
    }

    /// The measure of a quotient; a bare divisor counts as a number.
    pub fn quotient(self, divisor: Self) -> Self {
        match (self, divisor) {
            (_, Self::Bare) | (Self::Bare, Self::NUMBER) => self,
            (_, Self::Known(b)) => Self::Known(self.dimension().times(b, -1)),
        }
    }

    /// The measure of an integer power; a bare number's is bare.
    pub(super) fn power(self, times: i64) -> Self {
        let one = if self == Self::Bare { Self::Bare } else { Self::NUMBER };
        let power = (0..times.unsigned_abs()).fold(one, |power, _| power.product(self));
        if times < 0 { one.quotient(power) } else { power }
    }

    /// The measure of a rate; a bare number's is bare.
    pub(super) fn per_time(self) -> Self {
        match self {
            Self::Bare => Self::Bare,
            Self::Known(dimension) => Self::Known(dimension.times(Dimension::TIME, -1)),
        }
    }

    /// The measure of a square root, if the exponents can be halved.
    pub fn root(self) -> Option<Self> {
        match self {
            Self::Bare => Some(Self::Bare),
            Self::Known(Dimension { length, mass, time, .. })
                if length % 2 == 0 && mass % 2 == 0 && time % 2 == 0 =>
            {
                let (length, mass, time) = (length / 2, mass / 2, time / 2);
                Some(Self::Known(Dimension { length, mass, time, angle: false }))
            }
            Self::Known(_) => None,
        }
    }
}
