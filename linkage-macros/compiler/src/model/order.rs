//! The order of statements: each uses only what earlier ones have made.
//!
//! A name that is used too early is noted where it is met and judged here, once for the whole
//! declaration: either another order of the statements works, or some of them need each other.

use proc_macro2::Ident;

use crate::syntax::tree::StatementKind;

use crate::model::items::Item;
use crate::model::names::{Entity, listed};
use crate::model::needs::Needs;
use crate::model::reads::{Allowed, Reads};
use crate::model::scope::Scope;
use crate::model::{class_three, laws};

const TWO_UNKNOWNS: &str = "only drivers and dyads are solved in closed form; drive the chain at another \
                            link, so that each dyad stands on what is known";

/// A law of rates or loads that a statement about the machine itself uses too early.
fn law_in_a_dimension(scope: &Scope<'_>, items: &[Item<'_>]) -> Option<(Ident, Reads)> {
    let uses = scope.names.too_early.iter().filter(|use_| {
        let user = items[use_.user].written;
        !matches!(user, Some(StatementKind::Let(_) | StatementKind::Action(_)))
    });
    uses.filter_map(|use_| match scope.names.made(&use_.name)? {
        Entity::Law(id) => Some((use_.name.clone(), scope.facts.laws[id.index()].reads.clone())),
        _ => None,
    })
    .next()
}

/// Reports names that are used too early: with an order that works, or as a circle of statements
/// that need each other.
pub(super) fn items_are_in_order(scope: &mut Scope<'_>, items: &[Item<'_>]) {
    if let Some((name, reads)) = law_in_a_dimension(scope, items) {
        // No order would help.
        laws::law_stands_here(scope, &name, &reads, Allowed::IN_DIMENSIONS);
        return;
    }
    let Some(first) = scope.names.too_early.first() else {
        return;
    };
    let needs = Needs::of(items);
    let circles: Vec<_> =
        scope.names.too_early.iter().map(|use_| needs.circle(use_.user)).collect();
    let told = |index: &usize| {
        let rules = items[*index].rules;
        let name = rules.declares().first().map_or(String::new(), |(name, _)| name.to_string());
        format!("`{}`", rules.title(&name))
    };
    let (at, message, reason) = match circles.iter().position(|circle| !circle.is_empty()) {
        Some(index) => {
            let statements: Vec<_> = circles[index].iter().map(told).collect();
            (
                scope.names.too_early[index].name.span(),
                format!(
                    "{} need each other: a group of class III or higher",
                    listed(&statements, "and")
                ),
                class_three::instead(items, &needs, &circles[index])
                    .unwrap_or_else(|| TWO_UNKNOWNS.to_string()),
            )
        }
        None => {
            let uses = scope.names.too_early.iter();
            let statements = uses.flat_map(|use_| [use_.user, use_.maker]).collect();
            let order: Vec<_> = needs.ordered(statements).iter().map(told).collect();
            let made_by = items[first.maker].rules.title(&first.name.to_string());
            (
                first.name.span(),
                format!("`{}` is used before `{made_by}` makes it", first.name),
                format!("this order works: {}", order.join(", ")),
            )
        }
    };
    scope.diagnostics.error_because(at, message, reason);
}
