//! The equation of one amount of friction among those that depend on each other.

use crate::equations::symbol::Sym;

/// One amount's equation.
pub(super) struct Row<'s> {
    /// c
    pub share: Sym<'s>,
    /// G
    pub free: [Sym<'s>; 2],
    /// A, by amount.
    pub changes: Vec<[Sym<'s>; 2]>,
    pub is_guide: bool,
    /// The joint, as errors name it.
    pub joint: String,
}

impl<'s> Row<'s> {
    /// c, G and A, as the run-time crate lays a row out.
    pub(super) fn operands(&self) -> impl Iterator<Item = Sym<'s>> {
        let changes = self.changes.iter().flatten().copied();
        std::iter::once(self.share).chain(self.free).chain(changes)
    }

    /// The size of the reaction without friction.
    pub(super) fn size(&self) -> Sym<'s> {
        let [x, y] = self.free;
        if !self.is_guide {
            return x.hypot(y);
        }
        let [x, y] = [x, y].map(Sym::magnitude);
        if y.is_zero() { x } else { x.at_least(y, x, y) }
    }
}
