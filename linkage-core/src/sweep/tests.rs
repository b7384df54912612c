//! Sweeps of an entry point that is small enough to know by heart.

use std::vec;
use std::vec::Vec;

mod out_of_reach;

use super::kinds::OfPosition;
use super::{Entry, LengthMismatch, REPORT_EVERY, Series, Status, sweep};
use crate::{Float, Scalar, SolveError};

/// √(x·scale), and half of it.
#[derive(Clone, Copy)]
struct Root;

const REFUSED: SolveError = SolveError::Singular { group: "root" };

impl<T: Float> Entry<OfPosition, T, 2, 2> for Root {
    fn solve<U: Scalar>(&self, [x, scale]: [U; 2], put: impl FnOnce(&[U])) -> U::Mask {
        let root = (x * scale).sqrt();
        put(&[root, root * U::num(0.5)]);
        root.gt(U::num(0.0))
    }

    /// Unlike the lanes, it also knows the root of zero.
    fn solve_one(&self, [x, scale]: [T; 2], put: impl FnOnce(&[T])) -> Result<(), SolveError> {
        let root = (x * scale).sqrt();
        if !root.ge(T::lit(0.0, 0.0)) {
            return Err(REFUSED);
        }
        put(&[root, root * T::lit(0.5, 0.5)]);
        Ok(())
    }
}

/// −3, −2, …: the first three are refused, the fourth the lanes leave to the single call.
fn numbers<T: Float>(count: usize) -> Vec<T> {
    (0..count).map(|i| T::lit(i as f64 - 3.0, i as f32 - 3.0)).collect()
}

fn every_pose_is_the_single_call<T: Float>() {
    // Every remainder of a block, and more than one block.
    for count in 0..40 {
        let x = numbers::<T>(count);
        let (mut root, mut half) = (vec![T::lit(7.0, 7.0); count], vec![T::lit(7.0, 7.0); count]);
        let mut status: Vec<Status> = vec![Status::NotFinite; count];
        let inputs = [Series::from(&x), Series::Constant(T::lit(4.0, 4.0))];
        let outputs = [&mut root[..], &mut half[..]];
        sweep::<OfPosition, _, _, 2, 2>(&Root, inputs, outputs, &mut status, ()).unwrap();
        for i in 0..count {
            let mut values = [T::lit(f64::NAN, f32::NAN); 2];
            let single = Root.solve_one([x[i], T::lit(4.0, 4.0)], |found| {
                values.copy_from_slice(found);
            });
            let expected = single.map_or(Status::Singular, |()| Status::Solved);
            assert_eq!(status[i], expected, "pose {i} of {count}");
            match single {
                Ok(()) => assert_eq!([root[i], half[i]].map(T::value), values.map(T::value)),
                Err(_) => assert!(root[i].value().is_nan() && half[i].value().is_nan()),
            }
        }
    }
}

#[test]
fn every_pose_is_the_single_call_in_both_widths() {
    every_pose_is_the_single_call::<f64>();
    every_pose_is_the_single_call::<f32>();
}

#[test]
fn what_is_not_wanted_is_not_written() {
    let x = numbers::<f64>(9);
    let mut half = [7.0; 9];
    let inputs = [Series::Each(&x), 1.0.into()];
    sweep::<OfPosition, _, _, 2, 2>(&Root, inputs, [&mut [], &mut half], &mut [], ()).unwrap();
    assert!(half[2].is_nan());
    assert_eq!(half[7], 1.0);
}

#[test]
fn slices_of_different_lengths_are_refused_untouched() {
    let (x, scale) = (numbers::<f64>(9), [1.0; 8]);
    let mut half = [7.0; 9];
    let all = |inputs: [Series<'_, f64>; 2], half: &mut [f64], status: &mut [Status]| {
        sweep::<OfPosition, _, _, 2, 2>(&Root, inputs, [&mut [], half], status, ())
    };
    let mismatch = |found| Err(LengthMismatch { poses: 9, found });
    assert_eq!(all([(&x).into(), (&scale).into()], &mut half, &mut []), mismatch(8));
    assert_eq!(all([(&x).into(), 1.0.into()], &mut half[..7], &mut []), mismatch(7));
    assert_eq!(all([(&x).into(), 1.0.into()], &mut half, &mut [Status::Solved; 3]), mismatch(3));
    // An input is never without numbers.
    assert_eq!(all([(&x).into(), (&[]).into()], &mut half, &mut []), mismatch(0));
    assert_eq!(half, [7.0; 9]);
}

#[test]
fn constant_inputs_fill_what_is_wanted() {
    let mut root = [0.0; 5];
    let inputs = [9.0.into(), 4.0.into()];
    sweep::<OfPosition, _, _, 2, 2>(&Root, inputs, [&mut root, &mut []], &mut [], ()).unwrap();
    assert_eq!(root, [6.0; 5]);
}

#[test]
fn progress_rises_to_the_end() {
    let x = numbers::<f32>(2 * REPORT_EVERY + 5);
    let mut reports = Vec::new();
    let inputs = [(&x).into(), 1.0.into()];
    let report = |done, poses| reports.push((done, poses));
    sweep::<OfPosition, _, _, 2, 2>(&Root, inputs, [&mut [], &mut []], &mut [], report).unwrap();
    let poses = x.len();
    assert_eq!(reports, [(REPORT_EVERY, poses), (2 * REPORT_EVERY, poses), (poses, poses)]);
}
