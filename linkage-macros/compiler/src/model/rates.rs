//! Rates in forces and outputs.

use proc_macro2::Ident;

use crate::syntax::tree::{Expr, ExprKind};

use crate::model::names::Kind;
use crate::model::reads::Allowed;
use crate::model::resolved_expr::{Resolve, ResolvedExpr, counted};
use crate::model::scope::Scope;
use crate::model::{fits, laws, mechanism};

/// The function that forces alone may depend on.
pub(in crate::model) const RATE: &str = "rate";

/// `rate(x)`: in forces, torques and outputs, of what moves.
pub(in crate::model) fn rate(
    scope: &mut Scope<'_>,
    name: &Ident,
    arguments: &[Expr],
    allowed: Allowed,
    resolve: Resolve,
) -> Option<ResolvedExpr> {
    let argument = match arguments {
        [argument] => {
            argument_of_rate(scope, argument, Allowed { forces: false, ..allowed }, resolve)
        }
        _ => {
            let found = counted(arguments.len());
            let message = format!("`{name}` takes one argument, and {found} given");
            scope.diagnostics.error(name.span(), message);
            None
        }
    };
    if !allowed.forces {
        let message = "a `rate` stands in forces, torques and outputs alone";
        let reason = "what the mechanism is made of depends on no rate";
        scope.diagnostics.error_because(name.span(), message, reason);
        return None;
    }
    let mut argument = argument?;
    argument.reads = argument.reads.of_a_rate();
    Some(argument)
}

fn argument_of_rate(
    scope: &mut Scope<'_>,
    argument: &Expr,
    allowed: Allowed,
    resolve: Resolve,
) -> Option<ResolvedExpr> {
    let load = fits::first(scope, argument, &|scope, part| match &part.kind {
        ExprKind::Name(name) if scope.names.kind(name) == Some(Kind::Load) => true,
        _ => laws::is_law(scope, part, |reads| reads.load),
    });
    let nested = fits::first(scope, argument, &|scope, part| {
        is_rate(part) || laws::is_law(scope, part, |reads| reads.rate)
    });
    let mistake = match (load, nested) {
        (Some(at), _) => Some((at, "a load has no rate", "it is a number that each call is given")),
        (None, Some(at)) if allowed.efforts => Some((
            at,
            "a rate of a rate is an acceleration, and no output",
            "ask for what moves itself: `motion` gives the acceleration of every output",
        )),
        (None, Some(at)) => Some((
            at,
            "a rate of a rate is an acceleration, on which no force may depend",
            "what resists acceleration is a mass, `mass 2kg on P`, or an inertia",
        )),
        (None, None) => None,
    };
    if let Some((at, message, reason)) = mistake {
        scope.diagnostics.error_because(at, message, reason);
        return None;
    }
    let quantity = resolve(scope, argument, allowed)?;
    if !quantity.reads.efforts.is_empty() {
        let message = "the rate of an effort is not known";
        let reason = "it would follow from the rates of accelerations, which no call is given";
        scope.diagnostics.error_because(argument.span, message, reason);
        return None;
    }
    if quantity.links.is_empty() && !scope.mechanism.moves(&quantity.rest) {
        let message = "nothing here moves, and its rate is zero";
        let reason = "a rate is that of an input, a link's `angle` or `slide`, a point's `x` or \
                      `y`, or a `distance`";
        scope.diagnostics.error_because(argument.span, message, reason);
        return None;
    }
    let measure = quantity.measure.per_time();
    let rate = mechanism::Scalar::Rate(Box::new(quantity.turn()));
    Some(ResolvedExpr::plain(measure, rate))
}

/// True if the expression is a rate.
pub(in crate::model) fn is_rate(expr: &Expr) -> bool {
    matches!(&expr.kind, ExprKind::Call(function, _) if function == RATE)
}
