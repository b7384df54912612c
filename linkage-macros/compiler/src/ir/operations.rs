//! Counts of floating-point operations.

use std::ops::AddAssign;

/// Counts of floating-point operations.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Operations {
    /// Additions and subtractions.
    pub additions: u32,
    pub multiplications: u32,
    pub divisions: u32,
    pub roots: u32,
    /// Sine and cosine pairs, and other transcendental functions.
    pub sines: u32,
}

impl AddAssign for Operations {
    fn add_assign(&mut self, other: Self) {
        self.additions += other.additions;
        self.multiplications += other.multiplications;
        self.divisions += other.divisions;
        self.roots += other.roots;
        self.sines += other.sines;
    }
}
