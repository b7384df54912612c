//! Floats of exact numbers.

use super::{Exact, defined, number};

/// Each row: f64 and its low word, f32 and its low word, of a postfix expression. Rounded from
/// 2400 (where numbers are huge, 12 000) digits of mpmath's.
const ROUNDED: &str = include_str!("rounded.txt");

#[test]
fn floats_and_low_words_are_correctly_rounded() {
    for row in ROUNDED.lines() {
        let mut columns = row.splitn(5, ' ');
        let mut column = || columns.next().expect("a row has five columns");
        let expected = [column(), column(), column(), column()];
        let expression = column();
        let value = defined(expression);
        let found = [
            format!("{:016x}", value.to_f64().to_bits()),
            format!("{:016x}", value.low_f64().to_bits()),
            format!("{:08x}", value.to_f32().to_bits()),
            format!("{:08x}", value.low_f32().to_bits()),
        ];
        assert_eq!(found, expected, "`{expression}`");
    }
}

#[test]
fn a_tie_goes_to_the_even_neighbour() {
    assert_eq!(number("9007199254740993").to_f64(), 9007199254740992.0);
    assert_eq!(number("9007199254740995").to_f64(), 9007199254740996.0);
    assert_eq!(number("16777217").to_f32(), 16777216.0);
    assert_eq!(number("16777219").to_f32(), 16777220.0);
    // Next to the tie on either side, further away than any float could tell.
    assert_eq!(
        number(&format!("9007199254740993.{}1", "0".repeat(400))).to_f64(),
        9007199254740994.0
    );
    assert_eq!(
        number(&format!("9007199254740992.{}", "9".repeat(400))).to_f64(),
        9007199254740992.0
    );
}

#[test]
fn a_tie_that_the_form_hides_is_rounded_from_its_middle() {
    // √(3 + 2√2) − √2 = 1: the sum is exactly 2^53 + 1.
    let one = defined("3 8 sqrt add sqrt 2 sqrt sub");
    let tie = one.add(&number("9007199254740992"));
    let (below, above) = (9007199254740992.0, 9007199254740994.0);
    assert!([below, above].contains(&tie.to_f64()));
}

#[test]
fn rounding_once_differs_from_rounding_twice() {
    // Just above a tie of f32, and rounded to f64 the tie itself.
    let value = number("16777217").add(&number("1e-20"));
    assert_eq!(value.to_f32(), 16777218.0);
    assert_eq!(value.to_f64() as f32, 16777216.0);
}

#[test]
fn the_ends_of_the_ranges() {
    let half_of_least = defined("1 2 div").mul(&Exact::float(f64::from_bits(1)).expect("finite"));
    assert_eq!(half_of_least.to_f64(), 0.0);
    let above_half = half_of_least.mul(&number("1.0000000000000000000000001"));
    assert_eq!(above_half.to_f64(), f64::from_bits(1));
    assert_eq!(above_half.neg().to_f64(), -f64::from_bits(1));
    let irrational = half_of_least.mul(&defined("2 sqrt"));
    assert_eq!(irrational.to_f64(), f64::from_bits(1));
    assert_eq!(half_of_least.mul(&defined("1 2 div sqrt")).to_f64(), 0.0);

    let beyond = defined("1e4000 2 sqrt mul");
    assert_eq!((beyond.to_f64(), beyond.low_f64()), (f64::INFINITY, 0.0));
    assert_eq!((beyond.neg().to_f32(), beyond.low_f32()), (f32::NEG_INFINITY, 0.0));
    // Half an ulp above the greatest float is infinite, less than that is not.
    let greatest = Exact::float(f64::MAX).expect("finite");
    let half_ulp = Exact::float(2_f64.powi(970)).expect("finite");
    assert_eq!(greatest.add(&half_ulp).to_f64(), f64::INFINITY);
    assert_eq!(greatest.add(&half_ulp).sub(&number("1e-9")).to_f64(), f64::MAX);
    let greatest = Exact::float(f32::MAX.into()).expect("finite");
    assert_eq!(greatest.add(&number("1e31")).to_f32(), f32::MAX);
    assert_eq!(greatest.add(&number("1.1e31")).to_f32(), f32::INFINITY);
}

#[test]
fn zero_has_no_sign() {
    for text in ["0", "0 neg", "1e-400 neg", "1e-400 2 sqrt mul neg", "1e-400 neg sin"] {
        assert_eq!(defined(text).to_f64().to_bits(), 0, "`{text}`");
        assert_eq!(defined(text).to_f32().to_bits(), 0, "`{text}`");
    }
}

#[test]
fn a_float_is_its_own_rounding() {
    let mut bits = 1_u64;
    for _ in 0..2000 {
        bits = bits.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        let float = f64::from_bits(bits);
        match Exact::float(float) {
            Some(value) => {
                assert_eq!((value.to_f64(), value.low_f64()), (float, 0.0));
                assert_eq!(value.to_f32(), float as f32, "{float:e}");
            }
            None => assert!(!float.is_finite()),
        }
    }
    assert_eq!(Exact::float(f64::NAN), None);
    assert_eq!(Exact::float(f64::INFINITY), None);
    assert_eq!(Exact::float(-0.0).map(|zero| zero.is_zero()), Some(true));
    assert_eq!(
        Exact::float(0.1),
        Some(number("3602879701896397").mul(&Exact::float(2_f64.powi(-55)).expect("finite")))
    );
}

#[test]
fn every_written_decimal_is_read_like_rust_reads_it() {
    let mut state = 7_u64;
    for _ in 0..1000 {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        let exponent = (state >> 33) as i32 % 680 - 340;
        let text = format!("{}.{}e{exponent}", state >> 60, state % 1_000_000_007);
        assert_eq!(number(&text).to_f64(), text.parse().expect("a float"), "{text}");
        assert_eq!(number(&text).to_f32(), text.parse().expect("a float"), "{text}");
    }
}
