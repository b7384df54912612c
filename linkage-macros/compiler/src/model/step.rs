//! What places points, guides and links, one statement a step.

use crate::model::expr::{AngleSum, Expr};
use crate::model::ids::{GroupId, GuideId, LinkId, ParamId, PointId};

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Sign {
    Plus,
    Minus,
}

/// An assembly mode: +1 is `left` or `ahead`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Mode {
    Fixed(Sign),
    /// A mode parameter.
    Param(ParamId),
}

/// What a point, a guide or a crank's angle is fixed to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Carrier {
    Ground,
    Link(LinkId),
}

pub(crate) enum GuideDirection {
    /// The angle against the carrier's x.
    Along(AngleSum),
    Towards(PointId),
}

pub(crate) enum Through {
    /// Coordinates in the carrier's frame.
    At([Expr; 2]),
    Point(PointId),
}

pub(crate) enum Placement {
    Cartesian([Expr; 2]),
    /// Distance from the carrier's origin, angle against its x.
    Polar(Expr, Expr),
    /// Distances from the carrier's two joints, `length` apart on its x; `Plus` is left of it.
    Distances {
        distances: [Length; 2],
        length: Expr,
        side: Sign,
    },
}

/// One statement that places something. The comments name what the formulas call it.
pub(crate) enum Step {
    Ground {
        point: PointId,
        at: [Expr; 2],
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
    Crank {
        group: GroupId,
        link: LinkId,
        pivot: PointId,
        /// The pin and its distance from the pivot; a body without a pin has neither.
        pin: Option<(PointId, Length)>,
        angle: AngleSum,
        relative_to: Carrier,
    },
    Slider {
        group: GroupId,
        link: LinkId,
        guide: GuideId,
        pin: Option<PointId>,
        slide: Expr,
        offset: Expr,
    },
    Rrr {
        group: GroupId,
        links: [LinkId; 2],
        outer: [PointId; 2],
        pin: PointId,
        lengths: [Length; 2],
        mode: Mode,
    },
    Rrp {
        group: GroupId,
        links: [LinkId; 2],
        outer: PointId,
        guide: GuideId,
        pin: PointId,
        length: Length,
        offset: Expr,
        mode: Mode,
    },
    Rpr {
        group: GroupId,
        links: [LinkId; 2],
        outer: [PointId; 2],
        offset: Expr,
        mode: Mode,
    },
    Prp {
        group: GroupId,
        links: [LinkId; 2],
        guides: [GuideId; 2],
        pin: PointId,
        offsets: [Expr; 2],
    },
    Rpp {
        group: GroupId,
        links: [LinkId; 2],
        outer: PointId,
        guide: GuideId,
        slot: AngleSum,
        offsets: [Expr; 2],
    },
}

/// A length that must be positive, and the words that name it in `SolveError::Invalid`.
#[derive(Clone, Debug)]
pub(crate) struct Length {
    pub value: Expr,
    pub name: String,
}
