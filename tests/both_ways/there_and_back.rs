//! There and back between two sets of inputs, at poses near the drawing and anywhere.

use std::f64::consts::{PI, TAU};
use std::fmt::Debug;

use linkage_core::{CarriesOver, Solver};
use linkage_core::{Mechanism, Record, Transfer, TransferError};
use linkage_tests::random::Random;

/// The poses of a pair by what became of them.
#[derive(Debug, Default)]
pub(crate) struct Tally {
    /// Carried over, and back to where they came from.
    pub(crate) back: usize,
    /// Told as those of another assembly.
    pub(crate) other: usize,
    /// Without a pose there or here.
    pub(crate) refused: usize,
    /// Carried over, but not back: the way back has no pose where the way there has one.
    pub(crate) one_way: usize,
    /// Carried over and back, to elsewhere.
    pub(crate) torn: usize,
    /// Solved in both ways by `position` alone, and back elsewhere.
    pub(crate) elsewhere_by_position: usize,
    /// Errors over ε × (|∂own/∂other| |other| + 1), in rising order.
    pub(crate) errors: Vec<f64>,
    /// The worst over ε × (|∂own/∂other| (|other| + |∂other/∂own| |own|) + 1): both evaluations are off as if their inputs
    /// were by some roundings, and what the first is off by goes through the second. Next to a limit of the first that is
    /// more than the second's own.
    pub(crate) worst_of_both: f64,
}

/// A number that is an angle, by its value in the drawing; lengths have a size.
pub(crate) enum Kind {
    Angle,
    Length,
}

fn off(kind: &Kind, a: f64, b: f64) -> f64 {
    let off = a - b;
    match kind {
        Kind::Angle => off - TAU * (off / TAU).round(),
        Kind::Length => off,
    }
}

/// The coordinates of another solver in a pose of this one, as `position` alone gives them.
fn by_position<A, B, const N: usize>(a: &A, q: [f64; N]) -> Option<[f64; N]>
where
    A: Mechanism<Scalar = f64, Inputs = [f64; N]>,
    B: Mechanism<Scalar = f64, Inputs = [f64; N]>,
{
    let rows = a.position(q).ok()?;
    let mut found = [0.0; N];
    for (value, name) in found.iter_mut().zip(B::INPUTS) {
        let place = |list: &[&str]| list.iter().position(|other| other == name);
        *value = match place(A::INPUTS) {
            Some(input) => q[input],
            None => rows.as_ref()[place(A::OUTPUTS).expect("a coordinate is an output")],
        };
    }
    Some(found)
}

/// Poses of `a` there and back. Half of them are near the drawing, half anywhere.
pub(crate) fn there_and_back<A, B, const N: usize>(
    (a, b): (A, B),
    (drawn, kinds, size): ([f64; N], [Kind; N], f64),
    poses: usize,
) -> Tally
where
    A: CarriesOver<B, N> + Solver<Scalar = f64> + Mechanism<Scalar = f64, Inputs = [f64; N]>,
    B: CarriesOver<A, N> + Solver<Scalar = f64> + Mechanism<Scalar = f64, Inputs = [f64; N]>,
    <A as Solver>::Input: Record<Number = f64, Array = [f64; N]> + Debug,
    <B as Solver>::Input: Record<Number = f64, Array = [f64; N]> + Debug,
    <A as Solver>::Position: Record<Number = f64>,
    <B as Solver>::Position: Record<Number = f64>,
{
    let mut random = Random::new(57);
    let mut tally = Tally::default();
    for pose in 0..poses {
        let share = if pose % 2 == 0 { 0.1 } else { 1.0 };
        let q: [f64; N] = std::array::from_fn(|i| {
            let reach = if matches!(kinds[i], Kind::Angle) { PI } else { size };
            drawn[i] + share * reach * (2.0 * random.unit() - 1.0)
        });
        let elsewhere = |back: [f64; N]| (0..N).any(|i| off(&kinds[i], back[i], q[i]).abs() > 1e-6);
        let blind =
            by_position::<A, B, N>(&a, q).and_then(|there| by_position::<B, A, N>(&b, there));
        tally.elsewhere_by_position += usize::from(blind.is_some_and(elsewhere));
        let there = match Transfer::<A, B, N>::new(a, <A as Solver>::Input::from_array(q)) {
            Ok(there) => there,
            Err(TransferError::OtherAssembly { .. }) => {
                tally.other += 1;
                continue;
            }
            Err(_) => {
                tally.refused += 1;
                continue;
            }
        };
        let back = match Transfer::<B, A, N>::new(b, there.coordinates) {
            Ok(back) => back,
            // Another assembly of `a` than the one that it just had: the pose is not its own.
            Err(TransferError::OtherAssembly { .. }) => {
                tally.torn += 1;
                continue;
            }
            Err(_) => {
                tally.one_way += 1;
                continue;
            }
        };
        let found = back.coordinates.into_array();
        if elsewhere(found) {
            tally.torn += 1;
            continue;
        }
        tally.back += 1;
        let (Ok(ratios), Ok(given)) = (back.ratios(), there.ratios()) else { continue };
        let way = Way { kinds: &kinds, size, given, back: ratios };
        let [error, worst] = way.errors(q, there.coordinates.into_array(), found);
        tally.errors.push(error);
        tally.worst_of_both = tally.worst_of_both.max(worst);
    }
    tally.errors.sort_by(f64::total_cmp);
    tally
}

/// The ratios of both ways, and what the numbers of the first are.
struct Way<'a, const N: usize> {
    kinds: &'a [Kind; N],
    size: f64,
    given: [[f64; N]; N],
    back: [[f64; N]; N],
}

impl<const N: usize> Way<'_, N> {
    /// The worst error of a coordinate over ε × the condition of the way back, and over that of both ways.
    fn errors(&self, q: [f64; N], there: [f64; N], found: [f64; N]) -> [f64; 2] {
        let Self { kinds, size, given, back } = self;
        let (mut error, mut worst) = (0.0_f64, 0.0_f64);
        let sized =
            |k: usize| q[k].abs() + if matches!(kinds[k], Kind::Angle) { 1.0 } else { *size };
        let by_first = |j: usize| (0..N).map(|k| (given[j][k] * sized(k)).abs()).sum::<f64>();
        for i in 0..N {
            let own = |j: usize| (back[i][j] * there[j]).abs();
            let condition: f64 = (0..N).map(own).sum();
            let of_both: f64 = (0..N).map(|j| own(j) + back[i][j].abs() * by_first(j)).sum();
            let off = off(&kinds[i], found[i], q[i]).abs() / f64::EPSILON;
            error = error.max(off / (condition + 1.0));
            worst = worst.max(off / (of_both + 1.0));
        }
        [error, worst]
    }
}
