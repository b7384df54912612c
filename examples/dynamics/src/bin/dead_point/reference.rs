//! The same machine as three bars with their angles, two equations for the loop, and multipliers: nothing
//! of the compiler is in it, and no pose is a dead point to it.

use dynamics::Motion;
use linkage_core::SolveError;
use nalgebra::{SMatrix, SVector};

use crate::Pose;

const LENGTHS: [f64; 3] = [0.6, 0.5, 0.7];
const MASSES: [f64; 3] = [1.2, 1.0, 1.4];
const G: f64 = 9.81;

/// Where B and C are in the end.
pub(crate) fn ends(start: &Pose, seconds: f64) -> [[f64; 2]; 2] {
    let coupler = (start.c.y - start.b.y).atan2(start.c.x - start.b.x);
    let [left, right] = start.angles;
    assert_eq!(start.rates, [0.0; 2], "let go at rest");
    let state = [left, coupler, right, 0.0, 0.0, 0.0];
    let motion = Motion::new([0.0, seconds], state, |_, state| rates(state)).tolerance(1e-12);
    let [a, _, c, ..] = motion.ended().unwrap().last().1;
    let [l, _, r] = LENGTHS;
    [[l * a.cos(), l * a.sin()], [1.0 + r * c.cos(), r * c.sin()]]
}

/// Angles of left rocker, coupler and right rocker, and their rates.
fn rates([a, b, c, u, v, w]: [f64; 6]) -> Result<[f64; 6], SolveError> {
    let ([l1, l2, l3], [m1, m2, m3]) = (LENGTHS, MASSES);
    let k = 0.5 * m2 * l1 * l2;
    let mut matrix = SMatrix::<f64, 5, 5>::zeros();
    matrix[(0, 0)] = m1 * l1 * l1 / 3.0 + m2 * l1 * l1;
    matrix[(0, 1)] = k * (a - b).cos();
    matrix[(1, 0)] = matrix[(0, 1)];
    matrix[(1, 1)] = m2 * l2 * l2 / 3.0;
    matrix[(2, 2)] = m3 * l3 * l3 / 3.0;
    // The loop: l1 e(a) + l2 e(b) − l3 e(c) = (1, 0).
    let columns = [(l1, a), (l2, b), (-l3, c)];
    for (column, (length, angle)) in columns.into_iter().enumerate() {
        matrix[(3, column)] = -length * angle.sin();
        matrix[(4, column)] = length * angle.cos();
        matrix[(column, 3)] = matrix[(3, column)];
        matrix[(column, 4)] = matrix[(4, column)];
    }
    let swing = |along: fn(f64) -> f64| {
        l1 * along(a) * u * u + l2 * along(b) * v * v - l3 * along(c) * w * w
    };
    let right: SVector<f64, 5> = [
        -k * (a - b).sin() * v * v - G * a.cos() * (0.5 * m1 + m2) * l1,
        k * (a - b).sin() * u * u - G * b.cos() * 0.5 * m2 * l2,
        -G * c.cos() * 0.5 * m3 * l3,
        swing(f64::cos),
        swing(f64::sin),
    ]
    .into();
    let solved = matrix.lu().solve(&right).ok_or(SolveError::Singular { group: "bars" })?;
    Ok([u, v, w, solved[0], solved[1], solved[2]])
}
