//! What a condition becomes: a comparison for the fast path, unless it is known to hold, and a
//! question for the slow path.

use super::overflow::Overflow;
use super::routine::{Comparison, Condition, Threshold};
use crate::ir::graph::{Check, Graph, Guard, Id, Node};
use crate::ir::liveness::unguarded;

pub(super) fn condition(
    graph: &Graph,
    overflow: Option<&Overflow>,
    id: Id,
    value: Id,
    guard: &Guard,
) -> Condition {
    let operands = match guard.check {
        Check::ReachCircles | Check::ReachLine | Check::ReachOffset | Check::Square => {
            guard.operands.clone()
        }
        // These look at the value alone; the operands are there to be computed first.
        Check::Nonzero | Check::Positive(_) => Vec::new(),
    };
    let length = match &guard.check {
        Check::Positive(name) => Some(name.clone()),
        _ => None,
    };
    Condition {
        id,
        value,
        comparison: comparison(graph, overflow, value, &guard.check),
        diagnosis: diagnosis(guard),
        operands,
        group: guard.group,
        length,
    }
}

/// The function of the run-time crate that looks at the operands.
fn diagnosis(guard: &Guard) -> &'static str {
    match guard.check {
        Check::ReachCircles => "reach_circles",
        Check::ReachLine => "reach_line",
        Check::ReachOffset => "reach_offset",
        Check::Nonzero => "nonzero",
        Check::Positive(_) => "positive",
        Check::Square if guard.operands.is_empty() => "square",
        Check::Square => "square_of_centres",
    }
}

/// What the fast path asks; nothing where the condition is known to hold.
fn comparison(
    graph: &Graph,
    overflow: Option<&Overflow>,
    value: Id,
    check: &Check,
) -> Option<(Comparison, Threshold)> {
    if *check == Check::Nonzero && is_above_zero(graph, value) {
        return None;
    }
    let threshold = match overflow {
        Some(overflow) => overflow.threshold(unguarded(graph, value), check)?,
        None if *check == Check::Square => Threshold::SmallestSquare,
        None => Threshold::Number(0.0, 0.0),
    };
    let comparison = match check {
        Check::ReachCircles | Check::Positive(_) => Comparison::Above,
        Check::ReachLine | Check::ReachOffset | Check::Square => Comparison::AtLeast,
        Check::Nonzero => Comparison::Away,
    };
    Some((comparison, threshold))
}

/// Whether the value has passed a condition that keeps it above zero.
fn is_above_zero(graph: &Graph, value: Id) -> bool {
    match graph.node(value) {
        Node::Guard(inner, guard) => {
            let check = &graph.condition(guard).check;
            matches!(check, Check::ReachCircles | Check::Positive(_)) || is_above_zero(graph, inner)
        }
        _ => false,
    }
}
