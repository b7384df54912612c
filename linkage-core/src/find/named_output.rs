//! An output of a mechanism where it is wanted, by the output's name.

use core::cell::Cell;
use core::fmt;

use crate::mechanism::row;
use crate::roots::{FindError, Root, Search, constant, magnitude, number};
use crate::{Mechanism, Real, SolveError};

/// Why an output was not brought to where it is wanted.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum OutputError {
    /// The mechanism has no output of that name.
    NoOutput {
        /// The names of its outputs: [`Mechanism::OUTPUTS`].
        outputs: &'static [&'static str],
    },
    /// There is no root, or none was found.
    Find(FindError),
    /// The mechanism has no pose at a trial.
    Solve(SolveError),
}

impl fmt::Display for OutputError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::NoOutput { outputs } => no_output(outputs, f),
            Self::Find(ref error) => error.fmt(f),
            Self::Solve(ref error) => error.fmt(f),
        }
    }
}

impl core::error::Error for OutputError {}

impl From<FindError> for OutputError {
    fn from(error: FindError) -> Self {
        Self::Find(error)
    }
}

/// The text where a name is none of these.
pub(crate) fn no_output(outputs: &[&str], f: &mut fmt::Formatter<'_>) -> fmt::Result {
    f.write_str("no output of this name; there ")?;
    f.write_str(if outputs.len() == 1 { "is " } else { "are " })?;
    for (index, output) in outputs.iter().enumerate() {
        write!(f, "{}`{output}`", if index == 0 { "" } else { ", " })?;
    }
    Ok(())
}

impl<T: Real> Search<T> {
    /// The input at which the output of this name, one of [`Mechanism::OUTPUTS`], has a value: metres or
    /// radians. The mechanism has one input; of several, [`Search::find`] takes a line through them.
    ///
    /// ```
    /// use linkage_core::find::{OutputError, Search, Trend};
    /// use linkage_core::mechanism;
    ///
    /// mechanism! {
    ///     struct Press {
    ///         input theta: angle;
    ///         ground A(0, 0);
    ///         guide bed through (0, 0) along 0deg;
    ///         crank AB(A) -> B           { length: 80mm, angle: theta }
    ///         rrp   BC(B), ram(bed) -> C { length: 250mm, mode: ahead }
    ///         output ram.slide;
    ///     }
    /// }
    ///
    /// // The crank's angle that puts the ram at 260 mm on its way back.
    /// let press = Press::new();
    /// let search = Search::new([0.0, core::f64::consts::PI], Trend::Falling);
    /// let root = search.find_output(&press, "ram.slide", 0.26)?;
    /// let slide = press.position(root.at).expect("the crank turns fully").ram.slide;
    /// assert!((slide - 0.26).abs() < 1e-15);
    /// let error = search.find_output(&press, "ram", 0.26).unwrap_err();
    /// assert_eq!(error.to_string(), "no output of this name; there is `ram.slide`");
    /// # Ok::<(), OutputError>(())
    /// ```
    ///
    /// A direction's angle is compared within half a turn: between the ends it does not come to half a turn
    /// from the wanted one.
    ///
    /// # Errors
    /// See [`OutputError`].
    pub fn find_output<M: Mechanism<Scalar = T, Inputs = [T; 1]>>(
        &self,
        mechanism: &M,
        output: &str,
        wanted: T,
    ) -> Result<Root<T>, OutputError> {
        let outputs = M::OUTPUTS;
        let index = row(outputs, output).ok_or(OutputError::NoOutput { outputs })?;
        let is_angle = output.bytes().rev().take(6).eq(".angle".bytes().rev());
        let (failure, last) = (Cell::new(None), Cell::new((number::<T>(f64::NAN), number(0.0))));
        let found = self.find(|x| {
            let rows = match mechanism.motion([x], [number(1.0)], [number(0.0)]) {
                Ok(rows) => rows,
                Err(error) => {
                    failure.set(failure.get().or(Some(error)));
                    return [number(f64::NAN); 2];
                }
            };
            let [value, slope, _] =
                rows.map(|row| row.as_ref().get(index).copied().unwrap_or(number(f64::NAN)));
            let away = if is_angle { within_half_a_turn(value - wanted) } else { value - wanted };
            last.set((constant(x), constant(away)));
            [away, slope]
        });
        match (found, failure.get()) {
            (Err(FindError::NotFinite { .. }), Some(error)) => Err(OutputError::Solve(error)),
            (Ok(_), _) if is_angle && magnitude(last.get().1).gt(number(1.0)) => {
                let (at, by) = last.get();
                let (at, by) = (at.value(), magnitude(by).value());
                Err(FindError::NoSolution { at, by, other: None }.into())
            }
            (found, _) => Ok(found?),
        }
    }
}

/// The difference of two angles in (−π, π], by no more than π too large or too small.
fn within_half_a_turn<T: Real>(difference: T) -> T {
    let half = T::lit(core::f64::consts::PI, core::f32::consts::PI);
    let turn = half + half;
    if difference.gt(half) {
        difference - turn
    } else if (-half).gt(difference) {
        difference + turn
    } else {
        difference
    }
}
