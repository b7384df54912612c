//! Loads where forces read them, and the one that drives an input: forces are linear in it.

use proc_macro2::Ident;

use crate::syntax::tree::{self, ExprKind};

use crate::model::dimension::Measure;
use crate::model::expr::{Operator, Scalar};
use crate::model::facts::Degree;
use crate::model::names::{Entity, Kind};
use crate::model::reads::{Allowed, Reads};
use crate::model::resolved_expr::ResolvedExpr;
use crate::model::scope::Scope;
use crate::model::{fits, uses};

/// The value of a load in forces, torques and outputs.
pub(in crate::model) fn value_of_load(
    scope: &mut Scope<'_>,
    name: &Ident,
    allowed: Allowed,
) -> Option<ResolvedExpr> {
    load_stands_in_a_force(scope, name, allowed)?;
    let entity = uses::usable(scope, name, &[Kind::Load])?;
    let dynamics = &scope.mechanism.dynamics;
    let (load, value) = match entity {
        Entity::Load(id) => (&dynamics.loads[id.index()], Scalar::Load(id)),
        Entity::Pull => (dynamics.pull.as_ref()?, Scalar::Pull),
        _ => return None,
    };
    let reads = Reads::a_load();
    let measure = Measure::Known(load.dimension);
    Some(ResolvedExpr { reads, ..ResolvedExpr::plain(measure, value) })
}

/// The power to which a number contains the load that drives an input.
pub(in crate::model) fn degree(scope: &Scope<'_>, expr: &Scalar) -> Degree {
    let within = |inner: Degree| if inner == Degree::Free { inner } else { Degree::Other };
    match expr {
        Scalar::Pull => Degree::Linear,
        Scalar::Law(id) => scope.facts.laws[id.index()].pull,
        Scalar::Negate(value) => degree(scope, value),
        Scalar::AboveZero(inner) => within(degree(scope, &inner.value)),
        Scalar::Call(_, arguments) => {
            let degrees = arguments.iter().map(|argument| degree(scope, argument));
            within(degrees.max().unwrap_or(Degree::Free))
        }
        Scalar::Chain(first, rest) => {
            rest.iter().fold(degree(scope, first), |left, (operator, operand)| {
                match (operator, left, degree(scope, operand)) {
                    (Operator::Add | Operator::Sub, left, right) => left.max(right),
                    (_, left, Degree::Free) => left,
                    (Operator::Mul, Degree::Free, right) => right,
                    _ => Degree::Other,
                }
            })
        }
        _ => Degree::Free,
    }
}

/// A force is a multiple of the load that drives an input, and what is free of it.
pub(in crate::model) fn is_linear_in_pull(
    scope: &mut Scope<'_>,
    expr: &tree::Expr,
    value: &Scalar,
) -> Option<()> {
    if degree(scope, value) != Degree::Other {
        return Some(());
    }
    let load = scope.facts.driving.as_deref().unwrap_or_default();
    let message = format!("a force is a multiple of `{load}`, which drives an input");
    let reason = format!(
        "the value of `{load}` follows from one linear equation: write `2 * {load}` or \
         `5N - {load} * cos(theta)`, and no function of it"
    );
    pull_is_refused(scope, expr, message, reason)
}

/// A share of what presses a joint is no share of what follows from it.
pub(in crate::model) fn is_free_of_pull(
    scope: &mut Scope<'_>,
    expr: &tree::Expr,
    value: &Scalar,
) -> Option<()> {
    if degree(scope, value) == Degree::Free {
        return Some(());
    }
    let load = scope.facts.driving.as_deref().unwrap_or_default();
    let message = format!("no coefficient depends on `{load}`, which drives an input");
    let reason = format!("`{load}` follows from friction, and its equation is linear");
    pull_is_refused(scope, expr, message, reason)
}

/// Reports the first part of an expression that holds the load that drives an input.
fn pull_is_refused(
    scope: &mut Scope<'_>,
    expr: &tree::Expr,
    message: String,
    reason: String,
) -> Option<()> {
    let holds_pull = |scope: &Scope<'_>, part: &tree::Expr| {
        let ExprKind::Name(name) = &part.kind else { return false };
        match scope.names.entity(name) {
            Some(Entity::Pull) => true,
            Some(Entity::Law(id)) => scope.facts.laws[id.index()].pull != Degree::Free,
            _ => false,
        }
    };
    let at = fits::first(scope, expr, &holds_pull).unwrap_or(expr.span);
    scope.diagnostics.error_because(at, message, reason);
    None
}

/// A load stands in the value of a force or a torque, and nowhere else.
fn load_stands_in_a_force(scope: &mut Scope<'_>, name: &Ident, allowed: Allowed) -> Option<()> {
    if allowed.forces {
        return Some(());
    }
    let message = format!("`{name}` is a load, and stands in forces, torques and outputs alone");
    let reason = "what the mechanism is made of and how it moves depends on no load";
    scope.diagnostics.error_because(name.span(), message, reason);
    None
}
