//! The short text of a number, for the text form of a graph.

use core::fmt::{self, Display, Formatter};

use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{One, Signed, Zero};

use super::rational::Rational;
use super::sum::{Atom, Factor, Term};
use super::{Exact, Form};

/// The most digits a rational is written out with.
const DIGITS: usize = 20;

impl Display for Exact {
    /// `0.632`, `1/3*pi`, `0.5*sqrt(2) - sin(1.2)`; a rational that would be long is preceded by
    /// `~` and rounded.
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let terms = match &self.form {
            Form::Rational(value) => return f.write_str(&rational_text(value)),
            Form::Sum(terms) => terms,
        };
        for (place, term) in terms.iter().enumerate() {
            let negative = term.coefficient.signum().is_lt();
            f.write_str(match (place, negative) {
                (0, true) => "-",
                (0, false) => "",
                (_, true) => " - ",
                (_, false) => " + ",
            })?;
            write_size(f, term)?;
        }
        Ok(())
    }
}

/// The term without its sign: what multiplies, then what divides.
fn write_size(f: &mut Formatter<'_>, term: &Term) -> fmt::Result {
    let size = term.coefficient.abs();
    let multipliers = term.factors.iter().filter(|factor| factor.power > 0);
    let mut parts: Vec<String> = multipliers.map(factor_text).collect();
    if !size.is_one() || parts.is_empty() {
        parts.insert(0, rational_text(&size));
    }
    f.write_str(&parts.join("*"))?;
    for divisor in term.factors.iter().filter(|factor| factor.power < 0) {
        write!(f, "/{}", factor_text(divisor))?;
    }
    Ok(())
}

fn factor_text(factor: &Factor) -> String {
    let atom = match &factor.atom {
        Atom::Pi => "pi".to_owned(),
        Atom::Root(radicand) => format!("sqrt({radicand})"),
        Atom::Sin(angle) => format!("sin({angle})"),
        Atom::Cos(angle) => format!("cos({angle})"),
        Atom::Asin(sine) => format!("asin({sine})"),
        Atom::Atan(tangent) => format!("atan({tangent})"),
        Atom::Sum(sum) => format!("({sum})"),
    };
    match factor.power.unsigned_abs() {
        1 => atom,
        power => format!("{atom}^{power}"),
    }
}

/// A finite decimal where there is a short one, else a short fraction, else digits after `~`.
fn rational_text(value: &Rational) -> String {
    if let Some(decimal) = short_decimal(value) {
        return decimal;
    }
    let fraction = format!("{}/{}", value.numerator(), value.denominator());
    if fraction.len() <= 2 * DIGITS { fraction } else { approximate(value) }
}

fn short_decimal(value: &Rational) -> Option<String> {
    let (mut numerator, mut denominator) = (value.numerator(), value.denominator());
    if denominator.bits() > 4 * DIGITS as u64 || numerator.bits() > 4 * DIGITS as u64 {
        return None;
    }
    let mut places = 0;
    while !denominator.is_one() {
        // A factor of two or five is made a ten; a denominator with any other has no decimals.
        let factor = if denominator.is_even() { 2 } else { 5 };
        let (quotient, remainder) = denominator.div_rem(&BigInt::from(factor));
        if !remainder.is_zero() || places == DIGITS {
            return None;
        }
        (numerator, denominator) = match denominator.is_multiple_of(&BigInt::from(10)) {
            true => (numerator, denominator / 10),
            false => (numerator * (10 / factor), quotient),
        };
        places += 1;
    }
    let digits = format!("{:0>width$}", numerator.abs().to_string(), width = places + 1);
    if digits.len() > DIGITS {
        return None;
    }
    let (whole, fraction) = digits.split_at(digits.len() - places);
    let sign = if numerator.is_negative() { "-" } else { "" };
    let point = if places > 0 { "." } else { "" };
    Some(format!("{sign}{whole}{point}{fraction}"))
}

/// Seventeen digits and the exponent, also where no float reaches.
fn approximate(value: &Rational) -> String {
    const SIGNIFICANT: i64 = 17;
    let (numerator, denominator) = (value.numerator().abs(), value.denominator());
    // One bit is 0.30103 decimal digits: the estimate is off by one digit at most.
    let bits = numerator.bits() as i64 - denominator.bits() as i64;
    let exponent = bits * 30103 / 100_000;
    let shift = SIGNIFICANT - exponent;
    let ten = |power: i64| BigInt::from(10).pow(power.max(0) as u32);
    let digits = ((numerator * ten(shift)) / (denominator * ten(-shift))).to_string();
    let exponent = digits.len() as i64 - 1 - shift;
    let (first, rest) = digits.split_at(1);
    let rest = &rest[..rest.len().min(SIGNIFICANT as usize - 1)];
    let sign = if value.signum().is_lt() { "-" } else { "" };
    format!("~{sign}{first}.{rest}e{exponent}")
}
