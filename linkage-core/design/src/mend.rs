//! Starts that cannot be assembled: the slopes of what they are short of lead to some that can.

use crate::kernel::{Evaluation, Goal, Kernel};
use crate::problem::Problem;
use crate::rows::{Dual, Rows, finite};

/// A clearance below this, against its scale, is mended.
const ROOM: f64 = 1e-3;

/// All clearances that are short of some room: their squares become zero.
struct Short<'p, 'a, M, F, const N: usize>(&'p Problem<'a, M, F, N>);

impl<'a, M: 'a, F, const N: usize> Goal for Short<'_, 'a, M, F, N> {
    fn evaluate(&self, x: &[f64], with_slopes: bool) -> Option<Evaluation> {
        let machine = self.0.machine(self.0.parameters_at(x), with_slopes);
        let mut clearances = Vec::new();
        self.0.reaches.iter().for_each(|reach| reach(&machine, &mut clearances));
        finite(&clearances).ok()?;
        let short = |clearance: Dual<N>| match ROOM - clearance.re {
            short if short > 0.0 => -clearance + ROOM,
            _ => Dual::from_re(0.0),
        };
        let short: Vec<Dual<N>> = clearances.into_iter().map(short).collect();
        let widths = self.0.widths();
        Some(Evaluation { aims: Rows::of(&short, &widths), keeps: Rows::of(&[], &widths) })
    }
}

/// A place next to a start that is short of nothing, or of less.
pub(crate) fn mended<'a, M: 'a, F, const N: usize>(
    problem: &Problem<'a, M, F, N>,
    kernel: &dyn Kernel,
    start: [f64; N],
) -> [f64; N] {
    let end = kernel.search(&Short(problem), &start);
    core::array::from_fn(|i| end[i])
}
