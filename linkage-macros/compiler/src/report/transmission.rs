//! Sines of transmission angles, from the values whose sign says whether a group can be assembled.

use super::sensitivity::ProvedBoxes;
use super::{TransmissionReport, comparisons};
use crate::interface::EntryId;
use crate::ir::graph::{Guard, Id, Node};
use crate::ir::liveness::{Path, live, live_nodes};
use crate::lower::routine::Lowered;
use crate::prove::goal::Goal;
use crate::prove::one_box::OneBox;
use crate::prove::outward::OutwardInterval;
use crate::prove::premises::Premises;
use crate::prove::sloped::InputBox;
use crate::prove::width::Precision;

/// A group, and the numbers that its sine follows from.
struct Transmitted {
    group: u32,
    value: Id,
    /// The unit of the value, or the length of the bar.
    by: Id,
    /// Two bars have a value that is a quarter of the sine's square.
    factor: f64,
}

/// See the module's documentation.
pub(super) fn transmissions(
    lowered: &Lowered<'_>,
    id: EntryId,
    looked: &ProvedBoxes<'_>,
) -> Vec<TransmissionReport> {
    let graph = &lowered.program.graph;
    let needed = live(graph, comparisons::sinks(lowered, id), Path::Slow);
    let guards = live_nodes(graph, &needed).filter_map(|(_, node)| match node {
        Node::Guard(value, guard) => measured(value, graph.condition(guard)),
        _ => None,
    });
    let mut found: Vec<Transmitted> = Vec::new();
    for guard in guards {
        if found.iter().all(|known| known.value != guard.value) {
            found.push(guard);
        }
    }
    let sinks: Vec<Id> = found.iter().flat_map(|of| [of.value, of.by]).collect();
    let given: &Premises = looked.given;
    let subject = Goal::new(graph, (&sinks, &[]), given, Precision::Double);
    let mut least: Vec<(f64, Vec<f64>)> = vec![(f64::INFINITY, Vec::new()); found.len()];
    for sides in &looked.boxes {
        let values = OneBox::new(&subject, InputBox::new(sides));
        for (of, least) in found.iter().zip(&mut least) {
            let column = |id: Id, at: usize| values.column(id, at);
            let sine = |at: usize| of.sine(column(of.value, at), column(of.by, at));
            let over_the_box = sine(0).low;
            if over_the_box < least.0 {
                let corners = 1..values.frame.columns();
                let nearest = corners.min_by(|&a, &b| sine(a).low.total_cmp(&sine(b).low));
                let at = nearest.map_or_else(Vec::new, |at| values.frame.corner(at - 1));
                *least = (over_the_box, at);
            }
        }
    }
    let told = found.iter().zip(least).filter(|(_, (least, _))| least.is_finite());
    let group = |of: &Transmitted| lowered.program.groups[of.group as usize].clone();
    told.map(|(of, (least, at))| TransmissionReport { group: group(of), least, at }).collect()
}

fn measured(value: Id, guard: &Guard) -> Option<Transmitted> {
    let (operand, factor) = guard.check.sine()?;
    let by = *guard.operands.get(operand)?;
    Some(Transmitted { group: guard.group, value, by, factor })
}

impl Transmitted {
    fn sine(&self, value: OutwardInterval, by: OutwardInterval) -> OutwardInterval {
        value.root().scaled(self.factor).div(by.abs()).meet(OutwardInterval::between(0.0, 1.0))
    }
}
