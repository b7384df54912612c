//! The joints of a link that a search left out. The link stands on one of them; at the other a block stands in for it, whose
//! name nobody has written.

use proc_macro2::Ident;

use crate::model::acting::{Effort, RequestedEffort};
use crate::model::drawn_links::RodEnd;

/// The efforts of blocks as those of their links; what lies between the two is not asked for.
pub(in crate::model::drawn) fn as_of_links(
    ends: &[RodEnd],
    asked: Vec<RequestedEffort>,
) -> Vec<RequestedEffort> {
    let mut renamed: Vec<RequestedEffort> = Vec::new();
    for mut effort in asked {
        if let Some(end) = ends.iter().find(|end| end.block == effort.owner) {
            if !matches!(effort.effort, Effort::Pin(..)) {
                continue;
            }
            effort.owner = Ident::new(&end.link.to_string(), effort.owner.span());
        }
        // Efforts of one owner form one field of the result.
        let behind = renamed.iter().rposition(|known| known.owner == effort.owner);
        renamed.insert(behind.map_or(renamed.len(), |last| last + 1), effort);
    }
    renamed
}
