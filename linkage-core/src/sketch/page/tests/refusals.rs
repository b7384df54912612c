//! Refusals of numbers that are not finite, with the crate's own names.

use std::format;
use std::string::{String, ToString};
use std::vec::Vec;

use super::cases::{Case, Random};
use crate::SolveError;
use crate::checks::{Checks, FirstError};
use crate::diagnosis::finite_result;
use crate::roots::FindError;

const NAMES: [&str; 4] = ["0", "1", "2", "3"];

/// Given numbers, some of which are too large for their fourth power: the largest of these is named, wherever it
/// stands, and the result where there is none. And what an equation that was no number leaves of the conditions
/// behind it.
pub(super) fn refusals() -> impl Iterator<Item = Case> {
    let mut random = Random::new(41);
    (0..4_000).map(move |nth| {
        if nth % 2 == 0 {
            let mut number = || {
                let sign = if random.bits() & 1 == 0 { 1.0 } else { -1.0 };
                // The fourth power of 1.16e77 is the largest number.
                let sizes = [1.0, 1e30, 1e76, 1.1e77, 1.2e77, 1e78, 1e100, 1e200];
                sign * sizes[(random.bits() % 8) as usize] * (1.0 + 0.01 * random.unit())
            };
            blamed([number(), number(), number(), number()])
        } else {
            let equation = [0.0, 1.0, 2.0][(random.bits() % 3) as usize];
            let size = random.unit();
            let share = [0.0, 1e-7, 1e-6, -2e-6, 1.0, f64::NAN, f64::INFINITY];
            closed([equation, size * share[(random.bits() % 7) as usize], size])
        }
    })
}

fn said(found: Result<(), SolveError>) -> String {
    match found {
        Ok(()) => "fine".to_string(),
        Err(SolveError::NotFinite { name }) => format!("NotFinite {name}"),
        Err(SolveError::NoSolution { unknown, .. }) => format!("NoSolution {unknown}"),
        Err(other) => other.to_string(),
    }
}

fn blamed(given: [f64; 4]) -> Case {
    let named: Vec<_> = given.iter().copied().zip(NAMES).collect();
    let answer = said(finite_result(f64::INFINITY, "result", &named));
    Case { name: "blamed", given: given.into(), answer }
}

/// An equation that was a number (0), or was none there (1), or has no root (2); then its sides in the final pose.
fn closed(given: [f64; 3]) -> Case {
    let [equation, difference, size] = given;
    let mut checks = FirstError::new();
    let found: Result<[f64; 2], FindError> = match equation {
        0.0 => Ok([0.5, size]),
        1.0 => Err(FindError::NotFinite { at: 0.5 }),
        _ => Err(FindError::SeveralDeadPoints),
    };
    checks.root(found, "x", "m");
    checks.closed(difference, size, "x", "m");
    let answer = match checks.first() {
        Err(SolveError::SeveralDeadPoints { unknown }) => format!("SeveralDeadPoints {unknown}"),
        other => said(other),
    };
    Case { name: "closed", given: given.into(), answer }
}

/// The same of the script.
pub(super) const REFUSALS: &str = r#"
const blamedOf = (given) => {
  const { error } = solved(given.map((x, k) => [x, String(k)]), () => [Infinity], () => "result");
  return `${error.kind} ${error.name ?? error.group}`;
};
const closedOf = ([equation, difference, size]) => {
  const checks = new FirstError();
  const found = [[0.5, size], { kind: "NotFinite", at: 0.5 }, { kind: "SeveralDeadPoints" }][equation];
  checks.root(() => found, [], [], "x", "m");
  checks.Closed(difference, size, "x", "m");
  const { kind, group } = checks.reason ?? {};
  return kind ? `${kind} ${group}` : "fine";
};
"#;
