//! Premises of a program: numbers that are ranged over, and others.

use super::outward::OutwardInterval;
use crate::exact::Exact;

/// A number that a program is given.
#[derive(Clone, Debug)]
pub enum Leaf {
    /// A number of the width, which goes over this range of [`Premises::ranges`]. Taken as exact.
    Ranged(usize),
    /// A number of the width within these. Taken as exact.
    Within(OutwardInterval),
    /// A decimal, rounded to the width.
    Decimal(Exact),
}

/// See the module's documentation.
#[derive(Clone, Debug)]
pub struct Premises {
    /// The ends of each range.
    pub ranges: Vec<[f64; 2]>,
    /// Value, rate and acceleration of each input.
    pub inputs: Vec<[Leaf; 3]>,
    pub params: Vec<Leaf>,
    pub loads: Vec<Leaf>,
    pub drives: Vec<Leaf>,
    /// Functions of the target's in place of the run-time's.
    pub hooks: Hooks,
    /// True if results are wanted for all rates, as multiples of these: then the error of what depends on a rate is
    /// relative.
    pub scales_with_rates: bool,
}

/// The errors of functions that a target brings, where it brings any.
#[derive(Clone, Copy, Debug, Default)]
pub struct Hooks {
    /// The error of sine and cosine.
    pub sine: Option<f64>,
    /// The error of the square root, in last places.
    pub root: Option<f64>,
}

impl Leaf {
    pub const ZERO: Self = Self::Within(OutwardInterval::ZERO);

    /// This number, which every width holds.
    pub fn number(value: f64) -> Self {
        Self::Within(OutwardInterval::point(value))
    }
}
