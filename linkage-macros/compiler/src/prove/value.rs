//! A node's value over a box, from those of its operands and before its own error.

use super::function_ranges;
use super::goal::Goal;
use super::outward::OutwardInterval;
use super::premises::Leaf;
use super::sloped::{InputBox, SlopedValue};
use crate::ir::graph::{Graph, Id, Node};

/// The value that a comparison chooses.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Choice {
    First,
    Second,
    /// Either, where both meet at the seam.
    Both,
    /// Either, where the value jumps.
    Jump,
}

/// A value of which nothing is known.
pub(super) const UNKNOWN: SlopedValue = SlopedValue {
    columns: [OutwardInterval::ALL; super::sloped::COLUMNS],
    slopes: [OutwardInterval::ALL; super::sloped::INPUTS],
};

/// See the module's documentation.
pub(super) fn value(
    subject: &Goal<'_>,
    frame: &InputBox,
    values: &[SlopedValue],
    place: usize,
) -> SlopedValue {
    let node = subject.nodes[place].1;
    let of = |id: Id| &values[subject.place(id)];
    if let Some(known) = subject.known(place) {
        return SlopedValue::constant(known.hull);
    }
    let jet = match node {
        Node::Input { .. } | Node::Param(_) | Node::Load(_) | Node::Drive(_) | Node::Mode(_) => {
            return leaf(subject, frame, node);
        }
        Node::InputCos(_) | Node::InputSin(_) => {
            let angle = leaf(subject, frame, node);
            let [sin, cos] =
                [function_ranges::sin, function_ranges::cos].map(|of| of(angle.range()));
            match node {
                Node::InputCos(_) => frame.chain(&angle, function_ranges::cos, sin.neg()),
                _ => frame.chain(&angle, function_ranges::sin, cos),
            }
        }
        Node::Neg(a) => return frame.neg(of(a)),
        Node::Guard(a, _) => return *of(a),
        Node::Add(a, b) => frame.add(of(a), of(b)),
        Node::Sub(a, b) => frame.sub(of(a), of(b)),
        Node::Mul(a, b) => product(subject.graph, frame, values, [a, b], subject),
        Node::Fused(a, b, c) => {
            frame.add(&product(subject.graph, frame, values, [a, b], subject), of(c))
        }
        Node::Div(a, b) => frame.div(of(a), of(b)),
        Node::Det([a, b, c, d]) => frame.sub(&frame.mul(of(a), of(b)), &frame.mul(of(c), of(d))),
        Node::Apply(function, a) => applied(frame, function, &[of(a)]),
        Node::Apply2(function, a, b) => applied(frame, function, &[of(a), of(b)]),
        Node::Select([_, _, x, y]) => match choice(subject, values, node) {
            Choice::First => return *of(x),
            Choice::Second => return *of(y),
            Choice::Both => frame.map(
                |at| of(x).columns[at].hull(of(y).columns[at]),
                |input| of(x).slopes[input].hull(of(y).slopes[input]),
            ),
            Choice::Jump => UNKNOWN,
        },
        // In real numbers nothing is rounded.
        Node::MulErr(..) | Node::AddErr(..) => SlopedValue::ZERO,
        Node::Constant(_) | Node::Low(_) => unreachable!("known"),
        // Attained that need these are not proved.
        Node::Solved(..) | Node::Trial(_) => UNKNOWN,
    };
    frame.met(&jet)
}

fn leaf(subject: &Goal<'_>, frame: &InputBox, node: Node) -> SlopedValue {
    match subject.leaf(node).expect("an input is given") {
        Leaf::Ranged(input) => frame.input(*input),
        Leaf::Within(interval) => SlopedValue::constant(*interval),
        Leaf::Decimal(_) => unreachable!("known"),
    }
}

fn product(
    _graph: &Graph,
    frame: &InputBox,
    values: &[SlopedValue],
    [a, b]: [Id; 2],
    subject: &Goal<'_>,
) -> SlopedValue {
    let of = |id: Id| &values[subject.place(id)];
    if a == b { frame.square(of(a)) } else { frame.mul(of(a), of(b)) }
}

fn applied(
    frame: &InputBox,
    function: crate::function::Function,
    arguments: &[&SlopedValue],
) -> SlopedValue {
    let column = |at: usize| {
        let arguments: Vec<_> = arguments.iter().map(|jet| jet.columns[at]).collect();
        function_ranges::of(function, &arguments)
    };
    let Some((_, slopes)) = column(0) else { return UNKNOWN };
    let value = |at| column(at).map_or(OutwardInterval::ALL, |(value, _)| value);
    let slope = |input: usize| {
        let parts = arguments.iter().zip(slopes).map(|(jet, by)| jet.slopes[input].mul(by));
        parts.fold(OutwardInterval::ZERO, OutwardInterval::add)
    };
    frame.map(value, slope)
}

/// The choice of a selection over the box.
pub(super) fn choice(subject: &Goal<'_>, values: &[SlopedValue], node: Node) -> Choice {
    let Node::Select([a, b, x, y]) = node else { unreachable!("it is a selection") };
    let [left, right] = [a, b].map(|id| values[subject.place(id)].range());
    if left.low >= right.high {
        return Choice::First;
    }
    if left.high < right.low {
        return Choice::Second;
    }
    let graph = subject.graph;
    let is_negative = |of: Id, id: Id| matches!(graph.node(id), Node::Neg(inner) if inner == of);
    let is_zero = |id| graph.is_zero(id);
    // The larger or the smaller of two, and the size of a number: both values meet where these are equal.
    let meets = [x, y] == [a, b] || [x, y] == [b, a];
    let is_size = |of: Id, zero: Id| {
        is_zero(zero) && (x == of && is_negative(of, y) || y == of && is_negative(of, x))
    };
    let is_continuous = meets || x == y || is_size(a, b) || is_size(b, a);
    if is_continuous { Choice::Both } else { Choice::Jump }
}
