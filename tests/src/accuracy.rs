//! The error of a solver's numbers against a table, in units of what conditioning allows.
//!
//! Nothing about one mechanism belongs here.

use linkage_core::Real;

use crate::tables::truth::{Row, Table, Truth};

/// Positions, velocities and accelerations in the order of the mechanism's `OUTPUTS`.
pub type Motion = [Vec<f64>; 3];

/// A result's rows as `f64`, which holds every narrower number exactly.
pub fn widened<T: Real, const N: usize>(rows: [T; N]) -> Vec<f64> {
    rows.iter().map(|row| row.value()).collect()
}

/// The error of `value`; where it is an angle, a whole turn is no error.
fn error(value: f64, truth: Truth, is_angle: bool) -> f64 {
    let away = value - truth.0;
    let turns = if is_angle { (away / core::f64::consts::TAU).round() } else { 0.0 };
    // The turn's own rounding, 2.4e-16, is below half a unit in the last place of π.
    (away - turns * core::f64::consts::TAU - truth.1).abs()
}

/// The largest error of a table in units of ε times the number's condition, by order: the number
/// of roundings, each as harmful as rounding a dimension or an input, that would explain it.
///
/// A number whose condition is zero does not depend on anything and must be exact.
pub fn roundings<T: Real>(
    table: &Table,
    outputs: &[&str],
    solve: impl Fn(&Row) -> Motion,
) -> [f64; 3] {
    let mut worst = [0.0_f64; 3];
    for row in table.rows {
        let motion = solve(row);
        for (column, name) in table.outputs.iter().enumerate() {
            let place = outputs.iter().position(|output| output == name);
            let place = place.unwrap_or_else(|| panic!("no output `{name}` in {outputs:?}"));
            for (order, truths) in [row.position, row.velocity, row.acceleration].iter().enumerate()
            {
                let is_angle = order == 0 && name.ends_with(".angle");
                let error = error(motion[order][place], truths[column], is_angle);
                let allowed = T::EPSILON * truths[column].2;
                let count = if error == 0.0 { 0.0 } else { error / allowed };
                assert!(!count.is_nan(), "`{name}` of order {order} at {row:?}");
                worst[order] = worst[order].max(count);
            }
        }
    }
    worst
}
