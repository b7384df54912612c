//! One machine driven in two ways: from a pose of one solver to the inputs of another, and rates, efforts and inertias
//! with them.
//!
//! Both solvers have the sides of one drawing. Away from it a pose of the first may be another assembly of the second,
//! which would answer with its own: that is told before anything is carried over. Each dyad of the second has the
//! side of its drawing at the pose of the first, or the pose is one of another assembly. What is searched has no such
//! sign: there the second solver is asked, and its points are compared.

use core::fmt;

use crate::results::turned_near;
use crate::solver::{Solver, number};
use crate::{Real, Record, SolveError};

/// Where a number of a pose is found.
#[derive(Clone, Copy, Debug)]
pub enum Place {
    /// An input.
    Input(usize),
    /// A row of the outputs; of an angle with its value in the drawing.
    Row(usize, Option<f64>),
    /// A constant.
    Fixed(f64),
}

/// The line that tells the side of a group.
#[derive(Clone, Copy, Debug)]
pub enum Way {
    /// From the first outer joint to the second: the pin is left or right of it.
    Towards([Place; 2]),
    /// Along a guide of this direction: the pin is ahead of the outer joint or behind.
    Along([f64; 2]),
}

/// A group of the other solver, and the side on which it is assembled.
#[derive(Clone, Copy, Debug)]
pub struct AssembledSide {
    /// Its links, as errors name it.
    pub group: &'static str,
    /// The first outer joint.
    pub from: [Place; 2],
    /// The line from there.
    pub way: Way,
    /// The pin between the links.
    pub pin: [Place; 2],
    /// True if the pin is left, or ahead.
    pub is_positive: bool,
}

/// Roundings of a cross product over the square of the largest number in it: each place may be off by some units in the
/// last place of the machine's size, and each of four products by two of these. Printed C has the same number.
const ROUNDINGS: f64 = 128.0;

impl AssembledSide {
    /// True if the pin is left or ahead in this pose; nothing where rounding does not tell, at a limit of the group or
    /// where its outer joints meet.
    #[inline]
    fn found<T: Real>(&self, inputs: &[T], rows: &[T]) -> Option<bool> {
        // Numbers of single precision lose nothing, and their products are exact.
        let value = |place| value(place, inputs, rows).value();
        let ([x, y], pin) = (self.from.map(value), self.pin.map(value));
        let [right, up] = [pin[0] - x, pin[1] - y];
        let size = x.abs().max(y.abs()).max(right.abs().max(up.abs()));
        let rounding = ROUNDINGS * T::EPSILON * size;
        let (across, rounding) = match self.way {
            Way::Towards(to) => {
                let [to_x, to_y] = to.map(value);
                ((to_x - x) * up - (to_y - y) * right, rounding * size)
            }
            Way::Along([along_x, along_y]) => (along_x * right + along_y * up, rounding),
        };
        (across.abs() > rounding).then_some(across > 0.0)
    }
}

/// A solver whose poses are those of another, driven otherwise. Implemented by generated code.
pub trait CarriesOver<B: Solver, const N: usize>: Solver {
    /// The inputs of the other.
    #[doc(hidden)]
    const COORDINATES: [Place; N];
    /// The sides of the other's groups.
    #[doc(hidden)]
    const SIDES: &'static [AssembledSide];
    /// Rows of points, here and there, and the group that places each there, where the other is asked.
    #[doc(hidden)]
    const COMPARED: &'static [(usize, usize, &'static str)];

    /// The other solver, with the parameters of this one.
    fn other(&self) -> B;
}

/// Why a pose was not carried over to another set of inputs.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum TransferError {
    /// There is no such pose.
    Solve(SolveError),
    /// The pose is one of another assembly of the other solver: its inputs would be told another pose there.
    OtherAssembly {
        /// The solver whose assembly it is not.
        solver: &'static str,
        /// The first of its groups that stands on the other side.
        group: &'static str,
    },
}

impl From<SolveError> for TransferError {
    #[inline]
    fn from(error: SolveError) -> Self {
        Self::Solve(error)
    }
}

impl fmt::Display for TransferError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Solve(error) => error.fmt(f),
            Self::OtherAssembly { solver, group } => {
                write!(f, "{group}: not on the side that it has for {solver}")
            }
        }
    }
}

impl core::error::Error for TransferError {}

/// A pose that was carried over from one set of inputs to another.
#[derive(Clone, Copy, Debug)]
pub struct Transfer<A: Solver, B: Solver, const N: usize> {
    /// The inputs of the other solver in this pose. Angles are in the turn of the drawing, within half a turn of it.
    pub coordinates: B::Input,
    from: A,
    q: A::Input,
}

impl<A, B, T, const N: usize> Transfer<A, B, N>
where
    T: Real,
    A: CarriesOver<B, N> + Solver<Scalar = T>,
    B: Solver<Scalar = T>,
    A::Input: Record<Number = T, Array = [T; N]>,
    B::Input: Record<Number = T, Array = [T; N]>,
    A::Position: Record<Number = T>,
{
    /// Carries a pose over; called by generated code.
    #[doc(hidden)]
    #[inline]
    pub fn new(from: A, q: A::Input) -> Result<Self, TransferError> {
        let rows = A::position_rows(from.position(q)?);
        let inputs = q.into_array();
        for side in A::SIDES {
            match side.found(&inputs, rows.as_ref()) {
                Some(is_positive) if is_positive == side.is_positive => {}
                Some(_) => return Err(other_assembly::<B>(side.group)),
                None => return Err(SolveError::Singular { group: side.group }.into()),
            }
        }
        let coordinates =
            B::Input::from_array(A::COORDINATES.map(|place| value(place, &inputs, rows.as_ref())));
        if !A::COMPARED.is_empty() {
            compare::<A, B, N>(&from.other(), rows, coordinates)?;
        }
        Ok(Self { coordinates, from, q })
    }

    /// The rates of the other inputs where these go at their rates.
    ///
    /// # Errors
    /// Those of the first solver's `velocity`.
    #[inline]
    pub fn rates(&self, rates: impl Into<A::Input>) -> Result<B::Input, SolveError> {
        let rates = rates.into();
        let rows = self.from.velocity(self.q, rates)?.into_array();
        Ok(picked::<A, B, N>(&rates.into_array(), rows.as_ref()))
    }

    /// The inputs, rates and accelerations of the other.
    ///
    /// # Errors
    /// Those of the first solver's `motion`.
    #[inline]
    pub fn motion(
        &self,
        rates: impl Into<A::Input>,
        accelerations: impl Into<A::Input>,
    ) -> Result<[B::Input; 3], SolveError> {
        let (rates, accelerations) = (rates.into(), accelerations.into());
        let motion = self.from.motion(self.q, rates, accelerations)?;
        let [_, velocity, acceleration] = A::motion_rows(motion);
        Ok([
            self.coordinates,
            picked::<A, B, N>(&rates.into_array(), velocity.as_ref()),
            picked::<A, B, N>(&accelerations.into_array(), acceleration.as_ref()),
        ])
    }

    /// The kinematic coefficients between the two, ∂other/∂own: a row for each input of the other.
    ///
    /// # Errors
    /// Those of the first solver's `coefficients`.
    #[inline]
    pub fn ratios(&self) -> Result<[[T; N]; N], SolveError> {
        let rows = self.from.coefficients(self.q)?;
        Ok(A::COORDINATES.map(|place| match place {
            Place::Row(row, _) => {
                rows.as_ref().get(row).map_or([T::num(f64::NAN); N], |row| row.into_array())
            }
            Place::Input(own) => {
                core::array::from_fn(|input| T::num(if input == own { 1.0 } else { 0.0 }))
            }
            Place::Fixed(_) => [T::num(0.0); N],
        }))
    }

    /// The efforts at the inputs that have the power of these at the inputs of the other: Jᵀτ.
    ///
    /// # Errors
    /// Those of the first solver's `coefficients`.
    #[inline]
    pub fn efforts(&self, efforts: impl Into<B::Input>) -> Result<A::Input, SolveError> {
        let (ratios, efforts) = (self.ratios()?, efforts.into().into_array());
        Ok(A::Input::from_array(core::array::from_fn(|own| {
            let terms = ratios.iter().zip(efforts);
            terms.fold(T::num(0.0), |sum, (row, effort)| sum + number(row, own) * effort)
        })))
    }

    /// The inertia that is felt at the inputs of this one at the inputs of the other, such as that of rotors: JᵀMJ.
    ///
    /// # Errors
    /// Those of the first solver's `coefficients`.
    #[inline]
    pub fn inertia(&self, inertia: [[T; N]; N]) -> Result<[[T; N]; N], SolveError> {
        let ratios = self.ratios()?;
        let column = |own: usize| ratios.map(|row| number(&row, own));
        let dot = |a: [T; N], b: [T; N]| {
            a.into_iter().zip(b).fold(T::num(0.0), |sum, (a, b)| sum + a * b)
        };
        let weighted: [[T; N]; N] =
            core::array::from_fn(|own| inertia.map(|row| dot(row, column(own))));
        Ok(core::array::from_fn(|own| weighted.map(|weighted| dot(column(own), weighted))))
    }
}

#[inline]
fn value<T: Real>(place: Place, inputs: &[T], rows: &[T]) -> T {
    let at = |list: &[T], at: usize| list.get(at).copied().unwrap_or(T::num(f64::NAN));
    match place {
        Place::Input(input) => at(inputs, input),
        Place::Row(row, None) => at(rows, row),
        Place::Row(row, Some(drawn)) => turned_near(at(rows, row), drawn),
        Place::Fixed(value) => T::num(value),
    }
}

#[inline]
fn picked<A, B, const N: usize>(inputs: &[A::Scalar], rows: &[A::Scalar]) -> B::Input
where
    A: CarriesOver<B, N>,
    B: Solver<Scalar = A::Scalar>,
    B::Input: Record<Number = A::Scalar, Array = [A::Scalar; N]>,
{
    B::Input::from_array(A::COORDINATES.map(|place| match place {
        Place::Row(row, _) => value(Place::Row(row, None), inputs, rows),
        place => value(place, inputs, rows),
    }))
}

fn other_assembly<B: Solver>(group: &'static str) -> TransferError {
    TransferError::OtherAssembly { solver: B::TITLES.name, group }
}

/// Asks the other solver, and compares where it finds the points.
fn compare<A, B, const N: usize>(
    other: &B,
    rows: A::Rows,
    coordinates: B::Input,
) -> Result<(), TransferError>
where
    A: CarriesOver<B, N>,
    B: Solver<Scalar = A::Scalar>,
{
    let found = B::position_rows(other.position(coordinates)?);
    let at = |rows: &[A::Scalar], row: usize| rows.get(row).map_or(f64::NAN, |it| it.value());
    let places = || {
        A::COMPARED.iter().map(|&(here, there, group)| {
            (at(rows.as_ref(), here), at(found.as_ref(), there), group)
        })
    };
    let size = places().fold(0.0, |size: f64, (here, ..)| size.max(here.abs()));
    // Next to a limit of the other solver its assemblies come together as the root of the distance from the limit, and so
    // do the errors of a pose there: numbers that are off by ε move it by √ε. Poses that are nearer are one.
    let near = 256.0 * A::Scalar::EPSILON * size * size;
    for (here, there, group) in places() {
        let is_there = (here - there) * (here - there) <= near;
        if !is_there {
            return Err(other_assembly::<B>(group));
        }
    }
    Ok(())
}
