//! Many poses in one call.
//!
//! A sweep reads its inputs from slices and writes every component of every output to a slice of
//! its own, which is how plots, tables and other programs want them and what vector instructions
//! need. It runs the same generated code as a single call in a loop that the compiler vectorises,
//! falls back to the single call where the mask says no, and allocates nothing.
//!
//! Generated code solves one pose ([`Entry`]). Loops, tails, statuses and the choice of an instruction set
//! are written once, here.

mod batch;
mod block;
mod entries;
mod instructions;
pub(crate) mod kinds;
mod poses;
#[cfg(test)]
mod tests;
mod verdict;

use core::fmt;

use crate::roots::seed::Seed;
use crate::{Float, Record, Scalar, SolveError};
use batch::Batch;
pub use entries::{put_found, put_solved, put_usable};

/// The status of one pose, in a byte: the result of a single call without its details, which only the
/// single call gives.
///
/// There are two differences. Without fused operations the exact product of numbers beyond 2⁹⁹⁶ (`f32`:
/// 2¹¹⁵) cannot be made, and a call that needs it answers [`SolveError::NotFinite`]; a sweep that
/// found fused instructions on the machine needs no splitting and may solve such a pose, or find it out of
/// reach. And behind
/// a group whose pin was rounded otherwise, a pose that is at its limit in the one may be a rounding
/// away from it in the other, which then has a velocity; so it may be behind a root that a sweep found from
/// the pose before. What a sweep calls solved is right.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum Status {
    /// The pose was solved.
    #[default]
    Solved,
    /// See [`SolveError::OutOfReach`].
    OutOfReach,
    /// See [`SolveError::Singular`].
    Singular,
    /// See [`SolveError::Invalid`].
    Invalid,
    /// See [`SolveError::NotFinite`].
    NotFinite,
    /// See [`SolveError::OffCircle`].
    OffCircle,
    /// See [`SolveError::NoSolution`].
    NoSolution,
    /// See [`SolveError::SeveralDeadPoints`].
    SeveralDeadPoints,
    /// See [`SolveError::Jams`].
    Jams,
    /// See [`SolveError::NotCertified`].
    NotCertified,
}

/// One input of a sweep: a number for each pose, or one number for all of them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Series<'a, T> {
    /// A number for each pose.
    Each(&'a [T]),
    /// The same number at every pose.
    Constant(T),
}

/// A listener for the progress of a sweep: `()` for none, or a function of the number of poses done
/// and of all poses.
pub trait Progress {
    /// Called after every few thousand poses, and at the end.
    fn report(&mut self, done: usize, poses: usize);
}

/// Two slices of a sweep that should be of one length are not.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct LengthMismatch {
    /// The number of poses: the length of the longest slice.
    pub poses: usize,
    /// The length of the other slice.
    pub found: usize,
}

/// An entry point, as a sweep calls it; `K` tells the entry points of a mechanism apart.
pub trait Entry<K, T: Float, const IN: usize, const OUT: usize>: Copy {
    /// Puts the numbers of the result without a branch, for lanes as for any number, and says where they
    /// may be used; where nowhere, there need not be any.
    fn solve<U: Scalar>(&self, given: [U; IN], put: impl FnOnce(&[U])) -> U::Mask;

    /// The same for a single pose, with the slow path's decision.
    ///
    /// # Errors
    /// Those of the entry point, which puts nothing then.
    fn solve_one(&self, given: [T; IN], put: impl FnOnce(&[T])) -> Result<(), SolveError>;

    /// The same behind other poses of a sweep, which have left seeds to searches.
    ///
    /// # Errors
    /// Those of the entry point, which puts nothing then.
    #[inline]
    fn follow_one(
        &self,
        given: [T; IN],
        _seeds: &mut [Seed<T>],
        put: impl FnOnce(&[T]),
    ) -> Result<(), SolveError> {
        self.solve_one(given, put)
    }
}

/// Empty slices, one a field, for the unwanted outputs of a sweep.
///
/// They fill the fields behind the wanted ones:
///
/// ```
/// # use linkage_core::{Point, mechanism, unwanted};
/// # mechanism! {
/// #     struct Crank { input q: angle; ground A(0, 0); crank AB(A) -> B { length: 1m, angle: q } }
/// # }
/// let q = [0.0, 0.5, 1.0];
/// let (mut x, mut y) = ([0.0; 3], [0.0; 3]);
/// let b = Point { x: &mut x[..], y: &mut y };
/// Crank::new().sweep_position(&q, CrankPosition { B: b, ..unwanted() }, &mut [], ())?;
/// assert_eq!(x[0], 1.0);
/// # Ok::<(), linkage_core::LengthMismatch>(())
/// ```
#[must_use]
pub fn unwanted<'a, R, T, const N: usize>() -> R
where
    R: Record<Number = &'a mut [T], Array = [&'a mut [T]; N]>,
    T: 'a,
{
    R::from_array(core::array::from_fn(|_| Default::default()))
}

/// The unknowns of a mechanism that are searched by seeds; any further one is searched from both ends at
/// every pose.
const SEEDS: usize = 8;

/// Poses between two reports of progress: a fraction of a millisecond's work.
const REPORT_EVERY: usize = 4096;

/// Solves every pose. Outputs and statuses that are empty slices are not wanted; where a pose has
/// no solution, its outputs are not numbers.
pub fn sweep<K, T: Float, E: Entry<K, T, IN, OUT>, const IN: usize, const OUT: usize>(
    entry: &E,
    inputs: [Series<'_, T>; IN],
    outputs: [&mut [T]; OUT],
    statuses: &mut [Status],
    mut progress: impl Progress,
) -> Result<(), LengthMismatch> {
    let poses = common_length(&inputs, &outputs, statuses)?;
    let seeds = [Seed::unknown(); SEEDS];
    let mut batch = Batch { entry, inputs, outputs, statuses, is_agreed: None, seeds };
    let mut done = 0;
    while done < poses {
        let end = poses.min(done.saturating_add(REPORT_EVERY));
        instructions::run(&mut batch, done, end);
        done = end;
        progress.report(done, poses);
    }
    Ok(())
}

/// The length of the longest slice, which every other must have: an input one number for each
/// pose, an output or the statuses either all poses or none.
fn common_length<T, const IN: usize, const OUT: usize>(
    inputs: &[Series<'_, T>; IN],
    outputs: &[&mut [T]; OUT],
    statuses: &[Status],
) -> Result<usize, LengthMismatch> {
    let given = inputs.iter().filter_map(|series| match series {
        Series::Each(values) => Some(values.len()),
        Series::Constant(_) => None,
    });
    let wanted = outputs.iter().map(|output| output.len()).chain([statuses.len()]);
    let wanted = wanted.filter(|&length| length > 0);
    let lengths = given.chain(wanted);
    let poses = lengths.clone().max().unwrap_or(0);
    match lengths.into_iter().find(|&found| found != poses) {
        Some(found) => Err(LengthMismatch { poses, found }),
        None => Ok(poses),
    }
}

impl<T: Copy> Series<'_, T> {
    /// The number at a pose; the last one beyond the end, so that the last block is filled.
    #[inline(always)]
    fn at(&self, pose: usize) -> Option<T> {
        match *self {
            Self::Constant(value) => Some(value),
            Self::Each(values) => values.get(pose).or(values.last()).copied(),
        }
    }
}

impl From<SolveError> for Status {
    fn from(error: SolveError) -> Self {
        match error {
            SolveError::OutOfReach { .. } => Self::OutOfReach,
            SolveError::Singular { .. } => Self::Singular,
            SolveError::Invalid { .. } => Self::Invalid,
            SolveError::NotFinite { .. } => Self::NotFinite,
            SolveError::OffCircle { .. } => Self::OffCircle,
            SolveError::NoSolution { .. } => Self::NoSolution,
            SolveError::SeveralDeadPoints { .. } => Self::SeveralDeadPoints,
            SolveError::Jams { .. } => Self::Jams,
            SolveError::NotCertified { .. } => Self::NotCertified,
        }
    }
}

impl Progress for () {
    #[inline]
    fn report(&mut self, _: usize, _: usize) {}
}

impl<F: FnMut(usize, usize)> Progress for F {
    #[inline]
    fn report(&mut self, done: usize, poses: usize) {
        self(done, poses);
    }
}

impl<T: Float> From<T> for Series<'_, T> {
    #[inline]
    fn from(value: T) -> Self {
        Self::Constant(value)
    }
}

impl<'a, T> From<&'a [T]> for Series<'a, T> {
    #[inline]
    fn from(values: &'a [T]) -> Self {
        Self::Each(values)
    }
}

impl<'a, T, const N: usize> From<&'a [T; N]> for Series<'a, T> {
    #[inline]
    fn from(values: &'a [T; N]) -> Self {
        Self::Each(values)
    }
}

#[cfg(any(feature = "std", feature = "nalgebra"))]
impl<'a, T> From<&'a std::vec::Vec<T>> for Series<'a, T> {
    #[inline]
    fn from(values: &'a std::vec::Vec<T>) -> Self {
        Self::Each(values)
    }
}

impl fmt::Display for LengthMismatch {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { poses, found } = self;
        write!(f, "a slice of {found} beside one of {poses}: give every pose a place in both")
    }
}

impl core::error::Error for LengthMismatch {}
