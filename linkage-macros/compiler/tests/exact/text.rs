//! Literals and the short text.

use super::{Exact, defined, number};

#[test]
fn decimals_as_rust_writes_them() {
    let half = Exact::integer(1).div(&Exact::integer(2)).expect("not zero");
    for text in ["0.5", "5e-1", "0.50", "500E-3", "0_.5_0_", "0.005e+2", "5_0.0e-0_2"] {
        assert_eq!(Exact::decimal(text), Some(half.clone()), "{text}");
    }
    assert_eq!(number("1."), Exact::integer(1));
    assert_eq!(
        number("1_000.5e-3"),
        Exact::integer(2001).mul(&half).div(&number("1e3")).expect("not zero")
    );
    let digits = "123456789012345678901234567890.123456789";
    assert_eq!(number(digits), number("123456789012345678901234567890123456789e-9"));
}

#[test]
fn what_is_no_decimal() {
    for text in [
        "", ".", "e5", ".5", "1e", "1e+", "1e5.0", "-1", "+1", "0x10", "1.2.3", "inf", "NaN",
        "1 2", "١",
    ] {
        assert_eq!(Exact::decimal(text), None, "{text}");
    }
}

#[test]
fn exponents_that_no_dimension_has() {
    for text in ["1e4097", "1e-4097", "1e999999999", "1e-999999999999999999999999", "0e5000"] {
        assert_eq!(Exact::decimal(text), None, "{text}");
    }
    assert_eq!(number("1e4096").mul(&number("1e-4096")), Exact::integer(1));
    assert_eq!(Exact::decimal(&"9".repeat(5000)), None);
}

#[test]
fn the_text_of_a_number() {
    let texts = [
        ("0", "0"),
        ("632 1000 div", "0.632"),
        ("0.08 neg", "-0.08"),
        ("1e5", "100000"),
        ("1e-7", "0.0000001"),
        ("1 3 div neg", "-1/3"),
        ("1 3 div 0.1 add", "13/30"),
        ("pi", "pi"),
        ("20 deg neg", "-1/9*pi"),
        ("30 deg 0.2 add", "0.2 + 1/6*pi"),
        ("45 deg sin", "0.5*sqrt(2)"),
        ("70 deg sin 0.08 mul", "0.08*cos(1/9*pi)"),
        ("1.2 tan", "sin(1.2)/cos(1.2)"),
        ("1.2 cos 1.2 cos mul", "cos(1.2)^2"),
        ("1 0.2 asin pi add div 3 mul", "3/(pi + asin(0.2))"),
        ("2 neg 3 neg atan2", "-pi + atan(2/3)"),
        ("1.5 2 sqrt 3 sqrt add sqrt sub", "1.5 - sqrt(sqrt(2) + sqrt(3))"),
        ("1e400", "~1e400"),
        ("1e400 3 div neg", "~-3.333333333e399"),
        ("1e-400", "~1e-400"),
    ];
    for (expression, text) in texts {
        assert_eq!(defined(expression).to_string(), text, "`{expression}`");
    }
    assert_eq!(Exact::float(0.1).map(|value| value.to_string()).as_deref(), Some("~0.1"));
}

#[test]
fn a_long_text_is_rounded() {
    let mut value = defined("1 sin");
    for _ in 0..40 {
        value = value.mul(&value).add(&value.cos()).sqrt().expect("positive");
    }
    // Written out it would fill the memory.
    assert_eq!(value.to_string(), format!("~{:?}", value.to_f64()));
}
