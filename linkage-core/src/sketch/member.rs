//! Links of groups: what each stands on, and the shape that it is drawn in.

/// A link of a group: the outer joint by which it stands on what is there already, and the shape that
/// it is drawn in.
#[derive(Clone, Copy, Debug)]
pub struct Member {
    pub(super) link: usize,
    outer: OuterJoint,
    pub(super) shape: LinkShape,
    pub(super) is_turned: bool,
}

#[derive(Clone, Copy, Debug)]
enum OuterJoint {
    /// At this point.
    Revolute(usize),
    /// Along this guide.
    Prismatic(usize),
}

/// The shape of a link; `Member` says what each is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum LinkShape {
    Bar,
    Cylinder,
    Body,
    Block,
    Sleeve,
    SlottedBar,
    Yoke,
}

impl LinkShape {
    /// The number of its lengths and offsets.
    pub(super) fn dimensions(self) -> usize {
        match self {
            Self::Body | Self::Sleeve => 0,
            Self::Bar | Self::Cylinder | Self::Block | Self::SlottedBar => 1,
            Self::Yoke => 2,
        }
    }
}

impl Member {
    const fn revolute(link: usize, point: usize, shape: LinkShape) -> Self {
        Self { link, outer: OuterJoint::Revolute(point), shape, is_turned: false }
    }

    const fn prismatic(link: usize, guide: usize, shape: LinkShape) -> Self {
        Self { link, outer: OuterJoint::Prismatic(guide), shape, is_turned: false }
    }

    /// A bar from a point to the pin.
    #[must_use]
    pub const fn bar(link: usize, point: usize) -> Self {
        Self::revolute(link, point, LinkShape::Bar)
    }

    /// The same, of a length that an input changes.
    #[must_use]
    pub const fn cylinder(link: usize, point: usize) -> Self {
        Self::revolute(link, point, LinkShape::Cylinder)
    }

    /// A body on a point, without a second joint of its own.
    #[must_use]
    pub const fn body(link: usize, point: usize) -> Self {
        Self::revolute(link, point, LinkShape::Body)
    }

    /// A block on a guide.
    #[must_use]
    pub const fn block(link: usize, guide: usize) -> Self {
        Self::prismatic(link, guide, LinkShape::Block)
    }

    /// A block on a point, in another link of the group.
    #[must_use]
    pub const fn sleeve(link: usize, point: usize) -> Self {
        Self::revolute(link, point, LinkShape::Sleeve)
    }

    /// A bar on a point, along which a sleeve slides.
    #[must_use]
    pub const fn slotted_bar(link: usize, point: usize) -> Self {
        Self::revolute(link, point, LinkShape::SlottedBar)
    }

    /// A block on a guide with a slot for a sleeve.
    #[must_use]
    pub const fn yoke(link: usize, guide: usize) -> Self {
        Self::prismatic(link, guide, LinkShape::Yoke)
    }

    /// The same link, turned by an input against the ground.
    #[must_use]
    pub const fn turned(self) -> Self {
        Self { is_turned: true, ..self }
    }

    /// The point that it turns about.
    pub(super) fn pivot(self) -> Option<usize> {
        match self.outer {
            OuterJoint::Revolute(point) => Some(point),
            OuterJoint::Prismatic(_) => None,
        }
    }

    /// The guide that it slides on.
    pub(super) fn guide(self) -> Option<usize> {
        match self.outer {
            OuterJoint::Revolute(_) => None,
            OuterJoint::Prismatic(guide) => Some(guide),
        }
    }
}
