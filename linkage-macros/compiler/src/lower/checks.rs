//! What a condition becomes: a comparison for the fast path, unless it is known to hold, and a
//! question for the slow path.

use super::overflow::{Overflow, Spread};
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
        // These look at the value alone; the operands are there to be computed first.
        Check::Nonzero | Check::Positive(_) | Check::NotNegative(_) => Vec::new(),
        _ => guard.operands.clone(),
    };
    let spread = spread(graph, id);
    // Without limits on the inputs, rounding is asked of a spread in any case.
    let above_rounding = match spread {
        Some(Spread::Known(_)) if overflow.is_some() => None,
        Some(Spread::Known(_)) => guard.operands.last().copied(),
        Some(Spread::AtRunTime(spread)) => Some(spread),
        None => None,
    };
    let word = match &guard.check {
        Check::Positive(word) | Check::NotNegative(word) | Check::Closed(word) => {
            Some(word.clone())
        }
        _ => None,
    };
    Condition {
        id,
        value,
        comparison: comparison(graph, overflow, value, &guard.check, spread),
        above_rounding,
        diagnosis: diagnosis(guard),
        operands,
        in_a_list: guard.check.has_spread() || guard.check == Check::ShareOfCentres,
        group: guard.group,
        word,
    }
}

fn spread(graph: &Graph, id: Id) -> Option<Spread<'_>> {
    let spread = graph.spread(graph.node(id))?;
    Some(graph.as_constant(spread).map_or(Spread::AtRunTime(spread), Spread::Known))
}

/// The function of the run-time crate that looks at the operands.
fn diagnosis(guard: &Guard) -> &'static str {
    match guard.check {
        Check::ReachCircles => "reach_circles",
        Check::ShareOfCentres => "share_of_centres",
        Check::ReachDistances => "reach_distances",
        Check::ReachLine => "reach_line",
        Check::ReachOffset => "reach_offset",
        Check::Nonzero => "nonzero",
        Check::Positive(_) => "positive",
        Check::NotNegative(_) => "not_negative",
        Check::Moving => "moving",
        Check::Closed(_) => "closed",
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
    spread: Option<Spread<'_>>,
) -> Option<(Comparison, Threshold)> {
    let comparison = match check {
        Check::ShareOfCentres | Check::Closed(_) => return None,
        Check::Nonzero if is_above_zero(graph, value) => return None,
        Check::ReachCircles | Check::ReachDistances | Check::Positive(_) | Check::Moving => {
            Comparison::Above
        }
        Check::ReachLine | Check::ReachOffset | Check::Square | Check::NotNegative(_) => {
            Comparison::AtLeast
        }
        Check::Nonzero => Comparison::Away,
    };
    let threshold = match (overflow, check) {
        (Some(overflow), _) => overflow.threshold(unguarded(graph, value), check, spread)?,
        (None, Check::Square) => Threshold::SmallestSquare,
        (None, Check::ReachLine) => Threshold::Number(f64::MIN_POSITIVE, f32::MIN_POSITIVE.into()),
        (None, _) if spread.is_some() => return None,
        (None, _) => Threshold::Number(0.0, 0.0),
    };
    Some((comparison, threshold))
}

/// Whether the value has passed a condition that keeps it above zero.
fn is_above_zero(graph: &Graph, value: Id) -> bool {
    match graph.node(value) {
        Node::Guard(inner, guard) => {
            let check = &graph.condition(guard).check;
            let is_kept = matches!(
                check,
                Check::ReachCircles | Check::ReachDistances | Check::Positive(_) | Check::Moving
            );
            is_kept || is_above_zero(graph, inner)
        }
        _ => false,
    }
}
