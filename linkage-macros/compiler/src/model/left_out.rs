//! The body that holds the equation of an unknown: the bar or the block that the declaration has left out.
//!
//! `distance(P, Q) = l` is a bar without mass between two pins, `offset(P, guide) = h` a block on the
//! guide, pinned at P. Any other equation may be held by a drive on either side, and nobody says which.

use crate::exact::Exact;

use super::mechanism::{
    Drive, Equation, Group, Joint, LinkId, Mechanism, Scalar, Slideway, Step, UnknownId,
};

impl Mechanism {
    /// True if bodies hold every equation, so that all reactions are known.
    pub(crate) fn equations_are_held(&self) -> bool {
        self.unknowns.iter().all(|unknown| match &unknown.equation {
            Equation::Distance { .. } => true,
            Equation::Difference(sides) => {
                sides.iter().any(|side| matches!(side, Scalar::Offset(..)))
                    && sides.iter().any(|side| !matches!(side, Scalar::Offset(..)))
            }
            Equation::Turn(_) => false,
        })
    }

    /// True if an unknown is in what drives the link: alone there, it drives with nothing.
    pub(crate) fn is_driven_by_an_unknown(&self, link: LinkId) -> bool {
        let group = self.group_steps().find(|group| group.links.contains(&link));
        group.and_then(|group| group.outer[0].drive.as_ref()).is_some_and(|drive| match drive {
            Drive::Angle { angle, .. } => self.has_an_unknown(&angle.rest),
            Drive::Slide(slide) => self.has_an_unknown(slide),
        })
    }

    fn has_an_unknown(&self, expr: &Scalar) -> bool {
        expr.any_leaf(&|leaf| match leaf {
            Scalar::Unknown(_) | Scalar::Tracked(..) => true,
            Scalar::Let(id) => self.has_an_unknown(&self.lets[id.index()].rest),
            _ => false,
        })
    }

    /// The group behind `solve` that draws the bar or the block which holds the equation.
    pub fn left_out(&self, id: UnknownId) -> Option<&Group> {
        let unknown = &self.unknowns[id.index()];
        let mut behind = self.steps[unknown.steps[1]..].iter().filter_map(|step| match step {
            Step::Group(group) => Some(group),
            _ => None,
        });
        match &unknown.equation {
            Equation::Distance { points: [p, q], .. } => behind.find(|group| {
                let ends = || group.outer.iter().map(Joint::point);
                let is_between = ends().eq([Some(*p), Some(*q)]) || ends().eq([Some(*q), Some(*p)]);
                is_between && group.inner.iter().any(is_on_a_bar)
            }),
            Equation::Difference(sides) => {
                let (point, guide) = sides.iter().find_map(|side| match side {
                    Scalar::Offset(point, guide) => Some((*point, *guide)),
                    _ => None,
                })?;
                behind.find(|group| {
                    group.outer.len() == 2
                        && group.outer[0].point() == Some(point)
                        && group.outer[1].guide() == Some(guide)
                        && group.inner.iter().any(is_in_a_square_slot)
                })
            }
            Equation::Turn(_) => None,
        }
    }
}

fn is_zero(expr: &Scalar) -> bool {
    matches!(expr, Scalar::Constant(value) if value.is_zero())
}

/// True if the joint slides along the x axis of a link, from which it has no offset.
fn is_on_a_bar(joint: &Joint) -> bool {
    matches!(joint.slideway(), Some(Slideway::Bar(_))) && joint.offset().is_none_or(is_zero)
}

/// True if the joint slides square to the x axis of a link, in a slot from which it has no offset.
fn is_in_a_square_slot(joint: &Joint) -> bool {
    let Some(Slideway::Slot { angle, .. }) = joint.slideway() else { return false };
    let right = || Exact::pi().div(&Exact::integer(2));
    match &angle.rest {
        Scalar::Constant(value) if angle.links.is_empty() && joint.offset().is_none_or(is_zero) => {
            right().is_some_and(|right| value.sub(&right).is_zero())
        }
        _ => false,
    }
}
