//! The rate at which the true dimensions lie within their intervals.

use std::error::Error;

use super::fit::calibrate;
use super::machine::{Dimensions, UNKNOWNS};
use super::measurement::measure;

/// For each dimension, the number of calibrations whose interval holds the true one. Every
/// calibration has a measurement of its own.
pub(crate) fn held(
    built: Dimensions,
    calibrations: u64,
) -> Result<[u32; UNKNOWNS], Box<dyn Error>> {
    let mut held = [0; UNKNOWNS];
    for seed in 0..calibrations {
        let found = calibrate(&measure(built, 1000 + seed)?)?;
        for (i, count) in held.iter_mut().enumerate() {
            let away = (found.dimensions[i] - built[i]).abs();
            *count += u32::from(away <= found.half_widths[i]);
        }
    }
    Ok(held)
}
