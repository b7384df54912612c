//! Powers, and arguments that must be above zero.

use crate::exact::Exact;
use crate::function::Function;
use crate::syntax::tree;

use crate::model::as_written::text;
use crate::model::dimension::Measure;
use crate::model::fits;
use crate::model::mechanism::{AboveZero, Dimension, Scalar};
use crate::model::resolved_expr::ResolvedExpr;
use crate::model::scope::Scope;

/// A power by a known integer is one of units, too; any other is a number of numbers.
pub(super) fn measure_of_power(
    scope: &mut Scope<'_>,
    arguments: &[tree::Expr],
    values: &[ResolvedExpr],
) -> Option<Measure> {
    fits::dimension_fits(scope, &arguments[1], &values[1], Dimension::NUMBER)?;
    let Some(times) = known_integer(&values[1]) else {
        fits::dimension_fits(scope, &arguments[0], &values[0], Dimension::NUMBER)?;
        return Some(Measure::NUMBER);
    };
    if times.abs() > Function::LARGEST_POWER {
        let base = text(&arguments[0]);
        let message = format!("an exponent of {times}, beyond ±{}", Function::LARGEST_POWER);
        let reason = format!("write `exp({times} * ln({base}))`");
        scope.diagnostics.error_because(arguments[1].span, message, reason);
        return None;
    }
    Some(values[0].measure.power(times))
}

/// The arguments of a call, the first under the condition that it is above zero if the function needs that.
pub(super) fn arguments_above_zero(
    function: Function,
    arguments: &[tree::Expr],
    values: Vec<ResolvedExpr>,
) -> Vec<Scalar> {
    let is_free = !function.needs_positive() || values.get(1).and_then(known_integer).is_some();
    let mut rests: Vec<_> = values.into_iter().map(|value| value.rest).collect();
    if !is_free && !rests[0].is_constant() {
        let value = std::mem::replace(&mut rests[0], Scalar::zero());
        let name = text(&arguments[0]);
        rests[0] = Scalar::AboveZero(Box::new(AboveZero { value, name, function }));
    }
    rests
}

fn known_integer(value: &ResolvedExpr) -> Option<i64> {
    value.rest.constant().and_then(Exact::to_integer)
}
