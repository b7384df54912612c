//! Steps: statements that place points, guides and links, in solving order.

use crate::model::expr::{AngleSum, Scalar};
use crate::model::ids::{GroupId, GuideId, PointId};
use crate::model::incidence::{Carrier, Group, Length, Sign};

#[derive(Clone)]
pub enum GuideDirection {
    /// The angle against the carrier's x.
    Along(AngleSum),
    Towards(PointId),
}

#[derive(Clone)]
pub enum Through {
    /// Coordinates in the carrier's frame.
    At([Scalar; 2]),
    Point(PointId),
}

#[derive(Clone)]
pub enum Placement {
    Cartesian([Scalar; 2]),
    /// Distance from the carrier's origin, angle against its x.
    Polar(Scalar, Scalar),
    /// Distances from the carrier's two joints, `length` apart on its x; `Plus` is left of it.
    Distances {
        distances: [Length; 2],
        length: Scalar,
        side: Sign,
    },
}

/// One statement that places something.
#[derive(Clone)]
pub enum Step {
    Ground {
        point: PointId,
        at: [Scalar; 2],
    },
    Guide {
        guide: GuideId,
        carrier: Carrier,
        through: Through,
        course: GuideDirection,
    },
    /// A point of a link, or a driven point in ground axes.
    Point {
        point: PointId,
        carrier: Carrier,
        place: Placement,
        group: GroupId,
    },
    Group(Group),
}
