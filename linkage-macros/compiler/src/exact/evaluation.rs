//! Evaluation of a number in normal form: its enclosure, its sign and its floats.
//!
//! Enclosures are refined until they decide the question. A float is decided at the latest where
//! the enclosure is narrow against half the least subnormal, unless the number is a tie that the
//! normal form does not recognise as rational.

use core::cmp::Ordering;

use super::enclosure::Enclosure;
use super::rational::Rational;
use super::rounding::Format;
use super::sum::{Factor, Term};
use super::{Exact, ExactForm};

/// The coarsest bits for a question of sign and for a float, and the finest for both.
const COARSEST_SIGN: u32 = 64;
const COARSEST_FLOAT: u32 = 128;
const FINEST: u32 = 4096;

fn refinements(coarsest: u32) -> impl Iterator<Item = u32> {
    core::iter::successors(Some(coarsest), |bits| Some(bits * 2)).take_while(|&bits| bits <= FINEST)
}

impl Exact {
    /// An enclosure in units of 2^−bits; `None` where these are too coarse to tell a divisor from
    /// zero.
    pub(super) fn enclosed(&self, bits: u32) -> Option<Enclosure> {
        match &self.form {
            ExactForm::Rational(value) => Some(Enclosure::rational(value, bits)),
            ExactForm::Sum(terms) => terms
                .iter()
                .map(|term| term.enclosed(bits))
                .try_fold(Enclosure::integer(0, bits), |sum, term| Some(sum.add(&term?))),
        }
    }

    pub(super) fn sign(&self) -> Ordering {
        match &self.form {
            ExactForm::Rational(value) => value.signum(),
            ExactForm::Sum(terms) => match terms.as_slice() {
                [term] if term.factors.iter().all(|factor| factor.atom.is_surely_positive()) => {
                    term.coefficient.signum()
                }
                _ => refinements(COARSEST_SIGN)
                    .find_map(|bits| self.enclosed(bits)?.sign())
                    .unwrap_or(Ordering::Equal),
            },
        }
    }

    /// The number of the format next to self − `word`; zero has no sign.
    ///
    /// A number that the finest enclosure leaves undecided is a tie in all likelihood: its middle
    /// is rounded.
    pub(super) fn rounded(&self, format: Format, word: &Rational) -> f64 {
        if let ExactForm::Rational(value) = &self.form {
            return format.round(&value.sub(word)) + 0.0;
        }
        let mut finest = None;
        for bits in refinements(COARSEST_FLOAT) {
            let Some(enclosure) = self.enclosed(bits) else { continue };
            let rest = enclosure.sub(&Enclosure::rational(word, bits));
            let lower = format.round_fixed(rest.lower(), bits);
            if lower == format.round_fixed(rest.upper(), bits) {
                return lower + 0.0;
            }
            finest = Some(rest);
        }
        finest
            .map_or(0.0, |rest| format.round_fixed(&(rest.lower() + rest.upper()), rest.bits() + 1))
    }
}

impl Term {
    fn enclosed(&self, bits: u32) -> Option<Enclosure> {
        let mut product: Option<Enclosure> = None;
        for factor in &self.factors {
            let value = factor.enclosed(bits)?;
            product = Some(match product {
                Some(product) => product.mul(&value),
                None => value,
            });
        }
        Some(match product {
            Some(product) => product.scaled(&self.coefficient),
            None => Enclosure::rational(&self.coefficient, bits),
        })
    }
}

impl Factor {
    fn enclosed(&self, bits: u32) -> Option<Enclosure> {
        let value = self.atom.enclosed(bits)?;
        let power =
            (1..self.power.unsigned_abs()).fold(value.clone(), |power, _| power.mul(&value));
        if self.power < 0 { Enclosure::integer(1, bits).div(&power) } else { Some(power) }
    }
}
