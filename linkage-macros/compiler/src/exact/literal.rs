//! Decimal literals, exactly.

use num_bigint::BigInt;

use super::rational::Rational;

/// Beyond this decimal exponent, and beyond so many digits, no literal means a dimension; the
/// bound keeps a slip of the keyboard from filling the memory.
const EXPONENT_LIMIT: i64 = 4096;

/// The value of a decimal literal without sign and suffix, as Rust writes it: `1_000.5e-3`.
pub(super) fn parse(text: &str) -> Option<Rational> {
    let digits: String = text.chars().filter(|&letter| letter != '_').collect();
    let (mantissa, exponent) = match digits.split_once(['e', 'E']) {
        Some((mantissa, exponent)) => (mantissa, parse_exponent(exponent)?),
        None => (digits.as_str(), 0),
    };
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let all_digits = format!("{whole}{fraction}");
    let well_formed = !whole.is_empty() && all_digits.bytes().all(|byte| byte.is_ascii_digit());
    if !well_formed || all_digits.len() > EXPONENT_LIMIT as usize {
        return None;
    }
    let scale = exponent - fraction.len() as i64;
    Some(
        match all_digits.parse::<i64>() {
            Ok(significand) => Rational::integer(significand),
            Err(_) => Rational::of(BigInt::parse_bytes(all_digits.as_bytes(), 10)?, 1.into()),
        }
        .mul(&power_of_ten(scale)),
    )
}

fn parse_exponent(text: &str) -> Option<i64> {
    let digits = text.strip_prefix(['+', '-']).unwrap_or(text);
    if digits.is_empty() || !digits.bytes().all(|byte| byte.is_ascii_digit()) {
        return None;
    }
    // An exponent that does not fit a word is beyond the limit too.
    let size = digits.parse::<i64>().ok().filter(|&size| size <= EXPONENT_LIMIT)?;
    Some(if text.starts_with('-') { -size } else { size })
}

fn power_of_ten(exponent: i64) -> Rational {
    let size = exponent.unsigned_abs() as u32;
    let power = match 10_i64.checked_pow(size) {
        Some(power) => Rational::integer(power),
        None => Rational::of(BigInt::from(10).pow(size), 1.into()),
    };
    if exponent < 0 { power.recip() } else { power }
}
