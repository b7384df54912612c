//! Where a search begins: the root of the cubic through values and slopes of both ends.

use super::approach::{At, magnitude, number};
use crate::Real;

/// Newton's steps on the cubic, or halvings: from the parabola it takes two or three.
const STEPS: usize = 10;

/// The first trial between an end below zero and one above; not a number where the slopes are none.
pub(super) fn cubic<T: Real>([a, b]: [At<T>; 2]) -> T {
    let width = b.x - a.x;
    // From the end that is nearer to zero: next to a dead point the root is a small part of the
    // width away from it, and shall be right relative to that.
    if b.value.gt(-a.value) {
        a.x + width * part([a.value, b.value], [a.slope, b.slope].map(|slope| slope * width))
    } else {
        b.x - width * part([-b.value, -a.value], [b.slope, a.slope].map(|slope| slope * width))
    }
}

/// The root, between 0 and 1, of the cubic with these values at 0 and 1, below zero and above, and
/// with these slopes.
fn part<T: Real>([y0, y1]: [T; 2], [d0, d1]: [T; 2]) -> T {
    let [zero, half, one, two, three] = [0.0, 0.5, 1.0, 2.0, 3.0].map(number::<T>);
    if !(d0.is_finite() && d1.is_finite()) {
        return y0 / (y0 - y1);
    }
    let p = two * (y0 - y1) + (d0 + d1);
    let q = three * (y1 - y0) - (two * d0 + d1);
    // The parabola of the first end.
    let discriminant = d0 * d0 - number::<T>(4.0) * q * y0;
    let parabola = -two * y0 / (d0 + discriminant.sqrt());
    let mut u = if parabola.gt(zero) && one.gt(parabola) { parabola } else { half };
    let (mut low, mut high) = (zero, one);
    for _ in 0..STEPS {
        let value = ((p * u + q) * u + d0) * u + y0;
        let slope = (three * p * u + two * q) * u + d0;
        if value.gt(zero) {
            high = u;
        } else {
            low = u;
        }
        let next = u - value / slope;
        let near = (number::<T>(1e-3) * u).ge(magnitude(next - u));
        u = if next.gt(low) && high.gt(next) { next } else { (low + high) * half };
        if near {
            break;
        }
    }
    u
}
