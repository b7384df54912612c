//! Random numbers that are the same in every run.
#![allow(dead_code, reason = "each user draws the kind of number that it needs")]

/// The number of cases that a test draws: `plain` in an ordinary run, and `whole` where the environment variable
/// `LINKAGE_WHOLE` is set, as `.ci/nightly` sets it. A count that a test asserts is a share of this number.
pub fn cases(plain: usize, whole: usize) -> usize {
    if std::env::var_os("LINKAGE_WHOLE").is_some() { whole } else { plain }
}

/// SplitMix64 (Steele, Lea and Flood, OOPSLA 2014).
pub struct Random {
    state: u64,
    /// The count of bits of the numbers that `between` draws.
    width: u32,
}

impl Random {
    pub fn new(seed: u64) -> Self {
        Self { state: seed, width: 24 }
    }

    /// Draws numbers of so few bits that sums of them are exact.
    pub fn coarse(seed: u64) -> Self {
        Self { state: seed, width: 4 }
    }

    /// Draws 64 bits.
    pub fn bits(&mut self) -> u64 {
        self.state = self.state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.state ^ (self.state >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// Uniform in [low, high), and a number that `f32` holds exactly.
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        let unit = (self.bits() >> (64 - self.width)) as f64 / (1_u64 << self.width) as f64;
        f64::from((low + unit * (high - low)) as f32)
    }

    /// Uniform in [0, 1), to 53 bits.
    pub fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// Uniform in [low, high), to the last place of an `f64`.
    pub fn anywhere(&mut self, low: f64, high: f64) -> f64 {
        low + self.unit() * (high - low)
    }
}
