//! Friction as loads of known size: opposite couples of two bodies, opposite forces along a guide.

use super::{Applied, Motion, Part, part_of_carrier};
use crate::equations::kinematics::Kinematics;
use crate::ir::interpret::Number;
use crate::model::acting::Contact;
use crate::model::mechanism::{LinkId, Slideway};
use crate::oracle::Digits;

impl Motion<Digits> {
    /// A contact brakes its link with this couple or force, and the other body with the opposite.
    pub(in crate::equations) fn brake(
        &mut self,
        kinematics: &Kinematics<'_>,
        contact: Contact,
        braking: &Digits,
    ) {
        let zero = super::whole(0);
        let none = [zero.clone(), zero.clone()];
        let pair = match contact {
            Contact::Pin { link, against, .. } => {
                let parts = [Part::Link(link), part_of_carrier(against)];
                let couples = [braking.neg(), braking.clone()];
                parts
                    .into_iter()
                    .zip(couples)
                    .map(|(part, couple)| (part, none.clone(), couple))
                    .collect::<Vec<_>>()
            }
            Contact::Guide(link) => {
                let [x, y] = &self.directions[link.index()];
                let force = [x.mul(braking), y.mul(braking)];
                let back = super::negative(&force);
                vec![
                    (Part::Link(link), back, zero.clone()),
                    (under(kinematics, link), force, zero.clone()),
                ]
            }
        };
        let at = match contact {
            Contact::Guide(link) => self.origins[link.index()].clone(),
            Contact::Pin { .. } => none.clone(),
        };
        self.applied.extend(pair.into_iter().map(|(part, force, couple)| Applied {
            part,
            at: at.clone(),
            force,
            couple,
            velocity: none.clone(),
            omega: zero.clone(),
        }));
    }
}

/// The part that a link slides on.
pub(super) fn under(kinematics: &Kinematics<'_>, link: LinkId) -> Part {
    let mut joints = kinematics.mechanism.joints().filter(|joint| joint.link() == link);
    let found = joints.find_map(|joint| match joint.slideway()? {
        Slideway::Guide(guide) => Some(Part::Guide(*guide)),
        Slideway::Bar(bar) => Some(Part::Link(*bar)),
        Slideway::Slot { .. } => Some(Part::Slot(link)),
    });
    found.expect("it slides")
}
