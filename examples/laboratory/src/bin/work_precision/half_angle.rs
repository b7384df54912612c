//! The textbook's closed form: the tangent of each half angle from a quadratic equation, then the
//! angles, then their sines and cosines (Norton, Design of Machinery, ch. 4, 6 and 7).

use crate::mechanisms::{Dyad, Form};
use crate::number::Number;
use crate::plane::{Link, Moving, Vector};

pub(crate) enum HalfAngle {}

impl Form for HalfAngle {
    #[inline(always)]
    fn sin_cos<F: Number>(angle: F) -> (F, F) {
        angle.sin_cos()
    }

    #[inline(always)]
    fn dyad<F: Number>(pin: Moving<F>, Dyad { pivot, lengths }: Dyad) -> Option<[Link<F>; 2]> {
        let (l2, l3) = lengths;
        let d = Vector::of(pivot.0, pivot.1) - pin.position;
        let square = d.dot(d);
        // d·u = K for each bar's direction u.
        let k2 = (square + F::of(l2 * l2 - l3 * l3)) / F::of(2.0 * l2);
        let k3 = (F::of(l2 * l2 - l3 * l3) - square) / F::of(2.0 * l3);
        let angles = [half_angle(d, square, k2)?, half_angle(d, square, k3)?];
        let u = angles.map(|angle| {
            let (sin, cos) = angle.sin_cos();
            Vector { x: cos, y: sin }
        });
        let sine = (angles[1] - angles[0]).sin_cos().0;
        let inverse = [F::of(1.0 / l2) / sine, F::of(1.0 / l3) / sine];
        let v = pin.velocity;
        let omega = [-v.dot(u[1]) * inverse[0], -v.dot(u[0]) * inverse[1]];
        let g = u[0] * (F::of(l2) * omega[0] * omega[0])
            - u[1] * (F::of(l3) * omega[1] * omega[1])
            - pin.acceleration;
        let alpha = [g.dot(u[1]) * inverse[0], g.dot(u[0]) * inverse[1]];
        Some([0, 1].map(|k| Link { u: u[k], omega: omega[k], alpha: alpha[k] }))
    }
}

/// The angle of u where d·u = k, u on the left of d.
#[inline(always)]
fn half_angle<F: Number>(d: Vector<F>, square: F, k: F) -> Option<F> {
    let discriminant = square - k * k;
    if discriminant.partial_cmp(&F::of(0.0)) != Some(std::cmp::Ordering::Greater) {
        return None;
    }
    Some(F::of(2.0) * (d.y + discriminant.sqrt()).atan2(d.x + k))
}
