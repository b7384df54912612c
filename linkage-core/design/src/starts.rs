//! From random draws to starts, and from each start to its end.

use std::cell::Cell;
use std::ops::ControlFlow;

use linkage_core::SolveError;

use crate::error::DesignError;
use crate::kernel::{Evaluation, Goal, Kernel};
use crate::mend::mended;
use crate::optimality::ACTIVE;
use crate::problem::Problem;
use crate::random::Random;
use crate::rows::{Cause, Failure};
use crate::search::{Progress, Stage, each};

/// The end of one search.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Attempt<const N: usize> {
    pub(crate) draw: usize,
    pub(crate) x: [f64; N],
    pub(crate) cost: f64,
    pub(crate) violation: f64,
    pub(crate) begun: Begun,
    pub(crate) evaluations: usize,
}

/// A start's way to a machine that can be assembled.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Begun {
    Drawn,
    Mended,
    Redrawn,
}

/// The most draws of one start.
const TRIES: usize = 100;

/// The choice and the number of starts.
pub(crate) struct Plan<const N: usize> {
    pub(crate) drawn: Option<[[f64; 2]; N]>,
    pub(crate) draws: usize,
    pub(crate) starts: usize,
    pub(crate) seed: u64,
    pub(crate) threads: usize,
}

/// A place between the ranges, with the number of its draw.
pub(crate) type Start<const N: usize> = (usize, [f64; N]);

type Watch<'t> = &'t mut dyn FnMut(Progress) -> ControlFlow<()>;

impl<const N: usize> Plan<N> {
    /// The declared machine, and random ones.
    fn drawn<'a, M: 'a, F>(&self, problem: &Problem<'a, M, F, N>, draw: usize) -> [f64; N] {
        if draw == 0 {
            return problem.unit(problem.declared);
        }
        self.random(problem, &mut Random::of(self.seed, draw))
    }

    fn random<'a, M: 'a, F>(
        &self,
        problem: &Problem<'a, M, F, N>,
        random: &mut Random,
    ) -> [f64; N] {
        let ranges = self.drawn.unwrap_or(problem.ranges);
        problem.unit(ranges.map(|[from, to]| from + (to - from) * random.uniform()))
    }

    /// The starts: the best of the draws, or the first of them.
    pub(crate) fn starts<'a, M: 'a, F>(
        &self,
        problem: &Problem<'a, M, F, N>,
        told: Watch<'_>,
    ) -> Result<Vec<Start<N>>, DesignError> {
        if self.draws == 0 {
            let start = |draw| (draw, self.drawn(problem, draw));
            return Ok((0..self.starts).map(start).collect());
        }
        let (of, mut count) = (self.draws, 0_usize);
        let looked = each(
            of,
            self.threads,
            |draw| {
                let at = problem.evaluated(&self.drawn(problem, draw), false)?;
                Ok((at.cost(), at.shortage()))
            },
            |_, looked| {
                count += 1;
                // A line of progress is for a reader.
                let is_news = count.is_multiple_of(1000) || count == of;
                match looked {
                    looked if is_fault(looked) => ControlFlow::Break(()),
                    _ if is_news => {
                        told(Progress { stage: Stage::Draws, done: count, of, best: None })
                    }
                    _ => ControlFlow::Continue(()),
                }
            },
        );
        let (mut seen, mut refused, mut failures) = (Vec::new(), Vec::new(), Vec::new());
        for (draw, looked) in looked.into_iter().enumerate() {
            match looked {
                Some(Ok((cost, shortage))) => seen.push((draw, cost, shortage)),
                Some(Err(failure)) => {
                    refused.push(draw);
                    failures.push(failure);
                }
                None => {}
            }
        }
        judge(problem, &failures)?;
        let mut best = best_of(seen, self.starts);
        // Where these are too few, some that were refused are mended or drawn again.
        let rest = refused.into_iter().take(self.starts - best.len());
        best.extend(rest);
        Ok(best.into_iter().map(|draw| (draw, self.drawn(problem, draw))).collect())
    }
}

/// The draws of the least cost, with a weight of the shortage that makes both of one size: the quotient of
/// their medians.
fn best_of(mut seen: Vec<(usize, f64, f64)>, count: usize) -> Vec<usize> {
    let median = |mut numbers: Vec<f64>| {
        numbers.sort_by(f64::total_cmp);
        numbers.get(numbers.len() / 2).copied()
    };
    let costs = median(seen.iter().map(|seen| seen.1).collect());
    let shortages = median(seen.iter().map(|seen| seen.2).filter(|short| *short > 0.0).collect());
    let weight = costs.zip(shortages).map_or(0.0, |(cost, short)| cost / short);
    seen.sort_by(|a, b| (a.1 + weight * a.2).total_cmp(&(b.1 + weight * b.2)));
    seen.into_iter().take(count).map(|seen| seen.0).collect()
}

/// All that a search begins with.
pub(crate) struct Begin<'b, 'a, M, F, const N: usize> {
    pub(crate) plan: &'b Plan<N>,
    pub(crate) problem: &'b Problem<'a, M, F, N>,
    pub(crate) kernel: &'b dyn Kernel,
}

/// A problem that counts what a search evaluates.
struct Counted<'c, 'a, M, F, const N: usize> {
    problem: &'c Problem<'a, M, F, N>,
    count: Cell<usize>,
}

impl<'a, M: 'a, F, const N: usize> Goal for Counted<'_, 'a, M, F, N> {
    fn evaluate(&self, x: &[f64], with_slopes: bool) -> Option<Evaluation> {
        self.count.set(self.count.get() + 1);
        self.problem.evaluate(x, with_slopes)
    }
}

/// The end of a search, or why it could not begin.
pub(crate) type Ended<const N: usize> = Result<Attempt<N>, Failure>;

impl<'a, M: 'a, F, const N: usize> Begin<'_, 'a, M, F, N> {
    /// The ends of the searches from all starts.
    pub(crate) fn ended(&self, starts: &[Start<N>], told: Watch<'_>) -> Vec<Option<Ended<N>>> {
        let (mut count, mut best, of) = (0, None, starts.len());
        let watched = |_, ended: &Ended<N>| {
            count += 1;
            if let Ok(Attempt { cost, violation, .. }) = ended
                && *violation <= ACTIVE
                && best.is_none_or(|best| *cost < best)
            {
                best = Some(*cost);
            }
            let progress = Progress { stage: Stage::Starts, done: count, of, best };
            if is_fault(ended) { ControlFlow::Break(()) } else { told(progress) }
        };
        each(of, self.plan.threads, |index| self.attempt(starts[index]), watched)
    }

    /// One search.
    fn attempt(&self, (draw, start): Start<N>) -> Ended<N> {
        let (start, begun) = self.assembled(draw, start)?;
        let counted = Counted { problem: self.problem, count: Cell::new(0) };
        let end = self.kernel.search(&counted, &start);
        let x: [f64; N] = core::array::from_fn(|i| end[i]);
        let at = self.problem.evaluated(&x, true)?;
        let evaluations = counted.count.get();
        Ok(Attempt { draw, x, cost: at.cost(), violation: at.violation(), begun, evaluations })
    }

    /// A start that can be assembled: itself, mended, or drawn again.
    fn assembled(&self, draw: usize, start: [f64; N]) -> Result<([f64; N], Begun), Failure> {
        let Err(refusal) = self.problem.evaluated(&start, true) else {
            return Ok((start, Begun::Drawn));
        };
        if refusal.cause == Cause::NotANumber {
            return Err(refusal);
        }
        let mut random = Random::of(!self.plan.seed, draw);
        let mends = |start| {
            let is_asked = !self.problem.reaches.is_empty();
            let mended = is_asked.then(|| mended(self.problem, self.kernel, start));
            mended.filter(|mended| self.problem.evaluated(mended, true).is_ok())
        };
        if let Some(mended) = mends(start) {
            return Ok((mended, Begun::Mended));
        }
        for _ in 0..TRIES {
            let again = self.plan.random(self.problem, &mut random);
            if self.problem.evaluated(&again, true).is_ok() {
                return Ok((again, Begun::Redrawn));
            }
            if let Some(mended) = mends(again) {
                return Ok((mended, Begun::Redrawn));
            }
        }
        Err(refusal)
    }
}

/// The ends and the failures.
pub(crate) fn parted<const N: usize>(
    ended: Vec<Option<Ended<N>>>,
) -> (Vec<Attempt<N>>, Vec<Failure>) {
    let (mut attempts, mut failures) = (Vec::new(), Vec::new());
    for end in ended.into_iter().flatten() {
        match end {
            Ok(attempt) => attempts.push(attempt),
            Err(failure) => failures.push(failure),
        }
    }
    (attempts, failures)
}

/// True for a number that is none: a fault of the question, which ends a search.
fn is_fault<T>(result: &Result<T, Failure>) -> bool {
    matches!(result, Err(Failure { cause: Cause::NotANumber, .. }))
}

/// The error of a number that is none, if there is one.
pub(crate) fn judge<'a, M: 'a, F, const N: usize>(
    problem: &Problem<'a, M, F, N>,
    failures: &[Failure],
) -> Result<(), DesignError> {
    let fault = failures.iter().find(|failure| failure.cause == Cause::NotANumber);
    fault.map_or(Ok(()), |&fault| Err(problem.error(fault)))
}

/// The error of the start that was nearest to being assembled.
pub(crate) fn nearest<'a, M: 'a, F, const N: usize>(
    problem: &Problem<'a, M, F, N>,
    failures: &[Failure],
) -> DesignError {
    let short = |failure: &&Failure| match failure.cause {
        Cause::Refused(SolveError::OutOfReach { by, .. }) => by,
        _ => f64::INFINITY,
    };
    let nearest = failures.iter().min_by(|a, b| short(a).total_cmp(&short(b)));
    nearest.map_or(DesignError::NoAim, |&failure| problem.error(failure))
}
