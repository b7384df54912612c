//! The closed form as one tunes it when it matters: fused operations where the target has them,
//! one division and one root a dyad, the division beside the root, sine and cosine inlined.

use crate::mechanisms::{Dyad, Form};
use crate::number::Number;
use crate::plane::{Link, Moving, Vector};

pub(crate) enum Tuned {}

impl Form for Tuned {
    #[inline(always)]
    fn sin_cos<F: Number>(angle: F) -> (F, F) {
        angle.sin_cos_by_hand()
    }

    #[inline(always)]
    fn dyad<F: Number>(pin: Moving<F>, Dyad { pivot, lengths }: Dyad) -> Option<[Link<F>; 2]> {
        let (l2, l3) = lengths;
        let d = Vector::of(pivot.0, pivot.1) - pin.position;
        let square = dot(d, d);
        let triangle = Triangle {
            far: F::of((l2 + l3) * (l2 + l3)) - square,
            near: square - F::of((l2 - l3) * (l2 - l3)),
            square,
        };
        triangle.solve(d, pin, lengths)
    }
}

/// (l₂ + l₃)² − d², d² − (l₂ − l₃)² and d²: the first two make Heron's formula.
struct Triangle<F> {
    far: F,
    near: F,
    square: F,
}

impl<F: Number> Triangle<F> {
    #[inline(always)]
    fn solve(self, d: Vector<F>, pin: Moving<F>, (l2, l3): (f64, f64)) -> Option<[Link<F>; 2]> {
        let product = self.far * self.near;
        if product.partial_cmp(&F::of(0.0)) != Some(std::cmp::Ordering::Greater) {
            return None;
        }
        // One division for 1/d² and 1/J = 2/root = 2 root/product; it runs beside the root.
        let root = product.sqrt();
        let inverse = F::of(1.0) / (product * self.square);
        let half = inverse * (F::of(0.5) * product);
        let twice = inverse * (F::of(2.0) * self.square) * root;
        let along = (self.square + F::of(l2 * l2 - l3 * l3)) * half;
        let across = root * half;
        let r2 = Vector { x: d.x.fused(along, -d.y * across), y: d.y.fused(along, d.x * across) };
        let r3 = r2 - d;
        let (v, a) = (pin.velocity, pin.acceleration);
        let omega = [-dot(v, r3) * twice, -dot(v, r2) * twice];
        let (p, q) = (omega[0] * omega[0], omega[1] * omega[1]);
        let g = Vector {
            x: r2.x.fused(p, (-r3.x).fused(q, -a.x)),
            y: r2.y.fused(p, (-r3.y).fused(q, -a.y)),
        };
        let alpha = [dot(g, r3) * twice, dot(g, r2) * twice];
        let u = [r2 * F::of(1.0 / l2), r3 * F::of(1.0 / l3)];
        Some([0, 1].map(|k| Link { u: u[k], omega: omega[k], alpha: alpha[k] }))
    }
}

#[inline(always)]
fn dot<F: Number>(a: Vector<F>, b: Vector<F>) -> F {
    a.x.fused(b.x, a.y * b.y)
}

/// The four-bar: next to the crank d² is affine in cos θ.
#[inline(always)]
pub(crate) fn four_bar<F: Number>((sin, cos): (F, F), [omega, alpha]: [F; 2]) -> Option<[F; 14]> {
    const CRANK: f64 = 0.1016;
    const GROUND: f64 = 0.3048;
    const L2: f64 = 0.254;
    const L3: f64 = 0.1778;
    const MEAN: f64 = GROUND * GROUND + CRANK * CRANK;
    let b = Vector { x: cos * F::of(CRANK), y: sin * F::of(CRANK) };
    let (by_omega, by_alpha) = (omega * omega, alpha);
    let pin = Moving {
        position: b,
        velocity: b.normal() * omega,
        acceleration: Vector {
            x: (-b.y).fused(by_alpha, -b.x * by_omega),
            y: b.x.fused(by_alpha, -b.y * by_omega),
        },
    };
    let slope = F::of(2.0 * GROUND * CRANK);
    let triangle = Triangle {
        far: slope.fused(cos, F::of((L2 + L3) * (L2 + L3) - MEAN)),
        near: (-slope).fused(cos, F::of(MEAN - (L2 - L3) * (L2 - L3))),
        square: (-slope).fused(cos, F::of(MEAN)),
    };
    let d = Vector { x: F::of(GROUND) - b.x, y: -b.y };
    let [bc, dc] = triangle.solve(d, pin, (L2, L3))?;
    let r = Vector {
        x: bc.u.x.fused(F::of(0.15), -bc.u.y * F::of(0.05)),
        y: bc.u.y.fused(F::of(0.15), bc.u.x * F::of(0.05)),
    };
    let turning = bc.omega * bc.omega;
    let (v, a) = (pin.velocity, pin.acceleration);
    #[rustfmt::skip]
    let out = [
        b.x + r.x, b.y + r.y, bc.u.x, bc.u.y, dc.u.x, dc.u.y,
        (-r.y).fused(bc.omega, v.x), r.x.fused(bc.omega, v.y), bc.omega, dc.omega,
        (-r.y).fused(bc.alpha, (-r.x).fused(turning, a.x)),
        r.x.fused(bc.alpha, (-r.y).fused(turning, a.y)), bc.alpha, dc.alpha,
    ];
    Some(out)
}

/// The six-bar, without the angle of its bar.
#[inline(always)]
pub(crate) fn six_bar<F: Number>([angle, omega, alpha]: [F; 3]) -> Option<[F; 13]> {
    let (sin, cos) = angle.sin_cos_by_hand();
    let length = F::of(0.4);
    let b = Vector { x: length * cos, y: length * sin };
    // With the pivot of the bar 1 m below the crank's, b² is affine in sin θ.
    let square = F::of(0.8).fused(sin, F::of(1.16));
    if square.partial_cmp(&F::of(0.0)) != Some(std::cmp::Ordering::Greater) {
        return None;
    }
    let slide = square.sqrt();
    let inverse = slide * (F::of(1.0) / square);
    let u = Vector { x: b.x * inverse, y: (b.y + F::of(1.0)) * inverse };
    let (along, across) = (dot(b, u), b.x.fused(u.y, -b.y * u.x));
    // The pin's velocity ω b⊥ and acceleration α b⊥ − ω² b in the bar's axes.
    let turning = omega * along * inverse;
    let slide_rate = omega * across;
    let square_rate = omega * omega;
    let twice = turning + turning;
    let across_accel = alpha.fused(along, square_rate * across);
    let turning_rate = (-twice).fused(slide_rate, across_accel) * inverse;
    let along_accel = alpha.fused(across, -square_rate * along);
    let slide_second = (turning * turning).fused(slide, along_accel);
    let (e, p) = (u * F::of(1.6), turning * turning);
    #[rustfmt::skip]
    let out = [
        u.x, u.y, slide, e.x, e.y - F::of(1.8),
        turning, slide_rate, -e.y * turning, e.x * turning,
        turning_rate, slide_second,
        (-e.y).fused(turning_rate, -e.x * p), e.x.fused(turning_rate, -e.y * p),
    ];
    Some(out)
}
