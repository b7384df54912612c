//! Drivers and dyads: a file each, with everything that is the kind's own, and the list of them.
//!
//! A file places the links of its group, gives their rates, the distance from the group's limit, the
//! value under its root, and the reactions of its joints. The model (`incidence.rs`) knows which
//! joints there are and which bodies they connect; `forces` puts the opposites of reactions on those.

mod crank;
mod prp;
mod rpp;
mod rpr;
mod rrp;
mod rrr;
mod slider;

use crate::equations::kinematics::Kinematics;
use crate::equations::parts::{ClearanceTerms, LimitMeasures, Solved};
use crate::model::mechanism::Group;
use crate::syntax::anatomy::Class;

/// The formulas of a kind of group.
pub(super) trait Formulas {
    fn solve<'s>(&self, known: &Kinematics<'s>, group: &'s Group) -> Solved<'s>;

    /// The distance from its limit and the transmission angle, of a dyad.
    fn measures<'s>(&self, _: &Kinematics<'s>, _: &'s Group) -> Option<LimitMeasures<'s>> {
        None
    }

    /// The value under its root, where it can be assembled in two ways.
    fn clearance<'s>(&self, _: &Kinematics<'s>, _: &'s Group) -> Option<ClearanceTerms<'s>> {
        None
    }
}

/// Every kind of group.
pub(super) fn formulas(kind: Class) -> &'static dyn Formulas {
    match kind {
        Class::Crank => &crank::Crank,
        Class::Slider => &slider::Slider,
        Class::Rrr => &rrr::Rrr,
        Class::Rrp => &rrp::Rrp,
        Class::Rpr => &rpr::Rpr,
        Class::Prp => &prp::Prp,
        Class::Rpp => &rpp::Rpp,
    }
}
