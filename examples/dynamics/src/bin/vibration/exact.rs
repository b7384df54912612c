//! Closed forms of linear vibrations: m ẍ + c ẋ + k x = H cos wt.
//!
//! With ω² = k/m and n = c/2m, the free vibration is A e^(−nt) sin(ω_d t + a) for n < ω, where
//! ω_d² = ω² − n²; e^(−ωt) (C + D t) for n = ω; and C e^((−n+s)t) + D e^((−n−s)t) for n > ω, where
//! s² = n² − ω². See Den Hartog, Mechanical Vibrations, chapters 2 and 3.

/// Let go at `start` with n < ω.
pub(crate) fn underdamped([m, c, k]: [f64; 3], start: f64) -> impl Fn(f64) -> f64 {
    let n = c / (2.0 * m);
    let rotating = (k / m - n * n).sqrt();
    // x = A sin a at the start, and no speed: tan a = ω_d/n.
    let (size, phase) = (start * (n / rotating).hypot(1.0), rotating.atan2(n));
    move |t| size * (-n * t).exp() * (rotating * t + phase).sin()
}

/// Let go at `start` with n = ω.
pub(crate) fn critical([m, k]: [f64; 2], start: f64) -> impl Fn(f64) -> f64 {
    let own = (k / m).sqrt();
    move |t| start * (-own * t).exp() * (1.0 + own * t)
}

/// Let go at `start` with n > ω.
pub(crate) fn overdamped([m, c, k]: [f64; 3], start: f64) -> impl Fn(f64) -> f64 {
    let n = c / (2.0 * m);
    let s = (n * n - k / m).sqrt();
    let [slow, fast] = [s - n, -s - n];
    move |t| start / (2.0 * s) * ((n + s) * (slow * t).exp() - (n - s) * (fast * t).exp())
}

/// From rest under H cos wt, n < ω: the vibration that stays, X cos(wt − φ), and a free one that makes
/// up for it at the start.
pub(crate) fn forced([m, c, k]: [f64; 3], [push, w]: [f64; 2]) -> impl Fn(f64) -> f64 {
    let n = c / (2.0 * m);
    let rotating = (k / m - n * n).sqrt();
    let (against, across) = (k - m * w * w, c * w);
    let (size, phase) = (push / against.hypot(across), across.atan2(against));
    let cosine = -size * phase.cos();
    let sine = (n * cosine - size * w * phase.sin()) / rotating;
    move |t| {
        let free = cosine * (rotating * t).cos() + sine * (rotating * t).sin();
        size * (w * t - phase).cos() + (-n * t).exp() * free
    }
}

/// Squares of the two natural frequencies, (3 ∓ √5)/2 k/m, and the ways of the masses in each, of length
/// one.
fn modes([m, k]: [f64; 2]) -> [(f64, [f64; 2]); 2] {
    let golden = (1.0 + 5.0_f64.sqrt()) / 2.0;
    let length = golden.hypot(1.0);
    [
        ((3.0 - 5.0_f64.sqrt()) / 2.0 * k / m, [1.0 / length, golden / length]),
        ((3.0 + 5.0_f64.sqrt()) / 2.0 * k / m, [golden / length, -1.0 / length]),
    ]
}

/// Two masses in a row, let go.
pub(crate) fn two_free(machine: [f64; 2], start: [f64; 2]) -> impl Fn(f64) -> [f64; 2] {
    let modes = modes(machine);
    move |t| {
        let mut at = [0.0; 2];
        for (square, way) in modes {
            let share = (start[0] * way[0] + start[1] * way[1]) * (square.sqrt() * t).cos();
            at = [at[0] + share * way[0], at[1] + share * way[1]];
        }
        at
    }
}

/// Amplitudes of the vibration that stays under F cos wt on the second mass:
/// X₁ = k F/((2k − m w²)(k − m w²) − k²), X₂ = (2k − m w²) F over the same.
pub(crate) fn two_steady([m, k]: [f64; 2], [push, w]: [f64; 2]) -> [f64; 2] {
    let [first, second] = [2.0 * k - m * w * w, k - m * w * w];
    let determinant = first * second - k * k;
    [k * push / determinant, first * push / determinant]
}

/// Two masses from rest under F cos wt on the second.
pub(crate) fn two_forced(machine: [f64; 2], push: [f64; 2]) -> impl Fn(f64) -> [f64; 2] {
    let steady = two_steady(machine, push);
    let free = two_free(machine, steady);
    move |t| {
        let (cos, free) = ((push[1] * t).cos(), free(t));
        [steady[0] * cos - free[0], steady[1] * cos - free[1]]
    }
}
