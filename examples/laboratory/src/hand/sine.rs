//! Sine and cosine as a careful hand writes them for one project, inlined: a reduction by π/2 in two
//! words where operations are fused and in three elsewhere, and fdlibm's polynomials of degree 13 and 14
//! in Estrin's order. Errors are 1.1 units in the last place of a sine and 1.7 of a cosine, but next to
//! multiples of π/2, of which two words know only so much: what is left of the angle there, and is nearly
//! zero, may be wrong by hundreds of its own units. A hand that needs those digits takes a third word.

#![allow(clippy::excessive_precision, reason = "the digits are those of the source")]

use super::fused;

/// fdlibm's minimax coefficients for |x| ≤ π/4: those of the sine, behind x.
const SINE: [f64; 6] = [
    -1.66666666666666324348e-01,
    8.33333333332248946124e-03,
    -1.98412698298579493134e-04,
    2.75573137070700676789e-06,
    -2.50507602534068634195e-08,
    1.58969099521155010221e-10,
];
/// Those of the cosine, behind 1 − x²/2.
const COSINE: [f64; 6] = [
    4.16666666666666019037e-02,
    -1.38888888888741095749e-03,
    2.48015872894767294178e-05,
    -2.75573143513906633035e-07,
    2.08757232129817482790e-09,
    -1.13596475577881948265e-11,
];

/// Cosine and sine.
#[inline(always)]
#[must_use]
pub fn cos_sin(x: f64) -> [f64; 2] {
    // Where the spacing is one.
    const SHIFT: f64 = 6_755_399_441_055_744.0;
    // Below it the products with the words of π/2 are exact, or as good as that.
    if !(x.abs() <= 1e5) {
        return far(x);
    }
    let shifted = fused(x, std::f64::consts::FRAC_2_PI, SHIFT);
    let n = shifted - SHIFT;
    let words: &[f64] = if cfg!(target_feature = "fma") {
        &[std::f64::consts::FRAC_PI_2, 6.123_233_995_736_766e-17]
    } else {
        &[1.570_796_326_734_125_6, 6.077_100_506_303_966e-11, 2.022_266_248_795_950_6e-21]
    };
    let r = words.iter().fold(x, |r, &word| fused(-n, word, r));
    let z = r * r;
    let z2 = z * z;
    let series = |[c0, c1, c2, c3, c4, c5]: [f64; 6]| {
        let upper = fused(z2, fused(z, c5, c4), fused(z, c3, c2));
        fused(z2, upper, fused(z, c1, c0))
    };
    let sine = fused(z * r, series(SINE), r);
    let cosine = fused(z2, series(COSINE), fused(z, -0.5, 1.0));
    turned(sine, cosine, shifted.to_bits())
}

/// Cosine and sine, turned by quarter turns, of which the two low bits of q count.
#[inline(always)]
fn turned(sine: f64, cosine: f64, q: u64) -> [f64; 2] {
    let (s, c) = (sine.to_bits(), cosine.to_bits());
    let swap = (s ^ c) & (q & 1).wrapping_neg();
    let sine = f64::from_bits(s ^ swap ^ ((q & 2) << 62));
    let cosine = f64::from_bits(c ^ swap ^ ((q.wrapping_add(1) & 2) << 62));
    [cosine, sine]
}

/// Cosine and sine in single precision, by shorter polynomials. Below 1e3 the products with the first two words of π/2
/// are exact.
#[inline(always)]
#[must_use]
pub fn cos_sin_single(x: f32) -> [f32; 2] {
    const SHIFT: f32 = 12_582_912.0;
    if !(x.abs() <= 1e3) {
        let (sine, cosine) = x.sin_cos();
        return [cosine, sine];
    }
    let shifted = fused(x, std::f32::consts::FRAC_2_PI, SHIFT);
    let n = shifted - SHIFT;
    let r = [1.570_312_5, 4.837_513e-4, 7.549_79e-8].iter().fold(x, |r, &word| fused(-n, word, r));
    let z = r * r;
    let sine = fused(z * r, fused(z, fused(z, -1.951_529_6e-4, 8.332_161e-3), -1.666_665_5e-1), r);
    let series = fused(z, fused(z, 2.443_315_7e-5, -1.388_731_6e-3), 4.166_664_6e-2);
    let cosine = fused(z * z, series, fused(z, -0.5, 1.0));
    let (s, c, q) = (sine.to_bits(), cosine.to_bits(), shifted.to_bits());
    let swap = (s ^ c) & (q & 1).wrapping_neg();
    let sine = f32::from_bits(s ^ swap ^ ((q & 2) << 30));
    let cosine = f32::from_bits(c ^ swap ^ ((q.wrapping_add(1) & 2) << 30));
    [cosine, sine]
}

#[cold]
#[inline(never)]
fn far(x: f64) -> [f64; 2] {
    let (sine, cosine) = x.sin_cos();
    [cosine, sine]
}

#[cfg(test)]
mod tests {
    /// The kernel of the generated code is within 0.85 units in the last place, this one within 1.7 away
    /// from multiples of π/2, which no step here comes as near as the second word's rounding.
    #[test]
    fn it_is_within_two_places_of_the_kernel() {
        for step in -200_000..200_000_i32 {
            let angle = f64::from(step) * 3.7e-4;
            let [cos, sin] = super::cos_sin(angle);
            let (exact_sin, exact_cos) = linkage_core::Scalar::sin_cos(angle);
            for (found, exact) in [(cos, exact_cos), (sin, exact_sin)] {
                // An ulp of x is at most ε x.
                let allowed = 2.0 * f64::EPSILON * exact.abs();
                assert!((found - exact).abs() <= allowed, "{angle}: {found} for {exact}");
            }
        }
    }
}
