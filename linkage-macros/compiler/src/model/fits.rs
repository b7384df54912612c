//! Checks that a resolved expression fits its place.

use crate::diagnostics::Extent;
use crate::syntax::tree::{self, BinaryOp, ExprKind};

use crate::model::dimension::{Dimension, Measure};
use crate::model::expr::Scalar;
use crate::model::folding::shown;
use crate::model::literals;
use crate::model::meant;
use crate::model::mechanism::ParamKind;
use crate::model::names::{Entity, Kind};
use crate::model::resolved_expr::{ANGLE_REASON, ResolvedExpr};
use crate::model::scope::Scope;

/// A quantity has the dimension that belongs where it stands.
pub(in crate::model) fn dimension_fits(
    scope: &mut Scope<'_>,
    expr: &tree::Expr,
    quantity: &ResolvedExpr,
    wanted: Dimension,
) -> Option<()> {
    if quantity.measure.fits(wanted) {
        return match wanted {
            Dimension::ANGLE => literals::bare_angle_is_within_a_turn(scope, expr.span, quantity),
            Dimension::LENGTH => literals::bare_length_is_as_others(scope, expr.span, quantity),
            _ => Some(()),
        };
    }
    let found = quantity.measure.dimension();
    let message = format!("{} where {} belongs", found.words(), wanted.words());
    if let Some(reason) = literals::name_taken_for_a_unit(scope, expr) {
        scope.diagnostics.error_because(expr.span, message, reason);
        return None;
    }
    if let Some(reason) = factor_without_unit(scope, expr, wanted.times(found, -1)) {
        scope.diagnostics.error_because(expr.span, message, reason);
        return None;
    }
    if let Some(reason) = meant::literal_of(expr, found, wanted) {
        scope.diagnostics.error_because(expr.span, message, reason);
        return None;
    }
    let reason = match (found, wanted) {
        (Dimension::ANGLE, Dimension::LENGTH) => {
            "an angle times a length is a length, as in `theta * 20mm`"
        }
        (Dimension::NUMBER, Dimension::LENGTH) => {
            "a number times a length is a length, as in `cos(theta) * 20mm`"
        }
        (Dimension::LENGTH, _) if wanted.is_plain() => {
            "a length divided by a length is a number, and so an angle: `s / 20mm`"
        }
        _ => "multiply or divide by what is missing",
    };
    scope.diagnostics.error_because(expr.span, message, reason);
    None
}

/// The correction of a product that lacks a dimension and has a number without a unit:
/// `-10 * rate(s)` as a force.
fn factor_without_unit(scope: &Scope<'_>, expr: &tree::Expr, missing: Dimension) -> Option<String> {
    let unit = missing.unit()?;
    let factor = match &expr.kind {
        ExprKind::Negate(inner) => return factor_without_unit(scope, inner, missing),
        ExprKind::Chain(first, rest) => {
            let factors = rest.iter().filter(|(operator, _)| *operator == BinaryOp::Mul);
            let is_product = matches!(rest[0].0, BinaryOp::Mul | BinaryOp::Div);
            let mut factors = [&**first].into_iter().chain(factors.map(|(_, factor)| factor));
            factors.find_map(|factor| number_without_unit(scope, factor)).filter(|_| is_product)?
        }
        _ => return None,
    };
    Some(match factor {
        (digits, None) => format!("give `{digits}` its unit: `{digits}{unit}`"),
        (name, Some(default)) => {
            format!("give `{name}` its unit where it is declared: `param {name} = {default}{unit}`")
        }
    })
}

/// The digits of a number without a unit, or the name of such a parameter and its digits.
fn number_without_unit(scope: &Scope<'_>, expr: &tree::Expr) -> Option<(String, Option<String>)> {
    match &expr.kind {
        ExprKind::Number { digits, units } if units.is_empty() => Some((digits.clone(), None)),
        ExprKind::Negate(inner) => number_without_unit(scope, inner),
        ExprKind::Name(name) => {
            let Entity::Param(id) = scope.names.entity(name)? else { return None };
            let ParamKind::Number { default, .. } = &scope.mechanism.params[id.index()].kind else {
                return None;
            };
            let is_bare = scope.facts.params[id.index()].measure == Measure::Bare;
            is_bare.then(|| (name.to_string(), Some(shown(default))))
        }
        _ => None,
    }
}

/// A link's angle stands in sums of angles alone, never where one definite number is needed.
pub(in crate::model) fn no_link_angle(
    scope: &mut Scope<'_>,
    expr: &tree::Expr,
    quantity: &ResolvedExpr,
) -> Option<()> {
    let Some(&(link, _)) = quantity.links.first() else {
        return Some(());
    };
    let message = format!("`{}.angle` cannot stand here", scope.mechanism.links[link.index()].name);
    let span = first(scope, expr, &|scope, part| is_link_angle(scope, part));
    scope.diagnostics.error_because(span.unwrap_or(expr.span), message, ANGLE_REASON);
    None
}

fn is_link_angle(scope: &Scope<'_>, expr: &tree::Expr) -> bool {
    match &expr.kind {
        ExprKind::Member(_, member) => member == "angle",
        ExprKind::Name(name) => match scope.names.entity(name) {
            Some(Entity::Let(id)) => !scope.mechanism.lets[id.index()].links.is_empty(),
            Some(Entity::Law(id)) => !scope.mechanism.dynamics.laws[id.index()].links.is_empty(),
            _ => false,
        },
        _ => false,
    }
}

/// The span of the first part of the expression that answers yes.
pub(in crate::model) fn first(
    scope: &Scope<'_>,
    expr: &tree::Expr,
    asks: &dyn Fn(&Scope<'_>, &tree::Expr) -> bool,
) -> Option<Extent> {
    if asks(scope, expr) {
        return Some(expr.span);
    }
    expr.parts().find_map(|part| first(scope, part, asks))
}

/// The first part of the expression that depends on an input.
pub(in crate::model) fn moving_part(scope: &Scope<'_>, expr: &tree::Expr) -> Option<Extent> {
    first(scope, expr, &|scope, part| match &part.kind {
        // A link's angle or slide is no constant, even where the link stands still.
        ExprKind::Member(owner, _) if scope.names.kind(owner) == Some(Kind::Link) => true,
        ExprKind::Member(name, _) | ExprKind::Name(name) => {
            scope.names.entity(name).is_some_and(|entity| scope.facts.moves(entity))
        }
        _ => false,
    })
}

/// A length that is constant is greater than zero, and so is the default of a parameter that
/// is a length by itself.
pub(in crate::model) fn length_is_positive(
    scope: &mut Scope<'_>,
    at: Extent,
    value: &Scalar,
    what: &str,
) -> Option<()> {
    let constant = scope.constant_or_default(value, at);
    let Some((constant, span)) = constant.filter(|(constant, _)| !constant.signum().is_gt()) else {
        return Some(());
    };
    let message = format!("{what} is {} m; make it greater than zero", shown(constant));
    if !scope.was_blamed(value) {
        scope.diagnostics.error(span, message);
    }
    None
}
