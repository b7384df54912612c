//! Which instruction set a sweep runs on.
//!
//! Without the feature `std` it is the one the program was compiled for. With it, a program
//! compiled for any x86-64 asks the processor once and runs its sweeps on 256-bit registers with
//! fused operations where it has them; whether lanes fuse is a property of their type, so that
//! both versions are the same generated code.

use super::Entry;
use super::batch::Batch;
use crate::Float;
use crate::kernels::Native;

/// The poses from `start` on and before `end`.
pub(super) fn run<K, T: Float, E: Entry<K, T, IN, OUT>, const IN: usize, const OUT: usize>(
    batch: &mut Batch<'_, E, T, IN, OUT>,
    start: usize,
    end: usize,
) {
    #[cfg(all(feature = "std", target_arch = "x86_64", not(target_feature = "fma")))]
    if wide::run_if_available(batch, start, end) {
        return;
    }
    native(batch, start, end);
}

/// A function of its own: without optimisation the stack would hold the numbers of both versions.
fn native<K, T: Float, E: Entry<K, T, IN, OUT>, const IN: usize, const OUT: usize>(
    batch: &mut Batch<'_, E, T, IN, OUT>,
    start: usize,
    end: usize,
) {
    batch.run::<K, Native>(start, end);
}

#[cfg(all(feature = "std", target_arch = "x86_64", not(target_feature = "fma")))]
mod wide {
    //! AVX2 with fused operations, chosen while the program runs.

    use super::{Batch, Entry};
    use crate::{Float, Fused};

    /// The poses from `start` on and before `end`, or no where the processor has not what
    /// [`compiled`] is compiled for.
    #[allow(unsafe_code, reason = "the compiler cannot know what the processor answered")]
    pub(super) fn run_if_available<K, T, E, const IN: usize, const OUT: usize>(
        batch: &mut Batch<'_, E, T, IN, OUT>,
        start: usize,
        end: usize,
    ) -> bool
    where
        T: Float,
        E: Entry<K, T, IN, OUT>,
    {
        let available =
            std::is_x86_feature_detected!("avx2") && std::is_x86_feature_detected!("fma");
        if available {
            // SAFETY: the processor has just said that it has both instruction sets.
            unsafe { compiled(batch, start, end) };
        }
        available
    }

    #[target_feature(enable = "avx2,fma")]
    fn compiled<K, T: Float, E: Entry<K, T, IN, OUT>, const IN: usize, const OUT: usize>(
        batch: &mut Batch<'_, E, T, IN, OUT>,
        start: usize,
        end: usize,
    ) {
        batch.run::<K, Fused>(start, end);
    }
}
