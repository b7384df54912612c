//! A drawn path: points of a closed curve in order, from a text file.

use std::fmt;
use std::path::Path;

/// A drawn path, closed from its last point to its first.
#[derive(Clone, Debug, PartialEq)]
pub struct DrawnPath {
    /// Coordinates, in any unit.
    pub x: Vec<f64>,
    /// See [`x`](Self::x).
    pub y: Vec<f64>,
}

/// Why a file is not a path.
#[derive(Clone, Debug, PartialEq)]
pub enum PathError {
    /// It cannot be read.
    Unreadable {
        /// The file.
        file: String,
        /// The system's message.
        reason: String,
    },
    /// A line is not a point.
    NotAPoint {
        /// Counted from 1.
        line: usize,
        /// The text of the line.
        text: String,
    },
    /// There are too few points for a closed curve.
    TooFew {
        /// The number of points.
        points: usize,
    },
    /// All points are one, or so far apart that the path's length is no number.
    NoSize,
}

impl DrawnPath {
    /// The path in a file: a point a line, its x and its y, with a comma or space between them. Empty lines, and
    /// what stands behind `#`, are left out.
    ///
    /// # Errors
    /// See [`PathError`].
    pub fn read(file: &Path) -> Result<Self, PathError> {
        let text = std::fs::read_to_string(file).map_err(|error| PathError::Unreadable {
            file: file.display().to_string(),
            reason: error.to_string(),
        })?;
        Self::parse(&text)
    }

    /// See [`read`](Self::read).
    ///
    /// # Errors
    /// See [`PathError`].
    pub fn parse(text: &str) -> Result<Self, PathError> {
        let (mut x, mut y) = (Vec::new(), Vec::new());
        for (line, text) in (1..).zip(text.lines()) {
            let written = text.split('#').next().unwrap_or_default().trim();
            if written.is_empty() {
                continue;
            }
            let not_a_point = || PathError::NotAPoint { line, text: text.trim().to_owned() };
            let [to_x, to_y] = point(written).ok_or_else(not_a_point)?;
            x.push(to_x);
            y.push(to_y);
        }
        if x.len() < 3 {
            return Err(PathError::TooFew { points: x.len() });
        }
        let size = |values: &[f64]| {
            let (least, most) =
                values.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), &value| {
                    (value.min(least), value.max(most))
                });
            most - least
        };
        let size = size(&x).max(size(&y));
        // Squares of the size must stay within the range of numbers.
        if !(1e-100..=1e100).contains(&size) {
            return Err(PathError::NoSize);
        }
        Ok(Self { x, y })
    }

    /// The points in order, the first once more at the end.
    #[must_use]
    pub fn closed(&self) -> Vec<(f64, f64)> {
        let points = self.x.iter().copied().zip(self.y.iter().copied());
        points.clone().chain(points.take(1)).collect()
    }
}

/// Two finite numbers and nothing else.
fn point(text: &str) -> Option<[f64; 2]> {
    let mut numbers = text.split(|c: char| c == ',' || c == ';' || c.is_whitespace());
    let mut next = || numbers.by_ref().find(|number| !number.is_empty());
    let number = |text: &str| text.parse().ok().filter(|number: &f64| number.is_finite());
    let point = [number(next()?)?, number(next()?)?];
    next().is_none().then_some(point)
}

impl fmt::Display for PathError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Unreadable { file, reason } => write!(f, "`{file}` cannot be read: {reason}"),
            Self::NotAPoint { line, text } => {
                write!(
                    f,
                    "line {line}, `{text}`, is not a point; write its x and its y, as `1.5 0.2`"
                )
            }
            Self::TooFew { points } => write!(
                f,
                "a closed path needs three points or more, and there are {points}; write one a line"
            ),
            Self::NoSize => {
                write!(f, "the points are all one, or too far apart; write those of a closed curve")
            }
        }
    }
}

impl std::error::Error for PathError {}
