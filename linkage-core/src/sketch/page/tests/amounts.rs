//! Amounts of friction that depend on each other, with the crate's own solutions and refusals.

use std::string::{String, ToString};
use std::vec::Vec;
use std::{format, vec};

use super::cases::{Case, Random, bits};
use crate::SolveError;
use crate::checks::{Checks, FirstError};
use crate::friction::{Amounts, System};

const JOINTS: [&str; 8] = ["0", "1", "2", "3", "4", "5", "6", "7"];

/// Systems of one to eight amounts, their spectral radius on both sides of one; systems of absolute values alone, some
/// of which send Newton's steps round in a circle; some numbers are none, zero or out of range.
pub(super) fn amounts() -> Vec<Case> {
    let mut random = Random::new(29);
    let mut cases = Vec::new();
    for (count, of_values, calls) in [
        (1, false, 3_000),
        (2, false, 3_000),
        (3, false, 4_000),
        (4, true, 15_000),
        (8, false, 2_000),
    ] {
        for nth in 0..calls {
            let case = asked(&mut random, count, of_values);
            if nth % 3 == 0 {
                cases.push(in_steps(&case));
            }
            cases.push(case);
        }
    }
    cases
}

fn signed(random: &mut Random) -> f64 {
    2.0 * random.unit() - 1.0
}

/// A system: how many amounts it has, which are guides, where steps begin, and its rows.
pub(super) fn system(random: &mut Random, count: usize, of_values: bool) -> Vec<f64> {
    let width = 3 + 2 * count;
    let mut rows: Vec<f64> = (0..count * width).map(|_| signed(random)).collect();
    for row in rows.chunks_mut(width) {
        row[0] = row[0].abs();
        if of_values {
            row.iter_mut().skip(2).step_by(2).for_each(|second| *second = 0.0);
        }
    }
    let all = (1 << count) - 1;
    let guides = if of_values { all } else { random.bits() as u32 & all };
    let rho = match of_values {
        true => 0.95 + 0.049 * random.unit(),
        false => {
            let near = [0.05, 0.4, 0.9, 0.999, 1.001, 1.5];
            near[(random.bits() % 6) as usize] * (0.9 + 0.1 * random.unit())
        }
    };
    let scale = rho / radius_at_most(&rows, count, guides);
    rows.chunks_mut(width).for_each(|row| row[0] *= scale);
    if random.bits().is_multiple_of(12) {
        let at = random.bits() as usize % rows.len();
        let odd = [f64::NAN, f64::INFINITY, 0.0, -0.0, 1e300, 1e-310, 1e30];
        rows[at] = odd[(random.bits() % 7) as usize];
    }
    match random.bits() % 30 {
        // Corners: reactions without friction that are zero.
        0 => rows.chunks_mut(width).for_each(|row| (row[1], row[2]) = (0.0, 0.0)),
        1 => (rows[1], rows[2]) = (0.0, 0.0),
        // Reactions of which squares are out of range, or next to it.
        3 => {
            let size = [1e-130, 1e-138, 1e-146, 1e-155, 1e140, 1e153, 1e160];
            let size = size[(random.bits() % 7) as usize];
            rows.chunks_mut(width)
                .for_each(|row| (row[1], row[2]) = (size * row[1], size * row[2]));
        }
        // One that bears nothing, whatever the others do.
        5 => rows[1..width].fill(0.0),
        // A contact that does not rub, beside others.
        4 => rows[0] = 0.0,
        // A pivot that is zero.
        2 if count == 1 => (rows[0], rows[3], rows[4]) = (1.0, 1.0, 0.0),
        _ => {}
    }
    // Mostly where the steps begin; any other place is as good.
    let start: Vec<f64> = rows
        .chunks(width)
        .enumerate()
        .map(|(j, row)| {
            row[0]
                * size(guides, j, row[1], row[2])
                * [1.0, 1.0, 1.0, 3.0][(random.bits() % 4) as usize]
        })
        .collect();
    [vec![count as f64, f64::from(guides)], start, rows].concat()
}

fn asked(random: &mut Random, count: usize, of_values: bool) -> Case {
    let given = system(random, count, of_values);
    Case { name: "amounts", answer: answer(&given), given }
}

/// The amounts of a system, or why it has none.
pub(super) fn answer(given: &[f64]) -> String {
    let (count, guides) = (given[0] as usize, given[1] as u32);
    let (start, rows) = given[2..].split_at(count);
    match count {
        1 => said::<5, 1>(rows, guides, start),
        2 => said::<7, 2>(rows, guides, start),
        3 => said::<9, 3>(rows, guides, start),
        4 => said::<11, 4>(rows, guides, start),
        _ => said::<19, 8>(rows, guides, start),
    }
}

/// The same system by the slow path's steps, and by guarded ones alone.
fn in_steps(case: &Case) -> Case {
    let (count, guides) = (case.given[0] as usize, case.given[1] as u32);
    let rows = &case.given[2 + count..];
    let answer = match count {
        1 => steps::<5, 1>(rows, guides),
        2 => steps::<7, 2>(rows, guides),
        3 => steps::<9, 3>(rows, guides),
        4 => steps::<11, 4>(rows, guides),
        _ => steps::<19, 8>(rows, guides),
    };
    Case { name: "steps", given: case.given.clone(), answer }
}

fn steps<const W: usize, const M: usize>(rows: &[f64], guides: u32) -> String {
    let rows = core::array::from_fn(|j| core::array::from_fn(|i| rows[j * W + i]));
    let said = |found: Option<([f64; M], usize)>| match found {
        Some((amounts, steps)) => format!("{steps} {}", amounts.map(bits).join(" ")),
        None => "none".to_string(),
    };
    System::<f64, W, M> { rows, guides }.in_steps().map(said).join(" ")
}

fn size(guides: u32, j: usize, x: f64, y: f64) -> f64 {
    if guides >> j & 1 == 1 { x.abs().max(y.abs()) } else { x.hypot(y) }
}

/// An upper bound of the spectral radius, Collatz's: the largest growth of a component.
fn radius_at_most(rows: &[f64], count: usize, guides: u32) -> f64 {
    let width = rows.len() / count;
    let bound = |j: usize, k: usize| {
        let row = &rows[j * width..];
        row[0] * size(guides, j, row[3 + 2 * k], row[4 + 2 * k])
    };
    let (mut vector, mut largest) = (vec![1.0; count], 0.0);
    for _ in 0..40 {
        let grown = |j| (0..count).map(|k| bound(j, k) * vector[k]).sum::<f64>();
        let next: Vec<f64> = (0..count).map(grown).collect();
        largest = next.iter().zip(&vector).map(|(next, last)| next / last).fold(0.0, f64::max);
        let most = next.iter().copied().fold(f64::MIN_POSITIVE, f64::max);
        vector = next.iter().map(|x| x / most).collect();
    }
    largest
}

/// The amounts as the slow path has them, which takes the fast path's where that has found any.
fn said<const W: usize, const M: usize>(rows: &[f64], guides: u32, start: &[f64]) -> String {
    let rows = core::array::from_fn(|j| core::array::from_fn(|i| rows[j * W + i]));
    let start: [f64; M] = core::array::from_fn(|j| start[j]);
    let joints = core::array::from_fn(|j| JOINTS[j]);
    let mut checks = FirstError::new();
    let found =
        checks.amounts(start, Amounts { system: System::<f64, W, M> { rows, guides }, joints });
    match checks.first() {
        Ok(()) => found.map(bits).join(" "),
        Err(SolveError::Jams { joint }) => format!("Jams {joint}"),
        Err(SolveError::NotFinite { name }) => format!("NotFinite {name}"),
        Err(other) => other.to_string(),
    }
}
