//! The questions in front of each operation by which no value of the fast path is ever infinite or no number: for
//! controllers that stop at one.
//!
//! Intervals follow the statements in their order. Where they do not show that an operation stays within its width, its
//! operands are asked first. A pose that such a question refuses has a number far beyond those of machines.

mod sizes_of_functions;

use super::interval::Interval;
use super::room::Room;
use super::routine::{Condition, Instruction, Routine, is_leaf};
use crate::function::Function;
use crate::ir::check::Comparison;
use crate::ir::graph::{Graph, Id, Node};
use crate::ir::hash::{Map, Set};
use crate::ir::liveness::unguarded;

/// A question about the size of a value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum SizeCheck {
    /// |value| ≤ limit
    AtMost(Id, f64),
    /// value ≥ limit
    AtLeast(Id, f64),
    /// |value| ≥ limit
    Away(Id, f64),
    /// share |numerator| < |denominator|
    Quotient([Id; 2], f64),
}

/// A statement, or a question in front of one.
#[derive(Clone, Debug)]
pub(crate) enum FiniteStep {
    Ask(SizeCheck),
    Do(Instruction),
}

/// The statements with their questions, and the values that got a name so that they could be asked.
pub(crate) struct Steps {
    pub steps: Vec<FiniteStep>,
    pub named: Set<Id>,
}

/// The reason why there are none.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Unbounded {
    /// Something is searched, or solved for.
    Solved,
    /// No library of the language has the function.
    Function(Function),
    /// A constant is beyond the width.
    Constant,
}

/// The questions for the statements of a routine's fast path and for its results, where each of the known values has at
/// most this magnitude.
pub(crate) fn steps(
    graph: &Graph,
    routine: &Routine,
    statements: &[Instruction],
    sinks: &[Id],
    room: Room,
    known: &[(Id, f64)],
) -> Result<Steps, Unbounded> {
    let mut walk = SizeWalk {
        graph,
        routine,
        room,
        ranges: known.iter().map(|&(id, most)| (id, Interval::about(most))).collect(),
        made: Steps { steps: Vec::new(), named: Set::default() },
    };
    for statement in statements {
        walk.statement(statement)?;
        walk.made.steps.push(FiniteStep::Do(statement.clone()));
    }
    for &sink in sinks {
        walk.range(sink)?;
    }
    Ok(walk.made)
}

/// More than the relative error of any operation in either width.
const SLACK: f64 = 1e-6;

struct SizeWalk<'a> {
    graph: &'a Graph,
    routine: &'a Routine,
    room: Room,
    /// By what stands beneath conditions.
    ranges: Map<Id, Interval>,
    made: Steps,
}

impl SizeWalk<'_> {
    fn statement(&mut self, statement: &Instruction) -> Result<(), Unbounded> {
        match statement {
            Instruction::Let(id) => self.expression(*id),
            Instruction::SinCos { angle, sin, cos, .. } => {
                self.ask(SizeCheck::AtMost(*angle, self.room.near));
                for id in sin.iter().chain(cos) {
                    self.ranges.insert(*id, Interval::about(1.0 + SLACK));
                }
                Ok(())
            }
            Instruction::Length { id, least_square } => {
                let Node::Apply2(_, x, y) = self.graph.node(*id) else {
                    unreachable!("it is a hypotenuse")
                };
                let [x, y] = [self.square(x)?, self.square(y)?];
                let least = self.room.of(*least_square);
                let square = self.sum(x, y, &[])?;
                let range = Interval::of(least.sqrt(), square.largest().sqrt().max(least.sqrt()));
                self.put(*id, range)
            }
            Instruction::Check(condition) => self.condition(condition),
            Instruction::Solve(_) => Err(Unbounded::Solved),
            Instruction::ReportClearances { .. } => Ok(()),
        }
    }

    fn condition(&mut self, condition: &Condition) -> Result<(), Unbounded> {
        if condition.check.is_of_both_paths() {
            return Err(Unbounded::Solved);
        }
        let mut range = self.range(condition.value)?;
        if let Some((comparison, threshold)) = condition.comparison {
            let least = self.room.of(threshold);
            range.away = range.away.max(least);
            if comparison != Comparison::Away {
                range.low = range.low.max(least);
            }
        }
        if let Some(spread) = condition.above_rounding {
            self.range(spread)?;
            range.low = range.low.max(0.0);
        }
        range.high = range.high.max(range.low);
        // A comparison is exact, and only its limit is rounded.
        let (low, away) = (range.low * (1.0 - SLACK), range.away * (1.0 - SLACK));
        let low = if range.low > 0.0 { low } else { range.low };
        self.ranges.insert(unguarded(self.graph, condition.id), Interval { low, away, ..range });
        Ok(())
    }

    /// Stores the range of what was computed, with its rounding.
    fn put(&mut self, id: Id, range: Interval) -> Result<(), Unbounded> {
        let (slack, tiny) = (SLACK * range.largest() + self.room.tiny, self.room.tiny);
        let inward = |x: f64| (x * (1.0 - SLACK) - tiny).max(0.0);
        let widened = Interval {
            low: if range.low >= 0.0 { inward(range.low) } else { range.low - slack },
            high: if range.high <= 0.0 { -inward(-range.high) } else { range.high + slack },
            away: inward(range.away),
        };
        self.ranges.insert(unguarded(self.graph, id), widened);
        Ok(())
    }

    /// The range of a value that a statement reads.
    fn range(&mut self, id: Id) -> Result<Interval, Unbounded> {
        let id = unguarded(self.graph, id);
        if let Some(&known) = self.ranges.get(&id) {
            return Ok(known);
        }
        match self.graph.node(id) {
            node if is_leaf(node) => {
                self.ask(SizeCheck::AtMost(id, self.room.given));
                Ok(Interval::about(self.room.given))
            }
            Node::Constant(constant) => {
                let value = self.graph.value(constant).to_f64();
                let is_held = value.abs() <= self.room.asked;
                is_held.then(|| Interval::point(value)).ok_or(Unbounded::Constant)
            }
            Node::Low(_) => Ok(Interval::about(self.room.given)),
            Node::Neg(of) => Ok(self.range(of)?.negated()),
            Node::Mode(_) => Ok(Interval { low: -1.0, high: 1.0, away: 1.0 }),
            Node::Apply(function, _) | Node::Apply2(function, ..) => {
                Err(Unbounded::Function(function))
            }
            _ => Err(Unbounded::Solved),
        }
    }

    /// Asks, and narrows what is known by that. What has no name yet gets one.
    fn ask(&mut self, check: SizeCheck) {
        let base = |id| self.base(id);
        let check = match check {
            SizeCheck::AtMost(id, limit) => SizeCheck::AtMost(base(id), limit),
            SizeCheck::AtLeast(id, limit) => SizeCheck::AtLeast(id, limit),
            SizeCheck::Away(id, limit) => SizeCheck::Away(base(id), limit),
            SizeCheck::Quotient(ids, share) => SizeCheck::Quotient(ids.map(base), share),
        };
        let asked = match check {
            SizeCheck::AtMost(id, _) | SizeCheck::AtLeast(id, _) | SizeCheck::Away(id, _) => {
                vec![id]
            }
            SizeCheck::Quotient(ids, _) => ids.to_vec(),
        };
        for id in asked {
            let id = self.base(id);
            if self.routine.locals.nested.contains(&id) && self.made.named.insert(id) {
                self.made.steps.push(FiniteStep::Do(Instruction::Let(id)));
            }
        }
        self.narrow(check);
        self.made.steps.push(FiniteStep::Ask(check));
    }

    fn narrow(&mut self, check: SizeCheck) {
        let (id, with) = match check {
            SizeCheck::AtMost(id, limit) => (id, Interval::about(limit)),
            SizeCheck::AtLeast(id, limit) => (id, Interval::of(limit, f64::INFINITY)),
            SizeCheck::Away(id, limit) => {
                let away = Interval { away: limit, ..Interval::about(f64::INFINITY) };
                (id, away)
            }
            SizeCheck::Quotient(..) => return,
        };
        let id = unguarded(self.graph, id);
        let before = self.ranges.get(&id).copied();
        let before = before.unwrap_or(Interval::about(self.room.largest));
        let (low, high) = (before.low.max(with.low), before.high.min(with.high));
        let narrow = Interval { low: low.min(high), high, away: before.away.max(with.away) };
        self.ranges.insert(id, narrow);
    }

    /// The value behind signs that are written where it is read.
    fn base(&self, id: Id) -> Id {
        match self.graph.node(unguarded(self.graph, id)) {
            Node::Neg(of) if !self.routine.locals.components.contains(&id) => self.base(of),
            _ => id,
        }
    }

    /// An operation, with those that are written inside of it.
    fn expression(&mut self, id: Id) -> Result<(), Unbounded> {
        let node = self.graph.node(id);
        let mut operands = Vec::new();
        node.for_operands(&mut |operand| operands.push(operand));
        for operand in operands {
            let operand = self.base(operand);
            if self.routine.locals.nested.contains(&operand) {
                self.expression(operand)?;
            }
        }
        let range = self.operation(node)?;
        self.put(id, range)
    }

    fn operation(&mut self, node: Node) -> Result<Interval, Unbounded> {
        match node {
            Node::Neg(a) => Ok(self.range(a)?.negated()),
            Node::Add(a, b) => {
                let [x, y] = [self.range(a)?, self.range(b)?];
                self.sum(x, y, &[a, b])
            }
            Node::Sub(a, b) => {
                let [x, y] = [self.range(a)?, self.range(b)?.negated()];
                self.sum(x, y, &[a, b])
            }
            Node::Mul(a, b) => self.product(a, b),
            Node::Fused(a, b, c) => {
                let [x, y] = [self.product(a, b)?, self.range(c)?];
                self.sum(x, y, &[c])
            }
            Node::Det([a, b, c, d]) => {
                let [x, y] = [self.split_product(a, b)?, self.split_product(c, d)?];
                self.sum(x, y.negated(), &[])
            }
            Node::MulErr(a, b) => Ok(Interval::about(self.split_product(a, b)?.largest() * SLACK)),
            Node::AddErr(a, b) => {
                let [x, y] = [self.range(a)?, self.range(b)?];
                Ok(Interval::about(self.sum(x, y, &[a, b])?.largest() * SLACK))
            }
            Node::Select([a, b, x, y]) => {
                self.range(a)?;
                self.range(b)?;
                Ok(self.range(x)?.or(self.range(y)?))
            }
            Node::Div(a, b) => self.quotient(a, b),
            Node::Mode(_) => Ok(Interval { low: -1.0, high: 1.0, away: 1.0 }),
            Node::Apply(function, a) => self.function(function, a),
            Node::Apply2(Function::Atan2, a, b) => {
                self.range(a)?;
                self.range(b)?;
                Ok(Interval::about(3.2))
            }
            Node::Apply2(Function::Pow, a, b) => self.power(a, b),
            Node::Apply2(function, ..) => Err(Unbounded::Function(function)),
            Node::Guard(..) | Node::Solved(..) | Node::Trial(_) => Err(Unbounded::Solved),
            Node::Constant(_)
            | Node::Low(_)
            | Node::Input { .. }
            | Node::InputCos(_)
            | Node::InputSin(_)
            | Node::Param(_)
            | Node::Load(_)
            | Node::Drive(_) => unreachable!("read in place"),
        }
    }

    /// The sum; where it is too large, those of these parts are asked that may be.
    fn sum(&mut self, x: Interval, y: Interval, parts: &[Id]) -> Result<Interval, Unbounded> {
        let sum = x.plus(y);
        if sum.largest() <= self.room.largest {
            return Ok(sum);
        }
        for &part in parts {
            if self.range(part)?.largest() > self.room.asked {
                self.ask(SizeCheck::AtMost(part, self.room.usual));
            }
        }
        Ok(Interval::about(4.0 * self.room.asked))
    }

    fn square(&mut self, a: Id) -> Result<Interval, Unbounded> {
        self.product(a, a)
    }

    fn product(&mut self, a: Id, b: Id) -> Result<Interval, Unbounded> {
        let is_square = unguarded(self.graph, a) == unguarded(self.graph, b);
        let ranges = [self.range(a)?, self.range(b)?];
        let [x, y] = ranges.map(Interval::largest);
        if x * y > self.room.largest {
            let root = self.room.asked.sqrt();
            let limits = match () {
                () if x <= root => [None, Some(self.room.asked / x)],
                () if y <= root => [Some(self.room.asked / y), None],
                () if is_square => [Some(root), None],
                () => [Some(root); 2],
            };
            for (id, limit) in [a, b].into_iter().zip(limits) {
                if let Some(limit) = limit {
                    self.ask(SizeCheck::AtMost(id, limit.min(self.room.usual)));
                }
            }
        }
        let [x, y] = [self.range(a)?, self.range(b)?];
        Ok(if is_square { x.squared() } else { x.times(y) })
    }

    /// A product of which the rounding is computed, too: without a fused operation its factors are split.
    fn split_product(&mut self, a: Id, b: Id) -> Result<Interval, Unbounded> {
        for id in [a, b] {
            if self.range(id)?.largest() > self.room.factor {
                self.ask(SizeCheck::AtMost(id, self.room.factor));
            }
        }
        self.product(a, b)
    }

    fn quotient(&mut self, a: Id, b: Id) -> Result<Interval, Unbounded> {
        let [x, y] = [self.range(a)?, self.range(b)?];
        // √x/x is 1/√x.
        if let Node::Apply(Function::Sqrt, under) = self.graph.node(unguarded(self.graph, a))
            && unguarded(self.graph, under) == unguarded(self.graph, b)
            && let Some(range) = y.root().and_then(Interval::reciprocal)
        {
            return Ok(range);
        }
        if x.largest() / y.away <= self.room.asked
            && let Some(inverse) = y.reciprocal()
        {
            return Ok(x.times(inverse));
        }
        let least = x.largest() / self.room.quotient;
        if least <= self.room.divisor {
            self.ask(match y.low >= 0.0 {
                true => SizeCheck::AtLeast(b, least.max(self.room.normal)),
                false => SizeCheck::Away(b, least.max(self.room.normal)),
            });
            return Ok(Interval::about(self.room.quotient));
        }
        self.ask(SizeCheck::Quotient([a, b], 1.0 / self.room.asked));
        Ok(Interval::about(self.room.asked))
    }
}
