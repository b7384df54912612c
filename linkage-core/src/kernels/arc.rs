//! Arc sine, arc cosine and arc tangent without a branch, so that lanes are vectors: each within 1.5 units in
//! the last place (the largest errors seen are 0.82, 0.76 and 1.19), in both widths.
//!
//! Up to a half, asin x = x + x z P(z) with z = x². Above, asin x = π/2 − 2 asin √((1 − x)/2), where 1 − x is
//! exact and the root has a second word: as in fdlibm (K. C. Ng, Sun Microsystems, 1993), with the polynomial
//! over all of z ≤ 1/4 rather than a quotient. atan t = t + t z Q(z) holds up to one, where a quotient's
//! rounding counts half; the other octants follow from the quarter turn. P and Q pass through their functions
//! at the zeros of Chebyshev's polynomials, and are off by less than 2⁻⁵⁷ (`f32`: 2⁻²⁶) of the result.
//!
//! The tangent is the library's: no solver computes one unless it was asked for.

/// z P(z) for factors of powers from the lowest on, by Horner's scheme.
macro_rules! times_polynomial {
    ($t:ident, $z:ident, $factors:expr) => {{
        let mut sum: $t = 0.0;
        for &factor in $factors.iter().rev() {
            sum = $t::fused_by::<F>(sum, $z, factor);
        }
        $z * sum
    }};
}

/// The functions of one width: the number, its bits, how many of them the high word of a root leaves out, the
/// root, the library's tangent, a quarter turn in two words, half of that, and the coefficients of P and Q.
macro_rules! arc {
    ($width:ident, $t:ident, $bits:ident, $rest:literal, $root:ident, $tan:ident,
     quarter: [$quarter:expr, $quarter_low:literal], eighth: $eighth:expr,
     asin: [$($p:literal),*], atan: [$($q:literal),*]) => {
        pub(crate) mod $width {
            use crate::kernels::arithmetic::Arithmetic;
            use crate::kernels::{Fusion, $root};

            /// asin s = s + s r of s = |x|, or above a half of s = √z, z = (1 − |x|)/2: whether it is above that;
            /// then z, s and r.
            #[inline(always)]
            fn halved<F: Fusion>(x: $t) -> (bool, $t, $t, $t) {
                let size = x.abs();
                let is_large = size > 0.5;
                let z = if is_large { 0.5 * (1.0 - size) } else { x * x };
                let root = $root(z);
                let s = if is_large { root } else { size };
                const P: &[$t] = &[$($p),*];
                (is_large, z, s, times_polynomial!($t, z, P))
            }

            /// The high word of a number.
            #[inline(always)]
            fn high_word(s: $t) -> $t {
                $t::from_bits(s.to_bits() & ($bits::MAX << $rest))
            }

            /// Not a number beyond ±1.
            #[inline(always)]
            pub(crate) fn asin<F: Fusion>(x: $t) -> $t {
                let (is_large, z, s, r) = halved::<F>(x);
                let high = high_word(s);
                let rest = s - high;
                let missing = if F::FUSED {
                    $t::fused_by::<F>(-s, s, z)
                } else {
                    (z - high * high) - rest * (s + high)
                };
                // √z − s is `missing`/2s. In place of 1/2s a line does: it is off by at most a tenth of a last
                // place of the arc.
                let low = rest + missing * (1.5 - s);
                let below = $t::fused_by::<F>(s, r, low);
                let large = $eighth + (($eighth - 2.0 * high) - (2.0 * below - $quarter_low));
                let size = if is_large { large } else { x.abs() + s * r };
                size.copysign(x)
            }

            /// Not a number beyond ±1.
            #[inline(always)]
            pub(crate) fn acos<F: Fusion>(x: $t) -> $t {
                let (is_large, z, s, r) = halved::<F>(x);
                let (high, rest) = (high_word(s), s * r);
                // At one the root is zero, and so is its rest.
                let low = (z - high * high) / (s + high + $t::MIN_POSITIVE);
                let low = $t::fused_by::<F>(s, r, low);
                let near_one = 2.0 * high + 2.0 * low;
                let near_minus_one =
                    $quarter + (($quarter - 2.0 * high) - (2.0 * low - 2.0 * $quarter_low));
                let small = $quarter - (x - ($quarter_low - rest.copysign(x)));
                let large = if x > 0.0 { near_one } else { near_minus_one };
                if is_large { large } else { small }
            }

            /// The angle of (`x`, `y`); half a turn is positive whatever the sign of zero.
            #[inline(always)]
            pub(crate) fn atan2<F: Fusion>(y: $t, x: $t) -> $t {
                let (across, along) = (y.abs(), x.abs());
                // A NaN becomes `short` or `long` in any case, so the quotient is NaN as well.
                let short = if across < along { across } else { along };
                let long = if across < along { along } else { across };
                let quotient = short / long;
                // Two infinities are alike, and two zeros are the angle zero.
                let quotient = if short == long { 1.0 } else { quotient };
                let t = if long == 0.0 { short } else { quotient };
                let z = t * t;
                const Q: &[$t] = &[$($q),*];
                let rest = t * times_polynomial!($t, z, Q);
                // ± t + a multiple of a quarter turn, whose low word comes first.
                let is_steep = across > along;
                let (turns, sign) = match (is_steep, x.is_sign_negative()) {
                    (false, false) => (0.0, 1.0),
                    (true, false) => (1.0, -1.0),
                    (true, true) => (1.0, 1.0),
                    (false, true) => (2.0, -1.0),
                };
                let low = turns * $quarter_low + sign * rest;
                // −0 + 0 is +0.
                (turns * $quarter + (sign * t + low)).copysign(y + 0.0)
            }

            /// In [−π/2, π/2].
            #[inline(always)]
            pub(crate) fn atan<F: Fusion>(x: $t) -> $t {
                atan2::<F>(x, 1.0).copysign(x)
            }

            #[allow(clippy::extra_unused_type_parameters, reason = "called as those that are fused")]
            #[inline(always)]
            pub(crate) fn tan<F: Fusion>(x: $t) -> $t {
                libm::$tan(x)
            }
        }
    };
}

arc! {
    wide, f64, u64, 32, sqrt, tan,
    quarter: [core::f64::consts::FRAC_PI_2, 6.123233995736766e-17], eighth: core::f64::consts::FRAC_PI_4,
    asin: [
        0.16666666666666669, 0.07499999999998433, 0.04464285714635543, 0.030381944138531247,
        0.02237217294214989, 0.017352392720869973, 0.013971212973552933, 0.011479177415184906,
        0.01032281435018578, 0.005457506718640358, 0.01740087944269402, -0.014851887071247204,
        0.028757851367421566
    ],
    atan: [
        -0.3333333333333333, 0.19999999999999984, -0.14285714285711718, 0.11111111110929807,
        -0.09090909084093506, 0.07692307534369985, -0.06666664203478607, 0.0588232553920069,
        -0.05262931380521779, 0.04760471049395462, -0.043407182638729704, 0.03971908106924452,
        -0.036139320776507194, 0.03213544133307827, -0.02718155333081564, 0.021121594179966983,
        -0.014503079564732733, 0.00844989240397037, -0.004000209679906822,
        0.0014617449054205385, -0.00038394037972999467, 6.417524965866564e-05,
        -5.1088410388226665e-06
    ]
}

arc! {
    narrow, f32, u32, 12, sqrtf, tanf,
    quarter: [core::f32::consts::FRAC_PI_2, -4.371139e-08], eighth: core::f32::consts::FRAC_PI_4,
    asin: [
        0.16666666, 0.07500094, 0.044599403, 0.031100662, 0.017149238, 0.033690847
    ],
    atan: [
        -0.33333334, 0.1999995, -0.14284004, 0.11088262, -0.08931827, 0.070319146, -0.048960514,
        0.026305001, -0.009144629, 0.0014886919
    ]
}

#[cfg(test)]
mod tests;
