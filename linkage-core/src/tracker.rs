//! Following a motion through its change points.
//!
//! A solver keeps its assembly modes: at a change point, where a group's joints lie on one line,
//! a parallelogram whose mode is constant turns into an antiparallelogram. A [`Tracker`] keeps the
//! motion instead and lets the modes change, so that velocities stay continuous.
//!
//! A change point is recognised by a smooth function: the value under the square root of the group's height
//! touches zero and turns back, while at a dead end it passes through zero. Between one call and
//! the next the tracker follows these values along the straight line from input to input, so it
//! does not matter whether a sample falls on the change point, next to it, or far on either side.
//! That none is missed is proved stretch by stretch, by ranges that hold all that the values and
//! their velocities and accelerations can be between two inputs.
//!
//! This module contains no formula of a group: generated code gives the clearance of each group
//! ([`Solver`]).

mod affine_form;
mod around;
mod line;
mod linear;
mod passage;
mod stretch;
mod thresholds;

pub(crate) use affine_form::AffineForm;

use linear::Linear;
use passage::Passage;
use thresholds::{Thresholds, Zone};

use crate::solver::Solver;
use crate::{Record, Scalar, SolveError};

/// A solver that follows its motion: each pose continues the one before.
///
/// The modes that can change are those that the declaration makes parameters
/// (`param elbow: mode = left;`). The first pose has the modes of the solver it is made from; if
/// that pose lies on a change point, they are those of the poses to come at the given rates.
///
/// ```
/// use linkage_core::{mechanism, Tracker};
///
/// mechanism! {
///     struct Parallelogram {
///         input theta: angle;
///         param elbow: mode = left;
///         ground A(0, 0), D(2m, 0);
///         crank AB(A) -> B        { length: 1m, angle: theta }
///         rrr   BC(B), DC(D) -> C { lengths: (2m, 1m), mode: elbow }
///     }
/// }
///
/// let mut tracker = Tracker::new(Parallelogram::new());
/// for step in 0..=40 {
///     // A sample falls on the change point at half a turn.
///     let theta = core::f64::consts::PI * (0.5 + f64::from(step) / 20.0);
///     let motion = tracker.motion(theta, 3.0, 0.0)?;
///     assert!((motion.velocity.DC.omega - 3.0).abs() < 1e-9);
/// }
/// # Ok::<(), linkage_core::SolveError>(())
/// ```
///
/// # What is promised
/// From one call to the next the inputs are taken to move along the straight line between them, one
/// step of any length; whatever change points lie on it, the modes in the end are those to which
/// the motion leads, or there is an error. A step is looked at as a whole first. If a group comes
/// close to its limit, or ranges are too wide to tell, the step is followed in stretches of which
/// everything can be proved, at most 16,384 of them; and as many again for each of eight poses around
/// a change point from which the result is interpolated, or sixteen by [`follow`](Self::follow) (up to
/// four times, where the motion does not go on so far or bends too much). So the work differs from call to
/// call, as that of an unknown and of friction does; there is no heap, and no panic.
///
/// # What is refused
/// - A step on which the motion ends, even if there is a pose at its end: as `OutOfReach` or
///   `Singular`.
/// - A step on which no number of stretches tells what happens, as `Singular`: a group that stays at
///   its limit, or comes to it so softly that its height touches zero to the fourth order.
/// - A change point of a group whose mode is a constant of the declaration, or shared with a group
///   that does not change: as `Singular`.
/// - What leaves the range of numbers, on the way or in the result: as `NotFinite`.
///
/// # Beside an unknown
/// A searched unknown (`solve`) is a group as well: it comes to its limit at a dead point of its equation,
/// where two roots meet, and its mode is the sign of the slope, `rising` or `falling`. On every stretch
/// it is proved that one root continues, and that it is the one found at both ends of it. Where the root
/// leaves its interval the motion ends. Where it only touches an end, the continuation is undetermined and
/// the error is `Singular`. The same holds where a group that the equation contains changes its mode.
///
/// ```
/// use linkage_core::{Tracker, find::Trend, mechanism};
///
/// mechanism! {
///     /// A ram that goes where its twin goes.
///     struct Twins {
///         input turn: angle;
///         param way: mode = falling;
///         ground A(0, 0), O(0, 1m);
///         guide lower through (0, 0) along 0deg;
///         guide upper through (0, 1m) along 0deg;
///         crank lead(O) -> L             { length: 80mm, angle: turn }
///         rrp   rod(L), twin(upper) -> M { length: 250mm, mode: ahead }
///         unknown theta: angle between (-100deg, 100deg);
///         crank AB(A) -> B             { length: 80mm, angle: theta }
///         rrp   BC(B), ram(lower) -> C { length: 250mm, mode: ahead }
///         solve theta { ram.slide = twin.slide, mode: way }
///         output theta;
///     }
/// }
///
/// let mut tracker = Tracker::new(Twins::new());
/// for turn in [1.0, 0.5, -0.5, -1.0] {
///     // Through the dead point both cranks turn on.
///     assert!((tracker.motion(turn, -1.0, 0.0)?.velocity.theta + 1.0).abs() < 1e-9);
/// }
/// assert_eq!(tracker.solver().way, Trend::Rising);
/// # Ok::<(), linkage_core::SolveError>(())
/// ```
///
/// # What counts as a change point
/// The dimensions of a mechanism are rounded, so that its bars never lie on one line exactly. With
/// ε = 2⁻⁵² (`f32`: 2⁻²³), a group passes a change point where its clearance, the value under the
/// root, is lowest and no farther from zero than √ε of its scale. The scale is made of the squares
/// of the lengths that the clearance is made of, so that the rule is the same at every size: a
/// misfit of all lengths of up to √ε/4 of themselves, 3.7e-9 (`f32`: 8.6e-5), counts as none. A
/// clearance that stays above √ε of its scale keeps its mode, and one that falls lower is a dead
/// end.
///
/// Where a clearance is below 4 √ε of its scale a pose lies on the change point: its sides
/// cannot be told apart. Change points of two groups that are so close together are passed at once, and
/// a tracker's modes stay those of the last pose before. Below 1.2e-4
/// (`f32`: 4.8e-3) of the scale the rounding of rates would show, and results are interpolated over
/// the change point; those of [`follow`](Self::follow) below 2e-3, as what is integrated adds up.
///
/// A first pose that lies on a change point has the modes of the solver behind it, along the given
/// rates; without rates, or with rates whose squares leave the numbers' range, nothing is known of
/// where the motion comes from, and the next pose has the solver's modes.
#[derive(Clone, Copy, Debug)]
pub struct Tracker<M: Solver> {
    solver: M,
    /// The last pose that was clear of every limit; the solver's modes hold there.
    anchor: Option<M::Input>,
}

impl<M: Solver> Tracker<M> {
    /// Follows the motion that the solver's modes begin.
    #[must_use]
    pub const fn new(solver: M) -> Self {
        Self { solver, anchor: None }
    }

    /// The solver with the modes of the last pose that was clear of every change point.
    #[must_use]
    pub const fn solver(&self) -> &M {
        &self.solver
    }

    /// The pose at the inputs that continues the last one. Within the range of a change point
    /// in which its rounding would show it is interpolated from poses on both sides.
    ///
    /// # Errors
    /// The solver's; `OutOfReach` or `Singular` also where the motion ends on the way to the
    /// inputs, or where it passes a change point of a group whose mode is not a parameter of its
    /// own; `Singular` where the continuation is undetermined; `NotFinite` where numbers leave their
    /// range on the way. The tracker then stays at the last pose.
    pub fn position(&mut self, q: impl Into<M::Input>) -> Result<M::Position, SolveError> {
        self.advance(self.anchor, q.into(), None, Zone::Shown, |solver, q| solver.position(q))
    }

    /// The pose that continues the last one, with velocities and accelerations at the given rates
    /// of the inputs. At a change point they are the limits from both sides.
    ///
    /// # Errors
    /// As for [`position`](Self::position).
    pub fn motion(
        &mut self,
        q: impl Into<M::Input>,
        rate: impl Into<M::Input>,
        acceleration: impl Into<M::Input>,
    ) -> Result<M::Motion, SolveError> {
        let (q, rate, acceleration) = (q.into(), rate.into(), acceleration.into());
        let anchor = self.beginning(q, rate, Zone::Shown);
        self.advance(anchor, q, Some(rate), Zone::Shown, |solver, q| {
            solver.motion(q, rate, acceleration)
        })
    }

    /// Any answer of the solver at the inputs, by the modes that continue the last pose: accelerations
    /// under forces, reactions, an energy. `rate` is the rate at which the inputs move; it tells a
    /// first pose that lies on a change point where the motion comes from. `answer` is called with the
    /// solver to ask, at one or several places.
    ///
    /// This is how a motion under forces is integrated through change points. An integrator may try
    /// states in any order and reject some of them: with one input the modes depend on the input
    /// alone.
    ///
    /// ```
    /// use linkage_core::{Side, SolveError, Tracker, mechanism};
    ///
    /// mechanism! {
    ///     /// Bars 4, 1, 2 and 3: all in one line once a turn.
    ///     struct Flat {
    ///         input q: angle;
    ///         param elbow: mode = left;
    ///         ground A(0, 0), D(4m, 0);
    ///         crank AB(A) -> B        { length: 1m, angle: q }
    ///         rrr   BC(B), DC(D) -> C { lengths: (2m, 3m), mode: elbow }
    ///         mass 1kg on AB uniform;
    ///         mass 2kg on BC uniform;
    ///         mass 3kg on DC uniform;
    ///         output DC, energy;
    ///     }
    /// }
    ///
    /// /// A step of Runge and Kutta's method of order 4.
    /// fn step(tracker: &mut Tracker<Flat>, state: [f64; 2], h: f64) -> Result<[f64; 2], SolveError> {
    ///     let mut rates = |part: f64, k: [f64; 2]| {
    ///         let [q, v] = [state[0] + part * h * k[0], state[1] + part * h * k[1]];
    ///         tracker.follow(q, v, |solver, q| solver.state_rates([q, v], 0.0))
    ///     };
    ///     let a = rates(0.0, [0.0; 2])?;
    ///     let b = rates(0.5, a)?;
    ///     let c = rates(0.5, b)?;
    ///     let d = rates(1.0, c)?;
    ///     let mean = |i: usize| (a[i] + 2.0 * (b[i] + c[i]) + d[i]) / 6.0;
    ///     Ok([state[0] + h * mean(0), state[1] + h * mean(1)])
    /// }
    ///
    /// let mut tracker = Tracker::new(Flat::new());
    /// let mut state = [2.0, 5.0];
    /// let energy = |tracker: &mut Tracker<Flat>, [q, v]: [f64; 2]| {
    ///     tracker.follow(q, v, |solver, q| solver.energy(q, v))
    /// };
    /// let start = energy(&mut tracker, state)?.kinetic;
    /// // Over two change points.
    /// while state[0] < 12.0 {
    ///     state = step(&mut tracker, state, 1e-3)?;
    /// }
    /// assert!((energy(&mut tracker, state)?.kinetic / start - 1.0).abs() < 1e-7);
    /// # Ok::<(), SolveError>(())
    /// ```
    ///
    /// # Errors
    /// As for [`position`](Self::position), and those of `answer`.
    pub fn follow<R: Record<Number = M::Scalar> + Copy>(
        &mut self,
        q: impl Into<M::Input>,
        rate: impl Into<M::Input>,
        answer: impl Fn(&M, M::Input) -> Result<R, SolveError>,
    ) -> Result<R, SolveError> {
        let (q, rate) = (q.into(), rate.into());
        let anchor = self.beginning(q, rate, Zone::Integrated);
        self.advance(anchor, q, Some(rate), Zone::Integrated, answer)
    }

    /// The last pose, or where a first pose at `q` comes from.
    fn beginning(&self, q: M::Input, rate: M::Input, zone: Zone) -> Option<M::Input> {
        self.anchor.or_else(|| around::beginning(&self.solver, q, rate, zone))
    }

    /// Goes from the anchor to `q` and solves there with the modes that have come of it.
    fn advance<R: Record<Number = M::Scalar> + Copy>(
        &mut self,
        anchor: Option<M::Input>,
        q: M::Input,
        rate: Option<M::Input>,
        zone: Zone,
        solve: impl Fn(&M, M::Input) -> Result<R, SolveError>,
    ) -> Result<R, SolveError> {
        let passage = Passage::new(self.solver, anchor.unwrap_or(q), q);
        if passage.is_clear(zone.near::<M::Scalar>()) {
            let result = solve(&self.solver, q)?;
            self.anchor = Some(q);
            return Ok(result);
        }
        if !q.all(Scalar::is_finite) {
            // The solver has the name of the input.
            return solve(&self.solver, q);
        }
        let solver = if anchor.is_some() { passage.follow()? } else { self.solver };
        let direction = passage.direction().or(rate).unwrap_or(q);
        let interpolated = around::interpolated(&passage, &solver, q, direction, zone, &solve)?;
        let result = match interpolated {
            Some(result) => result,
            None => solve(&solver, q)?,
        };
        passage.contradicts(&solver).map_or(Ok(()), Err)?;
        *self = if passage.ends_clear(&solver) {
            Self { solver, anchor: Some(q) }
        } else {
            Self { solver: self.solver, anchor }
        };
        Ok(result)
    }
}

fn title<M: Solver>(group: usize) -> &'static str {
    M::TITLES.groups.get(group).map_or("", |of| of.0)
}

fn param<M: Solver>(group: usize) -> Option<usize> {
    M::TITLES.groups.get(group).and_then(|of| of.1)
}
