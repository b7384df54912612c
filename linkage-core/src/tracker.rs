//! Following a motion through its change points.
//!
//! A solver keeps its assembly modes: at a change point, where a group's joints lie on one line,
//! a parallelogram whose mode is constant turns into an antiparallelogram. A [`Tracker`] keeps the
//! motion instead and lets the modes change, so that velocities stay continuous.
//!
//! What tells a change point is smooth: the value under the square root of the group's height
//! touches zero and turns back, while at a dead end it passes through zero. Between one call and
//! the next the tracker follows these values along the straight line from input to input, so it
//! does not matter whether a sample falls on the change point, next to it, or far on either side.
//!
//! Nothing here knows a formula of a group: how clear of its limit each group is, generated code
//! says ([`Modes`]).

mod linear;
mod passage;

pub use linear::Linear;
use passage::{Nearby, Passage};

use crate::{Real, SolveError};

/// How clear of its limit a group is: zero at a toggle, negative out of reach.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Clearance<T> {
    /// The value under the square root of the group's height.
    pub value: T,
    /// Its rate.
    pub rate: T,
    /// Against this the rounding of `value` is a few ε.
    pub scale: T,
}

/// A solver whose assembly modes can be followed; implemented by generated code.
pub trait Modes: Copy {
    /// The numbers it computes with.
    type Scalar: Real;
    /// Its input: a number, or a record of several.
    type Input: Linear<Self::Scalar>;
    /// The result of `position`.
    type Position: Linear<Self::Scalar>;
    /// The result of `motion`.
    type Motion: Linear<Self::Scalar>;
    /// A [`Clearance`] for each of `GROUPS`.
    type Clearances: Copy + AsRef<[Clearance<Self::Scalar>]>;

    /// The groups that have an assembly mode, in solving order: the links, and the number of the
    /// parameter that holds the mode unless it is a constant.
    const GROUPS: &'static [(&'static str, Option<usize>)];

    /// Changes the mode that a parameter holds into its opposite.
    fn flip(&mut self, param: usize);

    /// The solver's `position`.
    ///
    /// # Errors
    /// The solver's.
    fn position(&self, q: Self::Input) -> Result<Self::Position, SolveError>;

    /// The solver's `motion`.
    ///
    /// # Errors
    /// The solver's.
    fn motion(
        &self,
        q: Self::Input,
        rate: Self::Input,
        acceleration: Self::Input,
    ) -> Result<Self::Motion, SolveError>;

    /// How clear of their limits the groups are. Behind a group out of reach there are no numbers.
    fn clearances(&self, q: Self::Input, rate: Self::Input) -> Self::Clearances;
}

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
/// Two groups' change points closer together than √ε of the mechanism's size, or a change point
/// missed by less than that, are one to the tracker: the dimensions do not say more.
#[derive(Clone, Copy, Debug)]
pub struct Tracker<M: Modes> {
    solver: M,
    /// The last pose that was clear of every limit; the solver's modes hold there.
    anchor: Option<M::Input>,
}

impl<M: Modes> Tracker<M> {
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
    /// own. The tracker then stays at the last pose.
    pub fn position(&mut self, q: impl Into<M::Input>) -> Result<M::Position, SolveError> {
        self.advance(self.anchor, q.into(), |solver, q| solver.position(q))
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
        let anchor = self.anchor.or_else(|| passage::beginning(&self.solver, q, rate));
        self.advance(anchor, q, |solver, q| solver.motion(q, rate, acceleration))
    }

    /// Goes from the anchor to `q` and solves there with the modes that have come of it.
    fn advance<R: Linear<M::Scalar>>(
        &mut self,
        anchor: Option<M::Input>,
        q: M::Input,
        solve: impl Fn(&M, M::Input) -> Result<R, SolveError>,
    ) -> Result<R, SolveError> {
        let passage = Passage::new(self.solver, anchor.unwrap_or(q), q);
        let solver = passage.solver_at(1.0)?;
        let (nearby, is_clear) = passage.around_end(&solver);
        let interpolated = nearby.and_then(|nearby| interpolated(&passage, nearby, &solve));
        let result = match interpolated {
            Some(result) => result,
            None => solve(&solver, q)?,
        };
        *self = if is_clear {
            Self { solver, anchor: Some(q) }
        } else {
            Self { solver: self.solver, anchor }
        };
        Ok(result)
    }
}

/// Where the nodes of an interpolation stand on both sides of a change point, in units of its
/// width.
const NODES: [f64; 8] = [-2.5, 2.5, -2.0, 2.0, -1.5, 1.5, -1.0, 1.0];

/// The result at the end of the passage from those on both sides of a change point, each with the
/// modes that hold there; none where the motion does not go on so far on both sides.
fn interpolated<M: Modes, R: Linear<M::Scalar>>(
    passage: &Passage<M>,
    nearby: Nearby,
    solve: &impl Fn(&M, M::Input) -> Result<R, SolveError>,
) -> Option<R> {
    let at = |part: f64| solve(&passage.solver_at(part).ok()?, passage.input(part)).ok();
    let widths = [1.0, 0.5, 0.25].map(|share| share * nearby.width);
    widths.into_iter().find_map(|width| {
        let value = |node: f64| at(nearby.at + node * width);
        linear::interpolate(NODES, value, (1.0 - nearby.at) / width)
    })
}
