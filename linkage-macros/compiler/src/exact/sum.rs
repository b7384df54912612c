//! The normal form of what is not rational: a sum of products.
//!
//! A [`Term`] is a rational times powers of [`Atom`]s: π, roots, sines, …. A sum's terms are sorted,
//! and no two of them have the same powers, so that what is equal by the laws of a ring is mostly
//! structurally equal: small products are multiplied out, large ones and quotients are not. Nothing
//! is rounded here, and nothing is decided by looking at a number's digits.

use super::atom::{Atom, AtomKind};
use super::rational::Rational;
use super::{Exact, ExactForm};
use crate::function::Function;

/// Products with more terms than this are not multiplied out, so that a sum grows no faster than
/// the source it came from.
const EXPANSION_LIMIT: usize = 16;

/// An atom to a power that is not zero.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub(super) struct Factor {
    pub(super) atom: Atom,
    pub(super) power: i32,
}

impl Factor {
    fn is_sum(&self) -> bool {
        matches!(self.atom.kind(), AtomKind::Sum(_))
    }
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

    pub(super) fn is_multiple_of_pi(&self) -> bool {
        matches!(self.factors.as_slice(), [Factor { atom, power: 1 }] if *atom.kind() == AtomKind::Pi)
    }

    fn scaled(&self, by: &Rational) -> Self {
        Self { factors: self.factors.clone(), coefficient: self.coefficient.mul(by) }
    }
}

impl Atom {
    /// True if the form alone shows that the atom is positive.
    pub(super) fn is_surely_positive(&self) -> bool {
        match self.kind() {
            AtomKind::Pi | AtomKind::Root(_) => true,
            // Multiples of π are between 0 and 45°.
            AtomKind::Of(Function::Sin | Function::Cos, angle) => {
                angle.as_term().is_some_and(Term::is_multiple_of_pi)
            }
            AtomKind::Of(Function::Exp, _) => true,
            // An arc or a hyperbolic tangent of a number with a positive first coefficient.
            AtomKind::Of(function, value) => {
                !function.needs_positive() && matches!(value.form, ExactForm::Rational(_))
            }
            AtomKind::Sum(_) => false,
        }
    }
}

impl Exact {
    /// The number that the atom is. A [`AtomKind::Sum`] is none by itself.
    pub(super) fn atom(kind: AtomKind) -> Self {
        let factors = vec![Factor { atom: Atom::new(kind), power: 1 }];
        Self { form: ExactForm::Sum(vec![Term { factors, coefficient: Rational::ONE }]) }
    }

    pub(super) fn rational(value: Rational) -> Self {
        Self { form: ExactForm::Rational(value) }
    }

    /// The terms; none for zero.
    pub(super) fn terms(&self) -> Vec<Term> {
        match &self.form {
            ExactForm::Rational(value) if value.is_zero() => Vec::new(),
            ExactForm::Rational(value) => vec![Term::rational(value.clone())],
            ExactForm::Sum(terms) => terms.clone(),
        }
    }

    /// Zero by its form; a sum that happens to be zero is not looked at.
    pub(super) fn is_structural_zero(&self) -> bool {
        matches!(&self.form, ExactForm::Rational(value) if value.is_zero())
    }

    /// The one term of a number that is not rational and has no other.
    pub(super) fn as_term(&self) -> Option<&Term> {
        match &self.form {
            ExactForm::Sum(terms) if terms.len() == 1 => terms.first(),
            _ => None,
        }
    }

    /// The number as one term: a sum of several is a factor of it.
    fn as_factor(&self) -> Term {
        match (&self.form, self.as_term()) {
            (_, Some(term)) => term.clone(),
            (ExactForm::Rational(value), _) => Term::rational(value.clone()),
            _ => {
                let (coefficient, monic) = self.monic();
                let atom = Atom::new(AtomKind::Sum(monic));
                Term { factors: vec![Factor { atom, power: 1 }], coefficient }
            }
        }
    }

    /// True if one of the terms has this sum as a divisor.
    fn divides_any_of(&self, terms: &[Term]) -> bool {
        let has_divisor = |term: &Term| term.factors.iter().any(|f| f.is_sum() && f.power < 0);
        // The factor is made only where there is something to compare it with.
        terms.iter().any(has_divisor) && {
            let divisor = &self.as_factor().factors[0].atom;
            let is_divided = |term: &Term| {
                term.factors.iter().any(|factor| factor.atom == *divisor && factor.power < 0)
            };
            terms.iter().any(is_divided)
        }
    }

    /// The kind of the atom, if the number is one.
    pub(super) fn as_atom(&self) -> Option<&AtomKind> {
        let term = self.as_term().filter(|term| term.coefficient.is_one())?;
        match term.factors.as_slice() {
            [Factor { atom, power: 1 }] => Some(atom.kind()),
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
            _ => Self { form: ExactForm::Sum(sum) },
        }
    }

    pub(super) fn sum_of(&self, other: &Self) -> Self {
        let mut terms = self.terms();
        terms.extend(other.terms());
        Self::collect(terms)
    }

    pub(super) fn scaled(&self, by: &Rational) -> Self {
        match &self.form {
            ExactForm::Rational(value) => Self::rational(value.mul(by)),
            ExactForm::Sum(_) if by.is_zero() => Self::rational(Rational::ZERO),
            ExactForm::Sum(terms) => {
                Self { form: ExactForm::Sum(terms.iter().map(|term| term.scaled(by)).collect()) }
            }
        }
    }

    pub(super) fn product_of(&self, other: &Self) -> Self {
        let (a, b) = match (&self.form, &other.form) {
            (ExactForm::Rational(value), _) => return other.scaled(value),
            (_, ExactForm::Rational(value)) => return self.scaled(value),
            (ExactForm::Sum(a), ExactForm::Sum(b)) => (a, b),
        };
        match (a.as_slice(), b.as_slice()) {
            ([a], _) => rewritten(merged(a, &other.as_factor())),
            (_, [b]) => rewritten(merged(b, &self.as_factor())),
            _ if other.divides_any_of(a) => sum_of_products(a, &[other.as_factor()]),
            _ if self.divides_any_of(b) => sum_of_products(b, &[self.as_factor()]),
            _ if is_expanded(a.len() * b.len(), a.iter().chain(b)) => sum_of_products(a, b),
            _ => rewritten(merged(&self.as_factor(), &other.as_factor())),
        }
    }

    /// One over a number that is not zero.
    pub(super) fn reciprocal(&self) -> Self {
        match &self.form {
            ExactForm::Rational(value) => Self::rational(value.recip()),
            ExactForm::Sum(_) => {
                let mut term = self.as_factor();
                term.factors.iter_mut().for_each(|factor| factor.power = -factor.power);
                term.coefficient = term.coefficient.recip();
                rewritten(term)
            }
        }
    }

    /// The quotient by a number that is not zero.
    pub(super) fn quotient_of(&self, divisor: &Self) -> Self {
        if let (ExactForm::Rational(a), ExactForm::Rational(b)) = (&self.form, &divisor.form) {
            return Self::rational(a.div(b));
        }
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
            ExactForm::Rational(value) => value.clone(),
            ExactForm::Sum(terms) => terms[0].coefficient.clone(),
        };
        if content.is_zero() {
            return (Rational::ONE, self.clone());
        }
        let monic = self.scaled(&content.recip());
        (content, monic)
    }
}

/// True if this many products of the terms are written out: few, and without sums as factors.
fn is_expanded<'a>(products: usize, mut terms: impl Iterator<Item = &'a Term>) -> bool {
    products <= EXPANSION_LIMIT && !terms.any(|term| term.factors.iter().any(Factor::is_sum))
}

fn sum_of_products(a: &[Term], b: &[Term]) -> Exact {
    let mut terms = Vec::with_capacity(a.len() * b.len());
    for left in a {
        for right in b {
            terms.extend(rewritten(merged(left, right)).terms());
        }
    }
    Exact::collect(terms)
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
        .or_else(|| open_square_of_sine(&mut term.factors));
    if let Some(opened) = opened {
        return rewritten(term).product_of(&opened);
    }
    match open_sum(&mut term.factors) {
        Some(terms) => sum_of_products(&[term], &terms),
        None => Exact::collect(vec![term]),
    }
}

/// (√x)^(2k + 1) = x^k·√x: takes x^k out, of either sign.
fn open_root(factors: &mut Vec<Factor>) -> Option<Exact> {
    let (place, radicand) = find(factors, |factor| match factor.atom.kind() {
        AtomKind::Root(radicand) if factor.power != 1 => Some(radicand.clone()),
        _ => None,
    })?;
    let power = factors[place].power;
    factors[place].power = power.rem_euclid(2);
    factors.retain(|factor| factor.power != 0);
    Some(radicand.power(power.div_euclid(2)))
}

/// √(a·g)·√(b·g) of integers = g·√(a·b).
fn join_roots(factors: &mut Vec<Factor>) -> Option<Exact> {
    let root_of_integer = |factor: &Factor| match factor.atom.kind() {
        AtomKind::Root(Exact { form: ExactForm::Rational(radicand) }) => Some(radicand.clone()),
        _ => None,
    };
    let (first, m) = find(factors, root_of_integer)?;
    let (between, n) = find(&factors[first + 1..], root_of_integer)?;
    factors.remove(first + 1 + between);
    factors.remove(first);
    // The fraction m/n = a/b is reduced, and √(a/b) = √(a·b)/b.
    Some(Exact::root_of_rational(&m.div(&n)).scaled(&n))
}

/// sin² x = 1 − cos² x.
fn open_square_of_sine(factors: &mut Vec<Factor>) -> Option<Exact> {
    let (place, angle) = find(factors, |factor| match factor.atom.kind() {
        AtomKind::Of(Function::Sin, angle) if factor.power > 1 => Some(angle.clone()),
        _ => None,
    })?;
    factors[place].power -= 2;
    factors.retain(|factor| factor.power != 0);
    let cosine = Atom::new(AtomKind::Of(Function::Cos, angle));
    let square = vec![Factor { atom: cosine, power: 2 }];
    Some(Exact::collect(vec![
        Term::rational(Rational::ONE),
        Term { factors: square, coefficient: Rational::integer(-1) },
    ]))
}

/// Takes out a small sum that no other sum multiplies or divides, and what is nothing but a sum.
fn open_sum(factors: &mut Vec<Factor>) -> Option<Vec<Term>> {
    let is_sum = |factor: &Factor| factor.is_sum() && factor.power == 1;
    let place = factors.iter().position(is_sum)?;
    let AtomKind::Sum(Exact { form: ExactForm::Sum(terms) }) = factors[place].atom.kind() else {
        return None;
    };
    let alone = factors.len() == 1;
    let others = factors.iter().filter(|factor| factor.is_sum()).count() > 1;
    if !alone && (others || !is_expanded(terms.len(), terms.iter())) {
        return None;
    }
    let terms = terms.clone();
    factors.remove(place);
    Some(terms)
}

/// The first factor that has what is looked for.
fn find<T>(factors: &[Factor], look: impl Fn(&Factor) -> Option<T>) -> Option<(usize, T)> {
    factors.iter().enumerate().find_map(|(place, factor)| Some((place, look(factor)?)))
}
