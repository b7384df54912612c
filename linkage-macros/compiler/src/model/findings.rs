//! Facts that constant dimensions fix about groups before anything is solved, for their docs.

use crate::exact::Exact;
use crate::reach::turn::Turn;

use crate::model::ids::{GroupId, InputId, LinkId, PointId};
use crate::model::incidence::Carrier;

/// Facts that constants fix about a group.
#[derive(Clone)]
pub struct Known {
    pub group: GroupId,
    /// The distance between its outer joints.
    pub span: Option<Exact>,
    /// The earlier point on which its pin is in one of its modes.
    pub coincides_with: Option<PointId>,
}

/// The range of a crank's turn that a dyad hanging on it allows.
#[derive(Clone)]
pub struct Rotatability {
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

/// A group of constants between two bodies that are pinned to each other, which some angle between them brings to its
/// limit exactly.
#[derive(Clone)]
pub struct Touching {
    pub group: GroupId,
    /// The joint of both bodies.
    pub hinge: PointId,
    /// The outer joint of the group on the first body.
    pub on: PointId,
    /// The second body.
    pub against: Carrier,
    /// The angles in degrees of the first body's line from the hinge to the outer joint, in the frame of the second.
    pub angles: Vec<f64>,
    /// Opposite sides are of one length.
    pub is_parallelogram: bool,
    /// The values of the only input there, in degrees: those that were found by poses over a turn.
    pub inputs: Vec<f64>,
}
