//! Bodies and joints: what every group is made of, and what follows from it.
//!
//! A group is a way to solve some joints. Owners, carriers and motion are read from the joints, once
//! for all kinds of groups. Code matches a kind only where formulas, words or shapes are its own.

use crate::syntax::anatomy::Class;

use super::expr::{AngleSum, Scalar};
use super::ids::{GroupId, GuideId, LinkId, ParamId, PointId};

/// A body that joints connect and that forces act on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Body {
    Ground,
    Link(LinkId),
    /// The pin between the links of a dyad, a body without mass of its own; or a driven point.
    Pin(PointId),
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sign {
    Plus,
    Minus,
}

/// An assembly mode: +1 is `left` or `ahead`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mode {
    Fixed(Sign),
    /// A mode parameter.
    Param(ParamId),
}

/// The body to which a point, a guide or a crank's angle is fixed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Carrier {
    Ground,
    Link(LinkId),
}

/// A length that must be positive, and the words that name it in `SolveError::Invalid`.
#[derive(Clone, Debug)]
pub struct Length {
    pub value: Scalar,
    pub name: String,
}

/// A joint of a group: its link is the second of the bodies.
#[derive(Clone)]
pub struct Joint {
    pub kind: JointKind,
    pub bodies: [Body; 2],
    pub drive: Option<Drive>,
}

#[derive(Clone)]
pub enum JointKind {
    Revolute(PointId),
    /// The link's origin keeps the offset from the line, along its normal; none where it is on it.
    Prismatic {
        along: Slideway,
        offset: Option<Scalar>,
    },
}

/// The line that a link slides along.
#[derive(Clone)]
pub enum Slideway {
    Guide(GuideId),
    /// The x axis of a link.
    Bar(LinkId),
    /// A slot of a link, at an angle to the link's x axis and so far across it.
    Slot {
        link: LinkId,
        across: Scalar,
        angle: AngleSum,
    },
}

/// The motion that a driver sets.
#[derive(Clone)]
pub enum Drive {
    Angle { angle: AngleSum, relative_to: Carrier },
    Slide(Scalar),
}

/// The ways in which a group can be assembled.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Assembly {
    Unique,
    Signed(Mode),
    /// `mode: parallel`, of two bars.
    Parallel(Opposite),
}

/// The corner of a parallelogram that is opposite to the pin of its bars.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Opposite {
    pub corner: PointId,
    /// By bar, the body that the opposite side is on.
    pub carriers: [Carrier; 2],
}

/// A driver or a dyad.
#[derive(Clone)]
pub struct Group {
    pub id: GroupId,
    pub kind: Class,
    pub links: Vec<LinkId>,
    /// One a link, in their order.
    pub outer: Vec<Joint>,
    /// Between the links: both on the pin, or one that slides.
    pub inner: Vec<Joint>,
    pub pin: Option<PointId>,
    /// By link, from its outer joint to the pin.
    pub lengths: Vec<Option<Length>>,
    pub assembly: Assembly,
}

impl From<Carrier> for Body {
    fn from(carrier: Carrier) -> Self {
        match carrier {
            Carrier::Ground => Self::Ground,
            Carrier::Link(link) => Self::Link(link),
        }
    }
}

impl Joint {
    pub fn link(&self) -> LinkId {
        match self.bodies[1] {
            Body::Link(link) => link,
            Body::Ground | Body::Pin(_) => unreachable!("a joint is a link's"),
        }
    }

    pub fn point(&self) -> Option<PointId> {
        match self.kind {
            JointKind::Revolute(point) => Some(point),
            JointKind::Prismatic { .. } => None,
        }
    }

    pub fn slideway(&self) -> Option<&Slideway> {
        match &self.kind {
            JointKind::Revolute(_) => None,
            JointKind::Prismatic { along, .. } => Some(along),
        }
    }

    pub fn guide(&self) -> Option<GuideId> {
        match self.slideway()? {
            Slideway::Guide(guide) => Some(*guide),
            Slideway::Bar(_) | Slideway::Slot { .. } => None,
        }
    }

    pub fn offset(&self) -> Option<&Scalar> {
        match &self.kind {
            JointKind::Revolute(_) => None,
            JointKind::Prismatic { offset, .. } => offset.as_ref(),
        }
    }
}

impl Group {
    /// Outer joints, then inner ones.
    pub fn joints(&self) -> impl Iterator<Item = &Joint> {
        self.outer.iter().chain(&self.inner)
    }

    /// True for two bars with a pin between them, each on another pin.
    pub(crate) fn is_of_bars(&self) -> bool {
        let are_pinned = self.outer.iter().all(|joint| joint.point().is_some());
        let have_lengths = self.lengths.iter().all(Option::is_some);
        self.links.len() == 2 && self.pin.is_some() && are_pinned && have_lengths
    }

    /// The point that the link with this index stands on.
    pub fn stands_on(&self, index: usize) -> PointId {
        self.outer[index].point().expect("its row has a revolute joint here")
    }

    /// The guide that the link with this index slides on.
    pub fn slides_on(&self, index: usize) -> GuideId {
        self.outer[index].guide().expect("its row has a prismatic joint here")
    }

    pub(crate) fn length(&self, index: usize) -> &Length {
        self.lengths[index].as_ref().expect("its row has a bar here")
    }

    /// Distances declared across its slideways, joint by joint: a slot's own, then the offset in it.
    pub fn offsets(&self) -> Vec<&Scalar> {
        let across = |joint| match Joint::slideway(joint)? {
            Slideway::Slot { across, .. } => Some(across),
            Slideway::Guide(_) | Slideway::Bar(_) => None,
        };
        self.joints().flat_map(|joint| [across(joint), joint.offset()]).flatten().collect()
    }

    pub fn mode(&self) -> Option<Mode> {
        match self.assembly {
            Assembly::Unique | Assembly::Parallel(_) => None,
            Assembly::Signed(mode) => Some(mode),
        }
    }

    /// The fourth corner, where its bars stay opposite sides of a parallelogram.
    pub(crate) fn opposite(&self) -> Option<Opposite> {
        match self.assembly {
            Assembly::Unique | Assembly::Signed(_) => None,
            Assembly::Parallel(opposite) => Some(opposite),
        }
    }

    /// The point at the origin of the link: its outer joint, or the pin where it slides.
    pub(crate) fn origin(&self, link: LinkId) -> Option<PointId> {
        let place = self.links.iter().position(|own| *own == link)?;
        self.outer[place].point().or_else(|| {
            let mut inner = self.inner.iter().filter(|joint| joint.link() == link);
            inner.find_map(Joint::point)
        })
    }
}
