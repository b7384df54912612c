//! The interface that every solver offers, for code that serves all of them.

use crate::solver::Solver;
use crate::{Record, Scalar, SolveError};

/// A mechanism, whichever it is: names, and solutions as rows of numbers.
///
/// Every `mechanism!` implements it. Code for one mechanism should use the struct's own methods, which
/// return records with a field for each output. Here inputs and outputs are arrays, of one number where
/// there is one.
///
/// ```
/// use linkage_core::{Mechanism, SolveError, mechanism};
///
/// mechanism! {
///     struct Crank { input q: angle; ground A(0, 0); crank AB(A) -> B { length: 1m, angle: q } }
/// }
///
/// /// A table of every output against the first input, the others at rest at zero.
/// fn table<M: Mechanism<Scalar = f64>>(mechanism: &M, values: &[f64]) -> Result<String, SolveError> {
///     let mut text = format!("{} {}\n", M::INPUTS[0], M::OUTPUTS.join(" "));
///     for &value in values {
///         let rows = mechanism.position(M::inputs(|input| if input == 0 { value } else { 0.0 }))?;
///         let rows: Vec<String> = rows.as_ref().iter().map(f64::to_string).collect();
///         text += &format!("{value} {}\n", rows.join(" "));
///     }
///     Ok(text)
/// }
///
/// assert_eq!(table(&Crank::new(), &[0.0])?, "q AB.angle B.x B.y\n0 0 1 0\n");
/// # Ok::<(), SolveError>(())
/// ```
pub trait Mechanism {
    /// The numbers it computes with.
    type Scalar: Scalar;

    /// `[Scalar; N]`: a value, a rate or an acceleration of each input, in the order of `INPUTS`; SI
    /// units.
    type Inputs: Copy + AsRef<[Self::Scalar]> + AsMut<[Self::Scalar]>;

    /// `[Scalar; N]`: a number for each of `OUTPUTS`; metres and radians, or their rates. A
    /// direction's row is its angle in (−π, π].
    type Rows: Copy + AsRef<[Self::Scalar]> + AsMut<[Self::Scalar]>;

    /// `[Inputs; N]`: for each of `OUTPUTS` its derivatives with respect to the inputs.
    type Coefficients: Copy + AsRef<[Self::Inputs]>;

    /// The name in the declaration.
    const NAME: &'static str;

    /// The names of the inputs.
    const INPUTS: &'static [&'static str];

    /// The names of the scalar rows of the outputs.
    const OUTPUTS: &'static [&'static str];

    /// Inputs from the number of each.
    #[must_use]
    fn inputs(value: impl FnMut(usize) -> Self::Scalar) -> Self::Inputs;

    /// The rows of the positions.
    ///
    /// # Errors
    /// Those of the solver's own `position`.
    fn position(&self, inputs: Self::Inputs) -> Result<Self::Rows, SolveError>;

    /// The rows of the velocities.
    ///
    /// # Errors
    /// Those of the solver's own `velocity`.
    fn velocity(&self, inputs: Self::Inputs, rates: Self::Inputs)
    -> Result<Self::Rows, SolveError>;

    /// The rows of positions, velocities and accelerations.
    ///
    /// # Errors
    /// Those of the solver's own `motion`.
    fn motion(
        &self,
        inputs: Self::Inputs,
        rates: Self::Inputs,
        accelerations: Self::Inputs,
    ) -> Result<[Self::Rows; 3], SolveError>;

    /// The kinematic coefficients ∂outputs/∂inputs.
    ///
    /// # Errors
    /// Those of the solver's own `coefficients`.
    fn coefficients(&self, inputs: Self::Inputs) -> Result<Self::Coefficients, SolveError>;
}

/// The row of the output of this name.
pub(crate) fn row(outputs: &[&str], name: &str) -> Option<usize> {
    // Byte by byte: comparing strings at once is a call to the C library.
    outputs.iter().position(|output| output.bytes().eq(name.bytes()))
}

impl<S: Solver> Mechanism for S {
    type Scalar = S::Scalar;
    type Inputs = <S::Input as Record>::Array;
    type Rows = S::Rows;
    type Coefficients = S::Coefficients;

    const NAME: &'static str = S::TITLES.name;
    const INPUTS: &'static [&'static str] = S::TITLES.inputs;
    const OUTPUTS: &'static [&'static str] = S::TITLES.outputs;

    #[inline]
    fn inputs(value: impl FnMut(usize) -> Self::Scalar) -> Self::Inputs {
        S::input(value).into_array()
    }

    #[inline]
    fn position(&self, inputs: Self::Inputs) -> Result<Self::Rows, SolveError> {
        Solver::position(self, Record::from_array(inputs)).map(S::position_rows)
    }

    #[inline]
    fn velocity(
        &self,
        inputs: Self::Inputs,
        rates: Self::Inputs,
    ) -> Result<Self::Rows, SolveError> {
        let [inputs, rates] = [inputs, rates].map(Record::from_array);
        Solver::velocity(self, inputs, rates).map(Record::into_array)
    }

    #[inline]
    fn motion(
        &self,
        inputs: Self::Inputs,
        rates: Self::Inputs,
        accelerations: Self::Inputs,
    ) -> Result<[Self::Rows; 3], SolveError> {
        let [inputs, rates, accelerations] = [inputs, rates, accelerations].map(Record::from_array);
        Solver::motion(self, inputs, rates, accelerations).map(S::motion_rows)
    }

    #[inline]
    fn coefficients(&self, inputs: Self::Inputs) -> Result<Self::Coefficients, SolveError> {
        Solver::coefficients(self, Record::from_array(inputs))
    }
}
