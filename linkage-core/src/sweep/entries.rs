//! Position, velocity and motion as sweeps call them: what a [`Solver`] has of each, given the numbers of
//! a pose one after the other, the inputs' values and then their rates.

use super::Entry;
use super::kinds::{OfMotion, OfPosition, OfVelocity};
use crate::roots::seed::Seed;
use crate::solver::{Solver, number};
use crate::{Float, Record, Scalar, SolveError};

/// The entry point of a solver's method, which is given so many orders of the inputs, these.
macro_rules! entry {
    ($of:ident: $method:ident by $count:literal, $($order:literal)*) => {
        impl<T, S, const IN: usize, const OUT: usize> Entry<$of, T, IN, OUT> for S
        where
            T: Float,
            S: Solver<Scalar = T>,
        {
            #[inline(always)]
            fn solve<U: Scalar>(&self, given: [U; IN], put: impl FnOnce(&[U])) -> U::Mask {
                Solver::solve::<{ $count - 1 }, U>(self, |at| number(&given, at), put)
            }

            fn solve_one(&self, given: [T; IN], put: impl FnOnce(&[T])) -> Result<(), SolveError> {
                put_found(Solver::$method(self, $(nth::<S, IN, $count>(&given, $order)),*), put)
            }

            #[inline]
            fn follow_one(
                &self,
                given: [T; IN],
                seeds: &mut [Seed<T>],
                put: impl FnOnce(&[T]),
            ) -> Result<(), SolveError> {
                let single = |put| Entry::<$of, T, IN, OUT>::solve_one(self, given, put);
                follow::<S, IN, { $count - 1 }, _>(self, &given, seeds, put, single)
            }
        }
    };
}

entry!(OfPosition: position by 1, 0);
entry!(OfVelocity: velocity by 2, 0 1);
entry!(OfMotion: motion by 3, 0 1 2);

/// Solves a pose by the seeds of its searches, or else as `single` does.
#[inline]
fn follow<S: Solver, const IN: usize, const ORDER: usize, P: FnOnce(&[S::Scalar])>(
    solver: &S,
    given: &[S::Scalar; IN],
    seeds: &mut [Seed<S::Scalar>],
    put: P,
    single: impl FnOnce(P) -> Result<(), SolveError>,
) -> Result<(), SolveError> {
    let mut put = Some(put);
    let once = |found: &[S::Scalar]| put.take().into_iter().for_each(|put| put(found));
    if S::SEARCHES && solver.follow::<ORDER>(seeds, |at| number(given, at), once) {
        return Ok(());
    }
    put.map_or(Ok(()), single)
}

/// Values, rates or accelerations of the inputs, of as many `ORDERS` as are given.
fn nth<S: Solver, const IN: usize, const ORDERS: usize>(
    given: &[S::Scalar; IN],
    order: usize,
) -> S::Input {
    S::input(|input| number(given, order * (IN / ORDERS) + input))
}

/// Puts the numbers of a fast path's record.
#[inline(always)]
pub fn put_solved<R: Record, M>((record, usable): (R, M), put: impl FnOnce(&[R::Number])) -> M {
    put(record.into_array().as_ref());
    usable
}

/// Puts the numbers of a record that may be used, and says whether it may be.
#[inline]
pub fn put_usable<R: Record>((record, usable): (R, bool), put: impl FnOnce(&[R::Number])) -> bool {
    if usable {
        put(record.into_array().as_ref());
    }
    usable
}

/// Puts the numbers of an entry point's record.
///
/// # Errors
/// That of the answer.
pub fn put_found<R: Record>(
    answer: Result<R, SolveError>,
    put: impl FnOnce(&[R::Number]),
) -> Result<(), SolveError> {
    answer.map(|record| put(record.into_array().as_ref()))
}
