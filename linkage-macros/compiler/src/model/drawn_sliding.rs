//! Links of a drawing by their statements: their names, and what slides.

use proc_macro2::Ident;

use crate::syntax::tree::GroupStatement;

use crate::model::mechanism::{LinkId, Sign, StandsFor};
use crate::model::scope::Scope;
use crate::model::uses;

/// The names of links as users know them.
pub(in crate::model) fn title_as_drawn<'n>(
    scope: &Scope<'_>,
    names: impl Iterator<Item = &'n Ident>,
) -> String {
    let stands_for = |name| scope.drawn.map_or(StandsFor::Itself, |drawn| drawn.stands_for(name));
    let known = names.flat_map(|name| match stands_for(name) {
        StandsFor::Itself => vec![name.to_string()],
        StandsFor::EndOf(_) => Vec::new(),
        StandsFor::Links(links) => links.iter().map(ToString::to_string).collect(),
    });
    known.collect::<Vec<_>>().join(", ")
}

/// The mode that a group which is declared by hand leaves to the drawing.
pub(in crate::model) fn mode_as_drawn(scope: &Scope<'_>, group: &GroupStatement) -> Option<Sign> {
    scope.drawn?.modes.get(&group.legs.first()?.link).copied()
}

/// True if a group of a drawing makes the link.
pub(in crate::model) fn is_drawn(scope: &Scope<'_>, link: &Ident) -> bool {
    scope.names.symbol(link).is_some_and(|symbol| symbol.is_drawn)
}

/// The link by whose joint a link slides; `None` where that is not made yet, which is reported.
pub(in crate::model) fn slides_by(
    scope: &mut Scope<'_>,
    name: &Ident,
    link: LinkId,
) -> Option<LinkId> {
    let Some(slide) = scope.drawn.and_then(|drawn| drawn.slide_of(name)) else {
        return Some(link);
    };
    uses::link(scope, &Ident::new(&slide.by.to_string(), name.span()))
}

/// True if a point is a joint between drawn links.
pub(in crate::model) fn is_joint_of_a_drawing(scope: &Scope<'_>, point: &Ident) -> bool {
    scope.drawn.is_some_and(|drawn| drawn.joints.contains(point))
}
