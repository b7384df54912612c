//! Inputs and results as arrays of numbers.

use crate::Scalar;

/// A record of numbers that can be taken as an array: a position, a velocity, an acceleration, a
/// motion, margins, or several inputs.
///
/// The records of a solver are structs with a field for each output. Code that serves every
/// mechanism, such as a table, a plot or an interpolation, takes their numbers one after the
/// other instead.
///
/// ```
/// use linkage_core::{Record, mechanism};
///
/// mechanism! {
///     struct Crank { input q: angle; ground A(0, 0); crank AB(A) -> B { length: 1m, angle: q } }
/// }
///
/// fn table<R: Record>(record: R) -> Vec<(&'static str, R::Number)> {
///     R::LABELS.iter().copied().zip(record.into_array()).collect()
/// }
///
/// let velocity = Crank::new().velocity(0.0, 2.0)?;
/// let expected = [("velocity of AB.angle", 2.0), ("velocity of B.x", 0.0), ("velocity of B.y", 2.0)];
/// assert_eq!(table(velocity), expected);
/// # Ok::<(), linkage_core::SolveError>(())
/// ```
pub trait Record: Sized {
    /// What the record holds.
    type Number;

    /// `[Number; N]`, in the order of the record's fields and their components.
    type Array: AsRef<[Self::Number]> + AsMut<[Self::Number]> + IntoIterator<Item = Self::Number>;

    /// What each number is, as errors call it: `C.x`, `velocity of DC.angle`. A direction holds two
    /// numbers, cosine and sine, under the label of its angle.
    const LABELS: &'static [&'static str];

    /// The numbers of the record.
    #[must_use]
    fn into_array(self) -> Self::Array;

    /// The record of the numbers.
    #[must_use]
    fn from_array(array: Self::Array) -> Self;
}

/// A single input is a record of one number.
impl<T: Scalar> Record for T {
    type Number = T;
    type Array = [T; 1];

    const LABELS: &'static [&'static str] = &[""];

    #[inline(always)]
    fn into_array(self) -> [T; 1] {
        [self]
    }

    #[inline]
    fn from_array([number]: [T; 1]) -> T {
        number
    }
}
