//! The walk through the statements, one after the other: each is resolved by its rules.

use crate::model::items::Item;
use crate::model::scope::Scope;

pub(super) fn items(scope: &mut Scope<'_>, items: &[Item<'_>]) {
    for (index, item) in items.iter().enumerate() {
        scope.names.go_to(index);
        item.rules.resolve(scope, item.docs);
        note_what_follows(scope, item);
    }
    scope.names.go_to(items.len());
}

/// Notes what the item has made with the unknown that is searched, or with what follows it.
fn note_what_follows(scope: &mut Scope<'_>, item: &Item<'_>) {
    let Some(searched) = scope.facts.searched() else { return };
    if !item.rules.uses(scope, &|entity| searched.reaches(entity)) {
        return;
    }
    let declared = item.rules.declares();
    let made = declared.iter().filter_map(|(name, _)| scope.names.made(name));
    if let Some(searched) = scope.facts.searches.last_mut() {
        searched.follows.extend(made);
    }
}
