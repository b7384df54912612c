//! The parts of a group while it is resolved: what its statement gives and makes, and its dimensions.

use proc_macro2::{Ident, Span};

use crate::diagnostics::Extent;
use crate::syntax::anatomy::{GroupSpec, Pin};
use crate::syntax::tree::{Expr, GroupFieldValue};

use crate::model::expr::{AngleSum, Scalar};
use crate::model::figures::Figure;
use crate::model::incidence::{Assembly, Carrier, Length, Sign};
use crate::model::mechanism::{GroupId, GuideId, LinkId, PointId};

/// The things that a group makes, and those that it stands on.
pub(in crate::model) struct Parts {
    /// Where messages about the whole group stand.
    pub at: Span,
    pub anatomy: &'static GroupSpec,
    pub id: GroupId,
    /// One a leg; `None` where the name was in error.
    pub links: Vec<Option<LinkId>>,
    pub outer: Vec<Option<OuterJoint>>,
    /// The name of its pin, where it has one or should have.
    pub pin_name: Option<Ident>,
    /// `None` where the name was in error, too.
    pub pin: Option<PointId>,
}

/// The support of an outer joint.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::model) enum OuterJoint {
    Point(PointId),
    Guide(GuideId),
}

/// The fields that are known and of the right shape.
pub(in crate::model) struct Fields<'t> {
    pub known: Vec<(&'static str, &'t GroupFieldValue)>,
    /// Fields that are there in some form, right or wrong: none of these is missing.
    pub present: Vec<&'static str>,
    pub all_are_read: bool,
}

/// The numbers that give a group, whether its fields hold them or its drawing.
#[derive(Default)]
pub(in crate::model) struct GroupNumbers {
    /// Those of the first bar or of both.
    pub lengths: Vec<Figure>,
    pub angle: Option<Figure>,
    pub slide: Option<Figure>,
    pub slot: Option<Figure>,
    /// None where all are zero.
    pub offsets: Vec<Figure>,
    /// In a drawing, the link that the angle is measured from; none for the ground.
    pub relative_to: Option<Ident>,
    /// In a drawing, the mode; none for plus, or where there is one way.
    pub mode: Option<Sign>,
}

impl GroupNumbers {
    pub(in crate::model) fn all(&self) -> Vec<Figure> {
        let Self { lengths, angle, slide, slot, offsets, .. } = self;
        lengths.iter().chain(angle).chain(slide).chain(slot).chain(offsets).cloned().collect()
    }
}

/// The numbers that the fields of a group give, as far as they are right.
pub(in crate::model) struct Dimensions {
    /// By link.
    pub lengths: Vec<Option<Length>>,
    pub angle: Option<AngleSum>,
    pub relative_to: Option<Carrier>,
    pub slide: Option<Scalar>,
    pub slot: Option<AngleSum>,
    /// Where that is written.
    pub slot_at: Option<Extent>,
    /// In the order of the statement.
    pub offsets: Option<Vec<Scalar>>,
    pub assembly: Option<Assembly>,
}

impl Parts {
    /// True if the group has a pin, or should have one.
    pub(in crate::model) fn has_pin(&self) -> bool {
        match self.anatomy.pin {
            Pin::Needed => true,
            Pin::Optional => self.pin_name.is_some(),
            Pin::None(_) => false,
        }
    }

    pub(in crate::model) fn link(&self, i: usize) -> Option<LinkId> {
        self.links.get(i).copied().flatten()
    }

    pub(in crate::model) fn point(&self, i: usize) -> Option<PointId> {
        match self.outer.get(i).copied().flatten()? {
            OuterJoint::Point(id) => Some(id),
            OuterJoint::Guide(_) => None,
        }
    }

    pub(in crate::model) fn guide(&self, i: usize) -> Option<GuideId> {
        match self.outer.get(i).copied().flatten()? {
            OuterJoint::Guide(id) => Some(id),
            OuterJoint::Point(_) => None,
        }
    }
}

impl<'t> Fields<'t> {
    pub(super) fn one(&self, name: &str) -> Option<&'t Expr> {
        match self.value(name)? {
            GroupFieldValue::One(value) => Some(value),
            GroupFieldValue::Pair(_) => None,
        }
    }

    pub(super) fn pair(&self, name: &str) -> Option<&'t [Expr; 2]> {
        match self.value(name)? {
            GroupFieldValue::One(_) => None,
            GroupFieldValue::Pair(values) => Some(values),
        }
    }

    /// True if the field is absent and its default holds.
    pub(super) fn is_left_out(&self, name: &str) -> bool {
        self.all_are_read && !self.present.contains(&name)
    }

    fn value(&self, name: &str) -> Option<&'t GroupFieldValue> {
        self.known.iter().find(|(known, _)| *known == name).map(|&(_, value)| value)
    }
}
