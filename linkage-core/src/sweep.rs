//! Many poses in one call.
//!
//! A sweep reads its inputs from slices and writes every component of every output to a slice of
//! its own, which is how plots, tables and other programs want them and what vector instructions
//! need. It computes [`Lanes`] of poses with the same generated code as a single call, falls back
//! to the single call where a lane's mask says no, and allocates nothing.
//!
//! What is generated for a mechanism is an [`Entry`]; loops, tails, statuses and the choice of an
//! instruction set are written once, here.

mod instructions;
#[cfg(test)]
mod tests;

use core::fmt;

use crate::{Float, Fusion, LaneMask, Lanes, Mask, SolveError};

/// What came of one pose: the same as the single call's result, without the values.
pub type Status = Result<(), SolveError>;

/// One input of a sweep: a number for each pose, or one number for all of them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Series<'a, T> {
    /// A number for each pose.
    Each(&'a [T]),
    /// The same number at every pose.
    Constant(T),
}

/// Who is told how far a sweep has come: nobody, `()`, or a function of the number of poses done
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

/// A generated entry point, as a sweep calls it; `K` tells the entry points of a mechanism apart.
pub trait Entry<K, T: Float, const IN: usize, const OUT: usize> {
    /// The components of the results for each lane, and where they may be used.
    fn solve_lanes<const W: usize, F: Fusion>(
        &self,
        inputs: [Lanes<T, W, F>; IN],
    ) -> ([Lanes<T, W, F>; OUT], LaneMask<W>);

    /// The same for a single pose, with the careful path's decision.
    fn solve_one(&self, inputs: [T; IN]) -> Result<[T; OUT], SolveError>;
}

/// The entry point `position`.
#[derive(Debug)]
pub enum OfPosition {}

/// The entry point `velocity`.
#[derive(Debug)]
pub enum OfVelocity {}

/// The entry point `motion`.
#[derive(Debug)]
pub enum OfMotion {}

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
    let mut batch = Batch { entry, inputs, outputs, statuses };
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

/// What a sweep works on.
struct Batch<'a, E, T, const IN: usize, const OUT: usize> {
    entry: &'a E,
    inputs: [Series<'a, T>; IN],
    outputs: [&'a mut [T]; OUT],
    statuses: &'a mut [Status],
}

impl<T: Copy> Series<'_, T> {
    /// The number at a pose; the last one beyond the end, so that the last lanes are filled.
    #[inline(always)]
    fn at(&self, pose: usize) -> Option<T> {
        match *self {
            Self::Constant(value) => Some(value),
            Self::Each(values) => values.get(pose).or(values.last()).copied(),
        }
    }

    /// The numbers at `W` poses from this one on.
    #[inline(always)]
    fn load<const W: usize>(&self, pose: usize) -> Option<[T; W]> {
        match *self {
            Self::Constant(value) => Some([value; W]),
            Self::Each(values) => match values.get(pose..).and_then(|rest| rest.first_chunk()) {
                Some(&lanes) => Some(lanes),
                None => {
                    let mut lanes = [*values.last()?; W];
                    let rest = values.get(pose..).unwrap_or(&[]);
                    lanes.iter_mut().zip(rest).for_each(|(lane, &value)| *lane = value);
                    Some(lanes)
                }
            },
        }
    }
}

impl<T: Float, E, const IN: usize, const OUT: usize> Batch<'_, E, T, IN, OUT> {
    /// The poses from `start` on and before `end`, `W` at a time.
    // `always`, with all it calls on the way to the lanes: a function of its own would be compiled
    // for the instruction set of the rest of the program.
    #[inline(always)]
    fn run<K, const W: usize, F: Fusion>(&mut self, start: usize, end: usize)
    where
        E: Entry<K, T, IN, OUT>,
    {
        for pose in (start..end).step_by(W) {
            let mut inputs = [Lanes::<T, W, F>::splat(T::lit(0.0, 0.0)); IN];
            for (lanes, series) in inputs.iter_mut().zip(&self.inputs) {
                let Some(values) = series.load(pose) else { return };
                *lanes = Lanes::new(values);
            }
            let (results, mask) = self.entry.solve_lanes(inputs);
            let count = W.min(end - pose);
            for (output, lanes) in self.outputs.iter_mut().zip(results) {
                store(output, pose, &lanes.to_array(), count);
            }
            store(self.statuses, pose, &[Ok(()); W], count);
            if !mask.all() {
                self.reconsider(pose, count, &mask.to_array());
            }
        }
    }

    /// Solves again, one by one, the poses whose lanes say no.
    #[cold]
    #[inline(never)]
    fn reconsider<K>(&mut self, start: usize, count: usize, mask: &[bool])
    where
        E: Entry<K, T, IN, OUT>,
    {
        let none = T::lit(f64::NAN, f32::NAN);
        let refused = mask.iter().take(count).enumerate().filter(|&(_, &usable)| !usable);
        for pose in refused.map(|(lane, _)| start + lane) {
            let mut inputs = [none; IN];
            for (input, series) in inputs.iter_mut().zip(&self.inputs) {
                *input = series.at(pose).unwrap_or(none);
            }
            let result = self.entry.solve_one(inputs);
            for (output, value) in self.outputs.iter_mut().zip(result.unwrap_or([none; OUT])) {
                store(output, pose, &[value], 1);
            }
            store(self.statuses, pose, &[result.map(|_| ())], 1);
        }
    }
}

/// Writes the first `count` values from `pose` on; nothing to an empty slice.
#[inline(always)]
fn store<V: Copy, const W: usize>(slice: &mut [V], pose: usize, values: &[V; W], count: usize) {
    let Some(rest) = slice.get_mut(pose..) else { return };
    match rest.first_chunk_mut() {
        Some(chunk) if count == W => *chunk = *values,
        _ => rest.iter_mut().zip(values).take(count).for_each(|(to, &value)| *to = value),
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

#[cfg(any(feature = "std", feature = "ad"))]
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
