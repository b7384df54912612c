//! Sine and cosine of `f64`, together.
//!
//! # Method
//! The argument is reduced to x = q·π/2 + r with |r| ≤ π/4 (Cody and Waite), the two polynomials
//! are evaluated at r, and q says which is which and with what sign.
//!
//! π/2 is the sum of [`PARTS`]: three of 33 bits, whose products with q (20 bits) are exact, and
//! the rest. x − q·C₁ is exact, because both are multiples of the smaller of ulp(x) and 2⁻³² and
//! the difference is below one. The remainder of π/2, times q, is subtracted in one rounded step,
//! so that the polynomials need not wait; the errors of that product (its difference from
//! q·C₂ + q·C₃ cancels to fewer than 53 bits) and of that difference (Dekker's fast sum: the
//! minuend is a multiple of the subtrahend's last place) are exact. q·C₄ is rounded, at
//! 2⁻⁸³·2⁻⁵³. Within the limit no f64 other than 0 comes closer than 2⁻⁶¹ to a multiple of π/2,
//! and for q > 2000 none closer than 2⁻⁵⁵ (searched multiple by multiple), so that r, as an
//! unevaluated difference of two numbers, is right to 2⁻⁶⁵ of itself.
//!
//! # Polynomials
//! sin r = r − r³·S(r²) and cos r = 1 − r²/2 + r⁴·C(r²), each minimax in the *relative* error on
//! |r| ≤ (1 + 2⁻¹²)π/4, from an exchange algorithm in 90 digits in which each coefficient was
//! rounded to f64 before the next ones were fitted again; what is left is 2⁻⁵⁷·⁹ for the sine and
//! 2⁻⁶³·⁹ for the cosine.
//!
//! # Error
//! Below one unit in the last place for |x| ≤ [`LIMIT`], fused or not: half of one for the last
//! rounding, five roundings of the cubic term at 0.08 each, 0.05 for all approximations. The
//! largest seen is 0.79, among the arguments nearest to multiples of π/2 and of π/4, against 80
//! digits, and 80 million others, against double-word arithmetic.
//!
//! W. J. Cody and W. Waite, "Software Manual for the Elementary Functions" (1980); the two-word
//! evaluation follows the kernels of Sun's fdlibm (1993).

// The digits are those of the binary value: the reader can check them against the bits.
#![allow(clippy::excessive_precision)]

use super::arithmetic::Arithmetic;
use super::far::quarters;
use super::{Fusion, mul_err};

/// Largest argument of the kernel, in radians: 2²⁰, so that q takes 20 bits.
pub(crate) const LIMIT: f64 = 1_048_576.0;

/// 2/π.
const QUADRANTS: f64 = core::f64::consts::FRAC_2_PI;

/// π/2, rounded to 33, 33, 33 and 53 significant bits in turn.
pub(crate) const PARTS: [f64; 4] =
    [1.5707963267341256, 6.077100506303966e-11, 2.0222662487111665e-21, 8.4784276603689e-32];

/// π/2 without 1.5·10⁻³³, in words of 53 bits: where operations are fused no product needs to be exact.
const WORDS: [f64; 2] = [core::f64::consts::FRAC_PI_2, 6.123233995736766e-17];

/// The remainder of π/2 after its first part.
const REST: f64 = 6.077100506506192e-11;

/// At 1.5·2⁵² the spacing of f64 is one: adding it rounds to an integer, whose two's complement
/// are then the low bits.
const SHIFT: f64 = 6_755_399_441_055_744.0;

/// sin r = r − r³·(S₀ + S₁·r² + …).
const SINE: [f64; 6] = [
    0.1666666666666663,
    -0.00833333333332184,
    0.00019841269829358528,
    -2.7557313538514158e-6,
    2.5050734389219857e-8,
    -1.5895433284842938e-10,
];

/// cos r = 1 − r²/2 + r⁴·(C₀ + C₁·r² + …).
const COSINE: [f64; 6] = [
    0.041666666666666595,
    -0.0013888888888873333,
    2.4801587288992887e-5,
    -2.7557314213561954e-7,
    2.087570483459e-9,
    -1.1358716362024778e-11,
];

/// Sine and cosine for |x| ≤ [`LIMIT`]; a meaningless pair beyond, not numbers for not a number.
// `always`: it must merge with the caller's straight line even where the optimiser finds the body
// long, or a loop over angles does not vectorise.
#[inline(always)]
pub(crate) fn sin_cos<F: Fusion>(x: f64) -> (f64, f64) {
    let shifted = f64::fused_by::<F>(x, QUADRANTS, SHIFT);
    let (r, excess) = reduce::<F>(x, shifted - SHIFT);
    let (sin, cos) = polynomials::<F>(r, excess);
    turn::<F>(sin, cos, shifted.to_bits())
}

/// Sine and cosine for |x| > [`LIMIT`], with the same error; not numbers for an infinite x or none.
///
/// The rest in quarter turns and π/2 are two words each, and the error of the product of the first is exact: the
/// remainder is right to 2⁻⁶⁵ of itself.
#[cold]
#[inline(never)]
pub(crate) fn sin_cos_far<F: Fusion>(x: f64) -> (f64, f64) {
    if !x.is_finite() {
        return (f64::NAN, f64::NAN);
    }
    let (count, [high, low]) = quarters(x);
    let [quarter, quarter_low] = WORDS;
    let product = high * quarter;
    let error = mul_err::<f64, F>(high, quarter) + (high * quarter_low + low * quarter);
    let r = product + error;
    let (sin, cos) = polynomials::<F>(r, (r - product) - error);
    turn::<F>(sin, cos, count)
}

/// The remainder x − q·π/2 as r − excess.
///
/// A difference rather than a sum, so that −0 has the remainder −0. Where products are exact,
/// fusing them changes no bit. The polynomials wait for r alone.
#[inline(always)]
fn reduce<F: Fusion>(x: f64, q: f64) -> (f64, f64) {
    let fused = f64::fused_by::<F>;
    let [c1, c2, c3, c4] = PARTS;
    let minuend = fused(-q, c1, x);
    let subtrahend = q * REST;
    let r = minuend - subtrahend;
    let r_error = (minuend - r) - subtrahend;
    let subtrahend_error = fused(q, c2, -subtrahend) + q * c3;
    (r, fused(q, c4, subtrahend_error - r_error))
}

/// Sine and cosine of r − excess, for |r| up to a little over π/4 and |excess| ≤ 2·ulp(r).
#[inline(always)]
fn polynomials<F: Fusion>(r: f64, excess: f64) -> (f64, f64) {
    let fused = f64::fused_by::<F>;
    let z = r * r;
    let z2 = z * z;

    // 1 − z/2 with the error of the subtraction, which is exact: z/2 < 1/2.
    let half = 0.5 * z;
    let head = 1.0 - half;
    let head_error = (1.0 - head) - half;

    let [s0, s1, s2, s3, s4, s5] = SINE;
    let upper = fused(z2, s5, fused(z, s4, s3));
    let series = fused(z2, upper, fused(z, s2, s1));
    let series = fused(z, series, s0);
    // sin(r − excess) = sin r − excess·cos r, and cos r is `head` as far as excess is concerned.
    let sin = r - fused(z * r, series, excess * head);

    let [c0, c1, c2, c3, c4, c5] = COSINE;
    let upper = fused(z2, c5, fused(z, c4, c3));
    let series = fused(z2, upper, fused(z, c2, c1));
    let series = fused(z, series, c0);
    // cos(r − excess) = cos r + excess·sin r, and sin r is r as far as excess is concerned.
    let cos = head + fused(z2, series, fused(r, excess, head_error));
    (sin, cos)
}

/// The same without what the remainder and 1 − r²/2 are rounded by, where operations are fused: within
/// 1.7 units in the last place, or 1.5·10⁻³³ for every quarter turn: less than 10⁻²⁷, and more than those
/// units only where sine or cosine is below 10⁻¹¹. Elsewhere it is [`sin_cos`] itself.
///
/// The last rounding is half a unit. In the sine, the remainder's rounding is half a unit: x − q·C₁ is exact,
/// a multiple of the smaller of ulp(x) and 2⁻⁵² below one. In the cosine, that of 1 − r²/2 is half a unit,
/// that of r² a quarter, and that of the remainder, which acts with sin r, is 0.36. The error of the two
/// words of π/2 acts with q.
///
/// `ALONE` is a number that stands in no lane: its quarter turns are looked up.
#[inline(always)]
pub(crate) fn sin_cos_near<F: Fusion, const ALONE: bool>(x: f64) -> (f64, f64) {
    let shifted = f64::fused_by::<F>(x, QUADRANTS, SHIFT);
    let q = shifted - SHIFT;
    let (sin, cos) = if F::FUSED {
        polynomials_near::<F>(x, q)
    } else {
        let (r, excess) = reduce::<F>(x, q);
        polynomials::<F>(r, excess)
    };
    let q = shifted.to_bits();
    if ALONE { turn_alone::<F>(sin, cos, q) } else { turn::<F>(sin, cos, q) }
}

/// Sine and cosine of what is left of x without q quarter turns.
#[inline(always)]
fn polynomials_near<F: Fusion>(x: f64, q: f64) -> (f64, f64) {
    let fused = f64::fused_by::<F>;
    let r = WORDS.iter().fold(x, |r, &word| fused(-q, word, r));
    let z = r * r;
    let z2 = z * z;
    let series = |[c0, c1, c2, c3, c4, c5]: [f64; 6]| {
        let upper = fused(z2, fused(z, c5, c4), fused(z, c3, c2));
        fused(z2, upper, fused(z, c1, c0))
    };
    let sin = fused(z * r, series(SINE.map(core::ops::Neg::neg)), r);
    let cos = fused(z2, series(COSINE), fused(-0.5, z, 1.0));
    (sin, cos)
}

/// Sine and cosine in quadrant `q` (its two low bits count) from those of the remainder.
///
/// A rotation by a multiple of a quarter turn, whose cosine and sine are zeros and ones: nothing
/// is rounded, and they are known long before the polynomials are. Where the sine of the rotation
/// vanishes it is −0 for q = 0, so that −0 keeps its sign. A choice, between numbers or between
/// bits, is recognised as such and becomes a jump; an exclusive or of the bits that is applied or
/// masked away goes through an integer register and back.
#[inline(always)]
fn turn<F: Fusion>(sin: f64, cos: f64, q: u64) -> (f64, f64) {
    const ONE: u64 = 1.0_f64.to_bits();
    let odd = (q & 1).wrapping_neg();
    let by_cos = f64::from_bits((ONE & !odd) | ((q & 2) << 62));
    let by_sin = f64::from_bits((ONE & odd) | ((!q.wrapping_add(1) & 2) << 62));
    turned::<F>(sin, cos, [by_sin, by_cos])
}

/// The same with a table, which takes five instructions in place of nineteen, and which a loop over lanes
/// could not look into.
#[inline(always)]
fn turn_alone<F: Fusion>(sin: f64, cos: f64, q: u64) -> (f64, f64) {
    /// Sines, each of which is the cosine of the quarter before.
    const QUARTERS: [f64; 5] = [-0.0, 1.0, 0.0, -1.0, -0.0];
    let quarter = (q & 3) as usize;
    turned::<F>(sin, cos, [QUARTERS[quarter], QUARTERS[quarter + 1]])
}

/// Sine and cosine turned by the angle whose sine and cosine are given.
#[inline(always)]
fn turned<F: Fusion>(sin: f64, cos: f64, [by_sin, by_cos]: [f64; 2]) -> (f64, f64) {
    let fused = f64::fused_by::<F>;
    (fused(cos, by_sin, sin * by_cos), fused(-sin, by_sin, cos * by_cos))
}
