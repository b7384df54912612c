//! Which poses vectors may call out of reach.

use std::cell::RefCell;
use std::vec;
use std::vec::Vec;

use super::super::kinds::OfPosition;
use super::super::{Entry, Series, Status, sweep};
use crate::checks::{AllMet, Checks};
use crate::diagnosis::{Nonzero, Positive, ReachCircles};
use crate::{Float, Scalar, SolveError};

const GROUP: &str = "bars";

/// A condition of the first input and one of the third, a hypotenuse, the reaches of two groups, of the second
/// and of twice the fourth, and a limit beside the formulas; which poses were solved one by one.
struct Conditions {
    singly: RefCell<Vec<[f64; 5]>>,
    /// The answer of single calls.
    answer: SolveError,
}

const BEYOND: SolveError = SolveError::OutOfReach { group: GROUP, by: 1.0 };

impl<T: Float> Entry<OfPosition, T, 5, 1> for &Conditions {
    fn solve<U: Scalar>(&self, given: [U; 5], put: impl FnOnce(&[U])) -> U::Mask {
        let [first, reach, second, other, beside] = given;
        let (one, mut all) = (U::num(1.0), AllMet::new());
        all.above(first, U::num(0.0));
        let length = all.guard(first, Positive(GROUP, "length"));
        all.away(second, U::num(0.0));
        let divisor = all.guard(second, Nonzero(GROUP));
        let hypotenuse = all.hypot(first, U::num(0.0), U::num(0.25));
        all.above(reach, U::num(0.0));
        all.above_rounding(reach, one);
        let root = all.guard(reach, ReachCircles([one; 6], GROUP)).sqrt();
        let twice = other + other;
        all.above_rounding(twice, one);
        let height = all.guard(twice, ReachCircles([one; 6], GROUP)).sqrt();
        let sum = length + hypotenuse + root + one / divisor + height;
        put(&[sum]);
        all.all() & one.ge(beside) & sum.is_finite()
    }

    fn solve_one(&self, given: [T; 5], _: impl FnOnce(&[T])) -> Result<(), SolveError> {
        self.singly.borrow_mut().push(given.map(T::value));
        Err(self.answer)
    }
}

const GOOD: [f64; 5] = [1.0, 1.0, 1.0, 1.0, 0.0];
const OUT: [f64; 5] = [1.0, -1.0, 1.0, 1.0, 0.0];

/// Poses in two blocks, of which the others are good: what each was called, and which were solved singly.
fn swept<T: Float>(
    poses: &[(usize, [f64; 5])],
    answer: SolveError,
) -> (Vec<Status>, Vec<[f64; 5]>) {
    let entry = Conditions { singly: RefCell::default(), answer };
    let count = 21;
    let columns: [Vec<T>; 5] = core::array::from_fn(|input| {
        let pose = |at| poses.iter().find(|&&(place, _)| place == at).map_or(GOOD, |pose| pose.1);
        (0..count).map(|at| T::num(pose(at)[input])).collect()
    });
    let (mut sum, mut status) = (vec![T::num(7.0); count], vec![Status::NotFinite; count]);
    let inputs = columns.each_ref().map(|column| Series::Each(&column[..]));
    sweep::<OfPosition, _, _, 5, 1>(&&entry, inputs, [&mut sum], &mut status, ()).unwrap();
    for (at, (status, sum)) in status.iter().zip(&sum).enumerate() {
        let is_solved = *status == Status::Solved;
        assert!(is_solved || poses.iter().any(|&(place, _)| place == at), "{status:?} at {at}");
        assert_eq!(sum.value().is_nan(), !is_solved);
    }
    (status, entry.singly.into_inner())
}

/// The status of a pose behind one that is out of reach, or `Singular` where it was solved by itself.
fn status<T: Float>(pose: [f64; 5]) -> Status {
    let (status, singly) = swept::<T>(&[(3, OUT), (18, pose)], BEYOND);
    assert_eq!((status[3], singly[0]), (Status::OutOfReach, OUT));
    if singly.len() > 1 { Status::Singular } else { status[18] }
}

fn in_both_widths(pose: [f64; 5]) -> Status {
    let found = status::<f64>(pose);
    assert_eq!(status::<f32>(pose), found, "{pose:?}");
    found
}

/// A parameter may be none, which vectors do not look at.
#[test]
fn vectors_are_believed_where_the_first_single_call_agrees() {
    let poses = [(2, OUT), (5, OUT), (17, OUT)];
    let (status, singly) = swept::<f64>(&poses, BEYOND);
    assert_eq!((status[17], singly.len()), (Status::OutOfReach, 1));
    let (status, singly) = swept::<f64>(&poses, SolveError::NotFinite { name: "length" });
    // Once to ask, and each of them.
    assert_eq!(singly.len(), 4);
    assert_eq!([2, 5, 17].map(|at: usize| status[at]), [Status::NotFinite; 3]);
}

#[test]
fn what_is_first_and_clear_is_told_by_vectors() {
    assert_eq!(in_both_widths([1.0, 1.0, 1.0, 1.0, 0.0]), Status::Solved);
    assert_eq!(in_both_widths([1.0, -1.0, 1.0, 1.0, 0.0]), Status::OutOfReach);
    assert_eq!(in_both_widths([1.0, 1.0, 1.0, -1.0, 0.0]), Status::OutOfReach);
    // Conditions behind the first failure do not matter.
    assert_eq!(in_both_widths([1.0, -1.0, 1.0, -1.0, 0.0]), Status::OutOfReach);
}

#[test]
fn what_is_not_first_or_not_clear_is_solved_by_itself() {
    // A condition before it, and before the second group.
    assert_eq!(in_both_widths([-1.0, -1.0, 1.0, 1.0, 0.0]), Status::Singular);
    assert_eq!(in_both_widths([1.0, 1.0, 0.0, -1.0, 0.0]), Status::Singular);
    // A hypotenuse that has to be made with more care.
    assert_eq!(in_both_widths([0.4, -1.0, 1.0, 1.0, 0.0]), Status::Singular);
    // A group that may be at its limit before one that is beyond it.
    assert_eq!(in_both_widths([1.0, 0.0, 1.0, -1.0, 0.0]), Status::Singular);
    // Next to the limit: 16 √ε are 2⁻²² (f32: 2⁻⁷).
    assert_eq!(status::<f64>([1.0, -0.9 * 2_f64.powi(-22), 1.0, 1.0, 0.0]), Status::Singular);
    assert_eq!(status::<f64>([1.0, -1.1 * 2_f64.powi(-22), 1.0, 1.0, 0.0]), Status::OutOfReach);
    assert_eq!(status::<f32>([1.0, -0.9 * 2_f64.powi(-7), 1.0, 1.0, 0.0]), Status::Singular);
    assert_eq!(status::<f32>([1.0, -1.1 * 2_f64.powi(-7), 1.0, 1.0, 0.0]), Status::OutOfReach);
    // A value that overflows, of inputs and operands that do not.
    assert_eq!(status::<f64>([1.0, 1.0, 1.0, -1e308, 0.0]), Status::Singular);
    assert_eq!(status::<f64>([1.0, 1.0, 1.0, -1e305, 0.0]), Status::OutOfReach);
    assert_eq!(status::<f32>([1.0, 1.0, 1.0, -3e38, 0.0]), Status::Singular);
    assert_eq!(status::<f32>([1.0, 1.0, 1.0, -3e35, 0.0]), Status::OutOfReach);
    // A limit beside the formulas, and numbers that are none.
    assert_eq!(in_both_widths([1.0, -1.0, 1.0, 1.0, 2.0]), Status::Singular);
    for place in 0..5 {
        for nothing in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            let mut pose = [1.0, -1.0, 1.0, 1.0, 0.0];
            pose[place] = nothing;
            assert_eq!(in_both_widths(pose), Status::Singular, "{pose:?}");
        }
    }
}
