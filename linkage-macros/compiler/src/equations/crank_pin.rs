//! A pin that swings about a point of the ground, seen from another one: the dyads RRR and RPR behind a crank.
//!
//! With the arm a of the pin B about A, and G = D − A to the other point, the line d = D − B has
//!
//! ```text
//! d² = G² + a² − 2 G·a     a·d = G·a − a²     d × a = G × a
//! ```
//!
//! in which a² does not turn, so that all of them are affine in one product: they are there before d is, and
//! what is made of them waits for no sum of squares.
//!
//! # Error
//! G² + a² is made of larger numbers than d² where B comes near D: [`CrankPin::of`] refuses what would come
//! nearer than a quarter of its farthest distance, where the sum has four times the last place of
//! d²'s.

use super::motion::{PointMotion, Swing};
use super::symbol::Sym;

#[derive(Clone, Copy)]
pub(super) struct CrankPin<'s> {
    pub swing: Swing<'s>,
    /// G·a
    along: Sym<'s>,
    /// G × a, which is d × a.
    pub across: Sym<'s>,
    /// G² and a²
    pub squares: [Sym<'s>; 2],
}

impl<'s> CrankPin<'s> {
    /// Where B is such a pin and D a point of the ground, not too near to its circle.
    pub(super) fn of([b, d]: [PointMotion<'s>; 2]) -> Option<Self> {
        let swing = b.swing.filter(|_| d.is_fixed())?;
        let between = d.base - b.base;
        let squares = [between.dot(between), swing.square()];
        let [reach, radius] = squares.map(|square| square.constant_value().map(f64::sqrt));
        let (reach, radius) = (reach?, radius?);
        let is_clear = reach + radius <= 4.0 * (reach - radius).abs();
        let (along, across) = (between.dot(swing.arm), between.cross(swing.arm));
        is_clear.then_some(Self { swing, along, across, squares })
    }

    /// G² + a², from which twice G·a is taken.
    pub(super) fn square_parts(self) -> [Sym<'s>; 2] {
        let [reach, radius] = self.squares;
        [reach + radius, self.along]
    }

    /// d²
    pub(super) fn square(self) -> Sym<'s> {
        let [sum, along] = self.square_parts();
        sum - along.twice()
    }

    /// Half of the rate and of the acceleration of d²: ω G × a, and α G × a + ω² G·a.
    pub(super) fn half_rates(self) -> [Sym<'s>; 2] {
        let (omega, alpha) = (self.swing.omega, self.swing.alpha);
        [omega * self.across, alpha * self.across + omega.squared() * self.along]
    }

    /// a·d
    pub(super) fn along(self) -> Sym<'s> {
        self.along - self.squares[1]
    }
}
