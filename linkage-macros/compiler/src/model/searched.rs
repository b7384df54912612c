//! The statements between `unknown` and `solve`.

use std::collections::HashSet;

use proc_macro2::Ident;

use crate::model::mechanism::UnknownId;
use crate::model::names::Entity;

/// An unknown, and what its statement and those behind it have made of it.
pub struct Searched {
    pub id: UnknownId,
    pub name: Ident,
    pub follows: HashSet<Entity>,
    /// True behind its `solve`.
    pub ended: bool,
}

impl Searched {
    pub(super) fn reaches(&self, entity: Entity) -> bool {
        self.follows.contains(&entity)
    }
}
