//! Slides of a drawing: what a group's joint exerts and transmits, told of the link that is drawn as sliding.
//!
//! A group may have the joint the other way round (σ = −1 in place of +1), and of another link's place. With s and S, N, T
//! the group's slide, the forces along the guide and along its normal and the couple, all at the origin O of the frame of
//! the group's link, and r = (x, y) from the origin of the drawn link's frame to O in the guide's axes,
//!
//! ```text
//! slide = σ s + shift      normal = σ N      couple = σ (T + x N − y S)      force along = σ S
//! ```
//!
//! Where the joint is reversed, r grows with s.

use crate::equations::forces::walk::Walk;
use crate::equations::kinematics::Kinematics;
use crate::equations::reactions::GuideReaction;
use crate::equations::symbol::Sym;
use crate::model::acting::Effort;
use crate::model::as_drawn::DrawnSlide;
use crate::model::mechanism::LinkId;

/// The reaction of a guide on the link that is drawn as sliding.
pub(super) fn reaction_as_drawn<'s>(
    kinematics: &Kinematics<'s>,
    by: LinkId,
    reaction: GuideReaction<'s>,
    along: Sym<'s>,
) -> GuideReaction<'s> {
    let Some(DrawnSlide { is_reversed, arm, .. }) = kinematics.mechanism.slide_as_drawn(by) else {
        return reaction;
    };
    let GuideReaction { normal, couple } = reaction;
    let [x, y] = kinematics.jets(arm).map(|jet| jet.value);
    let slide = kinematics.link(by).slide.expect("it slides").value;
    let x = if *is_reversed { x + slide } else { x };
    let couple = couple + (x * normal - y * along);
    match is_reversed {
        true => GuideReaction { normal: -normal, couple: -couple },
        false => GuideReaction { normal, couple },
    }
}

impl<'s> Walk<'_, 's> {
    /// Normal force and couple on the link that is drawn as sliding by the joint of another.
    pub(super) fn guide_as_drawn(&self, by: LinkId) -> Vec<Sym<'s>> {
        let found = &self.found[&Effort::Guide(by)];
        let reaction = GuideReaction { normal: found[0], couple: found[1] };
        let along = self.along[&by];
        let GuideReaction { normal, couple } =
            reaction_as_drawn(self.kinematics, by, reaction, along);
        vec![normal, couple]
    }

    /// A force on the link that is drawn as sliding, along its slide, and its opposite on what it slides on.
    pub(super) fn push_drawn_slide(&mut self, by: LinkId, force: Sym<'s>) {
        let mechanism = self.kinematics.mechanism;
        let Some(slide) = mechanism.slide_as_drawn(by) else { return self.push_slide(by, force) };
        self.push_slide(by, if slide.is_reversed { -force } else { force });
        self.transmit(&slide.shift, -force);
    }
}
