//! Conditions that hold over a whole turn of the inputs, though one interval of all angles does not show it.
//!
//! A turn is cut into arcs, which are halved until every one shows a condition, or are short. On each, a cosine and its
//! sine lie in short intervals, and so does what is made of both. An arc on which another condition fails for certain
//! asks nothing more: there the fast path has no answer.
//!
//! Sines are taken as wrong as those that a target may bring. That is more than a pair of cosine and sine that is given
//! may lie beside the circle.

use super::{AskedSizes, Assumed, Bounds, Interval, Thresholds, Values};
use crate::function::{Function, HOOKED_SINE};
use crate::ir::graph::{Graph, Id, Node};
use crate::ir::hash::Map;
use crate::ir::liveness::unguarded;

use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// The most inputs whose turns are cut, all together.
const MOST_INPUTS: usize = 2;
/// The arcs of one input's turn at first, and of each of two.
const FIRST: [u32; MOST_INPUTS] = [16, 8];
/// An arc that is no longer than this is not halved.
const SHORTEST: f64 = TAU / 1024.0;
/// The most boxes of arcs that are looked at.
const MOST_BOXES: usize = 400;

/// The angles of an input in an arc, each with any whole turns.
#[derive(Clone, Copy, Debug)]
pub(super) struct Arc {
    input: u32,
    from: f64,
    to: f64,
}

impl Arc {
    fn cosine(&self) -> Interval {
        let ([from, to], mut range) = ([self.from, self.to], [f64::INFINITY, f64::NEG_INFINITY]);
        let mut takes = |value: f64| range = [range[0].min(value), range[1].max(value)];
        takes(from.cos());
        takes(to.cos());
        // The multiples of a half turn between the ends.
        let (first, last) = ((from / PI).ceil() as i64, (to / PI).floor() as i64);
        (first..=last).for_each(|halves| takes(if halves % 2 == 0 { 1.0 } else { -1.0 }));
        Interval::of(range[0], range[1])
    }

    /// Its angles and so much more.
    fn turned(self, by: f64) -> Self {
        Self { from: self.from + by, to: self.to + by, ..self }
    }

    fn length(&self) -> f64 {
        self.to - self.from
    }

    fn halves(self) -> [Self; 2] {
        let middle = self.from + self.length() / 2.0;
        [Self { to: middle, ..self }, Self { from: middle, ..self }]
    }

    /// A turn, cut into as many arcs.
    fn turn(input: u32, parts: u32) -> impl Iterator<Item = Self> {
        let at = move |part: u32| TAU * (f64::from(part) / f64::from(parts) - 0.5);
        (0..parts).map(move |part| Self { input, from: at(part), to: at(part + 1) })
    }

    /// Its middle alone.
    fn middle(self) -> Self {
        let [first, _] = self.halves();
        Self { from: first.to, to: first.to, ..self }
    }
}

impl Bounds<'_> {
    /// A sine or a cosine of an input of which an arc is looked at.
    pub(super) fn on_arc(&self, node: Node) -> Option<Interval> {
        let (input, ahead) = turned_input(self.graph, node)?;
        let arc = self.arcs.iter().find(|arc| arc.input == input)?;
        let range = arc.turned(ahead).cosine();
        Some(Interval::of(range.low - self.error, range.high + self.error).rounded())
    }
}

/// The input of which a node is a cosine, after it was turned by so much.
fn turned_input(graph: &Graph, node: Node) -> Option<(u32, f64)> {
    let (input, function) = match node {
        Node::InputCos(input) => (input, Function::Cos),
        Node::InputSin(input) => return Some((input, -FRAC_PI_2)),
        Node::Apply(function, angle) => match graph.node(angle) {
            Node::Input { input, order: 0 } => (input, function),
            _ => return None,
        },
        _ => return None,
    };
    Some((input, function.as_cosine()?))
}

impl Values<'_> {
    /// Takes the thresholds away of the guards that hold on every arc, of those of which this is worth knowing.
    pub(in crate::lower) fn leave_out_those_of_every_arc(
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
        let shown_on = |arcs: &[Arc], open: &[Id]| self.shown(limits, asked, &nodes, arcs, open);
        let turns = inputs.iter().map(|&input| Arc::turn(input, FIRST[inputs.len() - 1]));
        let mut boxes = turns.fold(vec![Vec::new()], |boxes: Vec<Vec<Arc>>, turn| {
            let arcs: Vec<_> = turn.collect();
            let with = |arcs_of_box: Vec<Arc>| {
                arcs.iter().map(move |&arc| [&arcs_of_box[..], &[arc]].concat()).collect::<Vec<_>>()
            };
            boxes.into_iter().flat_map(with).collect()
        });
        let mut looked_at = 0;
        while let Some(arcs) = boxes.pop()
            && !open.is_empty()
        {
            looked_at += 1;
            let shown = shown_on(&arcs, &open);
            if shown.iter().all(|&is_shown| is_shown) {
                continue;
            }
            // Most that do not hold fail in the middle of one of the first arcs.
            let middle: Vec<_> = arcs.iter().map(|arc| arc.middle()).collect();
            let is_short = arcs.iter().all(|arc| arc.length() <= SHORTEST);
            let kept = if is_short { shown } else { shown_on(&middle, &open) };
            keep(&mut open, kept);
            if looked_at + boxes.len() >= MOST_BOXES {
                open.clear();
            } else if !is_short {
                boxes.extend(halves(&arcs));
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
            let input = turned_input(self.graph, node).map(|(input, _)| input);
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
        arcs: &[Arc],
        open: &[Id],
    ) -> Vec<bool> {
        let mut bounds = Bounds {
            graph: self.graph,
            limits,
            error: HOOKED_SINE,
            asked: Some(asked),
            arcs,
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

/// The longest arc halved, beside the others.
fn halves(arcs: &[Arc]) -> [Vec<Arc>; 2] {
    let longer = |&a: &usize, &b: &usize| arcs[a].length().total_cmp(&arcs[b].length());
    let longest = (0..arcs.len()).max_by(longer).expect("there is an arc");
    arcs[longest].halves().map(|half| {
        let mut arcs = arcs.to_vec();
        arcs[longest] = half;
        arcs
    })
}

fn keep(open: &mut Vec<Id>, shown: Vec<bool>) {
    let mut shown = shown.into_iter();
    open.retain(|_| shown.next() == Some(true));
}
