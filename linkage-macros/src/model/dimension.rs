//! What a quantity is measured in, and what becomes of that under arithmetic.
//!
//! A number without a unit is bare: it is SI and fits wherever it stands. Beside a quantity that
//! has a dimension it takes that dimension in a sum and counts as a plain number in a product.

use super::mechanism::Dimension;

impl Dimension {
    pub(crate) const NUMBER: Self = Self { length: 0, mass: 0, angle: false };
    pub(crate) const ANGLE: Self = Self { length: 0, mass: 0, angle: true };
    pub(crate) const LENGTH: Self = Self { length: 1, mass: 0, angle: false };
    pub(crate) const MASS: Self = Self { length: 0, mass: 1, angle: false };

    /// Whether the quantity is a number or an angle, which counts as one.
    pub(super) fn is_plain(self) -> bool {
        self.length == 0 && self.mass == 0
    }

    /// The quantity with its article, for messages.
    pub(super) fn words(self) -> String {
        match self {
            Self::NUMBER => "a number".into(),
            Self::ANGLE => "an angle".into(),
            Self::LENGTH => "a length".into(),
            Self::MASS => "a mass".into(),
            Self { length: 2, mass: 0, .. } => "an area".into(),
            Self { length: 3, mass: 0, .. } => "a volume".into(),
            Self { length, mass, .. } => {
                let unit = |name: &str, power: i32| match power {
                    0 => None,
                    1 => Some(name.to_string()),
                    _ => Some(format!("{name}^{power}")),
                };
                let units: Vec<_> =
                    [unit("m", length), unit("kg", mass)].into_iter().flatten().collect();
                format!("a quantity in {}", units.join(" "))
            }
        }
    }
}

/// What is known of an expression's dimension.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Measure {
    /// Made of numbers without a unit alone.
    Bare,
    Known(Dimension),
}

impl Measure {
    pub(super) const NUMBER: Self = Self::Known(Dimension::NUMBER);
    pub(super) const ANGLE: Self = Self::Known(Dimension::ANGLE);
    pub(super) const LENGTH: Self = Self::Known(Dimension::LENGTH);

    /// The dimension, a bare number being a number.
    pub(super) fn dimension(self) -> Dimension {
        match self {
            Self::Bare => Dimension::NUMBER,
            Self::Known(dimension) => dimension,
        }
    }

    /// Whether the quantity may stand where `wanted` belongs: angles and numbers stand for each
    /// other, so that a ratio of lengths is an angle.
    pub(super) fn fits(self, wanted: Dimension) -> bool {
        match self {
            Self::Bare => true,
            Self::Known(found) => found == wanted || (found.is_plain() && wanted.is_plain()),
        }
    }

    /// The measure of a sum, if the two can be added.
    pub(super) fn sum(self, other: Self) -> Option<Self> {
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
    pub(super) fn product(self, other: Self) -> Self {
        match (self, other) {
            (Self::Bare, Self::Bare | Self::NUMBER) | (Self::NUMBER, Self::Bare) => Self::Bare,
            (Self::Bare, known) | (known, Self::Bare) => known,
            (Self::Known(a), Self::Known(b)) => {
                let length = a.length.saturating_add(b.length);
                let mass = a.mass.saturating_add(b.mass);
                let angle = a.angle != b.angle && length == 0 && mass == 0;
                Self::Known(Dimension { length, mass, angle })
            }
        }
    }

    /// The measure of a quotient; a bare divisor counts as a number.
    pub(super) fn quotient(self, divisor: Self) -> Self {
        match (self, divisor) {
            (_, Self::Bare) | (Self::Bare, Self::NUMBER) => self,
            (_, Self::Known(b)) => {
                let a = self.dimension();
                let length = a.length.saturating_sub(b.length);
                let mass = a.mass.saturating_sub(b.mass);
                let angle = a.angle && !b.angle && length == 0 && mass == 0;
                Self::Known(Dimension { length, mass, angle })
            }
        }
    }

    /// The measure of a square root, if the exponents can be halved.
    pub(super) fn root(self) -> Option<Self> {
        match self {
            Self::Bare => Some(Self::Bare),
            Self::Known(Dimension { length, mass, .. }) if length % 2 == 0 && mass % 2 == 0 => {
                Some(Self::Known(Dimension { length: length / 2, mass: mass / 2, angle: false }))
            }
            Self::Known(_) => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lengths_carry_exponents() {
        let area = Measure::LENGTH.product(Measure::LENGTH);
        assert_eq!(area.dimension().words(), "an area");
        assert_eq!(area.root(), Some(Measure::LENGTH));
        assert_eq!(Measure::LENGTH.root(), None);
        assert_eq!(Measure::LENGTH.quotient(Measure::LENGTH), Measure::NUMBER);
        assert_eq!(Measure::Bare.quotient(area).dimension().words(), "a quantity in m^-2");
    }

    #[test]
    fn an_angle_counts_as_a_number_in_products() {
        assert_eq!(Measure::ANGLE.product(Measure::LENGTH), Measure::LENGTH);
        assert_eq!(Measure::ANGLE.product(Measure::Bare), Measure::ANGLE);
        assert_eq!(Measure::ANGLE.quotient(Measure::ANGLE), Measure::NUMBER);
        assert_eq!(Measure::ANGLE.sum(Measure::LENGTH), None);
        assert_eq!(Measure::NUMBER.sum(Measure::ANGLE), Some(Measure::ANGLE));
    }

    #[test]
    fn a_bare_number_fits_anywhere() {
        assert!(Measure::Bare.fits(Dimension::LENGTH) && Measure::Bare.fits(Dimension::ANGLE));
        assert_eq!(Measure::Bare.product(Measure::NUMBER), Measure::Bare);
        assert!(!Measure::NUMBER.fits(Dimension::LENGTH));
    }
}
