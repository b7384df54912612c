//! Every entry point of one mechanism, called at one state after the other.

use linkage_core::SolveError;

use super::calls::{At, Calls};
use super::numbers::{Number, Source};
use super::state::{Kind, State, any};
use super::truth::{Motion, error};

/// A mechanism as this program calls it, with `N` inputs and `P` numeric parameters.
pub(crate) trait Fuzzed<const N: usize, const P: usize>: Motion<N, P> {
    const NAME: &'static str;
    const DEFAULTS: [f64; P];
    /// The operations of one motion: how often it rounds at most.
    const OPERATIONS: f64;

    fn position<T: Number>(state: &State<T, N, P>) -> Result<(), SolveError>;

    /// Calls everything at one state, and gives the motions that were found, row by row.
    fn call<T: Number>(state: &State<T, N, P>, at: &mut At<'_>) -> Vec<Found<T>>;

    /// Sweeps over the states, with the parameters and modes of the first.
    fn sweep<T: Number>(states: &[State<T, N, P>], at: &mut At<'_>);

    /// Follows the states, with the parameters and modes of the first.
    fn track<T: Number>(states: &[State<T, N, P>], at: &mut At<'_>);
}

/// A motion, the entry point that found it, and how often that may round for each operation.
pub(crate) struct Found<T> {
    pub(crate) entry: &'static str,
    pub(crate) rows: Vec<T>,
    pub(crate) share: f64,
}

/// One state in so many that might be meant is compared with numbers of twice the width, which
/// takes as long as some hundred calls.
const COMPARED: usize = 8;
/// The count of states in a sweep, and in a path that a tracker follows.
const POSES: usize = 24;

/// Calls everything until about so many calls have been made.
pub(crate) fn fuzz<M: Fuzzed<N, P>, T: Number, const N: usize, const P: usize>(
    source: &mut Source,
    until: u64,
    calls: &mut Calls,
) {
    let end = calls.count + until;
    while calls.count < end {
        let mut states = Vec::with_capacity(POSES);
        for _ in 0..POSES {
            let (kind, state) = any(source, &M::DEFAULTS, M::position);
            let mut at = At { calls, mechanism: M::NAME, state: &(kind, state) };
            let found = M::call(&state, &mut at);
            let is_meant = matches!(kind, Kind::Sane | Kind::AtLimit);
            if is_meant && source.below(COMPARED) == 0 {
                compare::<M, T, N, P>(&state, &found, &mut at);
            }
            states.push(state);
        }
        let mut at = At { calls, mechanism: M::NAME, state: &states[0] };
        M::sweep(&states, &mut at);
        let mut at = At { calls, mechanism: M::NAME, state: &states };
        M::track(&states, &mut at);
    }
}

fn compare<M: Fuzzed<N, P>, T: Number, const N: usize, const P: usize>(
    state: &State<T, N, P>,
    found: &[Found<T>],
    at: &mut At<'_>,
) {
    for Found { entry, rows, share } in found {
        let Some(worst) = error::<M, T, N, P>(state, rows) else { return };
        let worst = worst / share;
        if worst > M::OPERATIONS || worst.is_nan() {
            at.wrong(entry, "wrong", &(worst, rows));
        }
        let name = format!("{}::{entry} in {}", M::NAME, T::NAME);
        let known = at.calls.worst.entry(name).or_default();
        *known = known.max(worst);
    }
}

/// True if the derivatives are those of a pose next to a limit, not on it. Derivatives in closed form and
/// those by dual numbers round the joints separately, so one pose may lie on the limit for the first and a
/// few units inside for the second. At n units inside, a height is √(2 n ε) of the lengths, and a derivative
/// by it is the inverse of that. On the limit no derivative exists, and what a formula gives is no larger
/// than the lengths' ratios. The bound between the two is n = 512.
pub(crate) fn next_to_a_limit<T: Number>(derivatives: &[T]) -> bool {
    let large = 1.0 / (1024.0 * T::EPSILON).sqrt();
    derivatives.iter().any(|derivative| derivative.value().abs() >= large)
}

/// A single input is given as itself, several as a list.
macro_rules! given {
    (one $list:expr) => {
        $list[0]
    };
    (many $list:expr) => {
        $list
    };
}

/// Calls the entry points that every mechanism has at a state, the answer to `position` being known;
/// gives that to `motion`.
macro_rules! answers {
    ($at:ident, $solver:expr, $position:expr, $q:expr, $rate:expr, $second:expr) => {{
        let (solver, position) = (&$solver, $position);
        let (q, rate, second) = ($q, $rate, $second);
        let position = $at.answer("position", position.map(|p| p.rows()));
        let (p, ok) = solver.solve_position(q);
        $at.straight("solve_position", (p.rows(), ok), position.as_ref());

        let velocity = solver.velocity(q, rate).map(|v| v.rows());
        let velocity = $at.answer("velocity", velocity);
        let (v, ok) = solver.solve_velocity(q, rate);
        $at.straight("solve_velocity", (v.rows(), ok), velocity.as_ref());

        let motion = solver.motion(q, rate, second).map(|m| rows!(m));
        let motion = $at.answer("motion", motion);
        let (m, ok) = solver.solve_motion(q, rate, second);
        $at.straight("solve_motion", (rows!(m), ok), motion.as_ref());

        let coefficients = solver.coefficients(q).map(|c| c.concat());
        let is_singular = matches!(coefficients, Err(SolveError::Singular { .. }));
        let coefficients = $at.answer("coefficients", coefficients);
        let (c, ok) = solver.solve_coefficients(q);
        $at.straight("solve_coefficients", (c.concat(), ok), coefficients.as_ref());

        let jacobian = solver.jacobian(q).map(|j| j.as_slice().to_vec());
        if is_singular
            && !jacobian.as_ref().map_or(true, |rows| $crate::mechanism::next_to_a_limit(rows))
        {
            $at.wrong("jacobian", "Ok, where coefficients are Singular", &jacobian);
        }
        $at.answer("jacobian", jacobian);
        motion
    }};
}

/// The rows of a motion, one order behind the other.
macro_rules! rows {
    ($motion:expr) => {{
        let m = $motion;
        [&m.position.rows()[..], &m.velocity.rows(), &m.acceleration.rows()].concat()
    }};
}

/// The facts of a declaration that this program needs. They are its counts of inputs and numeric parameters,
/// the names of its mode parameters and margins, and the links whose directions are outputs. `circle` marks a
/// declaration whose only input may be given by its cosine and sine. Behind `as` stands a declaration of the
/// same mechanism with other formulas, which is taken for right. Behind `=>` stands a test of positions, for
/// a mechanism that cannot be computed on numbers of twice the width.
macro_rules! fuzzed {
    ($($name:ident: $inputs:literal $count:ident, $params:literal($($param:ident)*),
        modes($($mode:ident)*), units($($link:ident)*),
        margins($($margin:ident)*) $(, $circle:ident)? $(as $twin:ident)?
        $(=> $is_right:ident)?;)*) => {$(
        const _: () = {
            solver!(solver: $name, $inputs, $params($($param)*), ($($mode)*));
            solver!(true_solver: $name $($twin)?, $inputs, $params($($param)*), ($($mode)*));

            impl Motion<$inputs, $params> for $name {
                const OUTPUTS: &'static [&'static str] = &$name::OUTPUTS;

                fn motion<S: Scalar<Mask = bool>>(
                    state: &State<S, $inputs, $params>,
                ) -> Option<Vec<S>> {
                    let State { q, rate, second, .. } = *state;
                    let given = (given!($count q), given!($count rate), given!($count second));
                    truth!(true_solver(state), given $(, $is_right)?)
                }
            }

            impl Fuzzed<$inputs, $params> for $name {
                const NAME: &'static str = stringify!($name);
                const DEFAULTS: [f64; $params] = {
                    let _solver = $name::new();
                    [$(_solver.$param),*]
                };
                const OPERATIONS: f64 = $name::COST.motion.total() as f64;

                fn position<T: Number>(
                    state: &State<T, $inputs, $params>,
                ) -> Result<(), SolveError> {
                    solver(state).position(given!($count state.q)).map(|_| ())
                }

                fn call<T: Number>(
                    state: &State<T, $inputs, $params>,
                    at: &mut At<'_>,
                ) -> Vec<Found<T>> {
                    let solver = solver(state);
                    let q = given!($count state.q);
                    let (rate, second) = (given!($count state.rate), given!($count state.second));

                    let position = solver.position(q);
                    $(at.alike("position", &position, &$twin::<T>::position(&true_solver(state), q));)?
                    if let Ok(_position) = &position {
                        $(if !$is_right(state, _position) {
                            at.wrong("position", "not right", _position);
                        })?
                        $(at.unit("position", [_position.$link.cos, _position.$link.sin]);)*
                    }
                    let motion = answers!(at, solver, position, q, rate, second);
                    sensitivity!(at, solver, q, $($param)*);
                    margins!(at, solver, q, $($margin)*);

                    #[allow(unused_mut, reason = "not every mechanism has more to add")]
                    let mut found: Vec<_> = motion.map(|rows| Found { entry: "motion", rows, share: 1.0 })
                        .into_iter().collect();
                    $(found.extend($circle!(at, solver, state));)?
                    found
                }

                fn sweep<T: Number>(states: &[State<T, $inputs, $params>], at: &mut At<'_>) {
                    let solver = solver(&states[0]);
                    let poses: Vec<_> = states.iter().map(|s| s.q).collect();
                    let singles: Vec<_> =
                        poses.iter().map(|&q| solver.position(given!($count q))).collect();
                    at.sweep::<OfPosition, _, _, _, _, _>("sweep_position", &solver, &poses, &singles);
                    let poses: Vec<[T; 2 * $inputs]> = states.iter()
                        .map(|s| [s.q, s.rate].concat().try_into().expect("two orders")).collect();
                    let singles: Vec<_> = states.iter().map(|s| {
                        solver.velocity(given!($count s.q), given!($count s.rate))
                    }).collect();
                    at.sweep::<OfVelocity, _, _, _, _, _>("sweep_velocity", &solver, &poses, &singles);
                    let poses: Vec<[T; 3 * $inputs]> = states.iter()
                        .map(|s| [s.q, s.rate, s.second].concat().try_into().expect("three orders"))
                        .collect();
                    let singles: Vec<_> = states.iter().map(|s| {
                        let (rate, second) = (given!($count s.rate), given!($count s.second));
                        solver.motion(given!($count s.q), rate, second)
                    }).collect();
                    at.sweep::<OfMotion, _, _, _, _, _>("sweep_motion", &solver, &poses, &singles);
                }

                fn track<T: Number>(states: &[State<T, $inputs, $params>], at: &mut At<'_>) {
                    let mut tracker = Tracker::new(solver(&states[0]));
                    for state in states {
                        let q = given!($count state.q);
                        let (rate, second) =
                            (given!($count state.rate), given!($count state.second));
                        let motion = tracker.motion(q, rate, second);
                        at.answer("Tracker::motion", motion.map(|m| rows!(m)));
                        at.answer("Tracker::position", tracker.position(q).map(|p| p.rows()));
                    }
                }
            }
        };
    )*

        /// So many calls of all of them, as many of each.
        pub(crate) fn run<T: Number>(source: &mut Source, count: u64, calls: &mut Calls) {
            let mechanisms = [$($name::<f64>::NAME),*].len() as u64;
            $(fuzz::<$name, T, $inputs, $params>(source, count / mechanisms, calls);)*
        }
    };
}

/// A function that makes a declaration's solver with the numbers of a state; its twin's, if it has one.
macro_rules! solver {
    ($solver:ident: $name:ident $twin:ident, $($rest:tt)*) => {
        solver!($solver: $twin, $($rest)*);
    };
    ($solver:ident: $name:ident, $inputs:literal, $params:literal($($param:ident)*),
        ($($mode:ident)*)) => {
        fn $solver<S: Scalar>(state: &State<S, $inputs, $params>) -> $name<S> {
            let [$($param),*] = state.params;
            let solver = $name::<S> { $($param,)* ..$name::<S>::default() };
            if state.flipped {
                $(let $mode = solver.$mode.flipped();)*
                return $name { $($mode,)* ..solver };
            }
            solver
        }
    };
}

/// The motion that every number can compute; nothing of a mechanism that searches.
macro_rules! truth {
    ($solver:expr, $given:ident) => {{
        let (motion, ok) = $solver.solve_motion($given.0, $given.1, $given.2);
        ok.then(|| rows!(motion))
    }};
    ($solver:expr, $given:ident, $is_right:ident) => {{
        let _ = ($solver, $given);
        None
    }};
}

/// A mechanism without numeric parameters has no sensitivities.
macro_rules! sensitivity {
    ($at:ident, $solver:ident, $q:ident,) => {};
    ($at:ident, $solver:ident, $q:ident, $($param:ident)+) => {
        let sensitivity = $solver.sensitivity($q).map(|s| s.as_slice().to_vec());
        $at.answer("sensitivity", sensitivity);
    };
}

macro_rules! margins {
    ($at:ident, $solver:ident, $q:ident,) => {};
    ($at:ident, $solver:ident, $q:ident, $($margin:ident)+) => {
        $at.answer("margins", $solver.margins($q).map(|m| [$(m.$margin),+]));
    };
}

/// The entry points on cosine and sine: with odd numbers, and with what a resolver gives for the
/// angle, at an amplitude that is nearly one.
macro_rules! circle {
    ($at:ident, $solver:ident, $state:ident) => {{
        let (q, rate, second) = ($state.q[0], $state.rate[0], $state.second[0]);
        for (cos, sin) in [(q, second), (rate, q)] {
            $at.answer("position_at", $solver.position_at(cos, sin).map(|p| p.rows()));
            $at.answer("velocity_at", $solver.velocity_at(cos, sin, rate).map(|v| v.rows()));
            $at.answer("motion_at", $solver.motion_at(cos, sin, rate, second).map(|m| rows!(m)));
        }
        let (sin, cos) = q.sin_cos();
        let amplitude = T::near(1.0 + 0.03 * (q.value() * 1e3).sin());
        let (cos, sin) = (amplitude * cos, amplitude * sin);
        $at.answer("position_at", $solver.position_at(cos, sin).map(|p| p.rows()));
        $at.answer("velocity_at", $solver.velocity_at(cos, sin, rate).map(|v| v.rows()));
        let motion = $solver.motion_at(cos, sin, rate, second).map(|m| rows!(m));
        let rows = $at.answer("motion_at", motion);
        // The angle is wrong by a unit of 1 rad: four times what the data allow one of 1/4 rad.
        let is_far = q.value().abs() > 0.25;
        rows.filter(|_| is_far).map(|rows| Found { entry: "motion_at", rows, share: 4.0 })
    }};
}
