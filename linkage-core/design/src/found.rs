//! The answer: the machine, what limits it, and how well its parameters are determined.

use core::fmt;

use nalgebra::DMatrix;

use crate::error::DesignError;
use crate::kernel::Evaluation;
use crate::optimality::{ACTIVE, Limit, Optimality};
use crate::problem::Problem;
use crate::rows::{Failure, named};
use crate::starts::{Attempt, Begun, nearest};
use crate::verdict::{Confirmed, Verdict};

/// A limit that the found machine is at.
#[derive(Clone, Debug, PartialEq)]
pub struct Price {
    /// The keep with its input, or the parameter at an end of its range.
    pub at: String,
    /// The fall of the sum of squares if the limit gave way by one of its own units; to first order.
    pub price: f64,
}

/// Another end of a search at which all is kept.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Other<const N: usize> {
    /// The parameters.
    pub values: [f64; N],
    /// The sum of squares.
    pub cost: f64,
    /// The number of starts that end there.
    pub starts: usize,
}

/// The number of starts, and where they went.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// Searches that were made.
    pub starts: usize,
    /// Searches that end at the found machine.
    pub here: usize,
    /// Searches that end where something is not kept.
    pub violating: usize,
    /// Starts that could not be assembled and were mended.
    pub mended: usize,
    /// Starts that could not be assembled and were drawn again.
    pub redrawn: usize,
    /// Starts that could not be assembled, however often they were drawn.
    pub refused: usize,
    /// Random machines that were looked at.
    pub draws: usize,
    /// Machines that the searches looked at, with slopes or without, all inputs of one counting once.
    pub evaluations: usize,
}

/// The machine that was found.
#[derive(Clone, Debug)]
pub struct Found<F, const N: usize> {
    /// The machine on `f64`.
    pub solver: F,
    /// Names of the free parameters.
    pub parameters: [&'static str; N],
    /// Their base units, as `m`, `rad` or `kg·m²`; none for a plain number.
    pub units: [&'static str; N],
    /// Their values.
    pub values: [f64; N],
    /// The sum of squares of the residuals.
    pub cost: f64,
    /// The part of the slope that no limit balances, against the slopes of single residuals: the condition of
    /// Kuhn and Tucker, 0 at an optimum.
    pub kuhn_tucker: f64,
    /// The limits that the machine is at, and what they cost.
    pub prices: Vec<Price>,
    /// Other ends, the best first.
    pub others: Vec<Other<N>>,
    /// The number of starts.
    pub counts: Counts,
    /// The parameters that the aims leave open, together with what is at its limit.
    pub undetermined: Vec<&'static str>,
    /// Conditions over a range, and whether they hold between the samples.
    pub confirmed: Vec<Confirmed>,
    deviations: Option<[f64; N]>,
}

/// Two ends within this part of the ranges are one.
const SAME: f64 = 1e-5;

impl<F, const N: usize> Found<F, N> {
    pub(crate) fn of<'a, M: 'a>(
        problem: &Problem<'a, M, F, N>,
        mut attempts: Vec<Attempt<N>>,
        failures: &[Failure],
    ) -> Result<Self, DesignError> {
        let starts = attempts.len() + failures.len();
        let is_kept = |attempt: &Attempt<N>| attempt.violation <= ACTIVE;
        // All that is kept comes first; of equals the first draw.
        attempts.sort_by(|a, b| {
            let by_draw = a.draw.cmp(&b.draw);
            match (is_kept(a), is_kept(b)) {
                (true, true) => a.cost.total_cmp(&b.cost).then(by_draw),
                (false, false) => a.violation.total_cmp(&b.violation).then(by_draw),
                (a, b) => b.cmp(&a),
            }
        });
        let Some(&best) = attempts.first() else { return Err(nearest(problem, failures)) };
        let at = problem.evaluated(&best.x, true).map_err(|failure| problem.error(failure))?;
        let parameters = problem.parameters_at(&best.x);
        let names = named(&problem.keeps, &problem.machines(parameters, false));
        if !is_kept(&best) {
            let short = at.keeps.values.iter().zip(&names).filter(|(reserve, _)| **reserve < 0.0);
            let violated = short.map(|(short, name)| (of_input(name), -short)).collect();
            return Err(DesignError::Infeasible { violated });
        }
        let kept = attempts.iter().filter(|attempt| is_kept(attempt));
        let ends = ends(problem, kept);
        let begun = |how| attempts.iter().filter(|attempt| attempt.begun == how).count();
        let counts = Counts {
            starts,
            here: ends[0].starts,
            violating: attempts.iter().filter(|attempt| !is_kept(attempt)).count(),
            mended: begun(Begun::Mended),
            redrawn: begun(Begun::Redrawn),
            refused: failures.len(),
            draws: 0,
            evaluations: attempts.iter().map(|attempt| attempt.evaluations).sum(),
        };
        let optimality = Optimality::of(&best.x, &at);
        let eliminated = problem.aims.iter().map(|aim| aim.eliminated).sum();
        let widths = problem.widths();
        let (undetermined, deviations) =
            determined(&problem.parameters, &widths, eliminated, &at, &optimality);
        Ok(Self {
            solver: (problem.on_numbers)(parameters),
            parameters: problem.parameters,
            units: problem.units,
            values: parameters,
            cost: best.cost,
            kuhn_tucker: optimality.residual,
            prices: prices(problem, &optimality, &names),
            others: ends[1..].to_vec(),
            counts,
            undetermined,
            confirmed: Vec::new(),
            deviations: deviations.map(|all| core::array::from_fn(|i| all[i])),
        })
    }

    /// The standard deviation of each parameter, if the residuals are independent and of one size, which is
    /// estimated from what remains of them. A parameter at the end of its range, or held by a keep at its
    /// limit, deviates less or not at all.
    ///
    /// # Errors
    /// `Undetermined` where the aims leave parameters open, or where there are no more residuals than
    /// parameters.
    pub fn deviations(&self) -> Result<[f64; N], DesignError> {
        let open = || match self.undetermined.as_slice() {
            [] => self.parameters.to_vec(),
            some => some.to_vec(),
        };
        self.deviations.ok_or_else(|| DesignError::Undetermined { parameters: open() })
    }
}

fn of_input((name, input): &(String, String)) -> String {
    format!("{name} at {input}")
}

/// The distinct ends, the best first.
fn ends<'a, 's, M: 'a, F, const N: usize>(
    problem: &Problem<'a, M, F, N>,
    kept: impl Iterator<Item = &'s Attempt<N>>,
) -> Vec<Other<N>> {
    let mut ends: Vec<(Other<N>, [f64; N])> = Vec::new();
    for attempt in kept {
        let is_there = |x: &[f64; N]| x.iter().zip(&attempt.x).all(|(a, b)| (a - b).abs() < SAME);
        match ends.iter_mut().find(|end| is_there(&end.1)) {
            Some(end) => end.0.starts += 1,
            None => {
                let values = problem.parameters_at(&attempt.x);
                ends.push((Other { values, cost: attempt.cost, starts: 1 }, attempt.x));
            }
        }
    }
    ends.into_iter().map(|end| end.0).collect()
}

fn prices<'a, M: 'a, F, const N: usize>(
    problem: &Problem<'a, M, F, N>,
    optimality: &Optimality,
    names: &[(String, String)],
) -> Vec<Price> {
    let widths = problem.widths();
    let priced = optimality.prices.iter().map(|&(limit, price)| match limit {
        Limit::Reserve(row) => Price { at: of_input(&names[row]), price },
        Limit::Least(i) | Limit::Most(i) => {
            let which = if matches!(limit, Limit::Least(_)) { "least" } else { "greatest" };
            let at = format!("the {which} {}", problem.parameters[i]);
            Price { at, price: price / widths[i] }
        }
    });
    priced.collect()
}

/// Singular values below this part of the largest are zero: exact slopes have fifteen digits, and a search
/// leaves half of them at a place that is not quite the optimum.
const RANK: f64 = 1e-8;

/// The parameters that are left open, and the deviations where none is.
fn determined(
    parameters: &[&'static str],
    widths: &[f64],
    eliminated: usize,
    at: &Evaluation,
    optimality: &Optimality,
) -> (Vec<&'static str>, Option<Vec<f64>>) {
    let count = parameters.len();
    let held: Vec<_> = optimality.prices.iter().filter(|(_, price)| *price > 0.0).collect();
    let push = DMatrix::from_fn(held.len(), count, |row, i| match held[row].0 {
        Limit::Reserve(row) => at.keeps.slopes[(row, i)] / at.keeps.slopes.row(row).norm(),
        Limit::Least(j) | Limit::Most(j) => f64::from(u8::from(i == j)),
    });
    let free = null_space(&push);
    let open = &free * null_space(&(&at.aims.slopes * &free));
    let is_open = |i: &usize| open.ncols() > 0 && open.row(*i).amax() > 1e-4;
    let undetermined = (0..count).filter(is_open).map(|i| parameters[i]).collect();
    let rows = at.aims.values.len().saturating_sub(eliminated);
    if open.ncols() > 0 || rows <= free.ncols() {
        return (undetermined, None);
    }
    let variance = at.cost() / (rows - free.ncols()) as f64;
    let reduced = &at.aims.slopes * &free;
    let Some(inverse) = (reduced.transpose() * &reduced).try_inverse() else {
        return (undetermined, None);
    };
    let covariance = &free * inverse * free.transpose();
    let deviation = |i: usize| (variance * covariance[(i, i)]).sqrt() * widths[i];
    (undetermined, Some((0..count).map(deviation).collect()))
}

/// An orthonormal basis of what a matrix maps to zero.
fn null_space(matrix: &DMatrix<f64>) -> DMatrix<f64> {
    let columns = matrix.ncols();
    if matrix.nrows() == 0 || columns == 0 {
        return DMatrix::identity(columns, columns);
    }
    // Rows of zeros make the decomposition a full one.
    let padded = matrix.clone().resize_vertically(matrix.nrows().max(columns), 0.0);
    let decomposed = padded.svd(false, true);
    let Some(basis) = decomposed.v_t else { return DMatrix::zeros(columns, 0) };
    let top = decomposed.singular_values.amax();
    let null: Vec<usize> =
        (0..columns).filter(|&i| decomposed.singular_values[i] <= RANK * top).collect();
    basis.select_rows(null.iter()).transpose()
}

/// A unit as a declaration writes it: `0.1m`, `0.1(kg*m^2)`.
fn declared(unit: &str) -> String {
    let text = unit.replace('·', "*").replace('²', "^2").replace('³', "^3");
    if text.chars().all(char::is_alphabetic) { text } else { format!("({text})") }
}

impl<F, const N: usize> fmt::Display for Found<F, N> {
    /// The lines of the declaration, with deviations where they exist, and what limits them.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (i, name) in self.parameters.iter().enumerate() {
            write!(f, "param {name} = {:.9}{};", self.values[i], declared(self.units[i]))?;
            match self.deviations {
                Some(deviations) if deviations[i] > 0.0 => {
                    writeln!(f, " // ± {:.1e}", deviations[i])?;
                }
                _ => writeln!(f)?,
            }
        }
        let Counts { starts, here, violating, refused, draws, evaluations, .. } = self.counts;
        write!(f, "sum of squares {:.9e}; {here} of {starts} starts end here", self.cost)?;
        if violating > 0 {
            write!(f, ", {violating} where not all is kept")?;
        }
        if refused > 0 {
            write!(f, ", {refused} could not be assembled")?;
        }
        writeln!(f, "; {draws} draws and {evaluations} evaluations")?;
        for Price { at, price } in &self.prices {
            writeln!(f, "at its limit: {at}; price {price:.3e} a unit")?;
        }
        for Confirmed { keep, verdict } in &self.confirmed {
            match verdict {
                Verdict::Everywhere => writeln!(f, "{keep}: confirmed over the whole range")?,
                Verdict::Not { at } => writeln!(f, "{keep}: not kept near {at:?}")?,
                Verdict::Unknown(why) => writeln!(f, "{keep}: not confirmed, {why}")?,
            }
        }
        if !self.undetermined.is_empty() {
            writeln!(f, "left open by the aims: {}", self.undetermined.join(", "))?;
        }
        Ok(())
    }
}
