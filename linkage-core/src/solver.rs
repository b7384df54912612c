//! The interface between this crate and a solver's generated code.
//!
//! One trait serves all that is written once for every mechanism: following a motion
//! ([`Tracker`](crate::Tracker)), sweeps of positions, velocities and motions, Jacobians and
//! [`Mechanism`](crate::Mechanism). A trait costs a user's compiler more by the
//! signatures of its functions than by their bodies, so the trait has each function once.

use crate::clearance::{Clearance, Jet, moving};
use crate::roots::seed::Seed;
use crate::{Real, Record, Scalar, SolveError};

/// The names in the declaration.
#[derive(Clone, Copy, Debug)]
pub struct Titles {
    /// The mechanism.
    pub name: &'static str,
    /// The inputs.
    pub inputs: &'static [&'static str],
    /// The scalar rows of the outputs.
    pub outputs: &'static [&'static str],
    /// The groups that have an assembly mode, in solving order: the links, and the number of the
    /// parameter that holds the mode unless it is a constant. An unknown is one as well: it stands for
    /// the dead points of its equation, the ends of its interval and, last, the root itself.
    pub groups: &'static [(&'static str, Option<usize>)],
}

/// A solver, whichever mechanism it is of: what [`Tracker`](crate::Tracker), [`Transfer`](crate::Transfer) and the
/// searches of [`range`](crate::range) are generic over.
///
/// Every `mechanism!` implements it, and nothing else can be relied on to: it has hidden items, which change. Code that
/// wants rows of numbers takes [`Mechanism`](crate::Mechanism).
///
/// ```
/// use linkage_core::{Solver, mechanism};
///
/// mechanism! {
///     struct Crank { input q: angle; ground A(0, 0); crank AB(A) -> B { length: 1m, angle: q } }
/// }
///
/// /// True if the mechanism can be assembled at every one of these inputs.
/// fn assembles<S: Solver>(solver: &S, at: impl IntoIterator<Item = S::Input>) -> bool {
///     at.into_iter().all(|q| solver.position(q).is_ok())
/// }
///
/// assert!(assembles(&Crank::new(), [0.0, 1.0, 2.0]));
/// ```
pub trait Solver: Copy {
    /// The numbers it computes with.
    type Scalar: Real;
    /// Its input: a number, or a record of several.
    type Input: Record<Number = Self::Scalar, Array: Copy> + Copy;
    /// The result of `position`.
    type Position: Record<Number = Self::Scalar> + Copy;
    /// The result of `velocity`, whose numbers are its rows.
    type Velocity: Record<Number = Self::Scalar, Array = Self::Rows> + Copy;
    /// The result of `motion`.
    type Motion: Record<Number = Self::Scalar> + Copy;
    /// `[Scalar; N]`: a number for each scalar row of the outputs.
    #[doc(hidden)]
    type Rows: Copy + AsRef<[Self::Scalar]> + AsMut<[Self::Scalar]>;
    /// The result of `coefficients`.
    #[doc(hidden)]
    type Coefficients: Copy + AsRef<[<Self::Input as Record>::Array]>;
    /// `[X; N]`: something for each group in the titles.
    #[doc(hidden)]
    type Groups<X: Copy>: Copy + AsRef<[X]>;

    /// Names.
    #[doc(hidden)]
    const TITLES: Titles;

    /// True if the solver searches for an unknown: it might then find another root where one is lost.
    #[doc(hidden)]
    const SEARCHES: bool = false;

    /// Changes the mode that a parameter holds into its opposite; nothing where none does.
    #[inline]
    #[doc(hidden)]
    fn flip(&mut self, _param: usize) {}

    /// The input of these numbers, asked one by one.
    #[doc(hidden)]
    fn input(number: impl FnMut(usize) -> Self::Scalar) -> Self::Input;

    /// The solver's `position`.
    ///
    /// # Errors
    /// The solver's.
    fn position(&self, q: Self::Input) -> Result<Self::Position, SolveError>;

    /// The solver's `velocity`.
    ///
    /// # Errors
    /// The solver's.
    fn velocity(&self, q: Self::Input, rate: Self::Input) -> Result<Self::Velocity, SolveError>;

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

    /// The solver's `coefficients`.
    ///
    /// # Errors
    /// The solver's.
    #[doc(hidden)]
    fn coefficients(&self, q: Self::Input) -> Result<Self::Coefficients, SolveError>;

    /// The rows of a position.
    #[doc(hidden)]
    fn position_rows(position: Self::Position) -> Self::Rows;

    /// The rows of the three parts of a motion.
    #[doc(hidden)]
    fn motion_rows(motion: Self::Motion) -> [Self::Rows; 3];

    /// The fast path, for lanes as for any number: of `position`, `velocity` or `motion`, as `ORDER` is
    /// 0, 1 or 2. It is given numbers by their places, first the inputs' values and then their rates,
    /// puts the numbers of the result, and says whether they may be used; where they may not be, there
    /// need not be any.
    #[doc(hidden)]
    fn solve<const ORDER: usize, U: Scalar>(
        &self,
        given: impl Fn(usize) -> U,
        put: impl FnOnce(&[U]),
    ) -> U::Mask;

    /// The fast path of a pose of a sweep, whose searches begin by the seeds of their unknowns. It is given
    /// numbers as [`solve`](Self::solve) is, and puts those of the result where they may be used. Where
    /// they may not be, or nothing is searched by a seed, a single call is to follow.
    #[inline]
    #[doc(hidden)]
    fn follow<const ORDER: usize>(
        &self,
        _seeds: &mut [Seed<Self::Scalar>],
        _given: impl Fn(usize) -> Self::Scalar,
        _put: impl FnOnce(&[Self::Scalar]),
    ) -> bool {
        false
    }

    /// Maps each group's clearance, as (value, scale), through `of`. The numbers are of another type:
    /// `standing` converts the parameters, and `input` gives the inputs. Groups that depend on one
    /// out of reach have NaN.
    #[doc(hidden)]
    fn told<U: Real, X: Copy>(
        &self,
        standing: impl Fn(Self::Scalar) -> U,
        input: impl Fn(usize) -> U,
        of: impl Fn([U; 2]) -> X,
    ) -> Self::Groups<X>;

    /// The clearances of the groups. Groups that depend on one out of reach have NaN.
    #[inline]
    #[doc(hidden)]
    fn clearances(
        &self,
        q: Self::Input,
        rate: Self::Input,
    ) -> Self::Groups<Clearance<Self::Scalar>> {
        let [q, rate] = [q, rate].map(Record::into_array);
        let along = |input| Jet::along(number(&q, input), number(&rate, input));
        // Parameters stand still, and keep what derivatives they have.
        self.told(Jet::standing, along, moving)
    }

    /// All values and scales of the clearances while the inputs lie no farther than `radius` from
    /// `middle`, without rates: a fraction of the work.
    #[inline]
    #[doc(hidden)]
    fn values(
        &self,
        middle: Self::Input,
        radius: Self::Input,
    ) -> Self::Groups<[<Self::Scalar as Real>::Enclosing; 2]> {
        let [middle, radius] = [middle, radius].map(Record::into_array);
        let around = |input| number(&middle, input).enclosing(number(&radius, input));
        self.told(lifted, around, |told| told)
    }

    /// The clearances with rates while the inputs lie no farther than `radius` from `middle`.
    #[inline]
    #[doc(hidden)]
    fn enclosures(
        &self,
        middle: Self::Input,
        radius: Self::Input,
        rate: Self::Input,
    ) -> Self::Groups<Clearance<<Self::Scalar as Real>::Enclosing>> {
        let [middle, radius, rate] = [middle, radius, rate].map(Record::into_array);
        let along = |input| {
            let around = number(&middle, input).enclosing(number(&radius, input));
            Jet::along(around, number(&rate, input).enclosing(Self::Scalar::num(0.0)))
        };
        self.told(|param| Jet::standing(lifted(param)), along, moving)
    }
}

/// A number of an array; none where there is none.
#[inline(always)]
pub(crate) fn number<T: Scalar>(array: &impl AsRef<[T]>, at: usize) -> T {
    array.as_ref().get(at).copied().unwrap_or(T::num(f64::NAN))
}

/// A number without its derivatives as one of another type.
#[inline(always)]
pub fn lifted<T: Real, U: Scalar>(number: T) -> U {
    U::num(number.value())
}
