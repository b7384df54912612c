//! The order of statements: each uses only what earlier ones have made.
//!
//! A name that is used too early is noted where it is met and judged here, once for the whole
//! declaration: either another order of the statements works, or some of them need each other.

use std::collections::BTreeSet;

use proc_macro2::Ident;

use crate::syntax::tree::StatementKind;

use crate::model::items::{Item, maker};
use crate::model::names::{Entity, Kind, listed};
use crate::model::needs::Needs;
use crate::model::reads::{Allowed, Reads};
use crate::model::scope::Scope;
use crate::model::{class_three, laws, uses};

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
    if let Some(index) = circles.iter().position(|circle| !circle.is_empty()) {
        let name = scope.names.too_early[index].name.clone();
        return report_circle(scope, &name, (items, &needs), &circles[index]);
    }
    let uses = scope.names.too_early.iter();
    let statements = uses.flat_map(|use_| [use_.user, use_.maker]).collect();
    let order = needs.ordered(statements).into_iter().map(|index| told(&items[index]));
    let order: Vec<_> = order.collect();
    let made_by = items[first.maker].rules.title(&first.name.to_string());
    let message = format!("`{}` is used before `{made_by}` makes it", first.name);
    let reason = format!("this order works: {}", order.join(", "));
    scope.diagnostics.error_because(first.name.span(), message, reason);
}

fn told(item: &Item<'_>) -> String {
    let declared = item.rules.declares();
    let name = declared.first().map_or(String::new(), |(name, _)| name.to_string());
    format!("`{}`", item.rules.title(&name))
}

/// Reports items that need each other, the first of them where it uses this name.
fn report_circle(
    scope: &mut Scope<'_>,
    name: &Ident,
    (items, needs): (&[Item<'_>], &Needs),
    circle: &BTreeSet<usize>,
) {
    let own = || circle.iter().map(|&index| &items[index]);
    // Nobody has written the groups of a drawing, but what drives and places their links.
    if own().any(|item| matches!(item.written, None | Some(StatementKind::Link(_))))
        && let Some(read) = own().find_map(|item| name_of_circle(item, items, circle))
    {
        return uses::moves_with_its_reader(scope, &read);
    }
    let all: Vec<_> = own().map(told).collect();
    let message = format!("{} need each other", listed(&all, "and"));
    let moves = |item: &Item<'_>| item.rules.declares().iter().any(|(_, kind)| *kind == Kind::Link);
    if !own().any(moves) {
        let reason = "each is made of the other; give one of them without it";
        return scope.diagnostics.error_because(name.span(), message, reason);
    }
    let message = format!("{message}: a group of class III or higher");
    let reason =
        class_three::instead(items, needs, circle).unwrap_or_else(|| TWO_UNKNOWNS.to_string());
    scope.diagnostics.error_because(name.span(), message, reason);
}

/// The first name in an expression of an item that an item of the circle makes.
fn name_of_circle(item: &Item<'_>, items: &[Item<'_>], circle: &BTreeSet<usize>) -> Option<Ident> {
    let mut found = None;
    item.rules.each_expression(&mut |expr| {
        expr.each_name(&mut |name| {
            let is_one = maker(items, name).is_some_and(|maker| circle.contains(&maker));
            found = found.take().or_else(|| is_one.then(|| name.clone()));
        });
    });
    found
}
