//! Angles beyond the kernels' range, without the quarter turns that they hold.
//!
//! # Method
//! An angle is m·2ᵏ with an integer m of 53 bits. Digits of 2/π that make whole turns of m·2ᵏ·2/π are left
//! out. Of those that follow, 192 give the number of quarter turns modulo four, in two bits, and the rest in
//! 190: M. H. Payne and R. N. Hanek, "Radian reduction for trigonometric functions", SIGNUM Newsletter 18
//! (1983). The products are those of integers of 32 bits, so that a machine without wider ones computes them too.
//!
//! # Error
//! The digits left out below are worth less than 2⁵³⁻¹⁹⁰ of a quarter turn, and 128 binary places of the rest
//! are kept. No f64 comes closer than 2⁻⁶² of a quarter turn to a multiple of it (by the continued fractions of
//! 2ᵏ·2/π), so that the rest is right to 2⁻⁶⁶ of itself.

/// 2/π in words of 32 bits, behind 64 zeros: an angle at the lower end has fewer digits to leave out than that.
const DIGITS: [u32; 39] = [
    0x0000_0000,
    0x0000_0000,
    0xa2f9_836e,
    0x4e44_1529,
    0xfc27_57d1,
    0xf534_ddc0,
    0xdb62_9599,
    0x3c43_9041,
    0xfe51_63ab,
    0xdebb_c561,
    0xb724_6e3a,
    0x424d_d2e0,
    0x0649_2eea,
    0x09d1_921c,
    0xfe1d_eb1c,
    0xb129_a73e,
    0xe882_35f5,
    0x2ebb_4484,
    0xe99c_7026,
    0xb45f_7e41,
    0x3991_d639,
    0x8353_39f4,
    0x9c84_5f8b,
    0xbdf9_283b,
    0x1ff8_97ff,
    0xde05_980f,
    0xef2f_118b,
    0x5a0a_6d1f,
    0x6d36_7ecf,
    0x27cb_09b7,
    0x4f46_3f66,
    0x9e5f_ea2d,
    0x7527_bac7,
    0xebe5_f17b,
    0x3d07_39f7,
    0x8a52_92ea,
    0x6bfb_5fb1,
    0x1f8d_5d08,
    0x5603_3046,
];

/// The exponent, as a number holds it, of an angle for which the first digit is asked for.
const FIRST: u32 = 1013;

/// The number of quarter turns of a finite angle of 2¹⁵ or more, modulo 2⁶⁴, and the rest in quarter turns, at most
/// a half without its sign, as a sum of two.
pub(super) fn quarters(x: f64) -> (u64, [f64; 2]) {
    let bits = x.to_bits();
    let exponent = (bits >> 52) as u32 & 0x7ff;
    let mantissa = bits & (u64::MAX >> 12) | 1 << 52;
    let [low, middle, high] = product(mantissa, digits(exponent.saturating_sub(FIRST)));
    // Two bits count, and 128 of those behind them are kept.
    let (rest, below) = (high << 2 | middle >> 62, middle << 2 | low >> 62);
    let is_above_half = rest >> 63;
    let count = (high >> 62) + is_above_half;
    // The complement is less than the difference from the next quarter turn by 2⁻¹²⁸.
    let flip = is_above_half.wrapping_neg();
    let [first, second] = in_two_words(rest ^ flip, below ^ flip);
    match (is_above_half == 1) != (x < 0.0) {
        true => (signed(count, x), [-first, -second]),
        false => (signed(count, x), [first, second]),
    }
}

fn signed(count: u64, x: f64) -> u64 {
    if x < 0.0 { count.wrapping_neg() } else { count }
}

/// Six words of the digits from this one on, the last ones first.
fn digits(start: u32) -> [u32; 6] {
    let (word, shift) = ((start / 32) as usize, start % 32);
    let mut window = [0; 6];
    let pairs = DIGITS.iter().zip(DIGITS.iter().skip(1)).skip(word);
    for (to, (&high, &low)) in window.iter_mut().rev().zip(pairs) {
        *to = ((u64::from(high) << 32 | u64::from(low)) >> (32 - shift)) as u32;
    }
    window
}

/// The last 192 bits of the product, the last ones first.
fn product(mantissa: u64, digits: [u32; 6]) -> [u64; 3] {
    let mut product = [0_u32; 6];
    for (place, factor) in [mantissa & 0xffff_ffff, mantissa >> 32].into_iter().enumerate() {
        let mut carry = 0;
        for (to, &digit) in product.iter_mut().skip(place).zip(&digits) {
            let sum = factor * u64::from(digit) + u64::from(*to) + carry;
            *to = sum as u32;
            carry = sum >> 32;
        }
    }
    let [a, b, c, d, e, f] = product.map(u64::from);
    [b << 32 | a, d << 32 | c, f << 32 | e]
}

/// A binary fraction of 128 places as a sum of two numbers: the first one is the sum rounded, but for what the
/// last 44 places add.
fn in_two_words(high: u64, low: u64) -> [f64; 2] {
    // Each part has 52 bits at most and is exact; the second is below the last place of the first.
    let first = (high >> 32) as f64 * power_of_two(32);
    let second = ((high & 0xffff_ffff) << 20 | low >> 44) as f64 * power_of_two(84);
    let third = (low & (u64::MAX >> 20)) as f64 * power_of_two(128);
    let sum = first + second;
    [sum, ((first - sum) + second) + third]
}

/// 2⁻ⁿ.
const fn power_of_two(n: u64) -> f64 {
    f64::from_bits((1023 - n) << 52)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Answers are those of the kernels' tests; here a rest is one, and turns its sign with the angle's.
    #[test]
    fn a_rest_is_at_most_half_a_quarter_turn() {
        for x in [51_472.0, 1_048_577.0, 3e9, 1e22, 1e300] {
            let (count, [first, second]) = quarters(x);
            let (opposite, rest) = quarters(-x);
            assert_eq!((opposite, rest), (count.wrapping_neg(), [-first, -second]));
            assert!(first.abs() <= 0.5 && second.abs() <= f64::EPSILON * first.abs());
        }
        // 100 000·2/π = 63 661.977 236 758 134 308…
        let (count, [first, second]) = quarters(100_000.0);
        assert_eq!(count % 4, 63_662 % 4);
        let rest = -0.022_763_241_865_692_446;
        assert!((first - rest).abs() <= 1e-17 && second.abs() < 1e-17, "{first}");
    }
}
