//! One mechanism in one width: every method in the same race, and its error.

use laboratory::race::{Race, Timing, angles, calls, chained, swept};
use linkage_core::{Float, Real, Record, SolveError, Status};

use crate::error::{Errors, errors};
use crate::forms::{dual, newton};
use crate::mechanisms::Mechanism;

/// A width in which every method can compute.
pub(crate) trait Width: Real + Float + dual::Base + newton::Field {
    const NAME: &'static str;
}

impl Width for f32 {
    const NAME: &'static str = "f32";
}

impl Width for f64 {
    const NAME: &'static str = "f64";
}

/// The result of a method: all numbers of a motion, or none.
pub(crate) trait Outcome<F, const N: usize> {
    fn numbers(&self) -> Option<[F; N]>;
}

impl<F: Copy, const N: usize> Outcome<F, N> for Option<[F; N]> {
    #[inline(always)]
    fn numbers(&self) -> Self {
        *self
    }
}

impl<F, M: Record<Array = [F; N], Number = F> + Copy, const N: usize> Outcome<F, N>
    for Result<M, SolveError>
{
    #[inline(always)]
    fn numbers(&self) -> Option<[F; N]> {
        self.as_ref().ok().map(|motion| motion.into_array())
    }
}

/// The measurements of one method.
#[derive(Clone, Debug)]
pub(crate) struct Finding {
    pub(crate) name: String,
    pub(crate) throughput: Timing,
    pub(crate) latency: Option<Timing>,
    /// In ε; none where the method was given something else than the angle.
    pub(crate) errors: Option<Errors>,
}

/// The poses of one run: what a sweep writes of them stays in the first cache, and its columns do
/// not share their lines, as those of a power of two would.
const POSES: usize = 240;

/// Poses in a round of Newton, and the turns they make: small, moderate and large steps.
const STEPS: [(usize, usize); 3] = [(5120, 1), (512, 1), (512, 7)];

pub(crate) struct Bench<F, const N: usize> {
    mechanism: Mechanism<N>,
    throughput: Race,
    latency: Race,
    errors: Vec<(String, Errors)>,
    /// Rate and acceleration.
    rates: [F; 2],
}

impl<F: Width, const N: usize> Bench<F, N> {
    pub(crate) fn new(mechanism: Mechanism<N>) -> Self {
        let rates = [F::num(mechanism.rate), F::num(mechanism.second)];
        let (throughput, latency) = (Race::default(), Race::default());
        Self { mechanism, throughput, latency, errors: Vec::new(), rates }
    }

    /// A form that needs nothing but the angle and its rates.
    pub(crate) fn form<S: Copy + 'static>(
        &mut self,
        name: &str,
        form: S,
        solve: impl Fn(&mut S, [F; 3]) -> Option<[F; N]> + Copy + 'static,
    ) {
        self.closed(name, move |input| solve(&mut { form }, input));
    }

    /// A method that needs nothing but the angle and its rates.
    pub(crate) fn closed<R: Outcome<F, N> + 'static>(
        &mut self,
        name: &str,
        solve: impl Fn([F; 3]) -> R + Copy + 'static,
    ) {
        self.timed(name, angles().take(POSES).collect(), solve);
        let found = errors(&self.mechanism, |input| solve(input).numbers());
        self.errors.push((name.to_owned(), found));
    }

    /// A form that starts from where it was.
    pub(crate) fn following<S: Copy + 'static>(
        &mut self,
        start: S,
        solve: impl Fn(&mut S, [F; 3]) -> Option<[F; N]> + Copy + 'static,
    ) {
        for (poses, turns) in STEPS {
            let step = std::f64::consts::TAU * turns as f64 / poses as f64;
            let name = format!("Newton, steps of {:.2}°", step.to_degrees());
            let angles = (0..poses).map(|k| F::num((k as f64 * step) % std::f64::consts::TAU));
            let mut state = start;
            self.timed(&name, angles.collect(), move |input| solve(&mut state, input));
            let (mut state, mut at) = (start, 0.0);
            let found = errors(&self.mechanism, |input: [F; 3]| {
                let target = input[0].value();
                while at + step < target {
                    at += step;
                    solve(&mut state, [F::num(at), input[1], input[2]]);
                }
                solve(&mut state, input)
            });
            self.errors.push((name, found));
        }
    }

    fn timed<R: Outcome<F, N> + 'static>(
        &mut self,
        name: &str,
        angles: Vec<F>,
        mut solve: impl FnMut([F; 3]) -> R + Clone + 'static,
    ) {
        let [rate, second] = self.rates;
        let mut other = solve.clone();
        let alone = calls(angles.clone(), move |angle| solve([angle, rate, second]));
        self.throughput.enter(name, alone);
        let [positions, velocities, _] = self.mechanism.labels.map(<[_]>::len);
        // An acceleration: what is done to make the next angle wait must not cost much itself.
        let last = move |result: &R| {
            result.numbers().map_or(F::num(0.0), |numbers| numbers[positions + velocities])
        };
        let waiting = chained(angles, move |angle| other([angle, rate, second]), last);
        self.latency.enter(name, waiting);
    }

    /// A method at all poses in one call.
    pub(crate) fn swept(
        &mut self,
        name: &str,
        sweep: impl Fn((&[F], F, F), [&mut [F]; N], &mut [Status]) + Copy + 'static,
    ) {
        let ([rate, second], angles) = (self.rates, angles().take(POSES).collect::<Vec<F>>());
        let run = swept(POSES, move |out, status| sweep((&angles, rate, second), out, status));
        self.throughput.enter(name, run);
        let found = errors(&self.mechanism, |input: [F; 3]| {
            let mut values = [F::num(0.0); N];
            let mut status = [Status::NotFinite];
            let out = values.each_mut().map(std::slice::from_mut);
            sweep((&input[..1], input[1], input[2]), out, &mut status);
            (status[0] == Status::Solved).then_some(values)
        });
        self.errors.push((name.to_owned(), found));
    }

    /// Something else about the mechanism, for its throughput only.
    pub(crate) fn aside<A: Copy + 'static, R: 'static>(
        &mut self,
        name: &str,
        prepare: impl Fn(F) -> A,
        solve: impl Fn(A, [F; 2]) -> R + 'static,
    ) {
        let (inputs, rates) = (angles().take(POSES).map(prepare).collect(), self.rates);
        self.throughput.enter(name, calls(inputs, move |input| solve(input, rates)));
    }

    pub(crate) fn run(mut self, rounds: usize, progress: &dyn Fn(usize)) -> Vec<Finding> {
        let waits = self.latency.run(rounds, progress);
        let alone = self.throughput.run(rounds, |round| progress(rounds + round));
        let finding = |throughput: Timing| {
            let name = throughput.name.clone();
            let latency = waits.iter().find(|timing| timing.name == name).cloned();
            let errors = self.errors.iter().find(|(of, _)| *of == name).map(|&(_, errors)| errors);
            Finding { name, throughput, latency, errors }
        };
        alone.into_iter().map(finding).collect()
    }
}
