//! The error of interpolation over a change point, in both widths.
//!
//! An antiparallelogram of bars 1 and 2 has tan φ/2 = −3 tan θ/2, so that e^iφ = (1 − 3it)/(1 + 3it)
//! of t = tan θ/2 has one pole, at t = i/3: θ = i ln 2 with a residue of 3/2. Its power series has
//! terms of (3/2) (w/ρ)⁸/ρ with ρ = ln 2 in the eighth power of a distance w, and the polynomial
//! through eight nodes at ±1, ±1.5, ±2 and ±2.5 widths is off by (1 · 1.5 · 2 · 2.5)² of that in
//! their middle. Where the clearance is `near` parts of its scale, w = √(2 near) but for a few
//! percent, which the eighth power makes a factor of up to four.

use core::f64::consts::{LN_2, TAU};
use linkage_core::{Float, Side, Tracker};
use linkage_tests::mechanisms::scaled_change_points::ScaledPairs;

fn bound(near: f64) -> f64 {
    let width = (2.0 * near).sqrt();
    4.0 * (1.0_f64 * 1.5 * 2.0 * 2.5).powi(2) * (width / LN_2).powi(8) * 1.5 / LN_2
}

/// The largest error of the rocker's direction and of its length, over a turn in steps of 0.05°.
fn worst<T: Float>() -> [f64; 2] {
    let number = |value: f64| T::lit(value, value as f32);
    let start = ScaledPairs::<T> { elbow: Side::Right, unit: number(1.0), base: number(2.0) };
    let mut tracker = Tracker::new(start);
    let mut worst = [0.0_f64; 2];
    for i in 0..7200 {
        let theta = 0.5 + TAU * f64::from(i) / 7200.0;
        let motion = tracker.motion(number(theta), number(1.0), number(0.0)).expect("it turns");
        let (s, c) = (number(theta).value() / 2.0).sin_cos();
        // tan φ/2 = −3 tan θ/2
        let phi = -2.0 * (3.0 * s).atan2(c);
        let [cos, sin] = [motion.position.DC.cos.value(), motion.position.DC.sin.value()];
        let off = (cos - phi.cos()).hypot(sin - phi.sin());
        worst = [worst[0].max(off), worst[1].max((cos.hypot(sin) - 1.0).abs())];
    }
    worst
}

#[test]
fn directions_over_a_change_point_are_as_right_as_eight_nodes_make_them() {
    for (name, found, allowed) in
        [("f64", worst::<f64>(), bound(1.2e-4)), ("f32", worst::<f32>(), bound(4.8e-3))]
    {
        println!("{name}: direction {:e}, length {:e}, {allowed:e} allowed", found[0], found[1]);
        assert!(found.iter().all(|found| *found <= allowed), "{name}: {found:?}, {allowed:e}");
    }
}
