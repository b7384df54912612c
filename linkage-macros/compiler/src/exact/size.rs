//! The size of a number in normal form. Nothing is rounded here, so every product has the digits of
//! both its factors: ten squarings in a row make a thousand digits of one.

use super::rational::Rational;
use super::sum::{Factor, Term};
use super::{Exact, ExactForm};

/// The most bits of a number that is written down, numerator and denominator together: 1200
/// decimal digits.
///
/// A literal with 17 digits has 114 bits, and 1100 with the exponent -308: so its 35th power, the
/// sum of the reciprocals of 300 primes and the product of any two literals are kept. An operation
/// on numbers of this size takes 6 ms where the compiler is not optimised, and the formulas of a
/// four-bar, all of whose dimensions are so long, a second or two.
const BITS: u64 = 4096;

/// The most bits of a number that formulas make of those. One group makes 24 times as many of
/// them; a chain of groups that stand still makes no end of them, where no root is in the way.
const BITS_OF_FORMULAS: u64 = 32 * BITS;

impl Exact {
    /// True if the number has more digits than a written number may have.
    pub(crate) fn is_too_long(&self) -> bool {
        self.bits() > BITS
    }

    /// True if the number has more digits than formulas may make of written numbers.
    pub(crate) fn is_too_long_for_formulas(&self) -> bool {
        self.bits() > BITS_OF_FORMULAS
    }

    /// Those of all coefficients; what stands inside an atom was counted when that was made.
    fn bits(&self) -> u64 {
        match &self.form {
            ExactForm::Rational(value) => value.bits(),
            ExactForm::Sum(terms) => terms.iter().map(Term::bits).sum(),
        }
    }

    /// The nesting depth of the atoms.
    pub(super) fn depth(&self) -> u32 {
        match &self.form {
            ExactForm::Rational(_) => 0,
            ExactForm::Sum(terms) => {
                let factors = terms.iter().flat_map(|term| &term.factors);
                factors.map(|factor| factor.atom.depth()).max().unwrap_or(0)
            }
        }
    }
}

impl Term {
    /// A power is reckoned by as many products.
    fn bits(&self) -> u64 {
        let bits = |factor: &Factor| 8 + u64::from(factor.power.unsigned_abs());
        self.coefficient.bits() + self.factors.iter().map(bits).sum::<u64>()
    }
}

impl Rational {
    fn bits(&self) -> u64 {
        match self {
            Self::Small(numerator, denominator) => {
                let zeros = numerator.unsigned_abs().leading_zeros() + denominator.leading_zeros();
                u64::from(2 * u64::BITS - zeros)
            }
            Self::Big(big) => big.numer().bits() + big.denom().bits(),
        }
    }
}
