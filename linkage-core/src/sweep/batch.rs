//! Poses in blocks: first all of a block in vectors, then those that vectors cannot tell of, one by one.

use super::block::{APART, BLOCK, Circles, Column, put};
use super::poses::Poses;
use super::verdict::{Asked, OutOfReach, Usable};
use super::{Entry, SEEDS, Series, Status};
use crate::roots::seed::Seed;
use crate::{Float, Fusion, Scalar};

/// The work of a sweep: one solver, its inputs, and the outputs to fill.
pub(super) struct Batch<'a, E, T, const IN: usize, const OUT: usize> {
    pub(super) entry: &'a E,
    pub(super) inputs: [Series<'a, T>; IN],
    pub(super) outputs: [&'a mut [T]; OUT],
    pub(super) statuses: &'a mut [Status],
    /// The answer of a single call for the first pose that a sweep finds out of reach: true if both agree. It
    /// holds for all poses, as they share the parameters that the call checks. None before that pose.
    pub(super) is_agreed: Option<bool>,
    /// The seeds that the previous poses leave for the searches of unknowns.
    pub(super) seeds: [Seed<T>; SEEDS],
}

// `inline(always)` on the way from an instruction set to the lanes: a function of its own would be
// compiled for the instruction set of the rest of the program.
impl<T: Float, E, const IN: usize, const OUT: usize> Batch<'_, E, T, IN, OUT> {
    /// The poses from `start` on and before `end`.
    #[inline(always)]
    pub(super) fn run<K, F: Fusion>(&mut self, start: usize, end: usize)
    where
        E: Entry<K, T, IN, OUT>,
    {
        if let Some(statuses) = self.statuses.get_mut(start..end) {
            statuses.fill(Status::Solved);
        }
        // A copy that no output can be part of, for all that the compiler knows: loads of parameters move out of the
        // loops over poses, which would not become loops over vectors with them.
        let entry = *self.entry;
        let mut inputs = [Column::splat(T::lit(0.0, 0.0)); IN];
        let mut results = [Column::splat(T::lit(0.0, 0.0)); OUT];
        let mut pose = start;
        while pose < end {
            let count = BLOCK.min(end - pose);
            if count == BLOCK {
                self.read(pose, &mut inputs);
            } else {
                self.read_last(pose, &mut inputs);
            }
            let circles = Circles::of_the_first::<F>(&inputs);
            let mut mask = Self::solve::<K, F>(&entry, &inputs, &circles, &mut results);
            if mask.contains(&false) {
                let mut refused = Self::out_of_reach::<K, F>(&entry, &inputs, &circles);
                if !self.is_agreed::<K>(pose, &refused) {
                    refused = [false; BLOCK];
                }
                self.refuse(pose, count, &refused, &mut results);
                mask.iter_mut().zip(&refused).for_each(|(done, &refused)| *done |= refused);
            }
            if count == BLOCK {
                self.write(pose, &results);
            } else {
                self.write_last(pose, &results);
            }
            if mask.contains(&false) {
                self.reconsider(pose, count, &mask);
            }
            pose += count;
        }
    }

    /// Loops over a few numbers each, which the compiler turns into loops over vectors: the fast path has no
    /// branch, the columns are no one else's, and lanes carry in their type whether they fuse. Nothing is
    /// indexed, so that no build can panic.
    #[inline(always)]
    fn solve<K, F: Fusion>(
        entry: &E,
        inputs: &[Column<T>; IN],
        circles: &Circles<T>,
        results: &mut [Column<T>; OUT],
    ) -> [bool; BLOCK]
    where
        E: Entry<K, T, IN, OUT>,
    {
        let mut mask = [true; BLOCK];
        for pose in 0..APART {
            let numbers = numbers::<T, F, Usable, IN>(inputs, circles, pose);
            let usable = entry.solve(numbers, |values| put(values, results, pose));
            for (nth, usable) in usable.to_array().into_iter().enumerate() {
                mask.get_mut(pose + nth * APART).into_iter().for_each(|ok| *ok = usable);
            }
        }
        mask
    }

    /// The poses that are out of reach for certain; of any other the slow path says what it is. Numbers
    /// that only results need are not computed.
    #[inline(always)]
    fn out_of_reach<K, F: Fusion>(
        entry: &E,
        inputs: &[Column<T>; IN],
        circles: &Circles<T>,
    ) -> [bool; BLOCK]
    where
        E: Entry<K, T, IN, OUT>,
    {
        let mut refused = [false; BLOCK];
        for pose in 0..APART {
            let numbers = numbers::<T, F, OutOfReach, IN>(inputs, circles, pose);
            let verdict = entry.solve(numbers, |_| ());
            for (nth, is_out) in verdict.out_of_reach().into_iter().enumerate() {
                refused.get_mut(pose + nth * APART).into_iter().for_each(|to| *to = is_out);
            }
        }
        // A pose with an input that is not finite is refused for that, not as out of reach.
        for column in inputs {
            for (refused, number) in refused.iter_mut().zip(&column.0) {
                *refused &= Scalar::is_finite(*number);
            }
        }
        refused
    }

    /// True if a single call agrees. Only the first refused pose of a sweep is solved again by one.
    #[inline(always)]
    fn is_agreed<K>(&mut self, start: usize, refused: &[bool; BLOCK]) -> bool
    where
        E: Entry<K, T, IN, OUT>,
    {
        match (self.is_agreed, refused.iter().position(|&refused| refused)) {
            (Some(is_agreed), _) => is_agreed,
            (None, None) => false,
            (None, Some(first)) => {
                let status = self.solved_singly(start + first, &mut [T::lit(0.0, 0.0); OUT]);
                self.is_agreed = Some(status == Status::OutOfReach);
                status == Status::OutOfReach
            }
        }
    }

    /// Puts what comes of poses out of reach.
    #[inline(always)]
    fn refuse(
        &mut self,
        start: usize,
        count: usize,
        refused: &[bool; BLOCK],
        results: &mut [Column<T>; OUT],
    ) {
        let none = T::lit(f64::NAN, f32::NAN);
        for column in results {
            for (number, &refused) in column.0.iter_mut().zip(refused) {
                *number = T::select(refused, none, *number);
            }
        }
        let statuses = self.statuses.get_mut(start..start + count).unwrap_or_default();
        for (status, &refused) in statuses.iter_mut().zip(refused) {
            *status = if refused { Status::OutOfReach } else { *status };
        }
    }

    #[inline(always)]
    fn read(&self, pose: usize, inputs: &mut [Column<T>; IN]) {
        for (column, series) in inputs.iter_mut().zip(&self.inputs) {
            match *series {
                Series::Constant(value) => *column = Column::splat(value),
                Series::Each(values) => {
                    let chunk = values.get(pose..).and_then(|rest| rest.first_chunk());
                    chunk.into_iter().for_each(|chunk| column.0 = *chunk);
                }
            }
        }
    }

    /// The last block, which the last pose fills up.
    #[cold]
    #[inline(never)]
    fn read_last(&self, pose: usize, inputs: &mut [Column<T>; IN]) {
        for (column, series) in inputs.iter_mut().zip(&self.inputs) {
            for (number, pose) in column.0.iter_mut().zip(pose..) {
                series.at(pose).into_iter().for_each(|value| *number = value);
            }
        }
    }

    #[inline(always)]
    fn write(&mut self, pose: usize, results: &[Column<T>; OUT]) {
        for (output, column) in self.outputs.iter_mut().zip(results) {
            if let Some(chunk) = output.get_mut(pose..).and_then(|rest| rest.first_chunk_mut()) {
                *chunk = column.0;
            }
        }
    }

    #[cold]
    #[inline(never)]
    fn write_last(&mut self, pose: usize, results: &[Column<T>; OUT]) {
        for (output, column) in self.outputs.iter_mut().zip(results) {
            let rest = output.get_mut(pose..).unwrap_or_default();
            rest.iter_mut().zip(column.0).for_each(|(to, value)| *to = value);
        }
    }

    /// Solves again, one by one, the poses whose mask says no.
    #[cold]
    #[inline(never)]
    fn reconsider<K>(&mut self, start: usize, count: usize, mask: &[bool])
    where
        E: Entry<K, T, IN, OUT>,
    {
        let none = T::lit(f64::NAN, f32::NAN);
        let refused = mask.iter().take(count).enumerate().filter(|&(_, &usable)| !usable);
        for pose in refused.map(|(lane, _)| start + lane) {
            let mut numbers = [none; OUT];
            let status = self.solved_singly(pose, &mut numbers);
            for (output, value) in self.outputs.iter_mut().zip(numbers) {
                output.get_mut(pose).into_iter().for_each(|to| *to = value);
            }
            self.statuses.get_mut(pose).into_iter().for_each(|to| *to = status);
        }
    }

    /// The status of a pose by a single call, which also writes the numbers if there are any.
    #[cold]
    #[inline(never)]
    fn solved_singly<K>(&mut self, pose: usize, numbers: &mut [T; OUT]) -> Status
    where
        E: Entry<K, T, IN, OUT>,
    {
        let none = T::lit(f64::NAN, f32::NAN);
        let mut inputs = [none; IN];
        for (input, series) in inputs.iter_mut().zip(&self.inputs) {
            *input = series.at(pose).unwrap_or(none);
        }
        let result = self.entry.follow_one(inputs, &mut self.seeds, |found| {
            numbers.iter_mut().zip(found).for_each(|(to, number)| *to = *number);
        });
        result.map_or_else(Status::from, |()| Status::Solved)
    }
}

/// The inputs at the poses that are computed together, of which this is the first; the first input with its
/// sine and cosine, see [`Poses`].
#[inline(always)]
fn numbers<T: Float, F: Fusion, A: Asked, const IN: usize>(
    inputs: &[Column<T>; IN],
    circles: &Circles<T>,
    pose: usize,
) -> [Poses<T, F, A>; IN] {
    let mut numbers = [Poses::<T, F, A>::lit(0.0, 0.0); IN];
    for (number, column) in numbers.iter_mut().zip(inputs) {
        *number = Poses::new(column.at(pose));
    }
    if let (Some(number), Some(angles)) = (numbers.first_mut(), inputs.first()) {
        let columns = [angles, &circles.sines, &circles.cosines];
        *number = Poses::on_circle(columns.map(|column| column.at(pose)));
    }
    numbers
}
