//! A cylinder between two points of one link, by which a bar about one of them is driven.
//!
//! With d from the cylinder's base to the bar's pivot, s the cylinder's length and r₂ × r₃ = h, as in
//! `dyads`, d² is a constant and s ṡ = r₂·v of the pin:
//!
//! ```text
//! ω₃ = −s ṡ/h     α₃ = (ω₃² (l₃² − r₂·r₃) − ṡ² − s s̈)/h
//! ```

use super::fused;
use super::plane::{Bar, Vector};

/// The bar, seen from the link that has its pivot and the cylinder's base; none out of reach.
#[inline(always)]
#[must_use]
pub fn cylinder(
    [base, pivot]: [[f64; 2]; 2],
    [s, rate, second]: [f64; 3],
    length: f64,
    side: f64,
) -> Option<Bar> {
    let d = Vector { x: pivot[0] - base[0], y: pivot[1] - base[1] };
    let (fixed, l2) = (d.dot(d), length * length);
    let (sum, difference) = (s + length, s - length);
    let x =
        fused(sum / 2.0, sum, -(fixed / 2.0)) * fused(-difference / 2.0, difference, fixed / 2.0);
    if !(x > 0.0) {
        return None;
    }
    let h = side * x.sqrt();
    let inverse_h = h * (1.0 / x);
    let square = s * s;
    let share = fused(0.5, square, (fixed - l2) / 2.0);
    let inverse = 1.0 / fixed;
    let r2 = Vector {
        x: inverse * fused(-h, d.y, share * d.x),
        y: inverse * fused(h, d.x, share * d.y),
    };
    let r3 = r2 - d;
    let between = fused(0.5, square, (l2 - fixed) / 2.0);
    let speed = s * rate;
    let omega3 = -(speed * inverse_h);
    let p = omega3 * omega3;
    let alpha3 = fused(p, l2 - between, -fused(rate, rate, s * second)) * inverse_h;
    Some(Bar { r: r3, length, omega: omega3, alpha: alpha3 })
}
