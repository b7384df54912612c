//! The inputs of a drawing whose drives are no linear functions of them.

use crate::model::drawn::drive_equations::agreement::{DriveEquations, Solution, solved};

/// The most steps of Newton's method, and the halvings of each.
const STEPS: usize = 40;
const HALVINGS: i32 = 8;

/// Where the inputs start beside the secant's root: within a turn of an angle, and within the length of a machine in
/// metres.
const STARTS: [f64; 9] = [0.0, 0.1, -0.1, 0.5, -0.5, 1.5, -1.5, 3.0, -3.0];

/// The part of one by which drives may be off at the inputs of a drawing: rounding of numbers of the machine's size.
const OFF: f64 = 1e-9;

impl DriveEquations<'_, '_> {
    /// The inputs that Newton's method finds from the secants' root, or from the first place of some about zero.
    pub(super) fn approached(&self, secant: Option<Vec<f64>>) -> Option<Vec<f64>> {
        let starts = secant.into_iter().chain(STARTS.map(|start| vec![start; self.count()]));
        starts.into_iter().find_map(|start| self.newton(start))
    }

    /// Newton's method from these inputs, each step halved until the drives come nearer to what is drawn.
    fn newton(&self, mut inputs: Vec<f64>) -> Option<Vec<f64>> {
        for _ in 0..STEPS {
            let Solution { inputs: step, decided_by } =
                solved(self.slopes(&inputs)?, inputs.len())?;
            let off = |inputs: &[f64]| {
                let offs = decided_by.iter().map(|&equation| self.off(equation, inputs));
                offs.map(|off| Some(off?.abs())).sum::<Option<f64>>()
            };
            let before = off(&inputs)?;
            let nearer = (0..HALVINGS).find_map(|halving| {
                let share = 0.5_f64.powi(halving);
                let next = inputs.iter().zip(&step).map(|(at, step)| at + share * step);
                let next: Vec<f64> = next.collect();
                off(&next).is_some_and(|off| off < before).then_some(next)
            });
            match nearer {
                Some(next) => inputs = next,
                // Rounding ends what converges.
                None => return (before <= OFF).then_some(inputs),
            }
        }
        None
    }

    /// The slopes of the equations at these inputs, each with what is missing last.
    fn slopes(&self, inputs: &[f64]) -> Option<Vec<Vec<f64>>> {
        // Central differences are off by the square of it and by rounding over it: about 1e-10.
        const STEP: f64 = 1e-5;
        let slope = |equation: usize, input: usize| {
            let mut beside = inputs.to_vec();
            beside[input] += STEP;
            let ahead = self.off(equation, &beside)?;
            beside[input] -= 2.0 * STEP;
            Some((ahead - self.off(equation, &beside)?) / (2.0 * STEP))
        };
        let row = |equation: usize| {
            let slopes = (0..inputs.len()).map(|input| slope(equation, input));
            let missing = self.off(equation, inputs).map(|off| -off);
            slopes.chain([missing]).collect()
        };
        (0..self.len()).map(row).collect()
    }

    /// An equation that holds at no input near any start, though some input moves it.
    pub(super) fn never_as_drawn(&self) -> Option<usize> {
        (0..self.len()).rev().find(|&equation| {
            let offs = STARTS.map(|start| self.off(equation, &vec![start; self.count()]));
            let [Some(first), ..] = offs else { return false };
            let is_moved = offs.iter().flatten().any(|off| (off - first).abs() > OFF);
            let changes_sign = offs.iter().flatten().any(|off| off * first <= 0.0);
            is_moved && !changes_sign
        })
    }
}
