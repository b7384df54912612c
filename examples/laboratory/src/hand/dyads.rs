//! Two bars and the pin between them.
//!
//! With d the line from the first bar's joint to the second's, x = h² where h d² is the pin's height
//! over it and q d² what d·r₂ is,
//!
//! ```text
//! r₂ = (q d + h d⊥)/d²        r₃ = r₂ − d        r₂ × r₃ = h
//! ```
//!
//! Everything about the pin is affine in h, so that its coefficients are there before the root is;
//! and 1/h = h · (1/h²), so that the division runs beside the root.

use super::fused;
use super::plane::{Bar, Moving, Vector};
use crate::number::Number;

/// A crank on the origin of ground axes, and two bars from its pin to a point of the ground.
#[derive(Clone, Copy, Debug)]
pub struct CrankDyad {
    /// Its length in m.
    pub crank: f64,
    /// The other end.
    pub dyad: Dyad,
}

/// Two bars to a point of the ground.
#[derive(Clone, Copy, Debug)]
pub struct Dyad {
    /// The point of the ground in m.
    pub pivot: [f64; 2],
    /// In m.
    pub lengths: [f64; 2],
    /// +1 where the pin is on the left of the line from the first to the second joint, −1 on the right.
    pub side: f64,
}

/// A dyad's second joint.
#[derive(Clone, Copy, Debug)]
pub enum Joint<F = f64> {
    /// A point of the ground.
    Ground([f64; 2]),
    /// A point that moves.
    Link(Moving<F>),
}

/// The crank's pin and the bars, from the crank's cosine and sine and its rates; none out of reach.
///
/// Two products a·r₂ and a × r₂ with the crank's arm a serve the velocities and accelerations of
/// both bars, in either order; d², h² and q are affine in one cosine, with one slope.
#[inline(always)]
#[must_use]
pub fn crank_dyad<F: Number>(
    form: CrankDyad,
    [cos, sin]: [F; 2],
    [omega, alpha]: [F; 2],
) -> Option<(Moving<F>, [Bar<F>; 2])> {
    let of = F::of;
    let CrankDyad { crank, dyad: Dyad { pivot: [gx, gy], lengths: [l2, l3], side } } = form;
    let mean = gx * gx + gy * gy + crank * crank;
    let aligned = gy == 0.0;
    let along = if aligned { cos } else { fused(of(gx), cos, of(gy) * sin) };
    let slope = if aligned { crank * gx } else { crank };
    let inverse = of(1.0) / fused(of(-2.0 * slope), along, of(mean));
    let far = fused(of(slope), along, of(((l2 + l3) * (l2 + l3) - mean) / 2.0));
    let near = fused(of(-slope), along, of((mean - (l2 - l3) * (l2 - l3)) / 2.0));
    let x = far * near;
    if !x.gt(of(0.0)) {
        return None;
    }
    let h = of(side) * x.sqrt();
    let share = fused(of(-slope), along, of((mean + l2 * l2 - l3 * l3) / 2.0));
    let between = fused(of(slope), along, of((l2 * l2 + l3 * l3 - mean) / 2.0));
    let arm = Vector { x: of(crank) * cos, y: of(crank) * sin };
    let (dx, dy) = (of(gx) - arm.x, if aligned { -arm.y } else { of(gy) - arm.y });
    let r2 =
        Vector { x: inverse * fused(-h, dy, share * dx), y: inverse * fused(h, dx, share * dy) };
    let r3 = Vector { x: r2.x - dx, y: r2.y - dy };
    // a·d and d × a
    let f = fused(of(slope), along, of(-(crank * crank)));
    let e = if aligned { of(gx) * arm.y } else { fused(of(gx), arm.y, -(of(gy) * arm.x)) };
    // a·r₂ and a × r₂
    let dot = inverse * fused(h, e, share * f);
    let cross = inverse * fused(h, f, -(share * e));
    let upright = -h * (of(1.0) / x);
    let (dot3, cross3) = (dot - f, cross + e);
    let (omega2, omega3) = (upright * omega * cross3, upright * omega * cross);
    let square_rate = omega * omega;
    let (p, q) = (omega2 * omega2, omega3 * omega3);
    let w2 = fused(alpha, cross3, -(square_rate * dot3));
    let w3 = fused(alpha, cross, -(square_rate * dot));
    let alpha2 = upright * fused(q, of(l3 * l3), fused(-p, between, w2));
    let alpha3 = upright * fused(q, between, fused(-p, of(l2 * l2), w3));
    let pin = Moving::about([0.0, 0.0], arm, omega, alpha);
    let bars = [
        Bar { r: r2, length: l2, omega: omega2, alpha: alpha2 },
        Bar { r: r3, length: l3, omega: omega3, alpha: alpha3 },
    ];
    Some((pin, bars))
}

/// Two bars between two joints; none out of reach.
///
/// The products with d⊥ and d serve both bars, as r₃ = r₂ − d.
#[inline(always)]
#[must_use]
pub fn dyad<F: Number>(
    from: Moving<F>,
    to: Joint<F>,
    [l2, l3]: [f64; 2],
    side: f64,
) -> Option<[Bar<F>; 2]> {
    let of = F::of;
    let d = match to {
        Joint::Ground([x, y]) => Vector { x: of(x), y: of(y) } - from.position,
        Joint::Link(joint) => joint.position - from.position,
    };
    let square = d.dot(d);
    let (inverse, half) = (of(1.0) / square, of(0.5));
    let x = fused(-half, square, of((l2 + l3) * (l2 + l3) / 2.0))
        * fused(half, square, of(-((l2 - l3) * (l2 - l3) / 2.0)));
    if !x.gt(of(0.0)) {
        return None;
    }
    let h = of(side) * x.sqrt();
    let share = fused(half, square, of((l2 * l2 - l3 * l3) / 2.0));
    let between = fused(-half, square, of((l2 * l2 + l3 * l3) / 2.0));
    let r2 = Vector {
        x: inverse * fused(-h, d.y, share * d.x),
        y: inverse * fused(h, d.x, share * d.y),
    };
    let r3 = r2 - d;
    // Velocity and acceleration of the first joint relative to the second.
    let (v, a) = match to {
        Joint::Ground(_) => (from.velocity, from.acceleration),
        Joint::Link(joint) => {
            (from.velocity - joint.velocity, from.acceleration - joint.acceleration)
        }
    };
    let upright = -h * (of(1.0) / x);
    // w·r₂ and w·d of w = v and w = a
    let products = |w: Vector<F>| {
        let (along, aside) = (w.dot(d), d.cross(w));
        let with2 = inverse * fused(h, aside, share * along);
        [with2, with2 - along]
    };
    let [v2, v3] = products(v);
    let (omega2, omega3) = (upright * v3, upright * v2);
    let (p, q) = (omega2 * omega2, omega3 * omega3);
    let [a2, a3] = products(a);
    let alpha2 = upright * fused(q, of(l3 * l3), fused(-p, between, a3));
    let alpha3 = upright * fused(q, between, fused(-p, of(l2 * l2), a2));
    Some([
        Bar { r: r2, length: l2, omega: omega2, alpha: alpha2 },
        Bar { r: r3, length: l3, omega: omega3, alpha: alpha3 },
    ])
}
