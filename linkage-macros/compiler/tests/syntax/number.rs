//! Tests of `syntax/number`.

pub(crate) use linkage_compiler::syntax::number::*;

fn read(text: &str) -> String {
    match number(text) {
        Ok(number) => {
            let sign = if number.negative { "-" } else { "" };
            format!("{sign}{} {}", number.digits, number.unit.unwrap_or_default())
        }
        Err((message, _)) => message,
    }
}

#[test]
fn a_suffix_is_parted_from_the_digits() {
    for (text, expected) in [
        ("632mm", "632 mm"),
        ("0.5m", "0.5 m"),
        ("90deg", "90 deg"),
        ("1e-3m", "1e-3 m"),
        ("1E3", "1E3 "),
        ("1.5e+2_0mm", "1.5e+20 mm"),
        ("2in", "2 in"),
        ("5.", "5 "),
        ("1_000.000_1", "1000.0001 "),
        ("1_mm", "1 mm"),
        ("2em", "2 em"),
        ("5f64", "5 f64"),
        ("-5mm", "-5 mm"),
    ] {
        assert_eq!(read(text), expected, "{text}");
    }
}

#[test]
fn what_is_no_decimal_number_is_refused() {
    for (text, expected) in [
        ("0x1F", "write `0x1F` in decimal"),
        ("0b1m", "write `0b1m` in decimal"),
        ("2e", "write the exponent of `2e`, or drop its `e`"),
        ("1e401", "write a smaller exponent than in `1e401`"),
        ("1e99999999999", "write a smaller exponent than in `1e99999999999`"),
        ("\"5mm\"", "expected a number or a name, found a string"),
        ("\"left\"", "write `left` without quotes"),
        ("b\"5\"", "expected a number or a name, found a string"),
        ("'5'", "expected a number or a name, found a character"),
    ] {
        assert_eq!(read(text), expected, "{text}");
    }
}
