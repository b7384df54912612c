//! Bounds on the values of a graph in floating-point arithmetic.
//!
//! Where every input is bounded and every divisor bounded away from zero, intervals show that no
//! value overflows, and then none needs to be asked whether it is finite: it is enough to ask the
//! inputs and the divisors, which are known early. An interval is widened by more than the
//! rounding of either width at every node, so it holds for the computed values, not for the real
//! ones alone.
//!
//! Arc by arc (`arcs`) more is shown than by one interval of all angles.

mod arcs;
use self::arcs::Arcs;
use super::interval::Interval;
use crate::exact::Exact;
use crate::function::{Function, HOOKED_SINE};
use crate::ir::check::{Comparison, Least};
use crate::ir::graph::{Graph, Guard, Id, Node};
use crate::ir::hash::Map;
use crate::ir::liveness::{live_nodes, unguarded};

/// Assumptions on one width of numbers.
#[derive(Clone, Copy, Debug)]
pub struct Assumed {
    /// The largest magnitude of an input that is not an angle in a sine, and of its rate; of its
    /// acceleration the square of it.
    pub input: f64,
    /// The least magnitude of a divisor that a guard keeps from zero, as a share of its largest.
    pub share: f64,
    /// The smallest square of full precision.
    pub square: f64,
    /// The smallest number of full precision.
    pub normal: f64,
    /// The distance from 1 to the next number.
    pub epsilon: f64,
    /// Upper limit on every magnitude.
    pub largest: f64,
    /// Upper limit on a factor whose product's rounding error is requested.
    pub factor: f64,
}

/// The factor of ε of the spread by which a value may be wrong, as the run-time crate counts it.
pub const ROUNDINGS: f64 = 16.0;

impl Assumed {
    /// Bound on the rounding error of a value of this spread.
    pub(super) fn rounding_of(&self, spread: &Exact) -> f64 {
        ROUNDINGS * self.epsilon * spread.to_f64()
    }
}

/// Tests left to the fast path where no result can overflow: the least value, or magnitude, of each guarded
/// value, by the unguarded node. Zero where the sign is enough, and `None` where no test is left.
pub type Thresholds = Map<Id, Option<f64>>;

/// The thresholds of guards, and the least lengths of hypotenuses.
pub(crate) type AskedSizes = (Thresholds, Map<Id, f64>);

/// More than the relative error of any operation in either width.
const SLACK: f64 = 1e-6;

/// More than what underflow takes from a value in either width.
const TINY: f64 = 1e-35;

/// The live nodes of a graph and the ranges of its constants, which hold under any limits.
pub struct Values<'a> {
    graph: &'a Graph,
    live: Vec<(Id, Node)>,
    constants: Vec<Option<Interval>>,
}

impl<'a> Values<'a> {
    pub fn new(graph: &'a Graph, live: &[bool]) -> Self {
        let mut constants = vec![None; graph.len()];
        let live: Vec<_> = live_nodes(graph, live).collect();
        for &(id, node) in &live {
            let value = |constant| graph.value(constant).to_f64();
            constants[id.index()] = match node {
                Node::Constant(constant) => Some(Interval::point(value(constant)).rounded()),
                Node::Low(constant) => Some(Interval::about(value(constant).abs() * SLACK)),
                _ => None,
            };
        }
        Self { graph, live, constants }
    }

    /// The thresholds of all guards under the limits, if every live value is bounded, and the least
    /// lengths of hypotenuses.
    pub fn thresholds(&self, limits: &Assumed) -> Option<AskedSizes> {
        let own = self.within(limits, 0.0, None)?;
        // Guards that the run-time's sine alone shows are asked all the same: a target may bring another one.
        let (hooked, _) = self.within(limits, HOOKED_SINE, Some(&own))?;
        let (thresholds, lengths) = own;
        let of_any = |&(id, asked): &(Id, Option<f64>)| (id, asked.or(hooked[&id]));
        Some((thresholds.iter().map(of_any).collect(), lengths))
    }

    /// The same for sines and cosines of this error, where these sizes are asked already.
    fn within(
        &self,
        limits: &Assumed,
        error: f64,
        asked: Option<&AskedSizes>,
    ) -> Option<AskedSizes> {
        let (graph, ranges, arcs) = (self.graph, self.constants.clone(), None);
        let (thresholds, lengths) = (Map::default(), Map::default());
        let fails = false;
        let mut bounds =
            Bounds { graph, limits, error, asked, arcs, fails, ranges, thresholds, lengths };
        for &(id, node) in &self.live {
            let range = match bounds.of(id) {
                Some(constant) => constant,
                None => bounds.range(id, node)?,
            };
            if range.largest() >= limits.largest {
                return None;
            }
            bounds.ranges[id.index()] = Some(range);
        }
        Some((bounds.thresholds, bounds.lengths))
    }
}

struct Bounds<'a> {
    graph: &'a Graph,
    limits: &'a Assumed,
    /// The error of a sine and a cosine.
    error: f64,
    /// Sizes that are asked whatever is found here.
    asked: Option<&'a AskedSizes>,
    /// Arcs of some inputs. Any other angle is possible.
    arcs: Option<Arcs<'a>>,
    /// True if a condition fails for certain.
    fails: bool,
    ranges: Vec<Option<Interval>>,
    thresholds: Thresholds,
    lengths: Map<Id, f64>,
}

impl Bounds<'_> {
    fn of(&self, id: Id) -> Option<Interval> {
        self.ranges[id.index()]
    }

    fn range(&mut self, id: Id, node: Node) -> Option<Interval> {
        let limits = self.limits;
        if let Some(range) = self.on_arc(node) {
            return Some(range);
        }
        Some(match node {
            Node::Constant(_) | Node::Low(_) => return None,
            Node::Input { order: 0 | 1, .. } => Interval::about(limits.input),
            Node::Input { .. } => Interval::about(limits.input * limits.input),
            Node::InputCos(_) | Node::InputSin(_) => Interval::about(1.0 + self.error).rounded(),
            // A parameter can be anything, and so can a load.
            Node::Param(_) | Node::Load(_) | Node::Drive(_) => return None,
            // Values that a search makes of the inputs are not followed.
            Node::Trial(_) | Node::Solved(..) => return None,
            Node::Mode(_) => Interval { low: -1.0, high: 1.0, away: 1.0 },
            Node::Neg(a) => self.of(a)?.negated(),
            Node::Add(a, b) => self.of(a)?.plus(self.of(b)?).rounded(),
            Node::Sub(a, b) => self.of(a)?.plus(self.of(b)?.negated()).rounded(),
            Node::Mul(a, b) => self.product(a, b)?.rounded(),
            Node::Fused(a, b, c) => self.product(a, b)?.rounded().plus(self.of(c)?).rounded(),
            Node::Det([a, b, c, d]) => {
                self.exact_product(a, b)?.plus(self.exact_product(c, d)?.negated()).rounded()
            }
            Node::Select([_, _, x, y]) => self.of(x)?.or(self.of(y)?),
            Node::Div(a, b) => self.quotient(a, b)?.rounded(),
            Node::Apply(Function::Sqrt, a) => self.of(a)?.root()?.rounded(),
            Node::Apply2(Function::Hypot, a, b) => {
                // The fast path asks for squares of full precision, or for a share of the largest.
                let high = self.of(a)?.largest() + self.of(b)?.largest();
                let least = limits.square.sqrt().max(limits.share * high).min(high);
                let least = self.asked.map_or(least, |(_, lengths)| lengths[&id]);
                self.lengths.insert(id, least);
                Interval::of(least, high).rounded()
            }
            Node::MulErr(a, b) => Interval::about(self.exact_product(a, b)?.largest() * SLACK),
            Node::AddErr(a, b) => Interval::about(self.of(a)?.plus(self.of(b)?).largest() * SLACK),
            Node::Apply(function, _) | Node::Apply2(function, ..) => {
                let mut is_bounded = true;
                node.for_operands(&mut |operand| is_bounded &= self.of(operand).is_some());
                let largest = function.largest().filter(|_| is_bounded)?;
                let error = if function.reduces_turns() { self.error } else { 0.0 };
                Interval::about(largest + error).rounded()
            }
            Node::Guard(value, guard) => self.guarded(value, self.graph.condition(guard))?,
        })
    }

    fn product(&self, a: Id, b: Id) -> Option<Interval> {
        let (x, y) = (self.of(a)?, self.of(b)?);
        Some(if unguarded(self.graph, a) == unguarded(self.graph, b) {
            x.squared()
        } else {
            x.times(y)
        })
    }

    /// The product where its rounding error is asked for: without fused operations the factors are
    /// split by a multiplication with up to 2²⁷ + 1 (f32: 2¹² + 1), which must not overflow.
    fn exact_product(&self, a: Id, b: Id) -> Option<Interval> {
        let room = |id| self.of(id).filter(|range| range.largest() < self.limits.factor);
        room(a).and(room(b)).and_then(|_| self.product(a, b))
    }

    /// √x/x is 1/√x: the quotient of the two ranges would be far too wide.
    fn quotient(&self, a: Id, b: Id) -> Option<Interval> {
        let (x, y) = (self.of(a)?, self.of(b)?);
        match self.graph.node(unguarded(self.graph, a)) {
            Node::Apply(Function::Sqrt, under)
                if unguarded(self.graph, under) == unguarded(self.graph, b) =>
            {
                y.root()?.reciprocal()
            }
            _ => Some(x.times(y.reciprocal()?)),
        }
    }

    /// The range that the fast path goes on with, once it has asked for the threshold.
    fn guarded(&mut self, value: Id, Guard { check, operands, .. }: &Guard) -> Option<Interval> {
        let range = self.of(value)?;
        let Some((comparison, least)) = check.row().comparison else { return Some(range) };
        let share = self.limits.share * range.largest();
        let least = match least {
            Least::Square => self.limits.square.max(share),
            Least::Normal => self.limits.normal.max(share),
            Least::Rounding => {
                let spread = operands.last().and_then(|&spread| self.graph.as_constant(spread));
                spread.map_or(share, |spread| self.limits.rounding_of(spread).max(share))
            }
            Least::Zero => share,
        };
        let id = unguarded(self.graph, value);
        let least = self.asked.and_then(|(asked, _)| asked[&id]).unwrap_or(least);
        let known = if comparison == Comparison::Away { range.away } else { range.low };
        // No threshold is below zero.
        let threshold = (known <= least).then_some(least);
        let asked = self.thresholds.or_insert(id, threshold);
        // Asked more than once, a value is asked for the most.
        *asked = match (*asked, threshold) {
            (Some(one), Some(other)) => Some(one.max(other)),
            (one, other) => one.or(other),
        };
        // A value that is above zero at no angle at all is the concern of what finds limits.
        let is_below = comparison != Comparison::Away && self.arcs.is_some();
        if (if is_below { range.high } else { range.largest() }) <= least {
            self.fails = true;
            return None;
        }
        Some(match (threshold, comparison) {
            (None, _) => range,
            (Some(least), Comparison::Away) => Interval { away: least, ..range },
            (Some(least), _) => Interval { low: least, away: least, ..range },
        })
    }
}

impl Interval {
    /// With the rounding of the operation that made it, which does not change a sign.
    fn rounded(self) -> Self {
        let slack = SLACK * self.largest() + TINY;
        let inward = |x: f64| (x * (1.0 - SLACK) - TINY).max(0.0);
        Self {
            low: if self.low >= 0.0 { inward(self.low) } else { self.low - slack },
            high: if self.high <= 0.0 { -inward(-self.high) } else { self.high + slack },
            away: inward(self.away),
        }
    }
}
