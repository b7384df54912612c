//! The six-bar of crank, rpr and rpp: a block that swings on a bar, and a yoke.

use super::{Vector, fused};
use crate::number::Number;

/// The bar's direction, the block's slide, the yoke's and its pin's; their rates; their accelerations,
/// at a crank's angle and its rates.
#[inline(always)]
#[must_use]
pub fn swinging_block<F: Number>([angle, omega, alpha]: [F; 3]) -> Option<[F; 13]> {
    let (of, [cos, sin]) = (F::of, angle.cos_sin());
    let b = Vector { x: cos, y: sin } * of(0.4);
    // With the pivot of the bar 1 m below the crank's, b² is affine in sin θ.
    let square = fused(of(0.8), sin, of(1.16));
    if !square.gt(of(0.0)) {
        return None;
    }
    let slide = square.sqrt();
    let inverse = slide * (of(1.0) / square);
    let u = Vector { x: b.x * inverse, y: (b.y + of(1.0)) * inverse };
    let (along, across) = (b.dot(u), b.cross(u));
    // The pin's velocity ω b⊥ and acceleration α b⊥ − ω² b in the bar's axes.
    let turning = omega * along * inverse;
    let slide_rate = omega * across;
    let square_rate = omega * omega;
    let twice = turning + turning;
    let across_accel = fused(alpha, along, square_rate * across);
    let turning_rate = fused(-twice, slide_rate, across_accel) * inverse;
    let along_accel = fused(alpha, across, -(square_rate * along));
    let slide_second = fused(turning * turning, slide, along_accel);
    let (e, p) = (u * of(1.6), turning * turning);
    #[rustfmt::skip]
    let out = [
        u.x, u.y, slide, e.x, e.y - of(1.8),
        turning, slide_rate, -e.y * turning, e.x * turning,
        turning_rate, slide_second,
        fused(-e.y, turning_rate, -e.x * p), fused(e.x, turning_rate, -e.y * p),
    ];
    Some(out)
}
