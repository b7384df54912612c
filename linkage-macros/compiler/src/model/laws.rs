//! Named expressions where they are used, and laws among them: those that read rates or loads, which stand in what
//! acts and in outputs.

use proc_macro2::Ident;

use crate::syntax::tree::{Expr, ExprKind};

use crate::model::expr::Scalar;
use crate::model::names::Entity;
use crate::model::reads::{Allowed, Reads};
use crate::model::resolved_expr::ResolvedExpr;
use crate::model::scope::Scope;

/// The value of a `let`, where it may stand here.
pub(in crate::model) fn value_of_let(
    scope: &mut Scope<'_>,
    name: &Ident,
    entity: Entity,
    allowed: Allowed,
) -> Option<ResolvedExpr> {
    let (facts, sum, rest) = match entity {
        Entity::Let(id) => {
            let sum = &scope.mechanism.lets[id.index()];
            let rest = if sum.rest.is_constant() { sum.rest.clone() } else { Scalar::Let(id) };
            (&scope.facts.lets[id.index()], sum, rest)
        }
        Entity::Law(id) => {
            let sum = &scope.mechanism.dynamics.laws[id.index()];
            (&scope.facts.laws[id.index()], sum, Scalar::Law(id))
        }
        _ => return None,
    };
    let (measure, links, reads) = (facts.measure, sum.links.clone(), facts.reads.clone());
    law_stands_here(scope, name, &reads, allowed)?;
    Some(ResolvedExpr { measure, links, rest, reads })
}

/// A law of rates or loads stands in forces, torques and outputs.
pub(in crate::model) fn law_stands_here(
    scope: &mut Scope<'_>,
    name: &Ident,
    reads: &Reads,
    allowed: Allowed,
) -> Option<()> {
    let (message, reason) = match (reads.corner, reads.is_of_forces()) {
        (_, true) if !allowed.forces => {
            let what = match (reads.load, reads.rate) {
                (true, true) => "loads and rates",
                (true, false) => "a load",
                (false, _) => "a rate",
            };
            (
                format!("`{name}` reads {what}, and stands in forces, torques and outputs alone"),
                "what the mechanism is made of and how it moves depends on no load and no rate",
            )
        }
        (Some(function), false) if !allowed.corners => (
            format!(
                "`{name}` has a corner by `{function}`, and stands in forces, torques and outputs \
                 alone"
            ),
            "a dimension is smooth: write `hypot(x, e)` with a small `e` for `abs(x)`",
        ),
        _ => return Some(()),
    };
    scope.diagnostics.error_because(name.span(), message, reason);
    None
}

/// The part of an expression is a law of which this is true.
pub(in crate::model) fn is_law(
    scope: &Scope<'_>,
    part: &Expr,
    reads: impl Fn(&Reads) -> bool,
) -> bool {
    let ExprKind::Name(name) = &part.kind else { return false };
    match scope.names.entity(name) {
        Some(Entity::Law(id)) => reads(&scope.facts.laws[id.index()].reads),
        _ => false,
    }
}
