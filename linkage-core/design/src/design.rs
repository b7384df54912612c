//! The question: free parameters, aims, keeps, and how long to search.

use std::ops::{ControlFlow, RangeInclusive};
use std::sync::Arc;

use linkage_core::{Parameters, Scalar, SolveError};

use crate::error::DesignError;
use crate::found::{Counts, Found};
use crate::kernel::{Kernel, Slsqp};
use crate::problem::Problem;
use crate::rows::{Block, Dual};
use crate::search::Progress;
use crate::starts::{Begin, Plan, judge, parted};
use crate::verdict::{Confirmed, Guard, Verdict};

/// The most times that samples are added and the search goes on from its ends.
const ROUNDS: usize = 12;

type Told<'a> = Box<dyn FnMut(Progress) -> ControlFlow<()> + 'a>;

/// A machine whose dimensions are sought; made by [`free!`](crate::free).
///
/// `M` is the machine on dual numbers, which aims and keeps are given; `F` the one that is found.
#[must_use = "nothing is sought before `run`"]
pub struct Design<'a, M, F, const N: usize> {
    problem: Problem<'a, M, F, N>,
    plan: Plan<N>,
    kernel: Box<dyn Kernel + 'a>,
    told: Told<'a>,
    pub(crate) guards: Vec<Guard<'a, M, F>>,
    /// Told by `run`.
    unknown: Option<DesignError>,
}

/// The machine with the values that have a place, the others as they are.
fn placed<P: Parameters<Number = f64>, T: Scalar>(
    machine: &P,
    places: &[Option<usize>],
    values: &[T],
) -> P::On<T> {
    let mut places = places.iter();
    machine.map(|own| {
        let place = places.next().copied().flatten();
        place.and_then(|place| values.get(place)).copied().unwrap_or(T::num(own))
    })
}

impl<'a, M: 'a, F, const N: usize> Design<'a, M, F, N> {
    /// A machine with these parameters free, whose declared values are the first start: what
    /// [`free!`](crate::free) writes for names that rustc checks. Parameters that are not named, and modes, stay as
    /// they are.
    pub fn of<P>(machine: P, names: [&'static str; N]) -> Self
    where
        P: Parameters<Number = f64, On<Dual<N>> = M, On<f64> = F> + Send + Sync + 'a,
    {
        let (mut declared, mut units) = ([f64::NAN; N], [""; N]);
        machine.each(|own, unit, value| {
            for place in (0..N).filter(|&place| names[place] == own) {
                declared[place] = value;
                units[place] = if unit == "1" { "" } else { unit };
            }
        });
        // The place of each parameter of the machine among those that are free.
        let places: Vec<_> =
            P::NAMES.iter().map(|own| names.iter().position(|name| name == own)).collect();
        let machine = Arc::new((machine, places));
        let on_duals = {
            let machine = Arc::clone(&machine);
            move |values: [Dual<N>; N]| placed(&machine.0, &machine.1, &values)
        };
        let on_numbers = move |values: [f64; N]| placed(&machine.0, &machine.1, &values);
        let ranges = declared.map(|value: f64| {
            let ends = [0.2 * value, 5.0 * value];
            if value < 0.0 { [ends[1], ends[0]] } else { ends }
        });
        let known = P::NAMES.iter().map(|name| name.to_string());
        let unknown = names.iter().find(|name| !P::NAMES.contains(name));
        let unknown = unknown
            .map(|name| DesignError::Unknown { name: name.to_string(), known: known.collect() });
        let problem = Problem {
            parameters: names,
            units,
            declared,
            ranges,
            on_duals: Box::new(on_duals),
            on_numbers: Box::new(on_numbers),
            aims: Vec::new(),
            keeps: Vec::new(),
            reaches: Vec::new(),
        };
        Self {
            problem,
            plan: Plan { drawn: None, draws: 0, starts: 1, seed: 1, threads: 1 },
            kernel: Box::new(Slsqp::default()),
            told: Box::new(|_| ControlFlow::Continue(())),
            guards: Vec::new(),
            unknown,
        }
    }

    /// The range of each parameter, in metres and radians; without it from a fifth to five times the declared
    /// value.
    pub fn within(mut self, ranges: [RangeInclusive<f64>; N]) -> Self {
        self.problem.ranges = ranges.map(|range| [*range.start(), *range.end()]);
        self
    }

    /// The ranges that draws and starts come from, where these are narrower than what may be found.
    pub fn drawn_within(mut self, ranges: [RangeInclusive<f64>; N]) -> Self {
        self.plan.drawn = Some(ranges.map(|range| [*range.start(), *range.end()]));
        self
    }

    /// Residuals at each of some inputs: the sum of their squares becomes least. The name stands in errors.
    pub fn aim<Q: Copy + core::fmt::Debug + Send + Sync + 'a, const R: usize>(
        self,
        name: &str,
        at: impl IntoIterator<Item = Q>,
        residuals: impl Fn(&M, Q) -> Result<[Dual<N>; R], SolveError> + Send + Sync + 'a,
    ) -> Self {
        self.aimed(Block::each(name, at.into_iter().collect(), residuals))
    }

    /// Reserves at each of some inputs: none of them becomes negative.
    pub fn keep<Q: Copy + core::fmt::Debug + Send + Sync + 'a, const R: usize>(
        self,
        name: &str,
        at: impl IntoIterator<Item = Q>,
        reserves: impl Fn(&M, Q) -> Result<[Dual<N>; R], SolveError> + Send + Sync + 'a,
    ) -> Self {
        self.kept(Block::each(name, at.into_iter().collect(), reserves)).1
    }

    /// The number of random machines that are looked at, each once, before the best of them become starts.
    /// Without it starts are drawn at random.
    pub fn draws(mut self, draws: usize) -> Self {
        self.plan.draws = draws;
        self
    }

    /// The number of searches. The declared machine is the first.
    pub fn starts(mut self, starts: usize) -> Self {
        self.plan.starts = starts.max(1);
        self
    }

    /// The seed of the random numbers; a seed is found again bit by bit.
    pub fn seed(mut self, seed: u64) -> Self {
        self.plan.seed = seed;
        self
    }

    /// The number of threads; the result does not depend on it.
    pub fn threads(mut self, threads: usize) -> Self {
        self.plan.threads = threads;
        self
    }

    /// Another optimiser.
    pub fn kernel(mut self, kernel: impl Kernel + 'a) -> Self {
        self.kernel = Box::new(kernel);
        self
    }

    /// A function that is told how far the search is. A break ends it with what is found.
    pub fn on(mut self, told: impl FnMut(Progress) -> ControlFlow<()> + 'a) -> Self {
        self.told = Box::new(told);
        self
    }

    /// Searches.
    ///
    /// # Errors
    /// See [`DesignError`].
    pub fn run(mut self) -> Result<Found<F, N>, DesignError> {
        self.check()?;
        let mut starts = self.plan.starts(&self.problem, &mut *self.told)?;
        let mut rounds = ROUNDS;
        let (mut first, mut evaluations) = (None, 0);
        loop {
            let begin = Begin { plan: &self.plan, problem: &self.problem, kernel: &*self.kernel };
            let (attempts, failures) = parted(begin.ended(&starts, &mut *self.told));
            judge(&self.problem, &failures)?;
            starts = attempts.iter().map(|attempt| (attempt.draw, attempt.x)).collect();
            let mut found = Found::of(&self.problem, attempts, &failures)?;
            // Later rounds begin where the first one ended.
            let Counts { mended, redrawn, .. } = *first.get_or_insert(found.counts);
            evaluations += found.counts.evaluations;
            let draws = self.plan.draws;
            found.counts = Counts { mended, redrawn, draws, evaluations, ..found.counts };
            found.confirmed = self.confirmed(&found);
            rounds -= 1;
            if rounds == 0 || !self.add_samples(&found.confirmed) {
                return Ok(found);
            }
        }
    }

    fn confirmed(&self, found: &Found<F, N>) -> Vec<Confirmed> {
        let plain = self.problem.machine(found.values, false);
        let confirmed = |guard: &Guard<'a, M, F>| Confirmed {
            keep: self.problem.keeps[guard.keep].name.clone(),
            verdict: guard.verdict(&found.solver, &plain),
        };
        self.guards.iter().map(confirmed).collect()
    }

    /// Adds the inputs at which a condition is broken to its samples; true where there are any.
    fn add_samples(&mut self, confirmed: &[Confirmed]) -> bool {
        let mut is_more = false;
        for (guard, Confirmed { verdict, .. }) in self.guards.iter().zip(confirmed) {
            let samples = &mut self.problem.keeps[guard.keep].samples;
            if let Verdict::Not { at } = verdict {
                let new: Vec<f64> = at.iter().copied().filter(|at| !samples.contains(at)).collect();
                is_more |= !new.is_empty();
                samples.extend(new);
            }
        }
        is_more
    }

    pub(crate) fn aimed(mut self, aim: Block<'a, M, N>) -> Self {
        self.problem.aims.push(aim);
        self
    }

    /// The index of a keep, and the design with it.
    pub(crate) fn kept(mut self, keep: Block<'a, M, N>) -> (usize, Self) {
        self.problem.keeps.push(keep);
        (self.problem.keeps.len() - 1, self)
    }

    /// Adds clearances by which starts are mended.
    pub(crate) fn reaches(&mut self, reach: impl Fn(&M, &mut Vec<Dual<N>>) + Send + Sync + 'a) {
        self.problem.reaches.push(Box::new(reach));
    }

    fn check(&mut self) -> Result<(), DesignError> {
        if let Some(unknown) = self.unknown.take() {
            return Err(unknown);
        }
        for (i, &parameter) in self.problem.parameters.iter().enumerate() {
            for [from, to] in
                [Some(self.problem.ranges), self.plan.drawn].into_iter().flatten().map(|r| r[i])
            {
                if !(from < to && (to - from).is_finite()) {
                    return Err(DesignError::Range { parameter, from, to });
                }
            }
        }
        if self.problem.aims.is_empty() { Err(DesignError::NoAim) } else { Ok(()) }
    }
}
