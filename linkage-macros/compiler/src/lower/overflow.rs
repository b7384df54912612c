//! Tests by which the fast path knows that its results are finite.
//!
//! A test of the results is always right, but late: all of them have to be kept until the last is
//! there. Where limits on the inputs and on the divisors keep every value from overflowing, the fast
//! path tests these instead, which are known early. This file decides between the two for each width.
//! A number that carries derivatives tests its results in any case, because a derivative may overflow
//! where the value does not.
//!
//! This saves a fifth of a solver's instructions: `examples/laboratory/README.md` says how
//! that was counted.

use super::input_limits::InputLimits;
use super::ranges::{Assumed, Thresholds, Values};
use super::routine::Threshold;
use super::witnesses::witnesses;
use crate::exact::Exact;
use crate::function::Function;
use crate::ir::check::Least;
use crate::ir::graph::{Graph, Id, Node, Path};
use crate::ir::hash::Map;
use crate::ir::liveness::live_nodes;

/// Limits on inputs and divisors that the fast path tests in place of its results.
pub struct Overflow {
    pub wide: Option<WidthLimits>,
    pub narrow: Option<WidthLimits>,
}

/// Size whose rounding may have moved a value across its limit.
#[derive(Clone, Copy)]
pub enum Spread<'g> {
    Known(&'g Exact),
    AtRunTime(Id),
}

/// Limits for one width.
pub struct WidthLimits {
    pub thresholds: Thresholds,
    /// The least lengths of hypotenuses.
    pub lengths: Map<Id, f64>,
    /// On inputs and rates; on accelerations its square.
    pub input: f64,
}

/// From what asks least to what asks most. A pose beyond the limits is not lost: the slow path
/// finds what there is to find.
pub const WIDE: [Assumed; 3] = [wide(1e60, 0.0), wide(1e60, 1e-30), wide(1e20, 1e-30)];
pub const NARROW: [Assumed; 4] =
    [narrow(1e6, 0.0), narrow(1e6, 1e-7), narrow(65_536.0, 1e-6), narrow(8192.0, 1e-5)];

/// Squares of full precision begin at the smallest normal number over ε².
const fn wide(input: f64, share: f64) -> Assumed {
    let (normal, epsilon) = (f64::MIN_POSITIVE, f64::EPSILON);
    Assumed { input, share, square: 4.6e-277, normal, epsilon, largest: 1e300, factor: 1e297 }
}

const fn narrow(input: f64, share: f64) -> Assumed {
    let (normal, epsilon) = (f32::MIN_POSITIVE as f64, f32::EPSILON as f64);
    Assumed { input, share, square: 8.4e-25, normal, epsilon, largest: 1e37, factor: 1e34 }
}

/// Largest least value of a divisor or a radicand. S of two bars is at most a quarter, and squares of
/// distances are some square metres. Where a length may be 10²⁰ m as an input, a share of the largest
/// square exceeds the square of any pose, and every pose would take the slow path.
const LARGEST_ASKED: f64 = 1e-3;

impl Overflow {
    /// Limits that keep every value on the way to the sinks from overflowing, given what the fast path
    /// computes for these; none if there are none, or if they take no fewer tests than the results.
    pub(super) fn of(graph: &Graph, sinks: &[Id], live: &[bool]) -> Option<Self> {
        let asked = asked(graph, sinks, live).len();
        if asked > 0 && asked >= witnesses(graph, sinks).len() {
            return None;
        }
        let values = Values::new(graph, live);
        let first = |ladder: &[Assumed], is_of_use: &dyn Fn(Id) -> bool| {
            let width = |assumed: &Assumed| {
                let mut sizes = values.thresholds(assumed)?;
                let is_small = |&least: &f64| least <= LARGEST_ASKED;
                let (thresholds, lengths) = &sizes;
                let is_met =
                    thresholds.values().flatten().all(is_small) && lengths.values().all(is_small);
                if !is_met {
                    return None;
                }
                values.leave_out_those_of_every_arc(assumed, &mut sizes, is_of_use);
                let (thresholds, lengths) = sizes;
                Some(WidthLimits { thresholds, lengths, input: assumed.input })
            };
            ladder.iter().find_map(width)
        };
        // A check that single precision needs stays.
        let narrow = first(&NARROW, &|_| true);
        let is_left_out = |id: Id| {
            narrow.as_ref().is_some_and(|narrow| matches!(narrow.thresholds.get(&id), Some(None)))
        };
        let wide = first(&WIDE, &is_left_out);
        (wide.is_some() || narrow.is_some()).then_some(Self { wide, narrow })
    }

    /// The least that the condition on a value is to find there; nothing where ranges show that it
    /// holds, or where a spread that is known at run time asks for more.
    pub fn threshold(
        &self,
        value: Id,
        least: Least,
        spread: Option<Spread<'_>>,
    ) -> Option<Threshold> {
        let sign = |assumed: Assumed| match (least, spread) {
            (Least::Square, _) => assumed.square,
            (Least::Normal, _) => assumed.normal,
            (_, Some(Spread::Known(spread))) => assumed.rounding_of(spread),
            _ => 0.0,
        };
        let of = |width: &Option<WidthLimits>, assumed: Assumed| match width {
            Some(width) => width.thresholds.get(&value).copied().unwrap_or(Some(sign(assumed))),
            None => Some(sign(assumed)),
        };
        let (wide, narrow) = (of(&self.wide, WIDE[0]), of(&self.narrow, NARROW[0]));
        let asked = wide.or(narrow)?;
        // A value above its rounding is above zero.
        let is_sign_alone = asked + narrow.unwrap_or(0.0) == 0.0;
        if matches!(spread, Some(Spread::AtRunTime(_))) && is_sign_alone {
            return None;
        }
        Some(Threshold::Number(wide.unwrap_or(0.0), narrow.unwrap_or(0.0)))
    }

    /// The least square of a hypotenuse.
    pub(super) fn least_square(&self, hypotenuse: Id) -> Threshold {
        let of = |width: &Option<WidthLimits>, assumed: Assumed| {
            let least = width.as_ref().and_then(|width| width.lengths.get(&hypotenuse));
            least.map_or(assumed.square, |least| (least * least).max(assumed.square))
        };
        Threshold::Number(of(&self.wide, WIDE[0]), of(&self.narrow, NARROW[0]))
    }

    /// The limits on the inputs that lead to some of the sinks.
    pub(super) fn limits(&self, graph: &Graph, sinks: &[Id], live: &[bool]) -> InputLimits {
        let input =
            |width: &Option<WidthLimits>, largest| width.as_ref().map_or(largest, |w| w.input);
        let first = [input(&self.wide, f64::MAX), input(&self.narrow, f64::from(f32::MAX))];
        let limit = |node| match node {
            Node::Input { order: 2, .. } => (node, first.map(|bound| bound * bound)),
            _ => (node, first),
        };
        InputLimits {
            widths: [self.wide.is_some(), self.narrow.is_some()],
            inputs: asked(graph, sinks, live).into_iter().map(limit).collect(),
        }
    }
}

/// The inputs and rates that limits are asked of: those that not only sines and cosines read.
fn asked(graph: &Graph, sinks: &[Id], live: &[bool]) -> Vec<Node> {
    let mut only_turned = vec![true; graph.len()];
    sinks.iter().for_each(|sink| only_turned[sink.index()] = false);
    for (_, node) in live_nodes(graph, live) {
        if !matches!(node, Node::Apply(Function::Sin | Function::Cos, _)) {
            let mut reads = |operand: Id| only_turned[operand.index()] = false;
            graph.for_operands(node, Path::Unchecked, &mut reads);
        }
    }
    live_nodes(graph, live)
        .filter(|&(id, node)| matches!(node, Node::Input { .. }) && !only_turned[id.index()])
        .map(|(_, node)| node)
        .collect()
}
