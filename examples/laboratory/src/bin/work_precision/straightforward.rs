//! The closed form as one writes it down: circles intersected, velocity and acceleration by
//! Cramer's rule, the standard library's sine.

use crate::mechanisms::{Dyad, Form};
use crate::number::Number;
use crate::plane::{Link, Moving, Vector, crank};

pub(crate) enum Straightforward {}

impl Form for Straightforward {
    #[inline(always)]
    fn sin_cos<F: Number>(angle: F) -> (F, F) {
        angle.sin_cos()
    }

    #[inline(always)]
    fn dyad<F: Number>(pin: Moving<F>, Dyad { pivot, lengths }: Dyad) -> Option<[Link<F>; 2]> {
        let (l2, l3) = lengths;
        let d = Vector::of(pivot.0, pivot.1) - pin.position;
        let square = d.dot(d);
        let along = (square + F::of(l2 * l2 - l3 * l3)) / (F::of(2.0) * square);
        let across = F::of(l2 * l2) / square - along * along;
        if across.partial_cmp(&F::of(0.0)) != Some(std::cmp::Ordering::Greater) {
            return None;
        }
        let r2 = d * along + d.normal() * across.sqrt();
        let r3 = r2 - d;
        let inverse = F::of(1.0) / r2.cross(r3);
        let omega = [-pin.velocity.dot(r3) * inverse, -pin.velocity.dot(r2) * inverse];
        let g = r2 * (omega[0] * omega[0]) - r3 * (omega[1] * omega[1]) - pin.acceleration;
        let alpha = [g.dot(r3) * inverse, g.dot(r2) * inverse];
        let u = [r2 * F::of(1.0 / l2), r3 * F::of(1.0 / l3)];
        Some([0, 1].map(|k| Link { u: u[k], omega: omega[k], alpha: alpha[k] }))
    }
}

/// The six-bar with the angle of its bar, by which everything else is found: 14 numbers.
#[inline(always)]
pub(crate) fn six_bar<F: Number>([angle, omega, alpha]: [F; 3]) -> Option<[F; 14]> {
    let b = crank(angle.sin_cos(), omega, alpha, 0.4);
    let from = b.position - Vector::of(0.0, -1.0);
    let slide = from.dot(from).sqrt();
    if slide.partial_cmp(&F::of(0.0)) != Some(std::cmp::Ordering::Greater) {
        return None;
    }
    let bar_angle = from.y.atan2(from.x);
    let u = from * (F::of(1.0) / slide);
    let turning = b.velocity.dot(u.normal()) / slide;
    let slide_rate = b.velocity.dot(u);
    let two = F::of(2.0);
    let turning_rate = (b.acceleration.dot(u.normal()) - two * turning * slide_rate) / slide;
    let slide_second = b.acceleration.dot(u) + turning * turning * slide;
    let bar = Link { u, omega: turning, alpha: turning_rate };
    let e = bar.end_about((0.0, -1.0), 1.6);
    let (x, v, a) = (e.position, e.velocity, e.acceleration);
    #[rustfmt::skip]
    let out = [
        u.x, u.y, slide, x.x, x.y - F::of(0.8),
        turning, slide_rate, v.x, v.y, turning_rate, slide_second, a.x, a.y, bar_angle,
    ];
    Some(out)
}
