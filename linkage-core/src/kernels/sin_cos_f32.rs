//! Sine and cosine of `f32`, together, in single precision throughout: on a microcontroller
//! without double precision in hardware, one operation in `f64` costs more than all of this.
//!
//! # Method
//! As for `f64`: x = q·π/2 + r with |r| ≤ π/4, two polynomials, and q says which is which.
//!
//! π/2 is the sum of [`PARTS`]: four of 9 bits, whose products with q (15 bits) are exact, and
//! the rest. x − q·C₁ and the subtraction of q·C₂ are exact: the operands are multiples of the
//! smaller of ulp(x) and 2⁻²⁰, and the differences are below one (the first, below 17 where ulp(x)
//! is above 2⁻⁹). The remainder of π/2, times q, is subtracted in one rounded step with both its
//! errors known exactly, as in `f64`; q·C₅ is rounded, at 2⁻²⁹·2⁻²⁴. Within the limit no f32 other
//! than 0 comes closer than 2⁻²⁸ to a multiple of π/2, and for q > 1000 none closer than 2⁻²⁵, so
//! that r, as an unevaluated difference of two numbers, is right to 2⁻²⁷ of itself.
//!
//! The limit is where it is because another factor of two would take another part of π/2, for all
//! arguments. It is 8192 turns, where neighbouring f32 are already a quarter of a degree apart.
//!
//! # Polynomials
//! sin r = r − r³·S(r²) and cos r = 1 − r²/2 + r⁴·C(r²), minimax in the relative error on
//! |r| ≤ (1 + 2⁻¹²)π/4 with coefficients rounded one after the other; what is left is 2⁻²⁷·⁹ for
//! the sine and 2⁻³²·⁹ for the cosine.
//!
//! # Error
//! Below 0.85 units in the last place for |x| ≤ [`LIMIT`], fused or not: every one was tried.

// The digits are those of the binary value: the reader can check them against the bits.
#![allow(clippy::excessive_precision)]

use super::Fusion;
use super::arithmetic::Arithmetic;
use super::far::quarters;

/// Largest argument of the kernel, in radians: 8192 turns, so that q takes 15 bits.
pub(crate) const LIMIT: f32 = 51_471.0;

/// 2/π.
const QUADRANTS: f32 = core::f32::consts::FRAC_2_PI;

/// π/2, rounded to 9, 9, 9, 9 and 24 significant bits in turn.
pub(crate) const PARTS: [f32; 5] = [
    1.5703125,
    0.00048351287841796875,
    3.1385570764541626e-7,
    6.070877134334296e-11,
    6.223371969669989e-14,
];

/// The remainder of π/2 after its first two parts.
const REST: f32 = 3.1391647326017846e-07;

/// At 1.5·2²³ the spacing of f32 is one: adding it rounds to an integer, whose two's complement
/// are then the low bits.
const SHIFT: f32 = 12_582_912.0;

/// sin r = r − r³·(S₀ + S₁·r² + …).
const SINE: [f32; 3] = [0.16666655242443085, -0.008332189172506332, 0.00019518277258612216];

/// cos r = 1 − r²/2 + r⁴·(C₀ + C₁·r² + …).
const COSINE: [f32; 3] = [0.04166664555668831, -0.0013887309469282627, 2.4432327336398885e-5];

/// Sine and cosine for |x| ≤ [`LIMIT`]; a meaningless pair beyond, not numbers for not a number.
// `always`: it must merge with the caller's straight line even where the optimiser finds the body
// long, or a loop over angles does not vectorise.
#[inline(always)]
pub(crate) fn sin_cos<F: Fusion>(x: f32) -> (f32, f32) {
    let shifted = f32::fused_by::<F>(x, QUADRANTS, SHIFT);
    let (r, excess) = reduce::<F>(x, shifted - SHIFT);
    let (sin, cos) = polynomials::<F>(r, excess);
    turn::<F>(sin, cos, shifted.to_bits())
}

/// Sine and cosine for |x| > [`LIMIT`], with the same error; not numbers for an infinite x or none. The remainder is
/// that of `f64`, rounded to two numbers.
#[cold]
#[inline(never)]
pub(crate) fn sin_cos_far<F: Fusion>(x: f32) -> (f32, f32) {
    if !x.is_finite() {
        return (f32::NAN, f32::NAN);
    }
    let (count, [high, low]) = quarters(x.into());
    let remainder = (high + low) * core::f64::consts::FRAC_PI_2;
    let r = remainder as f32;
    let (sin, cos) = polynomials::<F>(r, (f64::from(r) - remainder) as f32);
    turn::<F>(sin, cos, count as u32)
}

/// The remainder x − q·π/2 as r − excess.
///
/// A difference rather than a sum, so that −0 has the remainder −0. Where products are exact,
/// fusing them changes no bit. The polynomials wait for r alone.
#[inline(always)]
fn reduce<F: Fusion>(x: f32, q: f32) -> (f32, f32) {
    let fused = f32::fused_by::<F>;
    let [c1, c2, c3, c4, c5] = PARTS;
    let minuend = fused(-q, c2, fused(-q, c1, x));
    let subtrahend = q * REST;
    let r = minuend - subtrahend;
    let r_error = (minuend - r) - subtrahend;
    let subtrahend_error = fused(q, c3, -subtrahend) + q * c4;
    (r, fused(q, c5, subtrahend_error - r_error))
}

/// Sine and cosine of r − excess, for |r| up to a little over π/4 and |excess| ≤ 2·ulp(r).
#[inline(always)]
fn polynomials<F: Fusion>(r: f32, excess: f32) -> (f32, f32) {
    let fused = f32::fused_by::<F>;
    let z = r * r;
    let z2 = z * z;

    // 1 − z/2 with the error of the subtraction, which is exact: z/2 < 1/2.
    let half = 0.5 * z;
    let head = 1.0 - half;
    let head_error = (1.0 - head) - half;

    let [s0, s1, s2] = SINE;
    let series = fused(z2, s2, fused(z, s1, s0));
    // sin(r − excess) = sin r − excess·cos r, and cos r is `head` as far as excess is concerned.
    let sin = r - fused(z * r, series, excess * head);

    let [c0, c1, c2] = COSINE;
    let series = fused(z2, c2, fused(z, c1, c0));
    // cos(r − excess) = cos r + excess·sin r, and sin r is r as far as excess is concerned.
    let cos = head + fused(z2, series, fused(r, excess, head_error));
    (sin, cos)
}

/// Sine and cosine in quadrant `q` (its two low bits count) from those of the remainder, as for
/// `f64`.
///
/// An exclusive or of the bits that is applied or masked away would also leave the bits by which
/// the two differ in the unused half of a vector register, where they are a subnormal number
/// whenever the exponents are equal, and the next multiplication takes a hundred cycles over a
/// result that is never read.
#[inline(always)]
fn turn<F: Fusion>(sin: f32, cos: f32, q: u32) -> (f32, f32) {
    const ONE: u32 = 1.0_f32.to_bits();
    let odd = (q & 1).wrapping_neg();
    let by_cos = f32::from_bits((ONE & !odd) | ((q & 2) << 30));
    let by_sin = f32::from_bits((ONE & odd) | ((!q.wrapping_add(1) & 2) << 30));
    let fused = f32::fused_by::<F>;
    (fused(cos, by_sin, sin * by_cos), fused(-sin, by_sin, cos * by_cos))
}
