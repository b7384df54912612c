//! Lowering of a condition: a comparison for the fast path, unless the condition is known to hold, and a
//! question for the slow path.

use super::overflow::{Overflow, Spread};
use super::routine::{Condition, Threshold};
use crate::ir::check::{Check, Comparison, Least};
use crate::ir::graph::{Graph, Guard, Id, Node};
use crate::ir::liveness::unguarded;

pub(super) fn condition(
    graph: &Graph,
    overflow: Option<&Overflow>,
    id: Id,
    value: Id,
    guard: &Guard,
) -> Condition {
    let operands = match guard.check.row().reads_operands {
        true => guard.operands.clone(),
        false => Vec::new(),
    };
    let spread = spread(graph, id);
    // Without limits on the inputs, rounding is asked of a spread in any case.
    let above_rounding = match spread {
        Some(Spread::Known(_)) if overflow.is_some() => None,
        Some(Spread::Known(_)) => guard.operands.last().copied(),
        Some(Spread::AtRunTime(spread)) => Some(spread),
        None => None,
    };
    Condition {
        id,
        value,
        comparison: comparison(graph, overflow, value, &guard.check, spread),
        above_rounding,
        check: guard.check.clone(),
        operands,
        group: guard.group,
    }
}

fn spread(graph: &Graph, id: Id) -> Option<Spread<'_>> {
    let spread = graph.spread(graph.node(id))?;
    Some(graph.as_constant(spread).map_or(Spread::AtRunTime(spread), Spread::Known))
}

/// The comparison of the fast path; none where the condition is known to hold.
fn comparison(
    graph: &Graph,
    overflow: Option<&Overflow>,
    value: Id,
    check: &Check,
    spread: Option<Spread<'_>>,
) -> Option<(Comparison, Threshold)> {
    let (comparison, least) = check.row().comparison?;
    if comparison == Comparison::Away && is_above_zero(graph, value) {
        return None;
    }
    let threshold = match (overflow, least) {
        (Some(overflow), _) => overflow.threshold(unguarded(graph, value), least, spread)?,
        (None, Least::Square) => Threshold::SmallestSquare,
        (None, Least::Normal) => Threshold::Number(f64::MIN_POSITIVE, f32::MIN_POSITIVE.into()),
        (None, Least::Rounding) if spread.is_some() => return None,
        (None, Least::Rounding | Least::Zero) => Threshold::Number(0.0, 0.0),
    };
    Some((comparison, threshold))
}

/// True if the value has passed a condition that keeps it above zero.
fn is_above_zero(graph: &Graph, value: Id) -> bool {
    match graph.node(value) {
        Node::Guard(inner, guard) => {
            graph.condition(guard).check.keeps_above_zero() || is_above_zero(graph, inner)
        }
        _ => false,
    }
}
