//! Equations of amounts of friction in a pose, in either precision, and what straight-line code has found.

use crate::ir::graph::{Id, Node};
use crate::ir::implicit::Contacts;
use crate::ir::interpret::{Number, ProgramValues, Searched, amounts, interpret};
use crate::ir::liveness::{Path, live};
use crate::ir::program::Program;
use crate::oracle::Digits;

/// The equations of amounts in a pose, and what straight-line code has found.
pub(super) struct Case<'p> {
    pub contacts: &'p Contacts,
    /// c, both components of G, and those of A for each amount.
    pub rows: Vec<Vec<f64>>,
    pub starts: Vec<f64>,
    pub found: Vec<f64>,
    pub positive: Vec<f64>,
    pub small: Vec<[f64; 2]>,
}

/// A number in which a pose is computed.
pub(super) trait Width: Searched {
    fn narrowed(value: f64) -> Self;
    fn widened(&self) -> f64;
}

macro_rules! widths {
    ($($width:ident)+) => {$(
        impl Width for $width {
            fn narrowed(value: f64) -> Self {
                value as $width
            }
            fn widened(&self) -> f64 {
                f64::from(*self)
            }
        }
    )+};
}

widths! { f64 f32 }

fn digits(values: &[f64]) -> Vec<Digits> {
    values.iter().copied().map(Digits::float).collect()
}

impl<'p> Case<'p> {
    /// None out of reach.
    pub(super) fn of<T: Width>(program: &'p Program, given: &ProgramValues<f64>) -> Option<Self> {
        let all = |values: &[f64]| values.iter().copied().map(T::narrowed).collect::<Vec<_>>();
        let given = ProgramValues {
            inputs: given.inputs.iter().map(|input| input.map(T::narrowed)).collect(),
            params: all(&given.params),
            loads: all(&given.loads),
            drives: all(&given.drives),
            unit: None,
        };
        let values = interpret(program, &given);
        let sinks = &program.answer("forces").expect("there are forces").sinks;
        let (graph, mut found, mut first) = (&program.graph, Vec::new(), None);
        let live = live(graph, sinks, Path::Slow);
        for (id, node) in graph.iter().filter(|(id, _)| live[id.index()]) {
            let Node::Solved(solve, at, Some(value)) = node else { continue };
            let Some(contacts) = graph.implicit(solve).contacts() else { continue };
            assert_eq!(at as usize, found.len(), "{id:?}: one group has friction");
            found.push(values[value.index()].widened());
            first.get_or_insert(contacts);
        }
        let contacts = first.expect("the group has friction");
        let all = |ids: &[Id]| -> Vec<f64> {
            ids.iter().map(|id| values[id.index()].widened()).collect()
        };
        let (rows, starts) = contacts.parts();
        let case = Self {
            contacts,
            rows: rows.into_iter().map(all).collect(),
            starts: all(starts),
            found,
            positive: all(&contacts.positive),
            small: all(&contacts.small).chunks(2).map(|pair| [pair[0], pair[1]]).collect(),
        };
        case.starts.iter().all(|start| start.is_finite()).then_some(case)
    }

    fn size(&self, j: usize, [x, y]: [f64; 2]) -> f64 {
        match self.contacts.joints[j].1 {
            true => x.abs().max(y.abs()),
            false => x.hypot(y),
        }
    }

    /// L
    fn bounds(&self) -> Vec<Vec<f64>> {
        let entry = |j: usize, k: usize| {
            let row = &self.rows[j];
            row[0] * self.size(j, [row[3 + 2 * k], row[4 + 2 * k]])
        };
        let all = 0..self.rows.len();
        all.clone().map(|j| all.clone().map(|k| entry(j, k)).collect()).collect()
    }

    /// The spectral radius of L, by the growth of a positive vector.
    pub(super) fn radius(&self) -> f64 {
        let (bounds, mut grown) = (self.bounds(), 0.0);
        let mut vector = vec![1.0; bounds.len()];
        for _ in 0..400 {
            // With the unit matrix added, no power is periodic.
            let next = (0..vector.len()).map(|j| {
                vector[j] + bounds[j].iter().zip(&vector).map(|(l, x)| l * x).sum::<f64>()
            });
            let next: Vec<f64> = next.collect();
            grown = next.iter().copied().fold(0.0, f64::max);
            vector = next.iter().map(|x| x / grown).collect();
        }
        grown - 1.0
    }

    /// (I − L)⁻¹ v, by the sum of L's powers.
    pub(super) fn amplified(&self, v: &[f64]) -> Vec<f64> {
        let bounds = self.bounds();
        let (mut sum, mut power) = (v.to_vec(), v.to_vec());
        for _ in 0..2000 {
            power =
                bounds.iter().map(|row| row.iter().zip(&power).map(|(l, x)| l * x).sum()).collect();
            sum.iter_mut().zip(&power).for_each(|(sum, power)| *sum += power);
        }
        sum
    }

    /// c ‖G‖ + L x
    pub(super) fn scale(&self, j: usize) -> f64 {
        let own = self.bounds()[j].iter().zip(&self.found).map(|(l, x)| l * x).sum::<f64>();
        self.starts[j] + own
    }

    /// Φ(x) − x in a hundred digits.
    pub(super) fn residuals(&self) -> Vec<f64> {
        let (found, rows) = (digits(&self.found), self.rows_in_digits());
        let residual = |j: usize| {
            let row = &rows[j];
            let reaction = [1, 2].map(|axis| {
                let changes = row[2 + axis..].iter().step_by(2).zip(&found);
                changes.fold(row[axis].clone(), |sum, (by, x)| sum.add(&by.mul(x)))
            });
            let [x, y] = &reaction;
            let magnitude =
                |value: &Digits| if value.to_f64() < 0.0 { value.neg() } else { value.clone() };
            let size = match self.contacts.joints[j].1 {
                true if magnitude(x).is_at_least(&magnitude(y)) => magnitude(x),
                true => magnitude(y),
                false => x.hypot(y),
            };
            row[0].mul(&size).sub(&found[j]).to_f64()
        };
        (0..rows.len()).map(residual).collect()
    }

    fn rows_in_digits(&self) -> Vec<Vec<Digits>> {
        self.rows.iter().map(|row| digits(row)).collect()
    }

    /// The distance of an amount from the solution, by Newton's method in a hundred digits.
    pub(super) fn apart(&self, at: usize) -> f64 {
        let (rows, starts) = (self.rows_in_digits(), digits(&self.starts));
        let operands: Vec<&Digits> = rows.iter().flatten().chain(&starts).collect();
        let solution = amounts(self.contacts, &operands).expect("there is one solution");
        solution[at].sub(&Digits::float(self.found[at])).to_f64().abs()
    }

    /// True where the fast path takes the amounts.
    pub(super) fn is_proven(&self, epsilon: f64) -> bool {
        let is_small = |&[less, more]: &[f64; 2]| 4.0 * epsilon * more > less;
        self.positive.iter().all(|pivot| *pivot > 0.0) && self.small.iter().all(is_small)
    }
}
