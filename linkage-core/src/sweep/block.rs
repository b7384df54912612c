//! The numbers of a block of poses, in columns.

use super::poses::Poses;
use super::verdict::TOGETHER;
use crate::{Float, Fusion, Lanes, Scalar};

/// Poses in a block: a few registers full, so that the block's columns stay in the first cache.
pub(super) const BLOCK: usize = 16;

/// The distance between poses that are computed together: those between fill vectors.
pub(super) const APART: usize = BLOCK / TOGETHER;

/// The numbers of one input or output at the poses of a block, aligned to a line of the cache:
/// a vector across two lines costs twice.
#[derive(Clone, Copy)]
#[repr(align(64))]
pub(super) struct Column<T>(pub(super) [T; BLOCK]);

/// Sines and cosines of the first input; of nothing where there is none.
///
/// No option: where a loop over poses asked if there is one, it had two ways, and became none over vectors.
pub(super) struct Circles<T> {
    pub(super) sines: Column<T>,
    pub(super) cosines: Column<T>,
}

impl<T: Float> Circles<T> {
    /// Where no one reads them, they are not computed.
    #[inline(always)]
    pub(super) fn of_the_first<F: Fusion>(inputs: &[Column<T>]) -> Self {
        let angles = inputs.first().copied().unwrap_or(Column::splat(T::lit(0.0, 0.0)));
        let [mut sines, mut cosines] = [angles; 2];
        for (sine, cosine) in sines.0.iter_mut().zip(&mut cosines.0) {
            let (sin, cos) = Lanes::<T, 1, F>::splat(*sine).sin_cos_near();
            ([*sine], [*cosine]) = (sin.to_array(), cos.to_array());
        }
        Self { sines, cosines }
    }
}

impl<T: Float> Column<T> {
    pub(super) const fn splat(value: T) -> Self {
        Self([value; BLOCK])
    }

    /// The numbers at the poses that are computed together, of which this is the first.
    #[inline(always)]
    pub(super) fn at(&self, pose: usize) -> [T; TOGETHER] {
        core::array::from_fn(|nth| {
            self.0.get(pose + nth * APART).copied().unwrap_or(T::lit(0.0, 0.0))
        })
    }
}

/// Puts the numbers of poses into their columns; `pose` is the first.
///
/// In loops so short that they are unrolled: one that remained would keep the loop over the poses from
/// becoming one over vectors. As one loop, 84 numbers were written three times as slowly. 256 numbers are
/// more than any example has; what is beyond them is put by a loop that remains.
#[inline(always)]
pub(super) fn put<T: Float, F: Fusion>(
    mut values: &[Poses<T, F>],
    mut columns: &mut [Column<T>],
    pose: usize,
) {
    macro_rules! put_sixteen {
        () => {
            let count = values.len().min(16);
            let (columns_, values_) =
                (columns.split_at_mut_checked(count), values.split_at_checked(count));
            let (Some((these, columns_)), Some((numbers, values_))) = (columns_, values_) else {
                return;
            };
            put_all(numbers, these, pose);
            (columns, values) = (columns_, values_);
        };
    }
    macro_rules! put_sixty_four {
        () => {
            put_sixteen!();
            put_sixteen!();
            put_sixteen!();
            put_sixteen!();
        };
    }
    put_sixty_four!();
    put_sixty_four!();
    put_sixty_four!();
    put_sixty_four!();
    put_all(values, columns, pose);
}

#[inline(always)]
fn put_all<T: Float, F: Fusion>(values: &[Poses<T, F>], columns: &mut [Column<T>], pose: usize) {
    for (column, value) in columns.iter_mut().zip(values) {
        for (nth, number) in value.numbers().into_iter().enumerate() {
            column.0.get_mut(pose + nth * APART).into_iter().for_each(|to| *to = number);
        }
    }
}
