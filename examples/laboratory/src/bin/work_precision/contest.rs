//! Who races whom.

use laboratory::generated as g;
use laboratory::hand::swinging_block;
use linkage_core::Record;

use crate::bench::{Bench, Finding, Width};
use crate::forms::by_hand::ByHand;
use crate::forms::dual::Dual;
use crate::forms::half_angle::HalfAngle;
use crate::forms::newton::Newton;
use crate::forms::straightforward::Straightforward;
use crate::mechanisms::{self as m, CHAIN, FOUR_BAR, SIX_BAR, STEPHENSON};

/// Runs the races of one mechanism in one width; told the rounds that are done.
type Run = Box<dyn FnOnce(usize, &dyn Fn(usize)) -> Vec<Finding>>;

/// One mechanism in one width.
pub(crate) struct Contest {
    pub(crate) mechanism: &'static str,
    pub(crate) width: &'static str,
    pub(crate) run: Run,
}

pub(crate) fn all() -> Vec<Contest> {
    let of_width = [in_width::<f64>(), in_width::<f32>()];
    of_width.into_iter().flatten().collect()
}

fn in_width<F: Width>() -> [Contest; 4] {
    macro_rules! contest {
        ($mechanism:ident, $bench:ident) => {
            Contest {
                mechanism: $mechanism.name,
                width: F::NAME,
                run: Box::new(|rounds, progress| $bench::<F>().run(rounds, progress)),
            }
        };
    }
    [
        contest!(FOUR_BAR, four_bar),
        contest!(SIX_BAR, six_bar),
        contest!(STEPHENSON, stephenson),
        contest!(CHAIN, chain),
    ]
}

/// The ways that every mechanism has: the forms, Newton's method from unknowns at the crank angle 0, and the solver.
macro_rules! every_form {
    ($bench:ident, $width:ident, $mechanism:path, [$($name:literal $form:expr),*], $start:expr, $solver:ident) => {
        $($bench.form($name, $form, $mechanism);)*
        $bench.following(Newton::<$width, { $start.len() }>::starting_at($start), $mechanism);
        $bench.form("num-dual", Dual, $mechanism);
        let solver = g::$solver::<$width>::default();
        $bench.closed("generated", move |[t, w, a]| solver.motion(t, w, a));
        $bench.swept("generated, sweep", move |(t, w, a), out, status| {
            let swept = solver.sweep_motion(t, w, a, Record::from_array(out), status, ());
            assert_eq!(swept, Ok(()), "all slices are of one length");
        });
    };
}

macro_rules! compensated {
    ($bench:ident, $solver:ident) => {
        let solver = g::$solver::<F>::default();
        $bench.closed("generated, compensated", move |[t, w, a]| solver.motion(t, w, a));
    };
}

fn four_bar<F: Width>() -> Bench<F, 14> {
    let mut bench = Bench::new(FOUR_BAR);
    every_form!(
        bench, F, m::four_bar,
        ["straightforward" Straightforward, "tuned by hand" ByHand, "half angles" HalfAngle],
        [[0.77, 1.69]], FourBar
    );
    compensated!(bench, FourBarCompensated);
    let solver = g::FourBar::<F>::default();
    bench.aside("generated, (cos, sin) given", F::library_cos_sin, move |[c, s], [w, a]| {
        solver.motion_at(c, s, w, a)
    });
    let point = g::CouplerPoint::<F>::default();
    bench.aside("generated, coupler point only", |t| t, move |t, [w, a]| point.motion(t, w, a));
    bench.aside("generated, position only", |t| t, move |t, _| solver.position(t));
    bench
}

fn six_bar<F: Width>() -> Bench<F, 13> {
    let mut bench = Bench::new(SIX_BAR);
    bench.form("straightforward", Straightforward, m::six_bar);
    bench.closed("tuned by hand", swinging_block);
    every_form!(bench, F, m::six_bar, [], [[1.19, 1.08]], SixBar);
    let solver = g::SixBar::<F>::default();
    bench.aside("generated, (cos, sin) given", F::library_cos_sin, move |[c, s], [w, a]| {
        solver.motion_at(c, s, w, a)
    });
    bench
}

fn stephenson<F: Width>() -> Bench<F, 16> {
    let mut bench = Bench::new(STEPHENSON);
    every_form!(
        bench, F, m::stephenson,
        ["straightforward" Straightforward, "tuned by hand" ByHand, "half angles" HalfAngle],
        [[0.96, 1.53], [0.58, 1.98]], Stephenson
    );
    compensated!(bench, StephensonCompensated);
    bench
}

fn chain<F: Width>() -> Bench<F, 10> {
    let mut bench = Bench::new(CHAIN);
    every_form!(
        bench, F, m::chain,
        ["straightforward" Straightforward, "tuned by hand" ByHand, "half angles" HalfAngle],
        [[0.96, 1.53], [0.26, 1.70], [0.28, 1.82], [0.29, 1.90]], Chain
    );
    compensated!(bench, ChainCompensated);
    bench
}
