//! Adjoints: the effect of a node's change on a result, from the result back to the operands, with their slopes over
//! the box.

use super::function_ranges;
use super::goal::Goal;
use super::outward::OutwardInterval;
use super::sloped::{InputBox, SlopedValue};
use super::value::{Choice, UNKNOWN, choice};
use crate::function::Function;
use crate::ir::graph::{Id, Node};

/// Values over a box, whose adjoints are found.
pub struct Adjoints<'a, 'g> {
    pub subject: &'a Goal<'g>,
    pub frame: &'a InputBox,
    pub values: &'a [SlopedValue],
}

impl Adjoints<'_, '_> {
    /// The adjoint of every node for a result, none where the result does not depend on it.
    pub fn adjoints(&self, sink: Id) -> Vec<Option<SlopedValue>> {
        let mut adjoints: Vec<Option<SlopedValue>> = vec![None; self.subject.nodes.len()];
        adjoints[self.subject.place(sink)] =
            Some(SlopedValue::constant(OutwardInterval::point(1.0)));
        for place in (0..=self.subject.place(sink)).rev() {
            let Some(adjoint) = adjoints[place] else { continue };
            let adjoint = self.frame.met(&adjoint);
            adjoints[place] = Some(adjoint);
            self.spread(place, &adjoint, &mut |operand, change| {
                let sum = &mut adjoints[self.subject.place(operand)];
                *sum = Some(sum.map_or(change, |sum| self.frame.add(&sum, &change)));
            });
        }
        adjoints
    }

    fn of(&self, id: Id) -> &SlopedValue {
        &self.values[self.subject.place(id)]
    }

    /// Hands each operand what it does by way of this node.
    fn spread(&self, place: usize, adjoint: &SlopedValue, to: &mut dyn FnMut(Id, SlopedValue)) {
        let frame = self.frame;
        let by = |id: Id| frame.mul(adjoint, self.of(id));
        let node = self.subject.nodes[place].1;
        match node {
            Node::Constant(_)
            | Node::Low(_)
            | Node::Input { .. }
            | Node::InputCos(_)
            | Node::InputSin(_)
            | Node::Param(_)
            | Node::Load(_)
            | Node::Drive(_)
            | Node::Mode(_)
            | Node::Trial(_)
            | Node::Solved(..)
            // In real numbers they are zero whatever is rounded.
            | Node::MulErr(..)
            | Node::AddErr(..) => {}
            Node::Neg(a) => to(a, frame.neg(adjoint)),
            Node::Guard(a, _) => to(a, *adjoint),
            Node::Add(a, b) => {
                to(a, *adjoint);
                to(b, *adjoint);
            }
            Node::Sub(a, b) => {
                to(a, *adjoint);
                to(b, frame.neg(adjoint));
            }
            Node::Mul(a, b) => self.product(adjoint, [a, b], to),
            Node::Fused(a, b, c) => {
                self.product(adjoint, [a, b], to);
                to(c, *adjoint);
            }
            Node::Det([a, b, c, d]) => {
                to(a, by(b));
                to(b, by(a));
                to(c, frame.neg(&by(d)));
                to(d, frame.neg(&by(c)));
            }
            Node::Div(a, b) => {
                let one = SlopedValue::constant(OutwardInterval::point(1.0));
                let inverse = frame.met(&frame.div(&one, self.of(b)));
                to(a, frame.mul(adjoint, &inverse));
                let quotient = frame.met(&frame.mul(self.of(a), &inverse));
                let slope = frame.met(&frame.mul(&quotient, &inverse));
                to(b, frame.neg(&frame.mul(adjoint, &slope)));
            }
            Node::Select(_) => self.chosen(node, adjoint, to),
            Node::Apply(function, a) => self.applied(function, &[a], adjoint, to),
            Node::Apply2(function, a, b) => self.applied(function, &[a, b], adjoint, to),
        }
    }

    fn chosen(&self, node: Node, adjoint: &SlopedValue, to: &mut dyn FnMut(Id, SlopedValue)) {
        let Node::Select([_, _, x, y]) = node else { unreachable!("it is a selection") };
        match choice(self.subject, self.values, node) {
            Choice::First => to(x, *adjoint),
            Choice::Second => to(y, *adjoint),
            Choice::Both => {
                let either = SlopedValue::constant(OutwardInterval::between(0.0, 1.0));
                to(x, self.frame.mul(adjoint, &either));
                to(y, self.frame.mul(adjoint, &either));
            }
            Choice::Jump => {
                to(x, UNKNOWN);
                to(y, UNKNOWN);
            }
        }
    }

    fn applied(
        &self,
        function: Function,
        arguments: &[Id],
        adjoint: &SlopedValue,
        to: &mut dyn FnMut(Id, SlopedValue),
    ) {
        let values: Vec<_> = arguments.iter().map(|&id| self.of(id)).collect();
        let slopes = function_ranges::slopes(self.frame, function, &values);
        for (&id, slope) in arguments.iter().zip(&slopes) {
            to(id, self.frame.mul(adjoint, slope));
        }
    }

    fn product(&self, adjoint: &SlopedValue, [a, b]: [Id; 2], to: &mut dyn FnMut(Id, SlopedValue)) {
        if a == b {
            let twice = self.frame.add(self.of(a), self.of(a));
            return to(a, self.frame.mul(adjoint, &twice));
        }
        to(a, self.frame.mul(adjoint, self.of(b)));
        to(b, self.frame.mul(adjoint, self.of(a)));
    }
}
