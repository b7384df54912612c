//! What dyads leave of the turns of cranks.

use crate::model::ids::{GroupId, InputId, LinkId};

/// What a dyad leaves of the turn of the crank it hangs on.
pub(crate) struct Rotatability {
    pub group: GroupId,
    pub crank: LinkId,
    /// The input that is the crank's angle, where one is it bare.
    pub input: Option<InputId>,
    pub range: Range,
    /// The angles, in degrees, at which both assembly modes are one while the crank passes.
    pub change_points: Vec<f64>,
    /// Opposite links are of one length: crank and rocker, coupler and ground.
    pub is_parallelogram: bool,
    /// The comparison of lengths that decides it.
    pub reason: String,
}

/// The angles of a crank at which a dyad assembles, in degrees.
#[derive(Debug, PartialEq)]
pub(crate) enum Range {
    Full,
    /// From, to: one interval, or two that the crank cannot leave for each other.
    Within(Vec<[f64; 2]>),
    Never,
}
