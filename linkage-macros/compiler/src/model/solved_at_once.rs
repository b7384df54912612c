//! Groups of drawings that are solved by all their unknowns at once.

use crate::chain::fit::Piece;
use crate::model::expr::AngleSum;
use crate::model::ids::{GroupId, PointId};

/// A group that is solved by all its unknowns at once.
#[derive(Clone)]
pub struct Tracked {
    /// Its title is that of the links: what fails with it.
    pub group: GroupId,
    /// The value of the drive that its unknowns are fitted over, an angle or another number.
    pub drive: AngleSum,
    pub fit: TrackedFit,
    /// The number of steps before its first, and behind its last.
    pub steps: [usize; 2],
    pub closings: Vec<TrackedClosing>,
}

/// The unknowns of a group over the drive.
#[derive(Clone)]
pub struct TrackedFit {
    pub unknowns: Vec<TrackedUnknown>,
    /// The drive's value in the drawing.
    pub drawn: f64,
    /// True if it is an angle, which is one pose a turn on.
    pub is_turned: bool,
    /// True if the machine turns fully.
    pub closes: bool,
    pub pieces: Vec<Piece>,
    /// The size that slides are measured by.
    pub size: f64,
}

/// An angle or a slide.
#[derive(Clone, Debug)]
pub struct TrackedUnknown {
    pub name: String,
    pub is_angle: bool,
    /// Its value in the drawing.
    pub drawn: f64,
}

/// Two points that are one where the group is solved.
#[derive(Clone)]
pub struct TrackedClosing {
    pub points: [PointId; 2],
    /// A bound on the sum of the second derivatives of the vector between them.
    pub bend: f64,
}

impl TrackedFit {
    /// The stretch of the drive on which it is certified, from the drawing.
    pub fn stretch(&self) -> [f64; 2] {
        match &self.pieces[..] {
            [first, .., last] => [first.ends[0], last.ends[1]],
            [only] => only.ends,
            [] => [0.0; 2],
        }
    }
}
