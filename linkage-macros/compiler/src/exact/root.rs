//! Square roots in normal form.

use core::cmp::Ordering;

use num_bigint::BigInt;
use num_traits::One;

use super::atom::AtomKind;
use super::rational::{Rational, square_part};
use super::sum::{Factor, Term};
use super::{Exact, ExactForm};
use crate::function::Function;

impl Exact {
    /// The root of a number that is not negative.
    pub(super) fn root(&self) -> Self {
        match (&self.form, self.as_term()) {
            (ExactForm::Rational(value), _) => Self::root_of_rational(value),
            (_, Some(term)) => root_of_term(term),
            _ => {
                let (content, monic) = self.monic();
                let sign = sign_as_factor(content.signum());
                let root = match sine_of_square(&monic) {
                    Some(sine) => sine.scaled(&sign_as_factor(sine.signum())),
                    None => Self::atom(AtomKind::Root(monic.scaled(&sign))),
                };
                Self::root_of_rational(&content.abs()).product_of(&root)
            }
        }
    }

    /// √(a²m/(b²n)) = a/(b·n)·√(m·n), where m and n have no square factors.
    pub(super) fn root_of_rational(value: &Rational) -> Self {
        if value.is_zero() {
            return Self::rational(Rational::ZERO);
        }
        let (a, m) = square_part(&value.numerator());
        let (b, n) = square_part(&value.denominator());
        let coefficient = Rational::of(a, b * &n);
        let radicand = m * n;
        if radicand.is_one() {
            return Self::rational(coefficient);
        }
        let radicand = Self::rational(Rational::of(radicand, BigInt::one()));
        Self::atom(AtomKind::Root(radicand)).scaled(&coefficient)
    }
}

/// Takes the even powers out: √(c·f^(2k + 1)) = √|c|·|f|^k·√(±f).
fn root_of_term(term: &Term) -> Exact {
    let mut root = Exact::root_of_rational(&term.coefficient.abs());
    let mut radicand = Exact::rational(sign_as_factor(term.coefficient.signum()));
    for Factor { atom, power } in &term.factors {
        let value = Exact::atom(atom.kind().clone());
        let half = power.div_euclid(2);
        if half != 0 {
            let size = value.scaled(&sign_as_factor(value.signum()));
            root = root.product_of(&size.power(half));
        }
        if power.rem_euclid(2) == 1 {
            radicand = radicand.product_of(&value);
        }
    }
    match &radicand.form {
        // Nothing is left below the root: the coefficient had to be positive.
        ExactForm::Rational(_) => root,
        ExactForm::Sum(_) => root.product_of(&Exact::atom(AtomKind::Root(radicand))),
    }
}

/// sin x, where the number is 1 − cos² x: the form that the square of a sine has.
fn sine_of_square(number: &Exact) -> Option<Exact> {
    let ExactForm::Sum(terms) = &number.form else { return None };
    let [one, square] = terms.as_slice() else { return None };
    let [Factor { atom, power: 2 }] = square.factors.as_slice() else { return None };
    match atom.kind() {
        AtomKind::Of(Function::Cos, angle)
            if one.factors.is_empty() && square.coefficient == one.coefficient.neg() =>
        {
            Some(Exact::atom(AtomKind::Of(Function::Sin, angle.clone())))
        }
        _ => None,
    }
}

fn sign_as_factor(sign: Ordering) -> Rational {
    if sign.is_lt() { Rational::integer(-1) } else { Rational::ONE }
}
