//! The statements between `unknown` and `solve`.

use std::collections::HashSet;

use proc_macro2::Ident;

use super::mechanism::UnknownId;
use super::names::Entity;

/// The unknown between its `unknown` and its `solve`, and what has been made of it.
pub(super) struct Searched {
    pub id: UnknownId,
    pub name: Ident,
    pub follows: HashSet<Entity>,
}

impl Searched {
    pub(super) fn reaches(&self, entity: Entity) -> bool {
        self.follows.contains(&entity)
    }
}
