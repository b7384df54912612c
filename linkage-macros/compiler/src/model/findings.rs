//! What constant dimensions say of groups before anything is solved, for their docs.

use crate::exact::Exact;
use crate::model::ids::{GroupId, InputId, LinkId, PointId};
use crate::reach::turn::Turn;

/// What constants say of a group.
pub(crate) struct Known {
    pub group: GroupId,
    /// How far apart its outer joints are.
    pub span: Option<Exact>,
    /// The earlier point on which its pin is in one of its modes.
    pub coincides_with: Option<PointId>,
}

/// What a dyad leaves of the turn of the crank it hangs on.
pub(crate) struct Rotatability {
    pub group: GroupId,
    pub crank: LinkId,
    /// The input that is the crank's angle, where one is it bare.
    pub input: Option<InputId>,
    pub turn: Turn,
    /// Opposite links are of one length: crank and rocker, coupler and ground.
    pub is_parallelogram: bool,
    /// The comparison of lengths that decides it.
    pub reason: String,
}
