//! The closed form as one writes it down: circles intersected, velocity and acceleration by
//! Cramer's rule, the standard library's sine.

use laboratory::hand::guides::Turning;
use laboratory::hand::{Dyad, Moving};
use laboratory::number::Number;

use super::{Block, Form, crank, cross, dot, vector};

#[derive(Clone, Copy)]
pub(crate) struct Straightforward;

impl<F: Number> Form<F> for Straightforward {
    type Link = Turning<F>;

    #[inline(always)]
    fn crank(&self, input: [F; 3], length: f64) -> Moving<F> {
        crank(input, length)
    }

    #[inline(always)]
    fn dyad(&mut self, _: usize, pin: Moving<F>, dyad: Dyad) -> Option<[Turning<F>; 2]> {
        let ([l2, l3], one) = (dyad.lengths, F::of(1.0));
        let d = vector(dyad.pivot) - pin.position;
        let square = dot(d, d);
        let along = (square + F::of(l2 * l2 - l3 * l3)) / (F::of(2.0) * square);
        let across = F::of(l2 * l2) / square - along * along;
        if !across.gt(F::of(0.0)) {
            return None;
        }
        let r2 = d * along + d.normal() * across.sqrt();
        let r3 = r2 - d;
        let inverse = one / cross(r2, r3);
        let (v, a) = (pin.velocity, pin.acceleration);
        let omega = [-dot(v, r3) * inverse, -dot(v, r2) * inverse];
        let g = r2 * (omega[0] * omega[0]) - r3 * (omega[1] * omega[1]) - a;
        let alpha = [dot(g, r3) * inverse, dot(g, r2) * inverse];
        let u = [r2 * (one / F::of(l2)), r3 * (one / F::of(l3))];
        Some([0, 1].map(|k| Turning { u: u[k], omega: omega[k], alpha: alpha[k] }))
    }
}

impl<F: Number> Block<F> for Straightforward {
    #[inline(always)]
    fn block(&mut self, pin: Moving<F>, pivot: [f64; 2]) -> Option<(Turning<F>, [F; 3])> {
        let from = pin.position - vector(pivot);
        let slide = dot(from, from).sqrt();
        if !slide.gt(F::of(0.0)) {
            return None;
        }
        let u = from * (F::of(1.0) / slide);
        let (v, a) = (pin.velocity, pin.acceleration);
        let omega = dot(v, u.normal()) / slide;
        let rate = dot(v, u);
        let alpha = (dot(a, u.normal()) - F::of(2.0) * omega * rate) / slide;
        let second = dot(a, u) + omega * omega * slide;
        Some((Turning { u, omega, alpha }, [slide, rate, second]))
    }
}
