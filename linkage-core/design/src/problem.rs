//! A machine with free parameters, what is aimed at and what is kept, as a problem in numbers from 0 to 1.

use linkage_core::num_dual::DualSVec;

use crate::error::DesignError;
use crate::kernel::{Evaluation, Goal};
use crate::rows::{Block, Cause, Dual, Failure, Machines, Rows, computed};

/// A machine whose parameters are given as numbers of a type.
type Build<'a, T, M, const N: usize> = Box<dyn Fn([T; N]) -> M + Send + Sync + 'a>;

/// Clearances that have slopes beyond the limits of assembly, too.
type Reach<'a, M, const N: usize> = Box<dyn Fn(&M, &mut Vec<Dual<N>>) + Send + Sync + 'a>;

/// All that a search asks, from any thread.
pub(crate) struct Problem<'a, M, F, const N: usize> {
    pub(crate) parameters: [&'static str; N],
    /// The base unit of each.
    pub(crate) units: [&'static str; N],
    pub(crate) declared: [f64; N],
    pub(crate) ranges: [[f64; 2]; N],
    pub(crate) on_duals: Build<'a, Dual<N>, M, N>,
    pub(crate) on_numbers: Build<'a, f64, F, N>,
    pub(crate) aims: Vec<Block<'a, M, N>>,
    pub(crate) keeps: Vec<Block<'a, M, N>>,
    /// By these a start is mended that cannot be assembled.
    pub(crate) reaches: Vec<Reach<'a, M, N>>,
}

impl<'a, M: 'a, F, const N: usize> Problem<'a, M, F, N> {
    pub(crate) fn widths(&self) -> [f64; N] {
        self.ranges.map(|[from, to]| to - from)
    }

    /// The parameters of numbers from 0 to 1; the ends of a range are met exactly.
    pub(crate) fn parameters_at(&self, x: &[f64]) -> [f64; N] {
        core::array::from_fn(|i| {
            let [from, to] = self.ranges[i];
            if x[i] >= 1.0 { to } else { from + x[i] * (to - from) }
        })
    }

    /// The numbers from 0 to 1 of parameters; those beyond their range are brought to its end.
    pub(crate) fn unit(&self, parameters: [f64; N]) -> [f64; N] {
        core::array::from_fn(|i| {
            let [from, to] = self.ranges[i];
            ((parameters[i] - from) / (to - from)).clamp(0.0, 1.0)
        })
    }

    /// The machine with derivatives by its parameters, or without: what is zero of them is not computed.
    pub(crate) fn machine(&self, parameters: [f64; N], with_slopes: bool) -> M {
        (self.on_duals)(core::array::from_fn(|i| {
            let number = DualSVec::from_re(parameters[i]);
            if with_slopes { number.derivative(i) } else { number }
        }))
    }

    pub(crate) fn machines(&self, parameters: [f64; N], with_slopes: bool) -> Machines<M> {
        let machine = |with_slopes| self.machine(parameters, with_slopes);
        Machines { sloped: machine(with_slopes), plain: machine(false) }
    }

    pub(crate) fn evaluated(&self, x: &[f64], with_slopes: bool) -> Result<Evaluation, Failure> {
        let parameters = self.parameters_at(x);
        let machines = self.machines(parameters, with_slopes);
        let aims = computed(&self.aims, 0, &machines)?;
        let keeps = computed(&self.keeps, self.aims.len(), &machines)?;
        let widths = self.widths();
        Ok(Evaluation { aims: Rows::of(&aims, &widths), keeps: Rows::of(&keeps, &widths) })
    }

    /// The block of a failure, by its index among aims and then keeps.
    pub(crate) fn block(&self, index: usize) -> &Block<'a, M, N> {
        let keep = index.checked_sub(self.aims.len());
        keep.map_or_else(|| &self.aims[index], |keep| &self.keeps[keep])
    }

    /// The error that a failure is, if nothing better is known.
    pub(crate) fn error(&self, failure: Failure) -> DesignError {
        let block = self.block(failure.block);
        let (of, at) = (block.name.clone(), block.place(failure.place));
        match failure.cause {
            Cause::Refused(nearest) => DesignError::Unassembled { nearest, of, at },
            Cause::NotANumber => DesignError::NotANumber { of, at },
        }
    }
}

impl<'a, M: 'a, F, const N: usize> Goal for Problem<'a, M, F, N> {
    fn evaluate(&self, x: &[f64], with_slopes: bool) -> Option<Evaluation> {
        self.evaluated(x, with_slopes).ok()
    }
}
