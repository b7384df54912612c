//! The text of a literal into digits and unit.
//!
//! Rust's lexer has already decided where the literal ends (`632mm` is one token, an integer with
//! a suffix; `1e-3m` a float with one); here the suffix is parted from the digits.

use super::tree::ExprKind;

/// Beyond this power of ten neither a length nor an angle is meant, and exact arithmetic would
/// write the number out.
const LARGEST_EXPONENT: u32 = 400;

/// A decimal number: digits without underscores, and the suffix.
pub struct Literal {
    /// Only a literal made by another macro has a sign of its own.
    pub negative: bool,
    pub digits: String,
    pub unit: Option<String>,
}

impl Literal {
    pub(super) fn into_kind(self) -> ExprKind {
        let units = self.unit.map(|unit| (unit, 1));
        ExprKind::Number { digits: self.digits, units: units.into_iter().collect() }
    }
}

/// Reads a literal; the error is a message and its reason.
pub fn number(text: &str) -> Result<Literal, (String, &'static str)> {
    let unsigned = text.strip_prefix('-').unwrap_or(text);
    if !unsigned.starts_with(|c: char| c.is_ascii_digit()) {
        let quoted = unsigned.strip_prefix('"').and_then(|text| text.strip_suffix('"'));
        if let Some(word) = quoted.filter(|word| is_word(word)) {
            return Err((format!("write `{word}` without quotes"), "there are no strings here"));
        }
        let kind = if unsigned.ends_with('\'') { "character" } else { "string" };
        return Err((format!("expected a number or a name, found a {kind}"), WHAT_STANDS));
    }
    if ["0x", "0o", "0b"].iter().any(|prefix| unsigned.starts_with(prefix)) {
        return Err((format!("write `{text}` in decimal"), WHAT_STANDS));
    }
    let (digits, suffix) = unsigned.split_at(digits_end(unsigned));
    let digits: String = digits.chars().filter(|&c| c != '_').collect();
    if suffix == "e" || suffix == "E" {
        return Err((
            format!("write the exponent of `{text}`, or drop its `{suffix}`"),
            "a power of ten is written as in `1e-3m`",
        ));
    }
    if exponent(&digits).is_none_or(|exponent| exponent > LARGEST_EXPONENT) {
        return Err((
            format!("write a smaller exponent than in `{text}`"),
            "neither `f32` nor `f64` holds such a number",
        ));
    }
    let unit = (!suffix.is_empty()).then(|| suffix.to_string());
    let digits = digits.strip_suffix('.').map(str::to_string).unwrap_or(digits);
    Ok(Literal { negative: text.starts_with('-'), digits, unit })
}

fn is_word(text: &str) -> bool {
    let is_letter = |c: char| c.is_ascii_alphabetic() || c == '_';
    text.starts_with(is_letter) && text.chars().all(|c| is_letter(c) || c.is_ascii_digit())
}

const WHAT_STANDS: &str = "a number is decimal, with its unit directly behind it: `632mm`, `1e-3m`";

/// Where the suffix begins.
fn digits_end(text: &str) -> usize {
    let bytes = text.as_bytes();
    let run = |from: usize| {
        let digit = |&&b: &&u8| b.is_ascii_digit() || b == b'_';
        from + bytes[from..].iter().take_while(digit).count()
    };
    let mut end = run(0);
    if bytes.get(end) == Some(&b'.') {
        end = run(end + 1);
    }
    if matches!(bytes.get(end), Some(b'e' | b'E')) {
        let sign = usize::from(matches!(bytes.get(end + 1), Some(b'+' | b'-')));
        let exponent = run(end + 1 + sign);
        if bytes[end + 1..exponent].iter().any(u8::is_ascii_digit) {
            end = exponent;
        }
    }
    end
}

/// The size of the exponent; `None` where it has too many digits to be read.
fn exponent(digits: &str) -> Option<u32> {
    match digits.split_once(['e', 'E']) {
        Some((_, exponent)) => exponent.trim_start_matches(['+', '-']).parse().ok(),
        None => Some(0),
    }
}
