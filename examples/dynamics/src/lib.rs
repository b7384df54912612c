//! Shared code of the examples of motion under forces: runs of an integrator over a right side that may
//! refuse, and the folder for pictures.
//!
//! A mechanism's states are its inputs and their rates, so that `state_rates` is the whole right side.
//! The integrator is the crate `differential-equations`: Dormand and Prince's method of order 8 with
//! events, and symplectic steps.

#[cfg(test)]
mod tests;

use std::cell::Cell;
use std::fmt;
use std::path::PathBuf;

use differential_equations::methods::SymplecticIntegrator;
use differential_equations::ode::OrdinaryNumericalMethod;
use differential_equations::prelude::*;
use linkage_core::SolveError;
use linkage_core::sketch::{Film, SketchError};

/// The right side of an equation, where it is to be followed, and how exactly.
#[derive(Clone, Debug)]
pub struct Motion<F, const N: usize> {
    rates: F,
    span: [f64; 2],
    start: [f64; N],
    tolerance: f64,
}

/// The result of a run.
#[derive(Clone, Debug)]
pub struct Run<const N: usize> {
    /// In s.
    pub times: Vec<f64>,
    /// One for each time.
    pub states: Vec<[f64; N]>,
    /// The number of evaluations of the right side.
    pub evaluations: usize,
    /// True if an event ended it.
    pub is_interrupted: bool,
}

/// Why a run ended before its time.
#[derive(Clone, Debug, PartialEq)]
pub enum Stopped {
    /// The mechanism refused, first at this time in s.
    Refused(f64, SolveError),
    /// The integrator gave up.
    Integrator(String),
}

impl fmt::Display for Stopped {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Refused(time, error) => write!(f, "{error}, at {time} s"),
            Self::Integrator(why) => f.write_str(why),
        }
    }
}

impl std::error::Error for Stopped {}

impl<const N: usize> Run<N> {
    /// The last time and state.
    ///
    /// # Panics
    /// Never: a run has its start.
    #[must_use]
    pub fn last(&self) -> (f64, [f64; N]) {
        let last = self.times.last().zip(self.states.last());
        let (time, state) = last.expect("a run has its start");
        (*time, *state)
    }

    /// Times and states.
    pub fn iter(&self) -> impl Iterator<Item = (f64, [f64; N])> + '_ {
        self.times.iter().copied().zip(self.states.iter().copied())
    }

    /// A curve of something over time.
    pub fn curve(&self, value: impl Fn(f64, [f64; N]) -> f64) -> Vec<(f64, f64)> {
        self.iter().map(|(time, state)| (time, value(time, state))).collect()
    }
}

impl<F, const N: usize> Motion<F, N>
where
    F: Fn(f64, [f64; N]) -> Result<[f64; N], SolveError>,
{
    /// A motion from a start, over a span of time in s; `rates` is given time and state.
    pub fn new(span: [f64; 2], start: [f64; N], rates: F) -> Self {
        Self { rates, span, start, tolerance: 1e-12 }
    }

    /// With this error of a step, relative to a state's size, and absolutely below one.
    #[must_use]
    pub fn tolerance(self, tolerance: f64) -> Self {
        Self { tolerance, ..self }
    }

    /// From the same start, over another span of time in s.
    #[must_use]
    pub fn spanning(self, span: [f64; 2]) -> Self {
        Self { span, ..self }
    }

    /// At evenly spaced times, both ends among them.
    ///
    /// # Errors
    /// The error that stopped the run.
    pub fn sampled(&self, intervals: u32) -> Result<Run<N>, Stopped> {
        let [start, end] = self.span;
        let share = |k: u32| f64::from(k) / f64::from(intervals);
        let times = (0..=intervals).map(|k| start + (end - start) * share(k)).collect();
        self.solved(times, |_, _| 1.0)
    }

    /// At the end alone.
    ///
    /// # Errors
    /// The error that stopped the run.
    pub fn ended(&self) -> Result<Run<N>, Stopped> {
        self.sampled(1)
    }

    /// Samples a fixed time apart until the event's function passes from negative to positive; the
    /// event itself, to rounding, is the last of them.
    ///
    /// # Errors
    /// The error that stopped the run.
    pub fn until(
        &self,
        apart: f64,
        event: impl Fn(f64, [f64; N]) -> f64,
    ) -> Result<Run<N>, Stopped> {
        let [start, end] = self.span;
        let count = ((end - start) / apart) as u32;
        let evenly = (0..=count).map(|k| start + apart * f64::from(k));
        self.solved(evenly.filter(|time| *time < end).chain([end]).collect(), event)
    }

    /// Steps of one length by Forest and Ruth's symplectic method of order 4, for motions whose first
    /// half of states changes by the second half alone and the other way round.
    ///
    /// # Errors
    /// The error that stopped the run.
    pub fn symplectic(&self, step: f64) -> Result<Run<N>, Stopped> {
        let [start, end] = self.span;
        let side = RightSide::new(&self.rates);
        let steps = ((end - start) / step) as usize + 2;
        let method = SymplecticIntegrator::ruth_forest(step).max_steps(steps);
        side.run(IVP::ode(&side, start, end, self.start).method(method).solve())
    }

    fn solved(
        &self,
        times: Vec<f64>,
        event: impl Fn(f64, [f64; N]) -> f64,
    ) -> Result<Run<N>, Stopped> {
        let side = RightSide::new(&self.rates);
        let method = ExplicitRungeKutta::dop853().rtol(self.tolerance).atol(self.tolerance);
        let [start, end] = self.span;
        let last_step = Cell::new((start, self.start));
        let samples = Samples { side: &side, times, next: 0, last_step: &last_step };
        let event = Rising(event);
        let problem = IVP::ode(&side, start, end, self.start).solout(samples).event(&event);
        let mut run = side.run(problem.method(method.max_steps(1_000_000)).solve())?;
        if run.is_interrupted {
            let (time, state) = side.located(last_step.get(), run.last().0, &event.0);
            // The event as the crate found it, and samples of its step that come behind it.
            run.times.pop();
            let kept = run.times.iter().take_while(|sample| **sample < time).count();
            run.times.truncate(kept);
            run.states.truncate(kept);
            run.times.push(time);
            run.states.push(state);
        }
        Ok(run)
    }
}

/// A right side that cannot fail, made of one that can: it keeps the first refusal and is not a number
/// from then on, at which the integrator gives up.
struct RightSide<'a, F> {
    rates: &'a F,
    calls: Cell<usize>,
    refusal: Cell<Option<(f64, SolveError)>>,
}

impl<'a, F> RightSide<'a, F> {
    fn new(rates: &'a F) -> Self {
        Self { rates, calls: Cell::new(0), refusal: Cell::new(None) }
    }

    fn run<const N: usize>(
        &self,
        solved: Result<Solution<f64, [f64; N]>, Error<f64, [f64; N]>>,
    ) -> Result<Run<N>, Stopped> {
        if let Some((time, error)) = self.refusal.get() {
            return Err(Stopped::Refused(time, error));
        }
        let solution = solved.map_err(|error| Stopped::Integrator(format!("{error:?}")))?;
        Ok(Run {
            is_interrupted: matches!(solution.status, Status::Interrupted),
            times: solution.t,
            states: solution.y,
            evaluations: self.calls.get(),
        })
    }
}

impl<F> RightSide<'_, F> {
    /// The end of one step of the method. A state within an accepted step is as exact as its end.
    ///
    /// The method's own dense output is not used: that of version 0.7.0 of the crate exchanges s and 1 − s
    /// in three of its factors, and is off by 1e-8 where steps are right to 1e-13.
    fn step<const N: usize>(&self, (from, state): (f64, [f64; N]), to: f64) -> [f64; N]
    where
        F: Fn(f64, [f64; N]) -> Result<[f64; N], SolveError>,
    {
        let calls = self.calls.get();
        let mut method = ExplicitRungeKutta::dop853().h0(to - from);
        let stepped = method.init(self, from, to, &state).and_then(|_| method.step(self));
        // Samples are no part of what a motion takes.
        self.calls.set(calls);
        stepped.map_or([f64::NAN; N], |_| *method.y())
    }

    /// Where the event's function is zero, from about where it is, by secants.
    fn located<const N: usize>(
        &self,
        start: (f64, [f64; N]),
        about: f64,
        event: impl Fn(f64, [f64; N]) -> f64,
    ) -> (f64, [f64; N])
    where
        F: Fn(f64, [f64; N]) -> Result<[f64; N], SolveError>,
    {
        let value = |time| event(time, self.step(start, time));
        let (mut time, mut before) = (about, about + 1e-4 * (start.0 - about));
        let (mut here, mut there) = (value(time), value(before));
        for _ in 0..8 {
            let next = time - here * (time - before) / (here - there);
            if here == there || !next.is_finite() {
                break;
            }
            (before, there) = (time, here);
            (time, here) = (next, value(next));
        }
        (time, self.step(start, time))
    }
}

impl<F, const N: usize> ODE<f64, [f64; N]> for RightSide<'_, F>
where
    F: Fn(f64, [f64; N]) -> Result<[f64; N], SolveError>,
{
    fn diff(&self, t: f64, y: &[f64; N], dydt: &mut [f64; N]) {
        self.calls.set(self.calls.get() + 1);
        *dydt = [f64::NAN; N];
        if self.refusal.get().is_none() {
            match (self.rates)(t, *y) {
                Ok(rates) => *dydt = rates,
                Err(error) => self.refusal.set(Some((t, error))),
            }
        }
    }
}

/// The first time at which something passes from negative to positive ends the run.
struct Rising<E>(E);

impl<E, const N: usize> Event<f64, [f64; N]> for Rising<E>
where
    E: Fn(f64, [f64; N]) -> f64,
{
    fn config(&self) -> EventConfig {
        EventConfig::new(CrossingDirection::Positive, Some(1))
    }

    fn event(&self, t: f64, y: &[f64; N]) -> f64 {
        (self.0)(t, *y)
    }
}

/// Samples at these times, whatever the steps.
struct Samples<'a, F, const N: usize> {
    side: &'a RightSide<'a, F>,
    times: Vec<f64>,
    next: usize,
    /// Where the last step began.
    last_step: &'a Cell<(f64, [f64; N])>,
}

impl<F, const N: usize> Solout<f64, [f64; N]> for Samples<'_, F, N>
where
    F: Fn(f64, [f64; N]) -> Result<[f64; N], SolveError>,
{
    fn solout<I>(
        &mut self,
        now: f64,
        before: f64,
        state: &[f64; N],
        former: &[f64; N],
        _: &mut I,
        solution: &mut Solution<f64, [f64; N]>,
    ) -> ControlFlag<f64, [f64; N]>
    where
        I: Interpolation<f64, [f64; N]> + ?Sized,
    {
        self.last_step.set((before, *former));
        // The last step may end a rounding before the end of the span.
        let rounding = 16.0 * f64::EPSILON * now.abs().max(before.abs());
        while let Some(&time) = self.times.get(self.next).filter(|time| **time <= now + rounding) {
            let is_between = time > before && time < now - rounding;
            let sample = if is_between { self.side.step((before, *former), time) } else { *state };
            solution.push(time, sample);
            self.next += 1;
        }
        ControlFlag::Continue
    }
}

/// Where the pictures of the examples are written.
///
/// # Errors
/// An error of the file system.
pub fn picture(name: &str) -> std::io::Result<PathBuf> {
    let folder = PathBuf::from("target").join("charts");
    std::fs::create_dir_all(&folder)?;
    Ok(folder.join(format!("{name}.svg")))
}

/// Writes `target/charts/NAME.svg` and says so.
///
/// # Errors
/// An error of the film or of the file system.
pub fn show(name: &str, film: &Film) -> Result<(), SketchError> {
    let path = picture(name)?;
    film.write_svg(&path)?;
    println!("film: {}", path.display());
    Ok(())
}
