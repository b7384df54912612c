//! Why a picture could not be drawn or written.

use core::fmt;
use std::string::String;

use crate::SolveError;

/// Why there is no picture.
#[derive(Debug)]
#[non_exhaustive]
pub enum SketchError {
    /// Nothing of that kind is called that.
    UnknownName {
        /// The name that was given.
        name: String,
        /// `point` or `link`.
        kind: &'static str,
        /// The known name nearest to it.
        nearest: Option<String>,
    },
    /// A film of no poses at all.
    EmptyPath,
    /// The pose does not exist.
    Solve(SolveError),
    /// The file could not be written.
    Write(std::io::Error),
}

impl fmt::Display for SketchError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::UnknownName { name, kind, nearest: Some(nearest) } => {
                write!(f, "no {kind} named `{name}`; the nearest name is `{nearest}`")
            }
            Self::UnknownName { name, kind, nearest: None } => {
                write!(f, "no {kind} named `{name}`: the mechanism has none")
            }
            Self::EmptyPath => write!(f, "a film needs at least one pose, and its path has none"),
            Self::Solve(error) => error.fmt(f),
            Self::Write(error) => write!(f, "the picture could not be written: {error}"),
        }
    }
}

impl core::error::Error for SketchError {
    fn source(&self) -> Option<&(dyn core::error::Error + 'static)> {
        match self {
            Self::Solve(error) => Some(error),
            Self::Write(error) => Some(error),
            Self::UnknownName { .. } | Self::EmptyPath => None,
        }
    }
}

impl From<SolveError> for SketchError {
    fn from(error: SolveError) -> Self {
        Self::Solve(error)
    }
}

impl From<std::io::Error> for SketchError {
    fn from(error: std::io::Error) -> Self {
        Self::Write(error)
    }
}
