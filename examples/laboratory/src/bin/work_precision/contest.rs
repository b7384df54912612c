//! Who races whom.

use crate::bench::{Bench, Finding, Width};
use crate::half_angle::HalfAngle;
use crate::mechanisms::{self as m, CHAIN, FOUR_BAR, SIX_BAR, STEPHENSON};
use crate::newton::{self, Newton};
use crate::number::Number;
use crate::straightforward::{self, Straightforward};
use crate::tuned::{self, Tuned};
use crate::{batches, dual};
use laboratory::generated as g;

/// Runs the races of one mechanism in one width; told the rounds that are done.
type Run = Box<dyn FnOnce(usize, &dyn Fn(usize)) -> Vec<Finding>>;

/// One mechanism in one width.
pub(crate) struct Contest {
    pub(crate) mechanism: &'static str,
    pub(crate) width: &'static str,
    pub(crate) run: Run,
}

/// Poses in a round of Newton, and the turns they make: small, moderate and large steps.
const STEPS: [(usize, usize); 3] = [(5120, 1), (512, 1), (512, 7)];

pub(crate) fn all() -> Vec<Contest> {
    let of_width = [in_width::<f64>(), in_width::<f32>()];
    of_width.into_iter().flatten().collect()
}

fn in_width<F: Width>() -> [Contest; 4] {
    let contest = |mechanism, run| Contest { mechanism, width: F::NAME, run };
    [
        contest(
            FOUR_BAR.name,
            Box::new(|rounds, progress: &dyn Fn(usize)| four_bar::<F>().run(rounds, progress)),
        ),
        contest(
            SIX_BAR.name,
            Box::new(|rounds, progress: &dyn Fn(usize)| six_bar::<F>().run(rounds, progress)),
        ),
        contest(
            STEPHENSON.name,
            Box::new(|rounds, progress: &dyn Fn(usize)| stephenson::<F>().run(rounds, progress)),
        ),
        contest(
            CHAIN.name,
            Box::new(|rounds, progress: &dyn Fn(usize)| chain::<F>().run(rounds, progress)),
        ),
    ]
}

fn four_bar<F: Width>() -> Bench<F, 14> {
    let mut bench = Bench::new(FOUR_BAR);
    bench.closed("straightforward", m::four_bar::<Straightforward, F>, |out| *out);
    bench.closed(
        "tuned by hand",
        |[t, w, a]| tuned::four_bar(t.sin_cos_by_hand(), [w, a]),
        |out| *out,
    );
    bench.closed("half angles", m::four_bar::<HalfAngle, F>, |out| *out);
    for steps in STEPS {
        let start = Newton::<F, 1>::starting_at(newton::FOUR_BAR_START);
        bench.following(steps, start, Newton::four_bar);
    }
    bench.closed("num-dual", dual::four_bar::<F>, |out| *out);
    let solver = g::FourBar::<F>::default();
    bench.closed("generated", move |[t, w, a]| solver.motion(t, w, a), g::four_bar);
    let compensated = g::FourBarCompensated::<F>::default();
    bench.closed(
        "generated, compensated",
        move |[t, w, a]| compensated.motion(t, w, a),
        g::four_bar_compensated,
    );
    bench.swept("generated, sweep", move |input, slices| {
        let swept = batches::four_bar(&solver, input, slices);
        assert_eq!(swept, Ok(()), "all slices are of one length");
    });
    let on_circle = |t: F| Number::sin_cos(t);
    bench.aside("generated, (cos, sin) given", on_circle, move |(s, c), [w, a]| {
        solver.motion_at(c, s, w, a)
    });
    bench.aside("tuned by hand, (cos, sin) given", on_circle, |circle, rates| {
        tuned::four_bar(circle, rates)
    });
    let point = g::CouplerPoint::<F>::default();
    bench.aside("generated, coupler point only", |t| t, move |t, [w, a]| point.motion(t, w, a));
    bench.aside("generated, position only", |t| t, move |t, _| solver.position(t));
    bench
}

fn six_bar<F: Width>() -> Bench<F, 13> {
    let mut bench = Bench::new(SIX_BAR);
    let first = |out: &[F; 14]| std::array::from_fn(|k| out[k]);
    bench.closed("straightforward", straightforward::six_bar::<F>, first);
    bench.closed("tuned by hand", tuned::six_bar::<F>, |out| *out);
    for steps in STEPS {
        let start = Newton::<F, 1>::starting_at(newton::SIX_BAR_START);
        bench.following(steps, start, Newton::six_bar);
    }
    bench.closed("num-dual", dual::six_bar::<F>, |out| *out);
    let solver = g::SixBar::<F>::default();
    bench.closed("generated", move |[t, w, a]| solver.motion(t, w, a), g::six_bar);
    bench.swept("generated, sweep", move |input, slices| {
        let swept = batches::six_bar(&solver, input, slices);
        assert_eq!(swept, Ok(()), "all slices are of one length");
    });
    let on_circle = |t: F| Number::sin_cos(t);
    bench.aside("generated, (cos, sin) given", on_circle, move |(s, c), [w, a]| {
        solver.motion_at(c, s, w, a)
    });
    bench
}

fn stephenson<F: Width>() -> Bench<F, 16> {
    let mut bench = Bench::new(STEPHENSON);
    bench.closed("straightforward", m::stephenson::<Straightforward, F>, |out| *out);
    bench.closed("tuned by hand", m::stephenson::<Tuned, F>, |out| *out);
    bench.closed("half angles", m::stephenson::<HalfAngle, F>, |out| *out);
    for steps in STEPS {
        let start = Newton::<F, 2>::starting_at(newton::STEPHENSON_START);
        bench.following(steps, start, Newton::stephenson);
    }
    bench.closed("num-dual", dual::stephenson::<F>, |out| *out);
    let solver = g::Stephenson::<F>::default();
    bench.closed("generated", move |[t, w, a]| solver.motion(t, w, a), g::stephenson);
    let compensated = g::StephensonCompensated::<F>::default();
    bench.closed(
        "generated, compensated",
        move |[t, w, a]| compensated.motion(t, w, a),
        g::stephenson_compensated,
    );
    bench.swept("generated, sweep", move |input, slices| {
        let swept = batches::stephenson(&solver, input, slices);
        assert_eq!(swept, Ok(()), "all slices are of one length");
    });
    bench
}

fn chain<F: Width>() -> Bench<F, 10> {
    let mut bench = Bench::new(CHAIN);
    bench.closed("straightforward", m::chain::<Straightforward, F>, |out| *out);
    bench.closed("tuned by hand", m::chain::<Tuned, F>, |out| *out);
    bench.closed("half angles", m::chain::<HalfAngle, F>, |out| *out);
    for steps in STEPS {
        let start = Newton::<F, 4>::starting_at(newton::CHAIN_START);
        bench.following(steps, start, Newton::chain);
    }
    bench.closed("num-dual", dual::chain::<F>, |out| *out);
    let solver = g::Chain::<F>::default();
    bench.closed("generated", move |[t, w, a]| solver.motion(t, w, a), g::chain);
    let compensated = g::ChainCompensated::<F>::default();
    bench.closed(
        "generated, compensated",
        move |[t, w, a]| compensated.motion(t, w, a),
        g::chain_compensated,
    );
    bench.swept("generated, sweep", move |input, slices| {
        let swept = batches::chain(&solver, input, slices);
        assert_eq!(swept, Ok(()), "all slices are of one length");
    });
    bench
}
