//! Exact real constants: what is known when the mechanism is declared is computed without error
//! and rounded once.
//!
//! A number is a [`rational`] or a [`sum`] of products of [`atom`]s in normal form; [`root`] and
//! [`angle`] hold the identities of roots and of sines and angles. [`evaluation`] finds what a
//! number amounts to from an [`enclosure`], whose functions are in [`elementary`], and [`rounding`]
//! makes it a float; [`size`] says when there is too much of it. [`powers`] are exponentials and logarithms. [`literal`] and [`display`] are the ways in from text and out to it. No
//! identity of the expression graph belongs here: those are passes.

mod angle;
mod atom;
mod display;
pub mod elementary;
pub mod enclosure;
mod evaluation;
mod literal;
mod powers;
pub mod rational;
mod root;
pub mod rounding;
mod size;
mod sum;

use core::cmp::Ordering;

use num_bigint::BigInt;
use num_traits::One;

use atom::AtomKind;
pub use atom::AtomScope;
pub use atom::known as known_atoms;
pub use enclosure::Enclosure;
use rational::Rational;
use rounding::{Format, NARROW, WIDE};
use sum::Term;

/// An exact real number.
///
/// Held as a rational, or as a sum of rational multiples of products of π, roots, sines, cosines
/// and angles, which is enclosed more and more tightly until it rounds uniquely. Equality is
/// structural on the normal form: equal values are normally, not always, recognised as equal.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct Exact {
    form: ExactForm,
}

/// `Ord` is an order of forms, to sort by; [`Exact::cmp_value`] is the order of numbers.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
enum ExactForm {
    Rational(Rational),
    /// Sorted terms with different factors, not all of them rational.
    Sum(Vec<Term>),
}

impl Exact {
    pub fn integer(value: i64) -> Self {
        Self::rational(Rational::integer(value))
    }

    /// A decimal literal as Rust writes it (`1_000.5e-3`), exactly; `None` where it is none, and
    /// beyond an exponent or a length of 4096.
    pub fn decimal(digits: &str) -> Option<Self> {
        literal::parse(digits).map(Self::rational)
    }

    /// The exact value of a float; `None` unless finite.
    pub fn float(value: f64) -> Option<Self> {
        word(value).map(Self::rational)
    }

    pub fn pi() -> Self {
        Self::atom(AtomKind::Pi)
    }

    pub fn add(&self, other: &Self) -> Self {
        match (&self.form, &other.form) {
            (ExactForm::Rational(a), ExactForm::Rational(b)) => Self::rational(a.add(b)),
            _ => self.sum_of(other),
        }
    }

    pub fn sub(&self, other: &Self) -> Self {
        match (&self.form, &other.form) {
            (ExactForm::Rational(a), ExactForm::Rational(b)) => Self::rational(a.sub(b)),
            _ => self.sum_of(&other.neg()),
        }
    }

    pub fn mul(&self, other: &Self) -> Self {
        self.product_of(other)
    }

    /// `None` where the divisor is zero.
    pub fn div(&self, other: &Self) -> Option<Self> {
        (!other.is_zero()).then(|| self.quotient_of(other))
    }

    pub fn neg(&self) -> Self {
        self.scaled(&Rational::integer(-1))
    }

    /// `None` for a negative number; rational on rational squares.
    pub fn sqrt(&self) -> Option<Self> {
        match self.signum() {
            Ordering::Less => None,
            Ordering::Equal => Some(Self::integer(0)),
            Ordering::Greater => Some(self.root()),
        }
    }

    pub fn is_zero(&self) -> bool {
        self.signum().is_eq()
    }

    pub fn is_one(&self) -> bool {
        match &self.form {
            ExactForm::Rational(value) => value.is_one(),
            ExactForm::Sum(_) => self.cmp_value(&Self::integer(1)).is_eq(),
        }
    }

    /// The index of the first of the integers that equals the number.
    pub fn first_of(&self, integers: &[i64]) -> Option<usize> {
        // One coarse enclosure rules out all of them for nearly every number.
        if let (ExactForm::Sum(_), Some(coarse)) = (&self.form, self.enclose(Enclosure::MIN_BITS)) {
            let integer = |value| Enclosure::integer(value, coarse.bits());
            let is_other =
                |&value: &i64| coarse.sub(&integer(value)).sign().is_some_and(Ordering::is_ne);
            if integers.iter().all(is_other) {
                return None;
            }
        }
        integers.iter().position(|&value| self.cmp_value(&Self::integer(value)).is_eq())
    }

    /// The order against zero: exact for rationals; an expression whose enclosure still holds
    /// zero at the finest precision counts as zero.
    pub fn signum(&self) -> Ordering {
        self.sign()
    }

    pub fn cmp_value(&self, other: &Self) -> Ordering {
        match (&self.form, &other.form) {
            (ExactForm::Rational(a), ExactForm::Rational(b)) => a.cmp(b),
            _ => self.sub(other).signum(),
        }
    }

    /// `Some` where the number is an integer that fits.
    pub fn to_integer(&self) -> Option<i64> {
        match &self.form {
            ExactForm::Rational(value) => value.to_integer(),
            ExactForm::Sum(_) => {
                let near = word(self.to_f64().round())?.to_integer()?;
                self.sub(&Self::integer(near)).is_zero().then_some(near)
            }
        }
    }

    /// Correctly rounded (ties to even); infinite beyond the range.
    pub fn to_f64(&self) -> f64 {
        self.rounded(WIDE, &Rational::ZERO)
    }

    /// See [`Self::to_f64`].
    pub fn to_f32(&self) -> f32 {
        self.rounded(NARROW, &Rational::ZERO) as f32
    }

    /// The remainder of `to_f64`: (self − to_f64) correctly rounded, the low word of a double word.
    /// It is zero beyond the range.
    pub fn low_f64(&self) -> f64 {
        self.low_word(WIDE)
    }

    /// See [`Self::low_f64`].
    pub fn low_f32(&self) -> f32 {
        self.low_word(NARROW) as f32
    }

    /// An enclosure in units of 2^−bits; `None` where these are too coarse to tell a divisor from
    /// zero.
    pub fn enclose(&self, bits: u32) -> Option<Enclosure> {
        self.enclosed(bits.max(Enclosure::MIN_BITS))
    }

    fn low_word(&self, format: Format) -> f64 {
        word(self.rounded(format, &Rational::ZERO)).map_or(0.0, |word| self.rounded(format, &word))
    }
}

/// The exact value of a finite float.
pub fn word(value: f64) -> Option<Rational> {
    if !value.is_finite() {
        return None;
    }
    let bits = value.to_bits();
    let (biased, fraction) = ((bits >> 52 & 0x7ff) as i32, (bits & ((1 << 52) - 1)) as i64);
    let significand = if biased == 0 { fraction } else { fraction | 1 << 52 };
    let significand =
        BigInt::from(if value.is_sign_negative() { -significand } else { significand });
    let exponent = biased.max(1) - 1075;
    Some(if exponent < 0 {
        Rational::of(significand, BigInt::one() << -exponent)
    } else {
        Rational::of(significand << exponent, BigInt::one())
    })
}
