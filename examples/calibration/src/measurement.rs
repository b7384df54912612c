//! The camera's measurements of the machine as built: the tracked pins at 36 poses, with noise.

use std::f64::consts::TAU;

use linkage_core::SolveError;

use super::machine::{Dimensions, TRACKED, tracked};

/// The noise's standard deviation in each coordinate, in metres.
pub(crate) const NOISE: f64 = 50e-6;

/// Poses in a turn.
pub(crate) const POSES: usize = 36;

/// Encoder readings and what was seen at each.
#[derive(Clone, Debug)]
pub(crate) struct Measurement {
    pub(crate) thetas: Vec<f64>,
    pub(crate) seen: Vec<[f64; TRACKED]>,
}

/// Measures the machine; each seed has noise of its own.
pub(crate) fn measure(built: Dimensions, seed: u64) -> Result<Measurement, SolveError> {
    let mut noise = Noise(seed);
    let thetas: Vec<f64> = (0..POSES).map(|pose| TAU * pose as f64 / POSES as f64).collect();
    let seen = thetas
        .iter()
        .map(|&theta| Ok(tracked(built, theta)?.map(|exact| exact + NOISE * noise.normal())))
        .collect::<Result<_, SolveError>>()?;
    Ok(Measurement { thetas, seen })
}

/// Random numbers that are the same in every run: SplitMix64 (Steele, Lea and Flood, OOPSLA 2014).
struct Noise(u64);

impl Noise {
    /// Uniform in (0, 1].
    fn uniform(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        (((z ^ (z >> 31)) >> 11) + 1) as f64 / (1_u64 << 53) as f64
    }

    /// A normal random number with mean 0 and deviation 1 (Box and Muller, 1958).
    fn normal(&mut self) -> f64 {
        let radius = (-2.0 * self.uniform().ln()).sqrt();
        radius * (TAU * self.uniform()).cos()
    }
}
