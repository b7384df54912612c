//! Numbers as written: their units, and what a number without one is taken for.

use proc_macro2::Ident;

use crate::diagnostics::{Extent, nearest};
use crate::exact::Exact;
use crate::reach::absolute;
use crate::syntax::tree::{self, BinaryOp, ExprKind, UnitPower};
use crate::syntax::words::UNITS;

use crate::model::dimension::Measure;
use crate::model::folding::shown;
use crate::model::mechanism::Dimension;
use crate::model::names::NUMBERS;
use crate::model::resolved_expr::{ResolvedExpr, bare_name};
use crate::model::scope::Scope;
use crate::model::units::{is_beside_si, unit};

/// A bare length from which on a unit is asked for, in metres: few mechanisms are as long, and most
/// numbers of millimetres are longer.
const LONG: i64 = 10;

/// A bare length of `LONG` metres that is also this many times as long as the longest with a unit has lost its own. A
/// forgotten `mm` makes a length a thousand times as long as it is; metres beside a small offset, as in `length: 1` and
/// `offset: 2mm`, are meant.
const MANY: i64 = 10;

/// A literal is a number, and its units are among the known.
pub(super) fn literal(
    scope: &mut Scope<'_>,
    span: Extent,
    digits: &str,
    units: &[UnitPower],
) -> Option<ResolvedExpr> {
    let value = Exact::decimal(digits);
    number_can_be_held(scope, span, value.as_ref())?;
    let mut value = value?;
    if units.is_empty() {
        return Some(ResolvedExpr::constant(Measure::Bare, value));
    }
    let mut dimension = Dimension::NUMBER;
    for (name, power) in units {
        let Some((of_unit, factor)) = unit(name) else {
            unit_exists(scope, span, digits, name);
            return None;
        };
        for _ in 0..power.unsigned_abs() {
            let scaled = if *power > 0 { Some(value.mul(&factor)) } else { value.div(&factor) };
            value = scaled.expect("no unit is zero");
        }
        dimension = dimension.times(of_unit, *power);
    }
    number_can_be_held(scope, span, Some(&value))?;
    scope.facts.a_length_has_a_unit |= dimension.length != 0;
    Some(ResolvedExpr::constant(Measure::Known(dimension), value))
}

/// Reports letters behind a number that are no unit.
fn unit_exists(scope: &mut Scope<'_>, span: Extent, digits: &str, suffix: &str) {
    if suffix == "pi" || scope.names.of_kinds(&NUMBERS).any(|name| name == suffix) {
        let message = format!("write `{digits} * {suffix}`");
        let reason = "letters directly behind a number are its unit";
        scope.diagnostics.error_because(span, message, reason);
        return;
    }
    let product = match suffix {
        "Nm" => Some("N*m"),
        "Nmm" => Some("N*mm"),
        "kNm" => Some("kN*m"),
        "Ns" => Some("N*s"),
        _ => None,
    };
    if let Some(product) = product {
        let message = format!("write `{digits}({product})`");
        let reason = "a product of units stands in parentheses";
        scope.diagnostics.error_because(span, message, reason);
        return;
    }
    let mut message = format!("no unit named `{suffix}`");
    // One letter is near to any two.
    let known = UNITS.into_iter().filter(|unit| unit.len() > 1);
    if let Some(near) = nearest(suffix, known) {
        message += &format!("; a unit with a similar name exists: `{near}`");
    }
    let reason = "lengths have `m mm cm um in`, angles `rad deg turn`, masses `kg g t`, forces \
                  `N kN`, times `s ms`; products stand in parentheses, as in `15(N/m)`";
    scope.diagnostics.error_because(span, message, reason);
}

/// Reports `20N/mm`, whose `mm` would be the name of a number. Other products with it have no
/// meaning then.
pub(super) fn units_have_parentheses(
    scope: &mut Scope<'_>,
    first: &tree::Expr,
    rest: &[(BinaryOp, tree::Expr)],
) -> Option<()> {
    if let ExprKind::Negate(inner) = &first.kind {
        return units_have_parentheses(scope, inner, rest);
    }
    let ExprKind::Number { digits, units } = &first.kind else { return Some(()) };
    let [(unit, 1)] = &units[..] else { return Some(()) };
    let (mut product, mut last) = (unit.clone(), None);
    for (operator, operand) in rest {
        let sign = match operator {
            BinaryOp::Mul => '*',
            BinaryOp::Div => '/',
            BinaryOp::Add | BinaryOp::Sub => break,
        };
        let is_unit = |name: &&Ident| {
            UNITS.iter().any(|unit| name == unit) && scope.names.symbol(name).is_none()
        };
        let Some(name) = bare_name(operand).filter(is_unit) else { break };
        product += &format!("{sign}{name}");
        last = Some(operand.span);
    }
    let Some(last) = last else { return Some(()) };
    let message = format!("write `{digits}({product})`");
    let reason = "a product of units stands in parentheses";
    scope.diagnostics.error_because(first.span.to(last), message, reason);
    None
}

/// A constant has no more digits than can be reckoned with exactly.
pub(super) fn number_is_of_a_length(
    scope: &mut Scope<'_>,
    span: Extent,
    value: Option<&Exact>,
) -> Option<()> {
    if !value.is_some_and(Exact::is_too_long) {
        return Some(());
    }
    let message = "a number of more than 1200 digits; write it rounded";
    let reason = "constants are exact: a product has the digits of both its factors";
    scope.diagnostics.error_because(span, message, reason);
    None
}

/// A constant is one that floating point can hold: neither infinite nor lost as zero.
pub(super) fn number_can_be_held(
    scope: &mut Scope<'_>,
    span: Extent,
    value: Option<&Exact>,
) -> Option<()> {
    number_is_of_a_length(scope, span, value)?;
    let is_held = value.is_some_and(|value| {
        let rounded = value.to_f64();
        rounded.is_finite() && (rounded == 0.0) == value.is_zero()
    });
    if is_held {
        return Some(());
    }
    let message = "a number too large or too small; change its exponent";
    let reason = "`f64` holds numbers between 1e-308 and 1e308";
    scope.diagnostics.error_because(span, message, reason);
    None
}

/// The correction of a number whose letters are both its unit and a declared name: `2s`.
pub(super) fn name_taken_for_a_unit(scope: &Scope<'_>, expr: &tree::Expr) -> Option<String> {
    let ExprKind::Number { digits, units } = &expr.kind else { return None };
    let [(unit, 1)] = &units[..] else { return None };
    let declared = scope.names.of_kinds(&NUMBERS).any(|name| name == unit);
    declared.then(|| {
        format!("letters directly behind a number are its unit; write `{digits} * {unit}`")
    })
}

/// A number without a unit that is used as an angle is at most a full turn: more is a
/// forgotten `deg`.
pub(super) fn bare_angle_is_within_a_turn(
    scope: &mut Scope<'_>,
    at: Extent,
    quantity: &ResolvedExpr,
) -> Option<()> {
    if quantity.measure != Measure::Bare {
        return Some(());
    }
    let value = scope.constant_or_default(&quantity.rest, at);
    let Some((value, span)) = value.filter(|(value, _)| !within_a_turn(value)) else {
        return Some(());
    };
    let value = shown(value);
    if scope.was_blamed(&quantity.rest) {
        return None;
    }
    let message = format!("an angle of {value} without a unit; write `{value}deg`");
    let reason = format!("a bare number is SI; if radians are meant, write `{value}rad`");
    scope.diagnostics.error_because(span, message, reason);
    None
}

/// A number without a unit is SI: beside `10mm` or `90deg` it looks like a forgotten unit.
pub(super) fn no_bare_number_beside_a_unit(
    scope: &mut Scope<'_>,
    first: &tree::Expr,
    rest: &[(BinaryOp, tree::Expr)],
    measure: Measure,
) -> Option<()> {
    let is_sum = matches!(rest.first(), Some((BinaryOp::Add | BinaryOp::Sub, _)));
    let operands = || std::iter::once(first).chain(rest.iter().map(|(_, operand)| operand));
    let (si, other, dimension) = match measure {
        Measure::LENGTH => (["m", "metres"], "mm", Dimension::LENGTH),
        Measure::ANGLE => (["rad", "radians"], "deg", Dimension::ANGLE),
        _ => return Some(()),
    };
    if !is_sum || !operands().any(|operand| is_measured_in(operand, dimension)) {
        return Some(());
    }
    let Some((expr, digits)) = operands().find_map(|operand| Some((operand, bare(operand)?)))
    else {
        return Some(());
    };
    let message = format!("write the unit of `{digits}`: `{digits}{other}` or `{digits}{}`", si[0]);
    let reason = format!("a number without a unit is in {}", si[1]);
    scope.diagnostics.error_because(expr.span, message, reason);
    None
}

/// A length without a unit is in metres: among lengths with units, one that is many times as long as all of
/// them has lost its own. Remembers the longest for declarations without units.
pub(super) fn bare_length_is_as_others(
    scope: &mut Scope<'_>,
    span: Extent,
    quantity: &ResolvedExpr,
) -> Option<()> {
    if quantity.measure != Measure::Bare {
        return Some(());
    }
    let Some((value, span)) = scope.constant_or_default(&quantity.rest, span) else {
        return Some(());
    };
    let value = absolute(value);
    let [long, many] = [LONG, MANY].map(Exact::integer);
    let longest = scope.facts.longest_with_unit.as_ref();
    let is_as_others = longest.is_none_or(|longest| {
        value.cmp_value(&long).is_lt() || value.cmp_value(&longest.mul(&many)).is_lt()
    });
    if !is_as_others {
        if !scope.was_blamed(&quantity.rest) {
            length_needs_its_unit(scope, span, &value, "every length with a unit is much shorter");
        }
        return None;
    }
    let longest = scope.facts.longest_bare_length.as_ref();
    if longest.is_none_or(|(longest, _)| value.cmp_value(longest).is_gt()) {
        scope.facts.longest_bare_length = Some((value, span));
    }
    Some(())
}

fn length_needs_its_unit(scope: &mut Scope<'_>, span: Extent, length: &Exact, others: &str) {
    let length = shown(length);
    let message =
        format!("a length of {length} m; write `{length}mm`, or `{length}m` if it is meant");
    let reason = format!("{others}, and a bare number is in metres");
    scope.diagnostics.error_because(span, message, reason);
}

/// A declaration whose lengths have no units at all has none that only millimetres explain.
pub(super) fn bare_lengths_are_of_a_machine(scope: &mut Scope<'_>) {
    let Some((length, span)) = &scope.facts.longest_bare_length else {
        return;
    };
    // The numbers of a drawing are resolved before this.
    let has_a_unit = scope.drawn.is_some() && scope.facts.longest_with_unit.is_some();
    let is_short = length.cmp_value(&Exact::integer(LONG)).is_lt();
    if scope.facts.a_length_has_a_unit || has_a_unit || is_short {
        return;
    }
    let (length, span) = (length.clone(), *span);
    if scope.drawn.is_some() {
        // The lengths of a drawing follow from the places of pins, and nobody has written them.
        let message = format!(
            "a length of {} m in the drawing; write its numbers with a unit, `mm`, or `m` if it is meant",
            shown(&length)
        );
        let reason = "no length of this declaration has a unit, and a bare number is in metres";
        scope.diagnostics.error_because(span, message, reason);
        return;
    }
    length_needs_its_unit(scope, span, &length, "no length of this declaration has a unit");
}

/// True if the expression is a number with a unit beside the SI unit of this dimension, or a product with one.
fn is_measured_in(expr: &tree::Expr, dimension: Dimension) -> bool {
    match &expr.kind {
        ExprKind::Number { units: own, .. } => {
            own.iter().any(|(unit, _)| is_beside_si(unit, dimension))
        }
        ExprKind::Negate(inner) => is_measured_in(inner, dimension),
        ExprKind::Chain(first, rest) => {
            let is_product = matches!(rest.first(), Some((BinaryOp::Mul | BinaryOp::Div, _)));
            let mut operands = std::iter::once(&**first).chain(rest.iter().map(|(_, o)| o));
            is_product && operands.any(|operand| is_measured_in(operand, dimension))
        }
        _ => false,
    }
}

/// The digits of a number without a unit that is not zero.
fn bare(expr: &tree::Expr) -> Option<&str> {
    match &expr.kind {
        ExprKind::Number { digits, units } if units.is_empty() => {
            digits.contains(|c: char| ('1'..='9').contains(&c)).then_some(digits)
        }
        ExprKind::Negate(inner) => bare(inner),
        _ => None,
    }
}

fn within_a_turn(value: &Exact) -> bool {
    let turn = Exact::pi().mul(&Exact::integer(2));
    value.cmp_value(&turn).is_le() && value.cmp_value(&turn.neg()).is_ge()
}
