//! Numbers to try a solver with: any bit pattern, the odd ones of every class, any size, and what
//! somebody might mean.

use linkage_core::{Differentiable, Float};
use linkage_tests::random::Random;

/// `f32` or `f64`, and its bits.
pub(crate) trait Number: Differentiable + Float + PartialOrd {
    const NAME: &'static str;
    /// Half the distance from 1 to the next number.
    const HALF_UNIT: f64;
    /// The largest number whose products are exact without fused operations.
    const SPLIT: f64;

    /// The number of a bit pattern, of which as many bits count as the number has.
    fn from_bits(bits: u64) -> Self;

    fn near(value: f64) -> Self;

    /// The count of numbers between zero and this one, negative below zero.
    fn rank(self) -> i64;

    fn of_rank(rank: i64) -> Self;

    /// The number so many steps further.
    fn stepped(self, steps: i64) -> Self {
        Self::of_rank(self.rank().saturating_add(steps))
    }
}

macro_rules! number {
    ($float:ident, $bits:ident, $split:literal) => {
        impl Number for $float {
            const NAME: &'static str = stringify!($float);
            const HALF_UNIT: f64 = $float::EPSILON as f64 / 2.0;
            const SPLIT: f64 = $split;

            fn from_bits(bits: u64) -> Self {
                Self::from_bits(bits as $bits)
            }

            fn near(value: f64) -> Self {
                value as Self
            }

            fn rank(self) -> i64 {
                let size = (self.to_bits() & !(1 << ($bits::BITS - 1))) as i64;
                if self.is_sign_negative() { -size } else { size }
            }

            fn of_rank(rank: i64) -> Self {
                let size = Self::from_bits(rank.unsigned_abs() as $bits);
                if rank < 0 { -size } else { size }
            }
        }
    };
}

// 2¹¹⁵ and 2⁹⁹⁶, see `sweep::Status`.
number!(f32, u32, 4.15e34);
number!(f64, u64, 6.69e299);

/// Random numbers of every class.
pub(crate) struct Source(Random);

impl Source {
    pub(crate) fn new(seed: u64) -> Self {
        Self(Random::new(seed))
    }

    fn next(&mut self) -> u64 {
        self.0.bits()
    }

    pub(crate) fn below(&mut self, count: usize) -> usize {
        (self.next() >> 33) as usize % count
    }

    pub(crate) fn between(&mut self, low: f64, high: f64) -> f64 {
        self.0.anywhere(low, high)
    }

    fn signed(&mut self, size: f64) -> f64 {
        if self.below(2) == 0 { size } else { -size }
    }

    /// A number of any class.
    pub(crate) fn odd<T: Number>(&mut self) -> T {
        match self.below(8) {
            0 => T::from_bits(self.next()),
            1 => T::from_bits(self.next() << 32 | self.next() >> 32),
            2 => {
                // The ends of the classes, and a few steps around them.
                let ends = [0.0, f64::INFINITY, f64::NAN, 1.0, f64::MAX, f64::from(f32::MAX)];
                let tiny = [f64::MIN_POSITIVE, f64::from(f32::MIN_POSITIVE), 5e-324, 1e-45];
                let ends = [&ends[..], &tiny].concat();
                let end = ends[self.below(ends.len())];
                let end = self.signed(end);
                T::near(end).stepped(self.below(7) as i64 - 3)
            }
            3 => {
                let exponent = self.between(-325.0, 309.0);
                T::near(self.signed(10.0_f64.powf(exponent)))
            }
            4 => {
                let exponent = self.between(-46.0, 39.0);
                T::near(self.signed(10.0_f64.powf(exponent)))
            }
            5 => {
                let exponent = self.between(-9.0, 9.0);
                T::near(self.signed(10.0_f64.powf(exponent)))
            }
            6 => {
                let quarters = self.between(-9.0, 9.0).round();
                let angle = T::near(quarters * core::f64::consts::FRAC_PI_2);
                angle.stepped(self.below(13) as i64 - 6)
            }
            _ => T::near(self.between(-4.0, 4.0).round() / 2.0),
        }
    }
}
