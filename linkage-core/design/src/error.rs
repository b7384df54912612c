//! Why a design gave no answer.

use core::fmt;

use linkage_core::SolveError;

/// Why a search found no machine, or why a number about the found one does not exist.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum DesignError {
    /// The range of a parameter is not two finite numbers in rising order. The default range is a fifth
    /// to five times the declared value, so that a parameter declared as zero needs one.
    Range {
        /// The parameter.
        parameter: &'static str,
        /// The lower end.
        from: f64,
        /// The upper end.
        to: f64,
    },
    /// No aim was given.
    NoAim,
    /// No start could be assembled at every input that an aim or a keep looks at.
    Unassembled {
        /// The error of the start that was nearest to being assembled.
        nearest: SolveError,
        /// The aim or the keep that met it.
        of: String,
        /// The input at which it was met.
        at: String,
    },
    /// No start ended where all is kept.
    Infeasible {
        /// The keeps that the best end violates, and by how much.
        violated: Vec<(String, f64)>,
    },
    /// A function of an aim or a keep gave a number that is not finite.
    NotANumber {
        /// The aim or the keep.
        of: String,
        /// The input.
        at: String,
    },
    /// The aims do not determine these parameters, so that deviations of them do not exist.
    Undetermined {
        /// Names of the parameters.
        parameters: Vec<&'static str>,
    },
    /// No reaction and no link has that name.
    Unknown {
        /// The name that was asked for.
        name: String,
        /// The names that there are.
        known: Vec<String>,
    },
}

impl fmt::Display for DesignError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Range { parameter, from, to } => {
                write!(
                    f,
                    "`{parameter}` cannot be sought from {from} to {to}; give its range by `within`"
                )
            }
            Self::NoAim => f.write_str("nothing is aimed at; call `aim` or `path` before `run`"),
            Self::Unassembled { nearest, of, at } => write!(
                f,
                "no start can be assembled; the nearest fails in `{of}` at {at}: {nearest}"
            ),
            Self::Infeasible { violated } => {
                f.write_str("no start ends where all is kept; short at the best end: ")?;
                list(f, violated, |f, (name, by)| write!(f, "`{name}` by {by:.3e}"))
            }
            Self::NotANumber { of, at } => {
                write!(f, "`{of}` is not a finite number at {at}")
            }
            Self::Unknown { name, known } => {
                write!(f, "there is no `{name}`; there are ")?;
                list(f, known, |f, name| write!(f, "`{name}`"))
            }
            Self::Undetermined { parameters } => {
                f.write_str("the aims do not determine ")?;
                list(f, parameters, |f, name| write!(f, "`{name}`"))
            }
        }
    }
}

impl core::error::Error for DesignError {}

fn list<T>(
    f: &mut fmt::Formatter<'_>,
    items: &[T],
    one: impl Fn(&mut fmt::Formatter<'_>, &T) -> fmt::Result,
) -> fmt::Result {
    for (index, item) in items.iter().enumerate() {
        if index > 0 {
            f.write_str(", ")?;
        }
        one(f, item)?;
    }
    Ok(())
}
