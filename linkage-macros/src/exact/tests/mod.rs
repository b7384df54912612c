//! Tests of the exact numbers.

use super::Exact;

fn number(text: &str) -> Exact {
    Exact::decimal(text).expect("a decimal literal")
}

fn degrees(text: &str) -> Exact {
    let (sign, size) = match text.strip_prefix('-') {
        Some(size) => (-1, size),
        None => (1, text),
    };
    let turn = number(size).div(&Exact::integer(180)).expect("180 is not zero");
    turn.mul(&Exact::pi()).mul(&Exact::integer(sign))
}

#[test]
fn angles_of_equal_sine_are_the_same_number() {
    let sine = degrees("70").sin();
    assert_eq!(degrees("20").cos(), sine);
    assert_eq!(degrees("-20").cos(), sine);
    assert_eq!(degrees("110").sin(), sine);
    assert_eq!(degrees("160").cos().neg(), sine);
    assert_eq!(degrees("430").sin(), sine);
}

#[test]
fn a_triangle_of_integers_has_rational_sines() {
    let angle = number("5").atan2(&number("12").neg()).expect("not the zero vector");
    assert_eq!(angle.sin(), Exact::integer(5).div(&Exact::integer(13)).expect("not zero"));
    assert_eq!(angle.cos(), Exact::integer(-12).div(&Exact::integer(13)).expect("not zero"));
    assert_eq!(angle.to_f64(), 5_f64.atan2(-12.0));
}
