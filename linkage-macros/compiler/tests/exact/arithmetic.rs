//! The rational arithmetic, in machine words and beyond.

use super::rational::{BigRational, Rational, square_part};
use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{Signed, Zero};

/// Numbers at which words overflow, and ordinary ones.
fn samples() -> Vec<BigRational> {
    let words = [0, 1, -1, 2, 10, -632, 1000, 4_294_967_296, i64::MAX, i64::MIN, i64::MAX - 1];
    let mut samples = Vec::new();
    for numerator in words {
        for denominator in words.into_iter().filter(|word| *word != 0) {
            samples.push(BigRational::new(numerator.into(), denominator.into()));
        }
    }
    samples.sort();
    samples.dedup();
    samples
}

fn rational(value: &BigRational) -> Rational {
    Rational::of(value.numer().clone(), value.denom().clone())
}

/// The same number in the one form that it may have.
#[track_caller]
fn assert_is(found: &Rational, expected: &BigRational) {
    assert_eq!(found.numerator(), *expected.numer());
    assert_eq!(found.denominator(), *expected.denom());
    let fits = |part: &BigInt| part.abs() <= BigInt::from(i64::MAX);
    let small = fits(expected.numer()) && fits(expected.denom());
    assert_eq!(matches!(found, Rational::Small(..)), small, "{expected}");
}

#[test]
fn words_and_big_integers_agree() {
    let samples = samples();
    for a in &samples {
        assert_is(&rational(a).neg(), &-a);
        assert_is(&rational(a).abs(), &a.abs());
        assert_is(&rational(a).floor(), &a.floor());
        assert_eq!(rational(a).signum(), a.cmp(&BigRational::zero()));
        for b in &samples {
            let (left, right) = (rational(a), rational(b));
            assert_is(&left.add(&right), &(a + b));
            assert_is(&left.sub(&right), &(a - b));
            assert_is(&left.mul(&right), &(a * b));
            assert_eq!(left.cmp(&right), a.cmp(b));
            if !b.is_zero() {
                assert_is(&left.div(&right), &(a / b));
            }
        }
    }
}

#[test]
fn modulo_is_never_negative() {
    for (numerator, denominator, left) in [(7, 2, (3, 2)), (-1, 3, (5, 3)), (-4, 1, (0, 1))] {
        let left = Rational::ratio(left.0, left.1);
        assert_eq!(Rational::ratio(numerator, denominator).modulo(2), left);
    }
}

#[test]
fn square_parts() {
    for value in 1..2000_u32 {
        let (root, rest) = square_part(&value.into());
        assert_eq!(&root * &root * &rest, value.into());
        for factor in 2..45_u32 {
            assert!(!rest.is_multiple_of(&BigInt::from(factor * factor)), "{value}");
        }
    }
    let prime = BigInt::from(1_000_000_007);
    assert_eq!(square_part(&(&prime * &prime * 4)), (&prime * 2, 1.into()));
}
