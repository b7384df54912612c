//! A mechanism with unknowns. What is right is told by its equations: numbers of twice the width
//! search nothing.

use linkage_core::private::{OfMotion, OfPosition, OfVelocity};
use linkage_core::{Scalar, SolveError, Tracker, mechanism};

use super::calls::{At, Calls};
use super::mechanism::{Found, Fuzzed, fuzz};
use super::numbers::{Number, Source};
use super::state::State;
use super::truth::Motion;

mechanism! {
    /// A ram between the dead points of its crank, whose search has a seed, and a follower whose
    /// bracket overhangs one.
    pub struct Searched {
        input x, h: length;
        param r = 1m;
        param rod = 2.5m;
        param seed: near = 1rad;

        ground A(0, 0), D(4m, 0);
        guide bed through (0, 0) along 0deg;
        guide post through (5m, 0) along 90deg;

        unknown theta: angle between (0, 180deg);
        crank AB(A) -> B           { length: r, angle: theta }
        rrp   BC(B), ram(bed) -> C { length: rod, mode: ahead }
        solve theta { ram.slide = x, mode: falling, near: seed }

        unknown phi: angle between (-90deg, 90deg);
        crank DE(D) -> E { length: 1m, angle: phi }
        rrp   EF(E), block(post) -> F { length: 4m, mode: ahead }
        solve phi { block.slide = h, mode: rising }

        output theta, phi, AB, C, F, BC, BC.margin;
    }
}

type Given<T> = State<T, 2, 3>;

fn solver<S: Scalar>(state: &Given<S>) -> Searched<S> {
    let [r, rod, seed] = state.params;
    Searched { r, rod, seed }
}

impl Motion<2, 3> for Searched {
    const OUTPUTS: &'static [&'static str] = &Searched::OUTPUTS;

    fn motion<S: Scalar<Mask = bool>>(_: &Given<S>) -> Option<Vec<S>> {
        None
    }
}

/// The equations of a pose: what each misses, and what its sides are made of.
fn missed<T: Number>(state: &Given<T>, p: SearchedPosition<T>) -> [[f64; 2]; 2] {
    let [x, h] = state.q.map(|q| q.value());
    let sizes = [state.params[0].value().abs() + state.params[1].value().abs(), 5.0];
    [[p.C.x.value() - x, x.abs() + sizes[0]], [p.F.y.value() - h, h.abs() + sizes[1]]]
}

impl Fuzzed<2, 3> for Searched {
    const NAME: &'static str = "Searched";
    const DEFAULTS: [f64; 3] = {
        let solver = Searched::new();
        [solver.r, solver.rod, solver.seed]
    };
    const OPERATIONS: f64 = Searched::COST.motion.total() as f64;

    fn position<T: Number>(state: &Given<T>) -> Result<(), SolveError> {
        solver(state).position(state.q).map(|_| ())
    }

    fn call<T: Number>(state: &Given<T>, at: &mut At<'_>) -> Vec<Found<T>> {
        let (solver, State { q, rate, second, .. }) = (solver(state), *state);
        let position = solver.position(q);
        if let Ok(p) = &position {
            at.unit("position", [p.AB.cos, p.AB.sin]);
            for [miss, size] in missed(state, *p) {
                // A place of half a last place, and the rounding of a dozen operations.
                if miss.abs() > 64.0 * T::HALF_UNIT * size {
                    at.wrong("position", "an equation that is open", &(miss, size));
                }
            }
        }
        answers!(at, solver, position, q, rate, second);
        at.answer("sensitivity", solver.sensitivity(q).map(|s| s.as_slice().to_vec()));
        at.answer("margins", solver.margins(q).map(|m| [m.BC_margin]));
        Vec::new()
    }

    fn sweep<T: Number>(states: &[Given<T>], at: &mut At<'_>) {
        let solver = solver(&states[0]);
        let poses: Vec<_> = states.iter().map(|s| s.q).collect();
        let singles: Vec<_> = poses.iter().map(|&q| solver.position(q).map(|_| ())).collect();
        at.sweep::<OfPosition, _, _, _, _>("sweep_position", &solver, &poses, &singles);
        let poses: Vec<[T; 4]> =
            states.iter().map(|s| [s.q, s.rate].concat().try_into().expect("two orders")).collect();
        let singles: Vec<_> =
            states.iter().map(|s| solver.velocity(s.q, s.rate).map(|_| ())).collect();
        at.sweep::<OfVelocity, _, _, _, _>("sweep_velocity", &solver, &poses, &singles);
        let poses: Vec<[T; 6]> = states
            .iter()
            .map(|s| [s.q, s.rate, s.second].concat().try_into().expect("three orders"))
            .collect();
        let singles: Vec<_> =
            states.iter().map(|s| solver.motion(s.q, s.rate, s.second).map(|_| ())).collect();
        at.sweep::<OfMotion, _, _, _, _>("sweep_motion", &solver, &poses, &singles);
    }

    fn track<T: Number>(states: &[Given<T>], at: &mut At<'_>) {
        let mut tracker = Tracker::new(solver(&states[0]));
        for state in states {
            let motion = tracker.motion(state.q, state.rate, state.second);
            at.answer("Tracker::motion", motion.map(|m| m.position.theta).map(|theta| [theta]));
            let position = tracker.position(state.q);
            at.answer("Tracker::position", position.map(|p| [p.theta, p.phi, p.C.x, p.F.y]));
        }
    }
}

/// So many calls.
pub(crate) fn run<T: Number>(source: &mut Source, count: u64, calls: &mut Calls) {
    fuzz::<Searched, T, 2, 3>(source, count, calls);
}
