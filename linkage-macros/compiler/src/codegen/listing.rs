//! The sources of a list of assemblies, for every language.

use linkage_assemblies::{ClosureDegree, PinnedGroup};

use crate::lower::routine::Lowered;

/// The program of a list's numbers, and the kind of the group.
pub struct Listing<'l> {
    pub pinned: Lowered<'l>,
    pub group: &'l PinnedGroup,
    pub degree: &'l ClosureDegree,
}
