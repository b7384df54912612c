//! The textbook's closed form: the tangent of each half angle from a quadratic equation, then the
//! angles, then their sines and cosines (Norton, Design of Machinery, ch. 4, 6 and 7).

use laboratory::hand::guides::Turning;
use laboratory::hand::{Dyad, Moving, Vector};
use laboratory::number::Number;

use super::{Form, crank, dot, unit, vector};

#[derive(Clone, Copy)]
pub(crate) struct HalfAngle;

impl<F: Number> Form<F> for HalfAngle {
    type Link = Turning<F>;

    #[inline(always)]
    fn crank(&self, input: [F; 3], length: f64) -> Moving<F> {
        crank(input, length)
    }

    #[inline(always)]
    fn dyad(&mut self, _: usize, pin: Moving<F>, dyad: Dyad) -> Option<[Turning<F>; 2]> {
        let [l2, l3] = dyad.lengths;
        let d = vector(dyad.pivot) - pin.position;
        let square = dot(d, d);
        // d·u = K for each bar's direction u.
        let k2 = (square + F::of(l2 * l2 - l3 * l3)) / F::of(2.0 * l2);
        let k3 = (F::of(l2 * l2 - l3 * l3) - square) / F::of(2.0 * l3);
        let angles = [half_angle(d, square, k2)?, half_angle(d, square, k3)?];
        let u = angles.map(unit);
        let [_, sine] = (angles[1] - angles[0]).library_cos_sin();
        let inverse = [F::of(1.0 / l2) / sine, F::of(1.0 / l3) / sine];
        let v = pin.velocity;
        let omega = [-dot(v, u[1]) * inverse[0], -dot(v, u[0]) * inverse[1]];
        let g = u[0] * (F::of(l2) * omega[0] * omega[0])
            - u[1] * (F::of(l3) * omega[1] * omega[1])
            - pin.acceleration;
        let alpha = [dot(g, u[1]) * inverse[0], dot(g, u[0]) * inverse[1]];
        Some([0, 1].map(|k| Turning { u: u[k], omega: omega[k], alpha: alpha[k] }))
    }
}

/// The angle of u where d·u = k, u on the left of d.
#[inline(always)]
fn half_angle<F: Number>(d: Vector<F>, square: F, k: F) -> Option<F> {
    let discriminant = square - k * k;
    if !discriminant.gt(F::of(0.0)) {
        return None;
    }
    Some(F::of(2.0) * (d.y + discriminant.sqrt()).library_atan2(d.x + k))
}
