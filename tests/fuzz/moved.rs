//! Motions under forces of mechanisms with one, two and three inputs, next to singular mass matrices and
//! through change points: accelerations that are right, or a typed error.

use core::f64::consts::PI;

use linkage_core::private::OfForwardDynamics;
use linkage_core::{Scalar, Side, SolveError, Tracker};
use linkage_tests::mechanisms::change_points::HeavyParallelogram;
use linkage_tests::mechanisms::dynamics::*;
use linkage_tests::mechanisms::singular_arms::*;

use super::calls::{At, Calls};
use super::numbers::{Number, Source};
use super::state::{Kind, State, any};
use super::truth::{Motion, error};

/// A mechanism that moves under forces; the accelerations of a state stand for the drives.
trait Moved<const N: usize, const P: usize>: Motion<N, P> {
    const NAME: &'static str;
    const DEFAULTS: [f64; P];
    /// The name of the joint that the last input bends, if the mechanism is an arm.
    const ELBOWS: &'static [&'static str];
    /// The operations of one acceleration.
    const OPERATIONS: f64;

    fn position<T: Number>(state: &State<T, N, P>) -> Result<(), SolveError>;

    /// Calls everything at one state, and gives the accelerations.
    fn call<T: Number>(state: &State<T, N, P>, at: &mut At<'_>) -> Option<Vec<T>>;

    /// Sweeps over the states, with the parameters of the first.
    fn sweep<T: Number>(states: &[State<T, N, P>], at: &mut At<'_>);
}

/// The worst ratio of the squares in a row of the mass matrix to the row's pivot: an elimination multiplies
/// their rounding by it. The squares are the largest diagonal element, here or at a place of the last input
/// where no square is subtracted.
fn loss<const N: usize>(q: [f64; N], mass: impl Fn([f64; N]) -> [[f64; N]; N]) -> f64 {
    let mut rest = mass(q);
    let mut squares: [f64; N] = core::array::from_fn(|i| rest[i][i]);
    for last in [0.0, 0.5, 1.0] {
        let mut turned = q;
        turned[N - 1] = PI * last;
        let there = mass(turned);
        (0..N).for_each(|i| squares[i] = squares[i].max(there[i][i]));
    }
    let mut worst = 0.0_f64;
    for pivot in 0..N {
        worst = worst.max(squares[pivot] / rest[pivot][pivot]);
        for row in pivot + 1..N {
            let factor = rest[row][pivot] / rest[pivot][pivot];
            (pivot..N).for_each(|column| rest[row][column] -= factor * rest[pivot][column]);
        }
    }
    if N == 1 { 0.0 } else { worst }
}

const POSES: usize = 24;
const COMPARED: usize = 8;

fn fuzz<M: Moved<N, P>, T: Number, const N: usize, const P: usize>(
    source: &mut Source,
    until: u64,
    calls: &mut Calls,
) {
    let end = calls.count + until;
    while calls.count < end {
        let mut states = Vec::with_capacity(POSES);
        for _ in 0..POSES {
            let (kind, mut state) = any(source, &M::DEFAULTS, M::position);
            // Two bars that are stretched, or nearly.
            if !M::ELBOWS.is_empty() && source.below(4) == 0 {
                let bend = 10.0_f64.powf(source.between(-17.0, 0.0));
                state.q[N - 1] = T::near(if source.below(2) == 0 { bend } else { -bend });
            }
            let mut at = At { calls, mechanism: M::NAME, state: &(kind, state) };
            let found = M::call(&state, &mut at);
            // Next to a limit the masses of several inputs are nearly those of one, and what rounding does to
            // their difference is not counted here.
            let is_meant = kind == Kind::Sane || (kind == Kind::AtLimit && N == 1);
            if let Some(found) = found.filter(|_| is_meant && source.below(COMPARED) == 0)
                && let Some(worst) = error::<M, T, N, P>(&state, &found)
            {
                if worst > M::OPERATIONS || worst.is_nan() {
                    at.wrong("forward_dynamics", "wrong", &(worst, found));
                }
                let name = format!("{}::forward_dynamics in {}", M::NAME, T::NAME);
                let known = at.calls.worst.entry(name).or_default();
                *known = known.max(worst);
            }
            states.push(state);
        }
        let mut at = At { calls, mechanism: M::NAME, state: &states[0] };
        M::sweep(&states, &mut at);
    }
}

/// The value of one input, or the values of several, as a list.
macro_rules! list {
    (one $given:expr) => {
        [$given]
    };
    (many $given:expr) => {
        $given
    };
}

/// The facts of a declaration that this program needs: its counts of inputs and numeric parameters, and the
/// joint that its last input bends if it is an arm.
macro_rules! moved {
    ($($name:ident: $inputs:literal $count:ident, $params:literal($($param:ident)*)
        $(, $elbow:ident)?;)*) => {$(
        const _: () = {
            solver!(solver: $name, $inputs, $params($($param)*), ());

            impl Motion<$inputs, $params> for $name {
                const OUTPUTS: &'static [&'static str] = &$name::INPUTS;
                // A rounding of a pin's coordinates is one of its angle, by as much larger as they are longer
                // than the crank: four times at most.
                const LEAST: f64 = 4.0;

                fn motion<S: Scalar<Mask = bool>>(
                    state: &State<S, $inputs, $params>,
                ) -> Option<Vec<S>> {
                    let State { q, rate, second, .. } = *state;
                    let (found, ok) = solver(state).solve_forward_dynamics(
                        given!($count q),
                        given!($count rate),
                        given!($count second),
                    );
                    ok.then(|| list!($count found).to_vec())
                }

                fn loss(state: &State<f64, $inputs, $params>) -> f64 {
                    let mass = |q: [f64; $inputs]| {
                        let rate = given!($count state.rate);
                        solver(state).solve_equations_of_motion(given!($count q), rate).0.mass
                    };
                    loss(state.q, mass)
                }
            }

            impl Moved<$inputs, $params> for $name {
                const NAME: &'static str = stringify!($name);
                const ELBOWS: &'static [&'static str] = &[$(stringify!($elbow))?];
                const DEFAULTS: [f64; $params] = {
                    let _solver = $name::new();
                    [$(_solver.$param),*]
                };
                const OPERATIONS: f64 = $name::COST.forward_dynamics.total() as f64;

                fn position<T: Number>(
                    state: &State<T, $inputs, $params>,
                ) -> Result<(), SolveError> {
                    solver(state).position(given!($count state.q)).map(|_| ())
                }

                fn call<T: Number>(
                    state: &State<T, $inputs, $params>,
                    at: &mut At<'_>,
                ) -> Option<Vec<T>> {
                    let solver = solver(state);
                    let State { q, rate, second, .. } = *state;
                    let (q, rate, drive) =
                        (given!($count q), given!($count rate), given!($count second));
                    let found = solver.forward_dynamics(q, rate, drive).map(|a| list!($count a));
                    let found = at.answer("forward_dynamics", found);
                    let (straight, ok) = solver.solve_forward_dynamics(q, rate, drive);
                    at.straight("solve_forward_dynamics", (list!($count straight), ok), found.as_ref());
                    let both: [T; 2 * $inputs] =
                        [state.q, state.rate].concat().try_into().expect("two orders");
                    let rates = at.answer("state_rates", solver.state_rates(both, drive));
                    let seconds = rates.map(|rates| rates[$inputs..].to_vec());
                    // Rates that are no numbers are part of the one answer alone.
                    let is_moving = state.rate.iter().all(|rate| rate.is_finite());
                    let seen = found.as_ref().filter(|_| is_moving).map(|found| &found[..]);
                    if seconds.as_deref() != seen {
                        at.wrong("state_rates", "not the accelerations", &(seconds, found));
                    }
                    let equations = solver.equations_of_motion(q, rate);
                    let equations = equations.map(|e| [&e.mass.concat()[..], &e.force].concat());
                    at.answer("equations_of_motion", equations);
                    found.map(|found| found.to_vec())
                }

                fn sweep<T: Number>(states: &[State<T, $inputs, $params>], at: &mut At<'_>) {
                    let solver = solver(&states[0]);
                    let poses: Vec<[T; 3 * $inputs]> = states.iter()
                        .map(|s| [s.q, s.rate, s.second].concat().try_into().expect("three orders"))
                        .collect();
                    let singles: Vec<_> = states.iter().map(|s| {
                        solver.forward_dynamics(
                            given!($count s.q), given!($count s.rate), given!($count s.second),
                        )
                    }).collect();
                    at.sweep::<OfForwardDynamics, _, _, _, _, _>(
                        "sweep_forward_dynamics", &solver, &poses, &singles,
                    );
                }
            }
        };
    )*

        /// So many calls of all of them, as many of each.
        pub(crate) fn run<T: Number>(source: &mut Source, count: u64, calls: &mut Calls) {
            let mechanisms = [$(<$name as Moved<$inputs, $params>>::NAME),*].len() as u64 + 1;
            $(fuzz::<$name, T, $inputs, $params>(source, count / mechanisms, calls);)*
            followed::<T>(source, count / mechanisms, calls);
        }
    };
}

moved! {
    Squeezer: 1 one, 0();
    RockerDriven: 1 one, 0();
    HeavyRobot: 2 many, 0();
    TiltedLift: 2 many, 0();
    ElbowArm: 2 many, 1(wrist), elbow;
    GearedArm: 3 many, 0();
    CartArm: 3 many, 2(hand cart_mass), elbow;
}

/// The largest angle, rate and drive at which accelerations are compared with the pendulum's.
const LARGEST: f64 = 100.0;

/// A parallelogram whose crank is a pendulum, followed from anywhere to anywhere.
fn followed<T: Number>(source: &mut Source, until: u64, calls: &mut Calls) {
    let end = calls.count + until;
    // At a distance of w = √(4e-3) (`f32`: √(9.6e-3)) from a change point the rounding of an acceleration
    // is some 16 ε/w³ v², and an interpolation's as many times as its weights.
    let width: f64 = if T::HALF_UNIT < 1e-10 { 4e-3 } else { 9.6e-3 };
    let share = 8.0 * 16.0 * 2.0 * T::HALF_UNIT / width.powf(1.5);
    while calls.count < end {
        // Clear of the change points at 0 and π.
        let start = source.between(0.1, PI - 0.1) - if source.below(2) == 0 { PI } else { 0.0 };
        let elbow = if start > 0.0 { Side::Left } else { Side::Right };
        let solver = HeavyParallelogram::<T> { elbow, ..Default::default() };
        let mut tracker = Tracker::new(solver);
        tracker.position(T::near(start)).expect("a parallelogram turns fully");
        for _ in 0..POSES {
            let (kind, state): (Kind, State<T, 1, 0>) = any(source, &[], |_| Ok(()));
            let [q, rate, drive] = [state.q[0], state.rate[0], state.second[0]];
            let mut at = At {
                calls,
                mechanism: "Tracker<HeavyParallelogram>",
                state: &(start, kind, state),
            };
            let found =
                tracker.follow(q, rate, |solver, q| solver.forward_dynamics(q, rate, drive));
            let Some([found]) = at.answer("follow", found.map(|a| [a])) else { continue };
            let numbers = [q, rate, drive].map(|number| number.value());
            if numbers.iter().all(|number| number.abs() <= LARGEST) {
                let [q, v, drive] = numbers;
                let exact = (drive - 3.0 * 9.81 * q.cos()) * 3.0 / 8.0;
                let allowed = share * (v * v + exact.abs() + 12.0);
                if (found.value() - exact).abs() > allowed {
                    at.wrong("follow", "not the pendulum's", &(found, exact, allowed));
                }
            }
        }
    }
}
