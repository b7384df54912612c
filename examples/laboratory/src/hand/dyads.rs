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
pub enum Joint {
    /// A point of the ground.
    Ground([f64; 2]),
    /// A point that moves.
    Link(Moving),
}

/// The crank's pin and the bars, from the crank's cosine and sine and its rates; none out of reach.
///
/// Two products a·r₂ and a × r₂ with the crank's arm a serve the velocities and accelerations of
/// both bars, in either order; d², h² and q are affine in one cosine, with one slope.
#[inline(always)]
#[must_use]
pub fn crank_dyad(
    form: CrankDyad,
    [cos, sin]: [f64; 2],
    [omega, alpha]: [f64; 2],
) -> Option<(Moving, [Bar; 2])> {
    let CrankDyad { crank, dyad: Dyad { pivot: [gx, gy], lengths: [l2, l3], side } } = form;
    let mean = gx * gx + gy * gy + crank * crank;
    let aligned = gy == 0.0;
    let along = if aligned { cos } else { fused(gx, cos, gy * sin) };
    let slope = if aligned { crank * gx } else { crank };
    let square = fused(-2.0 * slope, along, mean);
    let inverse = 1.0 / square;
    let far = fused(slope, along, ((l2 + l3) * (l2 + l3) - mean) / 2.0);
    let near = fused(-slope, along, (mean - (l2 - l3) * (l2 - l3)) / 2.0);
    let x = far * near;
    if !(x > 0.0) {
        return None;
    }
    let h = side * x.sqrt();
    let share = fused(-slope, along, (mean + l2 * l2 - l3 * l3) / 2.0);
    let between = fused(slope, along, (l2 * l2 + l3 * l3 - mean) / 2.0);
    let arm = Vector { x: crank * cos, y: crank * sin };
    let (dx, dy) = (gx - arm.x, if aligned { -arm.y } else { gy - arm.y });
    let r2 =
        Vector { x: inverse * fused(-h, dy, share * dx), y: inverse * fused(h, dx, share * dy) };
    let r3 = Vector { x: r2.x - dx, y: r2.y - dy };
    // a·d and d × a
    let f = fused(slope, along, -(crank * crank));
    let e = if aligned { gx * arm.y } else { fused(gx, arm.y, -(gy * arm.x)) };
    // a·r₂ and a × r₂
    let dot = inverse * fused(h, e, share * f);
    let cross = inverse * fused(h, f, -(share * e));
    let upright = -h * (1.0 / x);
    let (dot3, cross3) = (dot - f, cross + e);
    let (omega2, omega3) = (upright * omega * cross3, upright * omega * cross);
    let square_rate = omega * omega;
    let (p, q) = (omega2 * omega2, omega3 * omega3);
    let w2 = fused(alpha, cross3, -(square_rate * dot3));
    let w3 = fused(alpha, cross, -(square_rate * dot));
    let alpha2 = upright * fused(q, l3 * l3, fused(-p, between, w2));
    let alpha3 = upright * fused(q, between, fused(-p, l2 * l2, w3));
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
pub fn dyad(from: Moving, to: Joint, [l2, l3]: [f64; 2], side: f64) -> Option<[Bar; 2]> {
    let d = match to {
        Joint::Ground([x, y]) => Vector { x: x - from.position.x, y: y - from.position.y },
        Joint::Link(joint) => joint.position - from.position,
    };
    let square = d.dot(d);
    let inverse = 1.0 / square;
    let x = fused(-0.5, square, (l2 + l3) * (l2 + l3) / 2.0)
        * fused(0.5, square, -((l2 - l3) * (l2 - l3) / 2.0));
    if !(x > 0.0) {
        return None;
    }
    let h = side * x.sqrt();
    let share = fused(0.5, square, (l2 * l2 - l3 * l3) / 2.0);
    let between = fused(-0.5, square, (l2 * l2 + l3 * l3) / 2.0);
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
    let upright = -h * (1.0 / x);
    // w·r₂ and w·d of w = v and w = a
    let products = |w: Vector| {
        let (along, aside) = (w.dot(d), d.cross(w));
        let with2 = inverse * fused(h, aside, share * along);
        [with2, with2 - along]
    };
    let [v2, v3] = products(v);
    let (omega2, omega3) = (upright * v3, upright * v2);
    let (p, q) = (omega2 * omega2, omega3 * omega3);
    let [a2, a3] = products(a);
    let alpha2 = upright * fused(q, l3 * l3, fused(-p, between, a3));
    let alpha3 = upright * fused(q, between, fused(-p, l2 * l2, a2));
    Some([
        Bar { r: r2, length: l2, omega: omega2, alpha: alpha2 },
        Bar { r: r3, length: l3, omega: omega3, alpha: alpha3 },
    ])
}
