//! Errors of an answer with constant and with tunable dimensions, and the error that the data allow.

use core::mem::{Discriminant, discriminant};

use linkage_core::SolveError;
use linkage_tests::conditioning::{State, conditions};
use linkage_tests::double_double::DoubleDouble;
use linkage_tests::measured::Width;

use crate::poses::Pose;
use crate::twins::{Answer, Twin, WAYS, answers};

/// The refusals of position and motion, by way: none where it is solved.
type Refusals = [[Option<SolveError>; WAYS.len()]; 2];

/// The answers of the ways at a pose.
pub(crate) struct Sample {
    pub(crate) refusals: Refusals,
    /// Two ways answer otherwise, and the first answers the same within two last places of the inputs: the
    /// data tell which of them is right.
    pub(crate) is_decided: bool,
    /// The largest error of each order, by way, where the data determine the answer.
    pub(crate) errors: [Option<[f64; 3]>; WAYS.len()],
}

/// By how much the data may be multiplied: at turn 0 they stay, then all of them move by a unit in the
/// last place, each its own way.
fn moved(number: usize, turn: usize, half_unit: f64) -> f64 {
    let bits = (number + 1).wrapping_mul(0x9e37_79b9).wrapping_mul(2 * turn + 1) >> 7;
    1.0 + 2.0 * half_unit * if turn == 0 { 0.0 } else { [-1.0, 1.0][bits % 2] }
}

pub(crate) fn measure(twin: &Twin, pose: &Pose, width: Width) -> Sample {
    let (refusals, motions) = asked(twin, pose, width);
    let kinds = kinds(&refusals);
    let differs = kinds.iter().any(|kinds| kinds.iter().any(|kind| *kind != kinds[0]));
    let state = State {
        is_flipped: false,
        params: twin.params.to_vec(),
        inputs: pose.q.clone(),
        rates: pose.rate.clone(),
        seconds: pose.second.clone(),
    };
    let errors = errors(twin, &state, width, motions).unwrap_or_default();
    Sample { refusals, is_decided: differs && is_decided(twin, pose, width), errors }
}

type Motions = [Answer<f64>; WAYS.len()];

fn asked(twin: &Twin, pose: &Pose, width: Width) -> (Refusals, Motions) {
    let lists = [&pose.q[..], &pose.rate, &pose.second];
    let (motions, positions) = match width {
        Width::Double => answers(&twin.double, lists),
        Width::Single => answers(&twin.single, lists),
    };
    let of_motion = motions.each_ref().map(|motion| motion.as_ref().err().cloned());
    ([positions.map(Result::err), of_motion], motions)
}

/// Which errors they are, whatever is in them.
fn kinds(refusals: &Refusals) -> [[Option<Discriminant<SolveError>>; WAYS.len()]; 2] {
    refusals.each_ref().map(|ways| ways.each_ref().map(|way| way.as_ref().map(discriminant)))
}

/// True if the first way answers the same kind at all corners two last places of 1 or more away.
fn is_decided(twin: &Twin, pose: &Pose, width: Width) -> bool {
    let first = |pose: &Pose| kinds(&asked(twin, pose, width).0).map(|ways| ways[0]);
    let here = first(pose);
    (0..1 << pose.q.len()).all(|corner| {
        let q = pose.q.iter().enumerate().map(|(input, x)| {
            let side = if corner >> input & 1 == 0 { 1.0 } else { -1.0 };
            width.round(x + 4.0 * side * width.half_unit() * x.abs().max(1.0))
        });
        first(&Pose { q: q.collect(), ..pose.clone() }) == here
    })
}

/// None where the data determine no answer.
fn errors(
    twin: &Twin,
    state: &State<f64>,
    width: Width,
    motions: Motions,
) -> Option<[Option<[f64; 3]>; WAYS.len()]> {
    if motions.iter().all(Result::is_err) {
        return None;
    }
    let truth = (twin.truth)(&state.map(DoubleDouble::new));
    if !truth.iter().all(|row| (row.high + row.low).is_finite()) {
        return None;
    }
    let allowed = allowed(twin, state, 0, width)?;
    let found = motions.map(|motion| motion.ok());
    let of = |allowed: &[f64]| {
        found
            .each_ref()
            .map(|found| found.as_ref().map(|found| worst(twin, found, &truth, allowed)))
    };
    let at_once = of(&allowed);
    if at_once.iter().flatten().flatten().all(|ratio| *ratio <= 2.0) {
        return Some(at_once);
    }
    let mut largest = allowed.clone();
    let total = |allowed: &[f64]| allowed.iter().sum::<f64>();
    for turn in 1..5 {
        let moved = self::allowed(twin, state, turn, width)?;
        if !(0.5..2.0).contains(&(total(&moved) / total(&allowed))) {
            return None;
        }
        largest.iter_mut().zip(moved).for_each(|(largest, moved)| *largest = largest.max(moved));
    }
    Some(of(&largest))
}

/// The changes due to half a unit in the last place of everything, at data moved by units.
fn allowed(twin: &Twin, state: &State<f64>, turn: usize, width: Width) -> Option<Vec<f64>> {
    let half_unit = width.half_unit();
    let mut number = 0;
    let state = state.map(|x| {
        number += 1;
        x * moved(number, turn, half_unit)
    });
    let conditions = conditions(&state, twin.dual).ok()?;
    let is_finite = conditions.iter().all(|condition| condition.is_finite());
    is_finite.then(|| conditions.into_iter().map(|condition| condition * half_unit).collect())
}

/// The largest ratio of error to allowed error, by order. A number that is not finite has left the range
/// and counts as no error.
fn worst(twin: &Twin, found: &[f64], truth: &[DoubleDouble], allowed: &[f64]) -> [f64; 3] {
    let rows = twin.labels.len();
    core::array::from_fn(|order| {
        let error = |row: usize| {
            let (at, turn) = (order * rows + row, core::f64::consts::TAU);
            let away = found[at] - truth[at].high;
            let is_angle = order == 0 && twin.labels[row].ends_with("angle");
            let turns = if is_angle { (away / turn).round() } else { 0.0 };
            ((away - turns * turn - truth[at].low).abs(), allowed[at])
        };
        let ratios = (0..rows).map(|row| {
            let label = twin.labels[row];
            let (error, allowed) = match label.strip_suffix(".x").or(label.strip_suffix(".y")) {
                // A point is one quantity: a component may be small by chance.
                Some(_) => {
                    let first = if label.ends_with(".x") { row } else { row - 1 };
                    let ((x, x_allowed), (y, y_allowed)) = (error(first), error(first + 1));
                    (x.hypot(y), x_allowed.hypot(y_allowed))
                }
                None => error(row),
            };
            if error == 0.0 { 0.0 } else { error / allowed }
        });
        ratios.filter(|ratio| ratio.is_finite()).fold(0.0, f64::max)
    })
}
