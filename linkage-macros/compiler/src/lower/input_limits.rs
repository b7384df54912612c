//! Tests of an entry point before its fast path's result may be used: a sum of results is finite, or, where
//! limits on the inputs keep a width from overflowing, the inputs are within these.

use super::routine::{Bound, Finite, Sum};
use crate::ir::graph::Node;

/// Within these limits no value overflows on the way.
#[derive(Clone, Debug)]
pub struct InputLimits {
    /// True for double and for single precision if the limits hold for that width.
    pub widths: [bool; 2],
    /// The largest magnitude of each of these inputs in either width.
    pub inputs: Vec<(Node, [f64; 2])>,
}

/// The angles for which sines are right without a look at more of π, in rad, in both widths: 2²⁰ and some
/// 8192 turns.
pub const NEAR: [f64; 2] = [1_048_576.0, 51_471.0];

/// The test of an entry point with these witnesses; none where nothing can be other than finite.
pub fn finite(
    witnesses: &[usize],
    limits: Option<InputLimits>,
    takes_cosine: bool,
) -> Option<Finite> {
    let sum = sum(witnesses)?;
    let instead = limits.map(|InputLimits { widths, inputs }| match takes_cosine {
        true if !inputs.is_empty() => (widths, vec![on_circle(&inputs)]),
        _ => (widths, within(&inputs)),
    });
    Some(Finite { sum, instead })
}

/// The sum as a balanced tree: it is short in time, and shallow for the compiler.
pub fn sum(values: &[usize]) -> Option<Sum> {
    match values {
        [] => None,
        [only] => Some(Sum::One(*only)),
        _ => {
            let (left, right) = values.split_at(values.len().div_ceil(2));
            Some(Sum::Of(Box::new([sum(left)?, sum(right)?])))
        }
    }
}

/// One comparison for an angle and its rates: (θ² + θ̇²)² + θ̈² up to the fourth power of a limit keeps angle
/// and rate within the limit and the acceleration within its square. In double precision it lies at 170 000
/// turns and as many a second.
pub fn on_circle(inputs: &[(Node, [f64; 2])]) -> Bound {
    let of_order = |wanted: u8| {
        let is_it = |node: &Node| matches!(node, Node::Input { order, .. } if *order == wanted);
        inputs.iter().map(|(node, _)| *node).find(is_it)
    };
    let mut least = NEAR;
    for (node, bounds) in inputs {
        let is_second = matches!(node, Node::Input { order: 2, .. });
        for (least, bound) in least.iter_mut().zip(bounds) {
            *least = least.min(if is_second { bound.sqrt() } else { *bound });
        }
    }
    let (rate, second) = (of_order(1), of_order(2));
    let power = if second.is_some() { 4 } else { 2 };
    Bound::OnCircle { rate, second, limit: least.map(|limit| limit.powi(power)) }
}

/// |value| ≤ limit for each of the inputs; a rate together with its acceleration, whose limit is the
/// square of the rate's.
pub fn within(inputs: &[(Node, [f64; 2])]) -> Vec<Bound> {
    let is_asked = |node| inputs.iter().any(|&(other, _)| other == node);
    let bound = |&(value, [wide, narrow]): &(Node, [f64; 2])| {
        let Node::Input { input, order } = value else { return None };
        let limit = [wide.min(f64::MAX), narrow.min(f32::MAX.into())];
        let [rate, second] = [1, 2].map(|order| Node::Input { input, order });
        match order {
            1 if is_asked(second) => None,
            2 if is_asked(rate) => Some(Bound::WithRate { rate, second, limit }),
            _ => Some(Bound::Within { value, limit }),
        }
    };
    inputs.iter().filter_map(bound).collect()
}
