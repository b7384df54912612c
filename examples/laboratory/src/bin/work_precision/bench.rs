//! One mechanism in one width: every method in the same race, and its error.

use linkage_core::{SolveError, Status};

use crate::batches::Slices;
use crate::error::{Errors, errors};
use crate::harness::{Race, Timing, batch, latency, throughput};
use crate::mechanisms::Mechanism;
use crate::number::Number;
use crate::{dual, newton};

/// A width in which every method can compute.
pub(crate) trait Width: Number + dual::Base + newton::Field + linkage_core::Float {}
impl Width for f32 {}
impl Width for f64 {}

/// The result of a solver: a motion, or none.
pub(crate) trait Outcome {
    type Motion;
    fn motion(&self) -> Option<&Self::Motion>;
}

impl<M> Outcome for Option<M> {
    type Motion = M;
    #[inline(always)]
    fn motion(&self) -> Option<&M> {
        self.as_ref()
    }
}

impl<M> Outcome for Result<M, SolveError> {
    type Motion = M;
    #[inline(always)]
    fn motion(&self) -> Option<&M> {
        self.as_ref().ok()
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

pub(crate) struct Bench<F, const N: usize> {
    mechanism: Mechanism<N>,
    throughput: Race,
    latency: Race,
    errors: Vec<(String, Errors)>,
    /// Rate and second rate.
    rates: [F; 2],
}

impl<F: Width, const N: usize> Bench<F, N> {
    pub(crate) fn new(mechanism: Mechanism<N>) -> Self {
        let rates = [F::of(mechanism.rate), F::of(mechanism.second)];
        let (throughput, latency) = (Race::default(), Race::default());
        Self { mechanism, throughput, latency, errors: Vec::new(), rates }
    }

    /// A method that needs nothing but the angle and its rates.
    pub(crate) fn closed<R: Outcome + 'static>(
        &mut self,
        name: &str,
        solve: impl Fn([F; 3]) -> R + Copy + 'static,
        numbers: impl Fn(&R::Motion) -> [F; N] + Copy + 'static,
    ) {
        self.timed(name, angles(), solve, numbers);
        let found = errors(&self.mechanism, |input| solve(input).motion().map(numbers));
        self.errors.push((name.to_owned(), found));
    }

    /// A method that starts from where it was: `turns` turns in `poses` equal steps.
    pub(crate) fn following<S: Copy + 'static>(
        &mut self,
        (poses, turns): (usize, usize),
        start: S,
        solve: impl Fn(&mut S, [F; 3]) -> Option<[F; N]> + Copy + 'static,
    ) {
        let step = std::f64::consts::TAU * turns as f64 / poses as f64;
        let name = format!("Newton, steps of {:.2}°", step.to_degrees());
        let angles: Vec<F> =
            (0..poses).map(|k| F::of((k as f64 * step) % std::f64::consts::TAU)).collect();
        let mut state = start;
        self.timed(&name, angles, move |input| solve(&mut state, input), |out| *out);
        let (mut state, mut at) = (start, 0.0);
        let found = errors(&self.mechanism, |input: [F; 3]| {
            let target = input[0].widen();
            while at + step < target {
                at += step;
                solve(&mut state, [F::of(at), input[1], input[2]]);
            }
            solve(&mut state, input)
        });
        self.errors.push((name, found));
    }

    fn timed<R: Outcome + 'static>(
        &mut self,
        name: &str,
        angles: Vec<F>,
        mut solve: impl FnMut([F; 3]) -> R + Clone + 'static,
        numbers: impl Fn(&R::Motion) -> [F; N] + Copy + 'static,
    ) {
        let [rate, second] = self.rates;
        let mut other = solve.clone();
        let alone = throughput(angles.clone(), move |angle| solve([angle, rate, second]));
        self.throughput.enter(name, alone);
        let accelerations = self.mechanism.orders.0 + self.mechanism.orders.1;
        // One of them: what is done to make the next angle wait must not cost much itself.
        let last = move |result: &R| {
            let first = |values: [F; N]| values.into_iter().nth(accelerations);
            result.motion().map(numbers).and_then(first).unwrap_or(F::of(0.0))
        };
        let chained = latency(angles, move |angle| other([angle, rate, second]), last);
        self.latency.enter(name, chained);
    }

    /// The method of this name, at all poses in one call.
    pub(crate) fn swept(
        &mut self,
        name: &str,
        sweep: impl Fn((&[F], F, F), Slices<'_, F, N>) + Copy + 'static,
    ) {
        let ([rate, second], angles) = (self.rates, angles::<F>());
        let mut columns: [Vec<F>; N] = std::array::from_fn(|_| vec![F::of(0.0); POSES]);
        let mut status: Vec<Status> = vec![Status::Solved; POSES];
        let run = move || {
            let numbers = columns.each_mut().map(|column| &mut column[..]);
            sweep((&angles, rate, second), Slices { numbers, status: &mut status });
            std::hint::black_box((&mut columns, &mut status));
        };
        self.throughput.enter(name, batch(POSES, run));
        let found = errors(&self.mechanism, |input: [F; 3]| {
            let mut values = [F::of(0.0); N];
            let numbers = values.each_mut().map(std::slice::from_mut);
            let mut status = [Status::NotFinite];
            sweep((&input[..1], input[1], input[2]), Slices { numbers, status: &mut status });
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
        let (inputs, rates) = (angles().into_iter().map(prepare).collect(), self.rates);
        self.throughput.enter(name, throughput(inputs, move |input| solve(input, rates)));
    }

    pub(crate) fn run(self, rounds: usize, progress: &dyn Fn(usize)) -> Vec<Finding> {
        let Self { throughput, latency, errors, .. } = self;
        let chained = latency.run(rounds, progress);
        let alone = throughput.run(rounds, |round| progress(rounds + round));
        let finding = |throughput: Timing| {
            let name = throughput.name.clone();
            let latency = chained.iter().find(|timing| timing.name == name).cloned();
            let errors = errors.iter().find(|(of, _)| *of == name).map(|&(_, errors)| errors);
            Finding { name, throughput, latency, errors }
        };
        alone.into_iter().map(finding).collect()
    }
}

/// Angles all over a turn, in no order.
fn angles<F: Number>() -> Vec<F> {
    // Multiples of the golden angle.
    (0..POSES).map(|k| F::of((k as f64 * 2.399_963_229_728_653) % std::f64::consts::TAU)).collect()
}
