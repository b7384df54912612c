//! What each group's solution leaves for its reactions: the vectors of its position and the inverse
//! that its velocities have, under the letters of the group's own file.

use crate::equations::symbol::{Sym, Vector};

/// What the reactions of a solved group are made of: the vectors of its position and the inverse
/// that its velocities have.
#[derive(Clone, Copy)]
pub(super) enum Levers<'s> {
    Rrr(Rrr<'s>),
    Rrp(Rrp<'s>),
    Rpr(Rpr<'s>),
    Prp(Prp<'s>),
    Rpp(Rpp<'s>),
}

/// The vectors of the bars and 1/J.
#[derive(Clone, Copy)]
pub(super) struct Rrr<'s> {
    pub r: [Vector<'s>; 2],
    pub inverse: Sym<'s>,
}

/// The bar's vector, the guide's axes, t of the bar in them, and 1/X.
#[derive(Clone, Copy)]
pub(super) struct Rrp<'s> {
    pub r: Vector<'s>,
    pub u: Vector<'s>,
    pub n: Vector<'s>,
    pub across: Sym<'s>,
    pub inverse: Sym<'s>,
}

/// The bar's normal and 1/s.
#[derive(Clone, Copy)]
pub(super) struct Rpr<'s> {
    pub n: Vector<'s>,
    pub inverse: Sym<'s>,
}

/// The guides' directions and 1/Δ.
#[derive(Clone, Copy)]
pub(super) struct Prp<'s> {
    pub u: [Vector<'s>; 2],
    pub inverse: Sym<'s>,
}

/// The directions of rail and slot, c and 1/σ, and s₂ + e₁ σ.
#[derive(Clone, Copy)]
pub(super) struct Rpp<'s> {
    pub rail: Vector<'s>,
    pub slot: Vector<'s>,
    pub cosine: Sym<'s>,
    pub inverse: Sym<'s>,
    pub arm: Sym<'s>,
}
