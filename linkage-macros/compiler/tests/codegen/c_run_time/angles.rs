//! Angles as numbers near a given one: those of `Direction::angle_near`, to the last bit.

use std::f64::consts::TAU;

use super::{Call, Program, Random, compare};
use linkage_core::Direction;

const NEAR: i32 = 19;

/// Directions of any length and sign of zero, beside angles of up to 2⁶⁰ rad, multiples of half a turn and what is no
/// number.
pub(super) fn agree(programs: &[Program], count: usize) {
    let mut random = Random(13);
    for is_single in [false, true] {
        let width = |x: f64| if is_single { f64::from(x as f32) } else { x };
        let mut call = || {
            let (sin, cos) = (random.unit() * TAU).sin_cos();
            let [cos, sin] = match random.below(4) {
                0 => [random.pick(&[0.0, -0.0, 1.0, -1.0]), random.pick(&[0.0, -0.0, 1.0])],
                _ => [cos, sin],
            };
            let previous = match random.below(4) {
                0 => (random.unit() * 20.0).round() * TAU / 2.0,
                1 => random.any(60.0),
                _ => (random.unit() - 0.5) * 1e4,
            };
            let x = [cos, sin, previous, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0];
            Call { which: NEAR, is_single, x: x.map(width) }
        };
        let calls: Vec<Call> = (0..count).map(|_| call()).collect();
        let answers = compare(programs, &calls, |call| {
            let [cos, sin, previous, ..] = call.x;
            let angle = match is_single {
                false => Direction { cos, sin }.angle_near(previous),
                true => {
                    let [cos, sin, previous] = [cos, sin, previous].map(|x| x as f32);
                    f64::from(Direction { cos, sin }.angle_near(previous))
                }
            };
            [0.0, 0.0, angle, 0.0]
        });
        // The nearest one is half a turn off at most, but for the rounding of both.
        for (call, answer) in calls.iter().zip(&answers) {
            let [off, size] = [answer[2] - call.x[2], call.x[2].abs()];
            let rounding = if is_single { 1e-6 } else { 1e-15 } * (size + 4.0);
            assert!(off.is_nan() || off.abs() <= TAU / 2.0 + rounding, "{call:?}: {answer:?}");
        }
    }
}
