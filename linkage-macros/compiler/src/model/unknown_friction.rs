//! Friction that no reaction tells: beside a search, and at bars that stand for drawn links.

use proc_macro2::{Ident, Span};

use crate::model::mechanism::{LinkId, StandsFor};
use crate::model::scope::Scope;

/// Friction beside an unknown, or beside links of a drawing that are searched for.
pub(in crate::model) fn beside_an_unknown(scope: &mut Scope<'_>, at: Span) {
    let mechanism = &scope.mechanism;
    let hidden = mechanism.unknowns.iter().find(|unknown| scope.names.is_hidden(&unknown.name));
    let (message, reason) = match hidden {
        Some(unknown) => (
            format!(
                "beside `{}`, which are one group of class III, no joint has friction",
                mechanism.title_of_unknown(unknown)
            ),
            "what closes the group follows from reactions, friction among them, and friction from it; drive another \
             joint, so that each pair of links stands on what is known",
        ),
        None => (
            "beside an unknown no joint has friction".to_string(),
            "what holds the equation of `solve` follows from reactions, friction among them, and friction from it",
        ),
    };
    scope.diagnostics.error_because(at, message, reason);
}

/// The links that turn at a pin are those of the declaration, and no bar or block stands for one.
pub(in crate::model) fn known_by_their_links(
    scope: &mut Scope<'_>,
    pin: &Ident,
    links: &[LinkId],
) -> Option<()> {
    let stands_for = |link: &LinkId| &scope.mechanism.links[link.index()].stands_for;
    if links.iter().all(|link| matches!(stands_for(link), StandsFor::Itself)) {
        return Some(());
    }
    let message =
        format!("friction at `{pin}` is not known where a drive holds two moving links together");
    let reason = "one bar stands for both links in their group, and what presses in its joints is not what presses \
                  in theirs";
    scope.diagnostics.error_because(pin.span(), message, reason);
    None
}
