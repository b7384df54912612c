//! A pin that swings about a point of the ground, seen from another one: the dyad RRR behind a crank.
//!
//! With the arm a of the pin B about A, and G = D − A to the other point, the line d = D − B has
//!
//! ```text
//! (d²)˙/2 = ω G × a     (d²)¨/2 = α G × a + ω² G·a     d × a = G × a
//! ```
//!
//! in which nothing cancels but the terms of G's products. d² itself is made of d's coordinates: what is made of
//! both keeps the bars' lengths only as far as they agree.

use super::motion::{PointMotion, Swing};
use super::symbol::Sym;

#[derive(Clone, Copy)]
pub(super) struct CrankPin<'s> {
    pub swing: Swing<'s>,
    /// G·a
    along: Sym<'s>,
    /// G × a, which is d × a.
    pub across: Sym<'s>,
}

impl<'s> CrankPin<'s> {
    /// Where B is such a pin and D a point of the ground.
    pub(super) fn of([b, d]: [PointMotion<'s>; 2]) -> Option<Self> {
        let swing = b.swing.filter(|_| d.is_fixed())?;
        let between = d.base - b.base;
        let (along, across) = (between.dot(swing.arm), between.cross(swing.arm));
        Some(Self { swing, along, across })
    }

    /// Half of the rate and of the acceleration of d²: ω G × a, and α G × a + ω² G·a.
    pub(super) fn half_rates(self) -> [Sym<'s>; 2] {
        let (omega, alpha) = (self.swing.omega, self.swing.alpha);
        [omega * self.across, alpha * self.across + omega.squared() * self.along]
    }
}
