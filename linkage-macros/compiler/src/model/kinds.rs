//! The word behind the colon: what kind of quantity a name stands for.

use proc_macro2::Ident;

use crate::diagnostics::nearest;

use crate::model::mechanism::Dimension;
use crate::model::names::listed;
use crate::model::scope::Scope;
use crate::model::units::unit;

/// Kinds of inputs and of unknowns.
pub(super) const KINDS: [&str; 2] = ["angle", "length"];

/// The word after the colon is one that exists.
pub(super) fn quantity_kind(
    scope: &mut Scope<'_>,
    kind: &Ident,
    what: &str,
    known: &[&'static str],
) -> Option<Dimension> {
    let text = kind.to_string();
    match text.as_str() {
        "angle" => return Some(Dimension::ANGLE),
        "length" => return Some(Dimension::LENGTH),
        "number" if known.contains(&"number") => return Some(Dimension::NUMBER),
        _ => {}
    }
    let kind_of_unit = unit(&text).and_then(|(dimension, _)| match dimension {
        Dimension::ANGLE => Some("angle"),
        Dimension::LENGTH => Some("length"),
        _ => None,
    });
    if let Some(kind_of_unit) = kind_of_unit {
        let message = format!("`{text}` is a unit; write `{kind_of_unit}`");
        let reason = "a value is in metres and radians; units stand behind numbers: `30deg`";
        scope.diagnostics.error_because(kind.span(), message, reason);
        return None;
    }
    let mut message = format!("no {what} named `{text}`");
    if let Some(near) = nearest(&text, known.iter().copied()) {
        message += &format!("; one with a similar name exists: `{near}`");
    }
    let known: Vec<_> = known.iter().map(|kind| format!("`{kind}`")).collect();
    let reason = format!("it is {}", listed(&known, "or"));
    scope.diagnostics.error_because(kind.span(), message, reason);
    None
}
