//! The short text of a number, for the text form of a graph.

use core::fmt::{self, Display, Formatter, Write};

use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{One, Signed, Zero};

use super::atom::AtomKind;
use super::rational::Rational;
use super::rounding::WIDE;
use super::sum::{Factor, Term};
use super::{Exact, ExactForm};

/// The most digits a rational is written out with.
const DIGITS: usize = 20;
/// The bits of so many digits.
const BITS: u64 = 66;
/// The most bytes an expression is written out with.
const LENGTH: usize = 160;

impl Display for Exact {
    /// `0.632`, `1/3*pi`, `0.5*sqrt(2) - sin(1.2)`; what would be long is rounded, with a `~`
    /// before it.
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let mut text = Bounded(String::new());
        match write_number(&mut text, self) {
            Ok(()) => f.write_str(&text.0),
            Err(fmt::Error) => write!(f, "~{:?}", self.to_f64()),
        }
    }
}

/// A text that refuses to get long: written out, a number that shares its parts grows without
/// bounds.
struct Bounded(String);

impl Write for Bounded {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        if self.0.len() + text.len() > LENGTH {
            return Err(fmt::Error);
        }
        self.0.write_str(text)
    }
}

fn write_number(text: &mut Bounded, number: &Exact) -> fmt::Result {
    let terms = match &number.form {
        ExactForm::Rational(value) => return text.write_str(&rational_text(value)),
        ExactForm::Sum(terms) => terms,
    };
    for (place, term) in terms.iter().enumerate() {
        let negative = term.coefficient.signum().is_lt();
        text.write_str(match (place, negative) {
            (0, true) => "-",
            (0, false) => "",
            (_, true) => " - ",
            (_, false) => " + ",
        })?;
        write_size(text, term)?;
    }
    Ok(())
}

/// The term without its sign: what multiplies, then what divides.
fn write_size(text: &mut Bounded, term: &Term) -> fmt::Result {
    let size = term.coefficient.abs();
    let mut multipliers = term.factors.iter().filter(|factor| factor.power > 0);
    if !size.is_one() {
        text.write_str(&rational_text(&size))?;
    } else if let Some(first) = multipliers.next() {
        write_factor(text, first)?;
    } else {
        text.write_str("1")?;
    }
    for factor in multipliers {
        text.write_str("*")?;
        write_factor(text, factor)?;
    }
    for divisor in term.factors.iter().filter(|factor| factor.power < 0) {
        text.write_str("/")?;
        write_factor(text, divisor)?;
    }
    Ok(())
}

fn write_factor(text: &mut Bounded, factor: &Factor) -> fmt::Result {
    let (function, argument) = match factor.atom.kind() {
        AtomKind::Pi => ("pi", None),
        AtomKind::Root(radicand) => ("sqrt", Some(radicand)),
        AtomKind::Of(function, argument) => (function.name(), Some(argument)),
        AtomKind::Sum(sum) => ("", Some(sum)),
    };
    text.write_str(function)?;
    if let Some(argument) = argument {
        text.write_str("(")?;
        write_number(text, argument)?;
        text.write_str(")")?;
    }
    match factor.power.unsigned_abs() {
        1 => Ok(()),
        power => write!(text, "^{power}"),
    }
}

/// A finite decimal where there is a short one, else a short fraction, else digits after `~`.
fn rational_text(value: &Rational) -> String {
    if let Some(decimal) = short_decimal(value) {
        return decimal;
    }
    let (numerator, denominator) = (value.numerator(), value.denominator());
    if numerator.bits() + denominator.bits() <= BITS {
        return format!("{numerator}/{denominator}");
    }
    let near = WIDE.round(value);
    if near.is_normal() { format!("~{near:?}") } else { approximate(value) }
}

fn short_decimal(value: &Rational) -> Option<String> {
    let (mut numerator, mut denominator) = (value.numerator(), value.denominator());
    if numerator.bits().max(denominator.bits()) > BITS {
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

/// Ten digits and the exponent of what no float reaches.
fn approximate(value: &Rational) -> String {
    const SIGNIFICANT: i64 = 10;
    let (numerator, denominator) = (value.numerator().abs(), value.denominator());
    // One bit is 0.30103 decimal digits: the estimate is off by one digit at most.
    let bits = numerator.bits() as i64 - denominator.bits() as i64;
    let shift = SIGNIFICANT + 1 - bits * 30103 / 100_000;
    let ten = |power: i64| BigInt::from(10).pow(power.max(0) as u32);
    let digits = ((numerator * ten(shift)) / (denominator * ten(-shift))).to_string();
    let exponent = digits.len() as i64 - 1 - shift;
    let (first, rest) = digits.split_at(1);
    let rest = rest[..rest.len().min(SIGNIFICANT as usize - 1)].trim_end_matches('0');
    let sign = if value.signum().is_lt() { "-" } else { "" };
    let point = if rest.is_empty() { "" } else { "." };
    format!("~{sign}{first}{point}{rest}e{exponent}")
}
