//! An expression as written into a sum of link angles and a number, with its measure.

use proc_macro2::Ident;

use crate::diagnostics::{Extent, nearest};
use crate::exact::Exact;
use crate::syntax::tree::{self, BinaryOp, ExprKind};

use crate::model::dimension::Measure;
use crate::model::mechanism::{Dimension, LinkId, Operator, ParamKind, Scalar};
use crate::model::names::{Entity, Kind, NUMBERS};
use crate::model::reads::Allowed;
use crate::model::resolved_expr::{ANGLE_REASON, ResolvedExpr};
use crate::model::scope::Scope;
use crate::model::{
    calls, effort_formulas, laws, literals, loads_in_forces, machine_functions, readings, uses,
};

/// Resolves an expression of a dimension, and reports every mistake in it.
pub(super) fn quantity(scope: &mut Scope<'_>, expr: &tree::Expr) -> Option<ResolvedExpr> {
    expression(scope, expr, Allowed::IN_DIMENSIONS)
}

/// Resolves an expression, and reports every mistake in it.
pub(super) fn expression(
    scope: &mut Scope<'_>,
    expr: &tree::Expr,
    allowed: Allowed,
) -> Option<ResolvedExpr> {
    match &expr.kind {
        ExprKind::Number { digits, units } => literals::literal(scope, expr.span, digits, units),
        ExprKind::Name(name) if name == "pi" => {
            Some(ResolvedExpr::constant(Measure::ANGLE, Exact::pi()))
        }
        ExprKind::Name(name) if name == "losses" && allowed.efforts => {
            effort_formulas::losses_read(scope, name)
        }
        ExprKind::Name(name) => named_number(scope, name, allowed),
        ExprKind::Member(owner, member) => {
            let effort = allowed
                .efforts
                .then(|| effort_formulas::effort_read(scope, owner, member))
                .flatten();
            effort.unwrap_or_else(|| readings::member(scope, owner, member, allowed))
        }
        // Where it does not stand its names are looked at all the same.
        ExprKind::Part(path) => effort_formulas::part_read(scope, path).filter(|_| allowed.efforts),
        ExprKind::Negate(inner) => {
            let mut quantity = expression(scope, inner, allowed)?;
            quantity.scale_links(-1)?;
            quantity.rest = quantity.rest.negated();
            Some(quantity)
        }
        ExprKind::Chain(first, rest) => chain(scope, first, rest, allowed),
        ExprKind::Call(function, arguments) => {
            let quantity = match machine_functions::named(function) {
                Some(row) => (row.resolve)(scope, function, arguments, allowed, expression),
                None => calls::call(scope, function, arguments, allowed, expression),
            }?;
            literals::number_is_of_a_length(scope, expr.span, quantity.rest.constant())?;
            Some(quantity)
        }
        // The names in it are among what was not read.
        ExprKind::Mistake => None,
    }
}

/// One operation after the other, each on what the one before has made.
fn chain(
    scope: &mut Scope<'_>,
    first: &tree::Expr,
    rest: &[(BinaryOp, tree::Expr)],
    allowed: Allowed,
) -> Option<ResolvedExpr> {
    literals::units_have_parentheses(scope, first, rest)?;
    let (mut span, mut left) = (first.span, expression(scope, first, allowed));
    for (operator, operand) in rest {
        // Operands after a mistake are still checked.
        let right = expression(scope, operand, allowed);
        let sides = left.zip(right);
        left = sides
            .and_then(|(left, right)| operation(scope, *operator, (span, left), (operand, right)));
        span = span.to(operand.span);
    }
    let left = left?;
    literals::no_bare_number_beside_a_unit(scope, first, rest, left.measure)?;
    Some(left)
}

fn operation(
    scope: &mut Scope<'_>,
    operator: BinaryOp,
    left: (Extent, ResolvedExpr),
    right: (&tree::Expr, ResolvedExpr),
) -> Option<ResolvedExpr> {
    let span = left.0.to(right.0.span);
    let reads = left.1.reads.clone().and(&right.1.reads);
    let quantity = match operator {
        BinaryOp::Add => sum(scope, Operator::Add, left, right),
        BinaryOp::Sub => sum(scope, Operator::Sub, left, right),
        BinaryOp::Mul => product(scope, left, (right.0.span, right.1)),
        BinaryOp::Div => quotient(scope, left.1, (right.0.span, right.1)),
    }?;
    if let Scalar::Constant(value) = &quantity.rest {
        literals::number_can_be_held(scope, span, Some(value))?;
    }
    Some(ResolvedExpr { reads, ..quantity })
}

fn named_number(scope: &mut Scope<'_>, name: &Ident, allowed: Allowed) -> Option<ResolvedExpr> {
    if scope.names.kind(name) == Some(Kind::Load) {
        return loads_in_forces::value_of_load(scope, name, allowed);
    }
    if allowed.forces && is_nearly_a_load(scope, name) {
        uses::usable(scope, name, &[Kind::Load])?;
    }
    match uses::usable(scope, name, &NUMBERS)? {
        Entity::Input(id) => {
            let measure = Measure::Known(scope.mechanism.inputs[id.index()].dimension);
            Some(ResolvedExpr::plain(measure, Scalar::Input(id)))
        }
        Entity::Param(id) => {
            if !matches!(scope.mechanism.params[id.index()].kind, ParamKind::Number { .. }) {
                let message = format!("`{name}` is a mode, not a number");
                scope.diagnostics.error(name.span(), message);
                return None;
            }
            let measure = scope.facts.params[id.index()].measure;
            Some(ResolvedExpr::plain(measure, Scalar::Param(id)))
        }
        entity @ (Entity::Let(_) | Entity::Law(_)) => {
            laws::value_of_let(scope, name, entity, allowed)
        }
        Entity::Unknown(id) => {
            let measure = Measure::Known(scope.mechanism.unknowns[id.index()].dimension);
            Some(ResolvedExpr::plain(measure, Scalar::Unknown(id)))
        }
        Entity::Point(_)
        | Entity::Link(_)
        | Entity::Guide(_)
        | Entity::Load(_)
        | Entity::Pull
        | Entity::Spring(_)
        | Entity::Stop(_) => None,
    }
}

/// True for a name that nothing declares and that is like that of a load, and of no other number.
fn is_nearly_a_load(scope: &Scope<'_>, name: &Ident) -> bool {
    let text = name.to_string();
    let is_near = |kinds: &[Kind]| nearest(&text, scope.names.of_kinds(kinds)).is_some();
    scope.names.symbol(name).is_none() && is_near(&[Kind::Load]) && !is_near(&NUMBERS)
}

/// The sides of a sum are quantities of one kind.
pub(super) fn sum(
    scope: &mut Scope<'_>,
    operator: Operator,
    (left, mut a): (Extent, ResolvedExpr),
    (right, b): (&tree::Expr, ResolvedExpr),
) -> Option<ResolvedExpr> {
    let Some(measure) = a.measure.sum(b.measure) else {
        let (found, wanted) = (b.measure.dimension(), a.measure.dimension());
        let message = format!("{} where {} belongs", found.words(), wanted.words());
        let sign = if operator == Operator::Add { '+' } else { '-' };
        let left = || format!("what stands left of the `{sign}` is {}", wanted.words());
        let reason = literals::name_taken_for_a_unit(scope, right).unwrap_or_else(left);
        scope.diagnostics.error_because(right.span, message, reason);
        return None;
    };
    if measure == Measure::ANGLE {
        let left_is_small = literals::bare_angle_is_within_a_turn(scope, left, &a);
        literals::bare_angle_is_within_a_turn(scope, right.span, &b).and(left_is_small)?;
    }
    a.measure = measure;
    let sign = if operator == Operator::Add { 1 } else { -1 };
    if a.add_links(&b.links, sign).is_none() {
        return link_angles_are_whole_multiples(scope, right.span, &b.links);
    }
    a.rest = a.rest.combined(operator, b.rest)?;
    Some(a)
}

fn product(
    scope: &mut Scope<'_>,
    (left, a): (Extent, ResolvedExpr),
    (right, b): (Extent, ResolvedExpr),
) -> Option<ResolvedExpr> {
    let measure = a.measure.product(b.measure);
    // The factor of a link angle, if there is one, is the other side.
    let (mut turn, factor, span) = match (a.links.is_empty(), b.links.is_empty()) {
        (true, true) => {
            return Some(ResolvedExpr::plain(measure, a.rest.combined(Operator::Mul, b.rest)?));
        }
        (false, _) => (a, b, right),
        (true, false) => (b, a, left),
    };
    let integer = factor.rest.constant().and_then(Exact::to_integer);
    let integer = integer.and_then(|k| i32::try_from(k).ok());
    let whole = factor.links.is_empty() && factor.measure.fits(Dimension::NUMBER);
    let links = turn.links.clone();
    if !whole || integer.and_then(|k| turn.scale_links(k)).is_none() {
        return link_angles_are_whole_multiples(scope, span, &links);
    }
    turn.rest = turn.rest.combined(Operator::Mul, factor.rest)?;
    Some(ResolvedExpr { measure, ..turn })
}

fn quotient(
    scope: &mut Scope<'_>,
    mut a: ResolvedExpr,
    (right, b): (Extent, ResolvedExpr),
) -> Option<ResolvedExpr> {
    if !b.links.is_empty() {
        return link_angles_are_whole_multiples(scope, right, &b.links);
    }
    if b.rest.is_zero() {
        scope.diagnostics.error(right, "a division by zero");
        return None;
    }
    if !a.links.is_empty() {
        let links = a.links.clone();
        let divided = match b.rest.constant() {
            Some(divisor) if b.measure.fits(Dimension::NUMBER) => a.divide_links(divisor),
            _ => None,
        };
        if divided.is_none() {
            return link_angles_are_whole_multiples(scope, right, &links);
        }
    }
    a.measure = a.measure.quotient(b.measure);
    a.rest = a.rest.combined(Operator::Div, b.rest)?;
    Some(a)
}

/// Reports a link angle that is multiplied by something other than an integer.
fn link_angles_are_whole_multiples(
    scope: &mut Scope<'_>,
    span: Extent,
    links: &[(LinkId, i32)],
) -> Option<ResolvedExpr> {
    let name = &scope.mechanism.links[links[0].0.index()].name;
    let message = format!("`{name}.angle` can be multiplied by an integer only");
    scope.diagnostics.error_because(span, message, ANGLE_REASON);
    None
}
