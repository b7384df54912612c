//! Sine and cosine as a careful hand would write them for one project: a reduction in three parts
//! of π/2 and Taylor-like polynomials, inlined, about one unit in the last place.

#![allow(clippy::excessive_precision, reason = "the digits are those of the source")]

use laboratory::hand::sine::{COSINE, SINE, turned};

use crate::number::Number;

/// Below 1e5 the products with the first two parts of π/2 are exact.
#[inline(always)]
pub(crate) fn sin_cos_f64(x: f64) -> (f64, f64) {
    const SHIFT: f64 = 6_755_399_441_055_744.0;
    if x.abs() > 1e5 || x.is_nan() {
        return x.sin_cos();
    }
    let shifted = x.fused(std::f64::consts::FRAC_2_PI, SHIFT);
    let n = shifted - SHIFT;
    let r = (-n).fused(1.570_796_326_734_125_6, x);
    let r = (-n).fused(6.077_100_506_303_966e-11, r);
    let r = (-n).fused(2.022_266_248_795_950_6e-21, r);
    let z = r * r;
    let [s0, s1, s2, s3, s4, s5] = SINE;
    let z2 = z * z;
    let series = z2.fused(z2.fused(z.fused(s5, s4), z.fused(s3, s2)), z.fused(s1, s0));
    let sine = (z * r).fused(series, r);
    let [c0, c1, c2, c3, c4, c5] = COSINE;
    let series = z2.fused(z2.fused(z.fused(c5, c4), z.fused(c3, c2)), z.fused(c1, c0));
    let cosine = z2.fused(series, z.fused(-0.5, 1.0));
    let [cosine, sine] = turned(sine, cosine, shifted.to_bits());
    (sine, cosine)
}

/// Below 1e3 the products with the first two parts of π/2 are exact.
#[inline(always)]
pub(crate) fn sin_cos_f32(x: f32) -> (f32, f32) {
    const SHIFT: f32 = 12_582_912.0;
    if x.abs() > 1e3 || x.is_nan() {
        return x.sin_cos();
    }
    let shifted = x.fused(std::f32::consts::FRAC_2_PI, SHIFT);
    let n = shifted - SHIFT;
    let r = (-n).fused(1.570_312_5, x);
    let r = (-n).fused(4.837_513e-4, r);
    let r = (-n).fused(7.549_79e-8, r);
    let z = r * r;
    let sine = (z * r).fused(z.fused(z.fused(-1.951_529_6e-4, 8.332_161e-3), -1.666_665_5e-1), r);
    let series = z.fused(z.fused(2.443_315_7e-5, -1.388_731_6e-3), 4.166_664_6e-2);
    let cosine = (z * z).fused(series, z.fused(-0.5, 1.0));
    let q = shifted.to_bits();
    let (s, c) = (sine.to_bits(), cosine.to_bits());
    let swap = (s ^ c) & (q & 1).wrapping_neg();
    (
        f32::from_bits(s ^ swap ^ ((q & 2) << 30)),
        f32::from_bits(c ^ swap ^ ((q.wrapping_add(1) & 2) << 30)),
    )
}
