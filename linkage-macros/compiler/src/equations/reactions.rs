//! Loads on the links of a group, and the reactions of its joints to them.

use crate::equations::symbol::{Sym, Vector};

/// The force on a link but for the joints of its own group, and the moment about the link's origin.
#[derive(Clone, Copy)]
pub struct Acting<'s> {
    pub force: Vector<'s>,
    pub moment: Sym<'s>,
}

/// A guide's reaction on the link that slides on it: a force along its normal, at the origin of the
/// link's frame, and a couple.
#[derive(Clone, Copy)]
pub(super) struct GuideReaction<'s> {
    pub normal: Sym<'s>,
    pub couple: Sym<'s>,
}

/// The part of a dyad's solution that its reactions are made of: the vectors of its position and the
/// inverse that its velocities have.
pub(super) trait JacobianFactors<'s> {
    fn reactions(&self, loads: &Loads<'s>) -> Reactions<'s>;

    /// By link, the largest turning or slide by which the loop takes in a unit of length, but for its sign: the
    /// norms of the rows of J⁻¹.
    fn gains(&self) -> [Sym<'s>; 2];

    /// The efforts of a slot's distance and angle in its link.
    fn efforts_of_slot(&self, _: GuideReaction<'s>, _: Sym<'s>) -> [Sym<'s>; 2] {
        unreachable!("only a group with a slot has any")
    }
}

/// Loads on a dyad from outside.
pub(super) struct Loads<'s> {
    /// By link, but for its own joints.
    pub links: [Acting<'s>; 2],
    pub pin: Vector<'s>,
    /// The force on the first link along the line on which it slides in the second.
    pub along: Sym<'s>,
}

/// Forces and couples of the joints of a dyad on its links.
pub(super) struct Reactions<'s> {
    /// By link.
    pub outer: [Reaction<'s>; 2],
    pub inner: Inner<'s>,
}

pub(super) enum Reaction<'s> {
    Force(Vector<'s>),
    Guide(GuideReaction<'s>),
}

pub(super) enum Inner<'s> {
    /// The pin's force on either link.
    Pin([Vector<'s>; 2]),
    /// The second link's on the first.
    Slide(GuideReaction<'s>),
}
