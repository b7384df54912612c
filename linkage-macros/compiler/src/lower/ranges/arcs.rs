//! Conditions that hold over a whole turn of the inputs, though one interval of all angles does not show it.
//!
//! A turn is cut into arcs, which are halved until every one shows a condition, or are short. On each, a cosine and its
//! sine lie in short intervals, and so does what is made of both. An arc on which another condition fails for certain
//! asks nothing more: there the fast path has no answer.
//!
//! Sines are taken as wrong as those that a target may bring. That is more than a pair of cosine and sine that is given
//! may lie beside the circle.

use super::{AskedSizes, Assumed, Bounds, Interval, Thresholds, Values};
use crate::function::HOOKED_SINE;
use crate::ir::graph::{Graph, Id, Node};
use crate::ir::hash::Map;
use crate::ir::liveness::unguarded;
use crate::prove::boxes::{BoxSides, first, halves, widest};
use crate::prove::function_ranges;
use crate::prove::outward::OutwardInterval;

use std::f64::consts::PI;

/// The most inputs whose turns are cut, all together.
const MOST_INPUTS: usize = 2;
/// A box with no side longer than this share of a turn is not halved.
const SHORTEST: f64 = 1.0 / 1024.0;
/// The most boxes of arcs that are looked at.
const MOST_BOXES: usize = 400;

/// The angles of some inputs, an arc each.
#[derive(Clone, Copy, Debug)]
pub(super) struct Arcs<'a> {
    inputs: &'a [u32],
    sides: &'a BoxSides,
}

impl Bounds<'_> {
    /// A sine or a cosine of an input of which an arc is looked at.
    pub(super) fn on_arc(&self, node: Node) -> Option<Interval> {
        let arcs = self.arcs?;
        let input = turned_input(self.graph, node)?;
        let [low, high] = arcs.sides[arcs.inputs.iter().position(|&one| one == input)?];
        let angle = OutwardInterval::between(low, high);
        let range = match node {
            Node::InputCos(_) => function_ranges::cos(angle),
            Node::InputSin(_) => function_ranges::sin(angle),
            Node::Apply(function, _) => function_ranges::of(function, &[angle])?.0,
            _ => return None,
        };
        Some(Interval::of(range.low - self.error, range.high + self.error).rounded())
    }
}

/// The input of which a node is a sine or a cosine.
fn turned_input(graph: &Graph, node: Node) -> Option<u32> {
    match node {
        Node::InputCos(input) | Node::InputSin(input) => Some(input),
        Node::Apply(function, angle) if function.reduces_turns() => match graph.node(angle) {
            Node::Input { input, order: 0 } => Some(input),
            _ => None,
        },
        _ => None,
    }
}

impl Values<'_> {
    /// Takes the thresholds away of the guards that hold on every arc, of those of which this is worth knowing.
    pub fn leave_out_those_of_every_arc(
        &self,
        limits: &Assumed,
        asked: &mut AskedSizes,
        is_of_use: impl Fn(Id) -> bool,
    ) {
        let mut open = self.asked_guards(&asked.0);
        open.retain(|&id| is_of_use(id));
        let inputs = if open.is_empty() { Vec::new() } else { self.turning_inputs() };
        if inputs.is_empty() || inputs.len() > MOST_INPUTS {
            return;
        }
        let nodes = self.those_that_lead_to(&open);
        let ranges = vec![[-PI, PI]; inputs.len()];
        let shown_on = |sides: &BoxSides, open: &[Id]| {
            self.shown(limits, asked, &nodes, Arcs { inputs: &inputs, sides }, open)
        };
        let mut boxes = first(&ranges);
        let mut looked_at = 0;
        while let Some(sides) = boxes.pop()
            && !open.is_empty()
        {
            looked_at += 1;
            let shown = shown_on(&sides, &open);
            if shown.iter().all(|&is_shown| is_shown) {
                continue;
            }
            // Most that do not hold fail in the middle of one of the first arcs.
            let middle = sides.iter().map(|[low, high]| [low + (high - low) / 2.0; 2]).collect();
            let is_short = widest(&sides, &ranges).1 <= SHORTEST;
            let kept = if is_short { shown } else { shown_on(&middle, &open) };
            keep(&mut open, kept);
            if looked_at + boxes.len() >= MOST_BOXES {
                open.clear();
            } else if !is_short {
                boxes.extend(halves(&sides, &ranges));
            }
        }
        for id in open {
            *asked.0.or_insert(id, None) = None;
        }
    }

    /// The inputs of which sines and cosines are taken.
    fn turning_inputs(&self) -> Vec<u32> {
        let mut inputs = Vec::new();
        for &(_, node) in &self.live {
            let input = turned_input(self.graph, node);
            inputs.extend(input.filter(|input| !inputs.contains(input)));
        }
        inputs
    }

    /// The guarded values that are asked, in the order of the graph.
    fn asked_guards(&self, thresholds: &Thresholds) -> Vec<Id> {
        let is_asked = |&(id, _): &(Id, Node)| matches!(thresholds.get(&id), Some(Some(_)));
        self.live.iter().copied().filter(is_asked).map(|(id, _)| id).collect()
    }

    /// The live nodes behind which one of these values stands, with the guards of such a value.
    fn those_that_lead_to(&self, values: &[Id]) -> Vec<(Id, Node)> {
        let mut leads = vec![false; self.graph.len()];
        let mut nodes = Vec::new();
        for &(id, node) in self.live.iter().rev() {
            let is_guard = matches!(node, Node::Guard(value, _) if values.contains(&unguarded(self.graph, value)));
            if leads[id.index()] || is_guard {
                node.for_operands(&mut |operand| leads[operand.index()] = true);
                nodes.push((id, node));
            }
        }
        nodes.reverse();
        nodes
    }

    /// For each of the open values, whether its conditions hold on these arcs or need not be asked there.
    fn shown(
        &self,
        limits: &Assumed,
        asked: &AskedSizes,
        nodes: &[(Id, Node)],
        arcs: Arcs<'_>,
        open: &[Id],
    ) -> Vec<bool> {
        let mut bounds = Bounds {
            graph: self.graph,
            limits,
            error: HOOKED_SINE,
            asked: Some(asked),
            arcs: Some(arcs),
            fails: false,
            ranges: self.constants.clone(),
            thresholds: Map::default(),
            lengths: Map::default(),
        };
        for &(id, node) in nodes {
            if bounds.of(id).is_none() {
                let Some(range) = bounds.range(id, node) else { break };
                bounds.ranges[id.index()] = Some(range);
            }
        }
        let is_shown = |id: &Id| match bounds.thresholds.get(id) {
            Some(threshold) => threshold.is_none(),
            None => bounds.fails,
        };
        open.iter().map(is_shown).collect()
    }
}

fn keep(open: &mut Vec<Id>, shown: Vec<bool>) {
    let mut shown = shown.into_iter();
    open.retain(|_| shown.next() == Some(true));
}
