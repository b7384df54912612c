//! The normal form of what is not rational: a sum of products.
//!
//! A [`Term`] is a rational times powers of [`Atom`]s, the numbers that arithmetic does not open:
//! π, roots, sines, …. A sum's terms are sorted, and no two of them have the same powers, so that
//! what is equal by the laws of a ring is structurally equal. Nothing is rounded here, and nothing
//! is decided by looking at a number's digits.

use super::rational::Rational;
use super::{Exact, Form};

/// Products of sums with more terms than this are not multiplied out.
const EXPANSION_LIMIT: usize = 64;

/// A number that arithmetic does not open.
///
/// The order of the variants is the order of factors in a product and of terms in a sum.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub(super) enum Atom {
    Pi,
    /// The root of a positive number: an integer without small square factors, or one that is not
    /// rational and has the leading coefficient ±1. Its power in a product is always one.
    Root(Exact),
    /// The sine of an angle in the normal form of [`super::angle`]; its power is never above one.
    Sin(Exact),
    Cos(Exact),
    /// The arc sine of a number whose leading coefficient is positive.
    Asin(Exact),
    Atan(Exact),
    /// A sum of several terms whose first coefficient is one, as a factor: a divisor mostly.
    Sum(Exact),
}

/// An atom to a power that is not zero.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub(super) struct Factor {
    pub(super) atom: Atom,
    pub(super) power: i32,
}

/// A rational, not zero, times sorted powers of different atoms.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub(super) struct Term {
    pub(super) factors: Vec<Factor>,
    pub(super) coefficient: Rational,
}

impl Term {
    pub(super) fn rational(coefficient: Rational) -> Self {
        Self { factors: Vec::new(), coefficient }
    }

    fn scaled(&self, by: &Rational) -> Self {
        Self { factors: self.factors.clone(), coefficient: self.coefficient.mul(by) }
    }
}

impl Exact {
    /// The number that the atom is; for atoms whose first power needs no rewriting.
    pub(super) fn atom(atom: Atom) -> Self {
        let factors = vec![Factor { atom, power: 1 }];
        Self { form: Form::Sum(vec![Term { factors, coefficient: Rational::ONE }]) }
    }

    pub(super) fn rational(value: Rational) -> Self {
        Self { form: Form::Rational(value) }
    }

    /// The terms; none for zero.
    pub(super) fn terms(&self) -> Vec<Term> {
        match &self.form {
            Form::Rational(value) if value.is_zero() => Vec::new(),
            Form::Rational(value) => vec![Term::rational(value.clone())],
            Form::Sum(terms) => terms.clone(),
        }
    }

    /// The one term of a number that is not rational and has no other.
    pub(super) fn as_term(&self) -> Option<&Term> {
        match &self.form {
            Form::Sum(terms) if terms.len() == 1 => terms.first(),
            _ => None,
        }
    }

    /// The sum of terms in any order.
    pub(super) fn collect(mut terms: Vec<Term>) -> Self {
        terms.sort_unstable_by(|a, b| a.factors.cmp(&b.factors));
        let mut sum: Vec<Term> = Vec::with_capacity(terms.len());
        for term in terms {
            match sum.last_mut() {
                Some(last) if last.factors == term.factors => {
                    last.coefficient = last.coefficient.add(&term.coefficient);
                }
                _ => sum.push(term),
            }
        }
        sum.retain(|term| !term.coefficient.is_zero());
        match sum.as_slice() {
            [] => Self::rational(Rational::ZERO),
            [term] if term.factors.is_empty() => Self::rational(term.coefficient.clone()),
            _ => Self { form: Form::Sum(sum) },
        }
    }

    pub(super) fn sum_of(&self, other: &Self) -> Self {
        let mut terms = self.terms();
        terms.extend(other.terms());
        Self::collect(terms)
    }

    pub(super) fn scaled(&self, by: &Rational) -> Self {
        match &self.form {
            Form::Rational(value) => Self::rational(value.mul(by)),
            Form::Sum(_) if by.is_zero() => Self::rational(Rational::ZERO),
            Form::Sum(terms) => {
                Self { form: Form::Sum(terms.iter().map(|term| term.scaled(by)).collect()) }
            }
        }
    }

    pub(super) fn product_of(&self, other: &Self) -> Self {
        match (&self.form, &other.form) {
            (Form::Rational(value), _) => other.scaled(value),
            (_, Form::Rational(value)) => self.scaled(value),
            (Form::Sum(a), Form::Sum(b)) => {
                if let Some(product) = cancelled(a, other).or_else(|| cancelled(b, self)) {
                    return product;
                }
                if a.len() > 1 && b.len() > 1 && a.len() * b.len() > EXPANSION_LIMIT {
                    return unexpanded(self, other);
                }
                let mut terms = Vec::with_capacity(a.len() * b.len());
                for left in a {
                    for right in b {
                        terms.extend(product_of_terms(left, right).terms());
                    }
                }
                Self::collect(terms)
            }
        }
    }

    /// One over a number that is not zero.
    pub(super) fn reciprocal(&self) -> Self {
        match &self.form {
            Form::Rational(value) => Self::rational(value.recip()),
            Form::Sum(terms) => match terms.as_slice() {
                [term] => {
                    let invert = |factor: &Factor| Factor {
                        atom: factor.atom.clone(),
                        power: -factor.power,
                    };
                    let factors = term.factors.iter().map(invert).collect();
                    rewritten(Term { factors, coefficient: term.coefficient.recip() })
                }
                _ => {
                    let (content, monic) = self.monic();
                    let factors = vec![Factor { atom: Atom::Sum(monic), power: -1 }];
                    let coefficient = content.recip();
                    Self { form: Form::Sum(vec![Term { factors, coefficient }]) }
                }
            },
        }
    }

    /// The quotient by a number that is not zero.
    pub(super) fn quotient_of(&self, divisor: &Self) -> Self {
        let ((content, monic), (divisor_content, divisor_monic)) = (self.monic(), divisor.monic());
        if monic == divisor_monic {
            return Self::rational(content.div(&divisor_content));
        }
        self.product_of(&divisor.reciprocal())
    }

    /// The integer power of a number that is not zero.
    pub(super) fn power(&self, exponent: i32) -> Self {
        let base = if exponent < 0 { self.reciprocal() } else { self.clone() };
        (0..exponent.unsigned_abs())
            .fold(Self::rational(Rational::ONE), |power, _| power.product_of(&base))
    }

    /// The coefficient of the first term, and the number divided by it; (1, 0) for zero.
    pub(super) fn monic(&self) -> (Rational, Self) {
        let content = match &self.form {
            Form::Rational(value) => value.clone(),
            Form::Sum(terms) => terms[0].coefficient.clone(),
        };
        if content.is_zero() {
            return (Rational::ONE, self.clone());
        }
        let monic = self.scaled(&content.recip());
        (content, monic)
    }
}

/// The product, where every term of `a` is divided by the sum `b`.
fn cancelled(a: &[Term], b: &Exact) -> Option<Exact> {
    let several = matches!(&b.form, Form::Sum(terms) if terms.len() > 1);
    if !several || !a.iter().any(|term| term.factors.iter().any(is_divisor)) {
        return None;
    }
    let (content, monic) = b.monic();
    let divisor = Atom::Sum(monic);
    let cancel = |term: &Term| {
        let mut term = term.scaled(&content);
        let place = term.factors.iter().position(|f| f.atom == divisor && is_divisor(f))?;
        term.factors[place].power += 1;
        term.factors.retain(|factor| factor.power != 0);
        Some(term)
    };
    Some(Exact::collect(a.iter().map(cancel).collect::<Option<_>>()?))
}

fn is_divisor(factor: &Factor) -> bool {
    matches!(factor.atom, Atom::Sum(_)) && factor.power < 0
}

/// The product of two sums as one term of two factors.
fn unexpanded(a: &Exact, b: &Exact) -> Exact {
    let as_term = |sum: &Exact| {
        let (coefficient, monic) = sum.monic();
        Term { factors: vec![Factor { atom: Atom::Sum(monic), power: 1 }], coefficient }
    };
    Exact { form: Form::Sum(vec![merged(&as_term(a), &as_term(b))]) }
}

fn product_of_terms(a: &Term, b: &Term) -> Exact {
    if a.factors.is_empty() || b.factors.is_empty() {
        return Exact::collect(vec![merged(a, b)]);
    }
    rewritten(merged(a, b))
}

/// The product by the laws of powers alone.
fn merged(a: &Term, b: &Term) -> Term {
    let mut factors = a.factors.clone();
    for factor in &b.factors {
        match factors.binary_search_by(|known| known.atom.cmp(&factor.atom)) {
            Ok(place) => factors[place].power += factor.power,
            Err(place) => factors.insert(place, factor.clone()),
        }
    }
    factors.retain(|factor| factor.power != 0);
    Term { factors, coefficient: a.coefficient.mul(&b.coefficient) }
}

/// The term in normal form: an identity that opens one of its atoms is applied until none does.
fn rewritten(mut term: Term) -> Exact {
    let opened = open_root(&mut term.factors)
        .or_else(|| join_roots(&mut term.factors))
        .or_else(|| open_square_of_sine(&mut term.factors))
        .or_else(|| open_sum(&mut term.factors));
    match opened {
        Some(opened) => rewritten(term).product_of(&opened),
        None => Exact::collect(vec![term]),
    }
}

/// (√x)^(2k + 1) = x^k·√x: takes x^k out, of either sign.
fn open_root(factors: &mut Vec<Factor>) -> Option<Exact> {
    let (place, radicand) =
        factors.iter().enumerate().find_map(|(place, factor)| match &factor.atom {
            Atom::Root(radicand) if factor.power != 1 => Some((place, radicand.clone())),
            _ => None,
        })?;
    let power = factors[place].power;
    factors[place].power = power.rem_euclid(2);
    factors.retain(|factor| factor.power != 0);
    Some(radicand.power(power.div_euclid(2)))
}

/// √m·√n of integers = √(m·n), whose square factors come out.
fn join_roots(factors: &mut Vec<Factor>) -> Option<Exact> {
    let rational_root = |factor: &Factor| match &factor.atom {
        Atom::Root(Exact { form: Form::Rational(radicand) }) => Some(radicand.clone()),
        _ => None,
    };
    let first = factors.iter().position(|factor| rational_root(factor).is_some())?;
    let second =
        factors.iter().skip(first + 1).position(|factor| rational_root(factor).is_some())?
            + first
            + 1;
    let second = rational_root(&factors.remove(second))?;
    let first = rational_root(&factors.remove(first))?;
    Some(Exact::root_of_rational(&first.mul(&second)))
}

/// sin² x = 1 − cos² x.
fn open_square_of_sine(factors: &mut Vec<Factor>) -> Option<Exact> {
    let (place, angle) =
        factors.iter().enumerate().find_map(|(place, factor)| match &factor.atom {
            Atom::Sin(angle) if factor.power > 1 => Some((place, angle.clone())),
            _ => None,
        })?;
    factors[place].power -= 2;
    factors.retain(|factor| factor.power != 0);
    let square = vec![Factor { atom: Atom::Cos(angle), power: 2 }];
    Some(Exact::collect(vec![
        Term::rational(Rational::ONE),
        Term { factors: square, coefficient: Rational::integer(-1) },
    ]))
}

/// Multiplies a sum out, unless there are several: those were kept apart for their size.
fn open_sum(factors: &mut Vec<Factor>) -> Option<Exact> {
    let is_multiplier = |factor: &Factor| matches!(factor.atom, Atom::Sum(_)) && factor.power > 0;
    let mut multipliers = factors.iter().enumerate().filter(|(_, factor)| is_multiplier(factor));
    let (place, _) = multipliers.next().filter(|(_, factor)| factor.power == 1)?;
    if multipliers.next().is_some() {
        return None;
    }
    match factors.remove(place).atom {
        Atom::Sum(sum) => Some(sum),
        _ => None,
    }
}
