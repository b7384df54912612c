//! One long step against many short ones: whatever the step, a tracker arrives on the branch to
//! which the motion leads.
//!
//! A walk of three degrees a step, and of half a degree where `.ci/nightly` runs all cases, is stored with the
//! solver at every sample. From any sample a fresh tracker goes to any other within 180° in one step and has
//! to find what the walk found.

use core::f64::consts::{FRAC_PI_2, PI};
use linkage_core::{Float, Real, Side, SolveError, Tracker};
use linkage_tests::mechanisms::scaled_change_points::*;
use linkage_tests::random::{Random, cases};
use linkage_tests::widths::number;

/// Steps in half a turn, and so many that a quarter of a turn has a whole number of them.
fn half_turn() -> usize {
    cases(60, 360)
}

/// Cosine, sine and angular velocity of a link; a pin and its velocity in units of length.
type Row = [f64; 7];

/// A mechanism that turns by one radian a second, with a tracker of its own.
trait Stepped: Copy + 'static {
    type Number: Float;
    type Tracker: Copy;
    const NAME: &'static str;
    /// The mechanism of this size.
    fn of_size(unit: f64) -> Self;
    fn tracker(self) -> Self::Tracker;
    fn solver(tracker: &Self::Tracker) -> Self;
    /// The tracker's motion.
    fn step(tracker: &mut Self::Tracker, theta: f64, unit: f64) -> Result<Row, SolveError>;
}

macro_rules! stepped {
    ($solver:ident: $link:ident, $pin:ident, |$unit:ident| { $($field:ident: $value:expr),* }) => {
        impl<T: Float> Stepped for $solver<T> {
            type Number = T;
            type Tracker = Tracker<Self>;
            const NAME: &'static str = stringify!($solver);

            fn of_size($unit: f64) -> Self {
                Self { unit: number($unit), $($field: $value,)* ..Self::default() }
            }
            fn tracker(self) -> Tracker<Self> {
                Tracker::new(self)
            }
            fn solver(tracker: &Tracker<Self>) -> Self {
                *tracker.solver()
            }
            fn step(tracker: &mut Tracker<Self>, theta: f64, unit: f64) -> Result<Row, SolveError> {
                let m = tracker.motion(number::<T>(theta), number::<T>(1.0), number::<T>(0.0))?;
                stepped!(row m, unit, $link, $pin)
            }
        }
    };
    (row $m:ident, $unit:ident, $link:ident, $pin:ident) => {{
        let (p, v) = ($m.position, $m.velocity);
        let [x, y, vx, vy] = [p.$pin.x, p.$pin.y, v.$pin.x, v.$pin.y].map(|x| x.value() / $unit);
        Ok([p.$link.cos.value(), p.$link.sin.value(), v.$link.omega.value(), x, y, vx, vy])
    }};
}

stepped!(ScaledPairs: DC, C, |unit| { base: number(2.0 * unit) });
stepped!(ScaledFourBar: DC, C, |unit| {});
stepped!(ScaledSliderCrank: BC, C, |unit| {});
stepped!(ScaledKite: DC, C, |unit| {});
stepped!(ScaledPivot: bar, C, |unit| {});
stepped!(ScaledOffset: bar, C, |unit| {});
stepped!(ScaledChain: CE, E, |unit| {});
stepped!(ScaledTwins: EH, E, |unit| {});

/// A walk's sample: the angle, what the tracker found there, and a solver with the modes there,
/// unless it lies so near a change point that a tracker cannot begin there in a given mode. All
/// change points here lie at multiples of a quarter turn.
struct Sample<S> {
    theta: f64,
    row: Row,
    solver: Option<S>,
}

/// The difference of results on one branch: next to a change point they come from interpolations at different
/// places. A wrong branch turns at another rate, at least 0.4 apart for all the mechanisms here, wherever it
/// is. The bounds are a small part of that.
fn allowed<S: Stepped>() -> f64 {
    if S::Number::EPSILON > 1e-10 { 0.03 } else { 1e-5 }
}

/// Where the clearance counts as one, 4 √ε of its scale, it has grown with the square of the
/// distance: 1e-4 rad and 0.04 rad times a factor of a few.
fn from_change_points<S: Stepped>() -> f64 {
    if S::Number::EPSILON > 1e-10 { 0.25 } else { 0.01 }
}

fn differ(a: &Row, b: &Row, by: f64) -> bool {
    !a.iter().zip(b).all(|(a, b)| (a - b).abs() <= by * b.abs().max(1.0))
}

/// A walk of two turns, which passes every change point several times.
fn walk<S: Stepped>(unit: f64, step: f64, from: f64) -> Vec<Sample<S>> {
    let mut tracker = S::of_size(unit).tracker();
    let sample = |i: usize| {
        let theta = from + step * i as f64;
        let row = S::step(&mut tracker, theta, unit).unwrap_or_else(|error| {
            panic!("{} × {unit:e} from {from} at {theta}: {error}", S::NAME)
        });
        let off = theta.rem_euclid(FRAC_PI_2);
        let is_sure = off.min(FRAC_PI_2 - off) > from_change_points::<S>();
        Sample { theta, row, solver: is_sure.then_some(S::solver(&tracker)) }
    };
    (0..4 * half_turn()).map(sample).collect()
}

/// A number below the end.
fn below(random: &mut Random, end: usize) -> usize {
    random.anywhere(0.0, end as f64) as usize
}

/// Steps of all lengths up to half a turn, forward and backward, a tenth of them half a turn, from
/// more places the more of them there are.
/// Gives how many were compared, and how many of them refused.
fn compare<S: Stepped>(unit: f64, pairs: usize, random: &mut Random) -> [usize; 2] {
    let (mut refused, mut compared) = (0, 0);
    let (walks, half_turn) = (1 + pairs / 100, half_turn());
    let step = PI / half_turn as f64;
    for turn in 0..walks {
        // The samples of some walks fall on change points, which all lie at multiples of a quarter
        // turn.
        let on_change_points = if walks == 1 { below(random, 2) == 0 } else { turn == 0 };
        let from = step * if on_change_points { 7.0 } else { random.anywhere(7.0, 8.0) };
        let walk = walk::<S>(unit, step, from);
        for _ in 0..pairs.div_ceil(walks) {
            let length = match below(random, 10) {
                0 => half_turn,
                _ => 1 + below(random, half_turn),
            };
            let lower = below(random, walk.len() - length);
            let ends = [lower, lower + length];
            let [begin, end] = if below(random, 2) == 0 { ends } else { [ends[1], ends[0]] };
            let (begin, end) = (&walk[begin], &walk[end]);
            let Some(solver) = begin.solver else { continue };
            let mut tracker = solver.tracker();
            S::step(&mut tracker, begin.theta, unit).expect("the walk was there");
            let degrees = step.to_degrees() * length as f64;
            let step = format!(
                "{} × {unit:e}, ε = {:e}, {} to {} ({degrees}°)",
                S::NAME,
                S::Number::EPSILON,
                begin.theta,
                end.theta,
            );
            compared += 1;
            match S::step(&mut tracker, end.theta, unit) {
                Ok(row) => assert!(
                    !differ(&row, &end.row, allowed::<S>()),
                    "{step}: {row:?} for {:?}",
                    end.row
                ),
                Err(error) => {
                    assert!(degrees > 90.0, "{step}: {error}");
                    refused += 1;
                }
            }
        }
    }
    assert!(compared >= pairs / 2, "{} of {pairs} compared", compared);
    [compared, refused]
}

/// Ten to the nine smaller, as built, ten to the nine larger.
const UNITS: [f64; 3] = [1e-9, 1.0, 1e9];

fn all_sizes<S64: Stepped, S32: Stepped>(pairs: usize) {
    let mut random = Random::new(13);
    let (mut compared, mut refused) = (0, 0);
    for (nth, unit) in UNITS.into_iter().enumerate() {
        // Few steps are of one width a size: a walk takes longer than they do.
        let widths = if pairs > 100 { [true, true] } else { [nth != 1, nth == 1] };
        for (is_double, _) in
            [true, false].into_iter().zip(widths).filter(|&(_, is_asked)| is_asked)
        {
            let [of_width, without_answer] = match is_double {
                true => compare::<S64>(unit, pairs, &mut random),
                false => compare::<S32>(unit, pairs, &mut random),
            };
            compared += of_width;
            refused += without_answer;
        }
    }
    assert!(100 * refused <= compared, "{}: {refused} of {compared} refused", S64::NAME);
}

/// The bars of the parallelogram crossed.
#[derive(Clone, Copy)]
struct Anti<T>(ScaledPairs<T>);

impl<T: Float> Stepped for Anti<T> {
    type Number = T;
    type Tracker = Tracker<ScaledPairs<T>>;
    const NAME: &'static str = "Anti";

    fn of_size(unit: f64) -> Self {
        Self(ScaledPairs { elbow: Side::Right, ..ScaledPairs::of_size(unit) })
    }
    fn tracker(self) -> Self::Tracker {
        self.0.tracker()
    }
    fn solver(tracker: &Self::Tracker) -> Self {
        Self(*tracker.solver())
    }
    fn step(tracker: &mut Self::Tracker, theta: f64, unit: f64) -> Result<Row, SolveError> {
        ScaledPairs::step(tracker, theta, unit)
    }
}

/// Some five hundred pairs (twins take the longest and have few) of all mechanisms, sizes and widths together in an ordinary run, and a hundred
/// thousand of each mechanism where they are asked for.
macro_rules! steps {
    ($($name:ident, $all:ident: $solver:ident $pairs:expr;)*) => {$(
        #[test]
        fn $name() {
            all_sizes::<$solver<f64>, $solver<f32>>($pairs);
        }

        #[test]
        #[ignore = "a thousand times as many steps, minutes without optimisation"]
        fn $all() {
            all_sizes::<$solver<f64>, $solver<f32>>(100_000 / 6);
        }
    )*};
}

steps! {
    a_parallelogram_steps, a_parallelogram_steps_everywhere: ScaledPairs 20;
    an_antiparallelogram_steps, an_antiparallelogram_steps_everywhere: Anti 20;
    a_four_bar_steps, a_four_bar_steps_everywhere: ScaledFourBar 20;
    a_slider_crank_steps, a_slider_crank_steps_everywhere: ScaledSliderCrank 20;
    a_kite_steps, a_kite_steps_everywhere: ScaledKite 20;
    a_block_over_its_pivot_steps, a_block_over_its_pivot_steps_everywhere: ScaledPivot 20;
    a_block_with_an_offset_steps, a_block_with_an_offset_steps_everywhere: ScaledOffset 20;
    a_chain_steps, a_chain_steps_everywhere: ScaledChain 20;
    twins_step, twins_step_everywhere: ScaledTwins cases(8, 20);
}
