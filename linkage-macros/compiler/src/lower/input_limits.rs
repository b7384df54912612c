//! Tests of an entry point before its fast path's result may be used: a sum of results is finite, or, where
//! limits on the inputs keep a width from overflowing, the inputs are within these.

use super::routine::{Bound, Finite, Sum};
use crate::ir::graph::Node;

/// Within these limits no value overflows on the way.
#[derive(Clone, Debug)]
pub(super) struct InputLimits {
    /// True for double and for single precision if the limits hold for that width.
    pub widths: [bool; 2],
    /// The largest magnitude of each of these inputs in either width.
    pub inputs: Vec<(Node, [f64; 2])>,
}

/// The angles for which sines are right without a look at more of π, in rad, in both widths: 2²⁰ and some
/// 8192 turns.
const NEAR: [f64; 2] = [1_048_576.0, 51_471.0];

/// The test of an entry point with these witnesses; none where nothing can be other than finite.
pub(super) fn finite(
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
fn sum(values: &[usize]) -> Option<Sum> {
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
fn on_circle(inputs: &[(Node, [f64; 2])]) -> Bound {
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
fn within(inputs: &[(Node, [f64; 2])]) -> Vec<Bound> {
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

#[cfg(test)]
mod tests {
    use super::*;

    const RATE: Node = Node::Input { input: 0, order: 1 };
    const SECOND: Node = Node::Input { input: 0, order: 2 };

    /// Bounds on these inputs, under limits of 10 in double and 100 in single precision.
    fn bounds(inputs: &[Node], takes_cosine: bool) -> Vec<Bound> {
        let inputs = inputs.iter().map(|&node| match node {
            SECOND => (node, [100.0, 1e4]),
            _ => (node, [10.0, 100.0]),
        });
        let limits = InputLimits { widths: [true; 2], inputs: inputs.collect() };
        let finite = finite(&[0], Some(limits), takes_cosine).expect("there is a witness");
        finite.instead.expect("there are limits").1
    }

    #[test]
    fn a_rate_is_asked_once_with_its_second_rate() {
        let both = Bound::WithRate { rate: RATE, second: SECOND, limit: [100.0, 1e4] };
        assert_eq!(bounds(&[RATE, SECOND], false), [both]);
        let within = |value, limit| Bound::Within { value, limit };
        assert_eq!(bounds(&[SECOND], false), [within(SECOND, [100.0, 1e4])]);
        assert_eq!(bounds(&[RATE], false), [within(RATE, [10.0, 100.0])]);
        let other = Node::Input { input: 1, order: 2 };
        let apart = [within(RATE, [10.0, 100.0]), within(other, [10.0, 100.0])];
        assert_eq!(bounds(&[RATE, other], false), apart);
        // Infinity is within no limit.
        let beyond = [(RATE, [f64::INFINITY; 2])];
        assert_eq!(super::within(&beyond), [within(RATE, [f64::MAX, f32::MAX.into()])]);
    }

    #[test]
    fn an_angle_is_asked_together_with_its_rates() {
        let on_circle = |rate, second, limit| [Bound::OnCircle { rate, second, limit }];
        let both = on_circle(Some(RATE), Some(SECOND), [1e4, 1e8]);
        assert_eq!(bounds(&[RATE, SECOND], true), both);
        assert_eq!(bounds(&[RATE], true), on_circle(Some(RATE), None, [100.0, 1e4]));
        assert_eq!(bounds(&[SECOND], true), on_circle(None, Some(SECOND), [1e4, 1e8]));
        assert_eq!(bounds(&[], true), [], "the angle's own test is enough");
        // Wide limits give way to the sine's own.
        let wide = [(RATE, [f64::MAX; 2])];
        let limit = NEAR.map(|near| near * near);
        assert_eq!(
            super::on_circle(&wide),
            Bound::OnCircle { rate: Some(RATE), second: None, limit }
        );
    }

    #[test]
    fn angles_are_near_as_far_as_at_run_time() {
        use linkage_core::Scalar;
        let [wide, narrow] = NEAR;
        assert!(wide.is_near() && !wide.next_up().is_near());
        let narrow = narrow as f32;
        assert!(narrow.is_near() && !narrow.next_up().is_near());
    }

    #[test]
    fn a_sum_is_as_shallow_as_can_be() {
        fn depth(sum: &Sum) -> usize {
            match sum {
                Sum::One(_) => 0,
                Sum::Of(parts) => 1 + parts.iter().map(depth).max().unwrap_or(0),
            }
        }
        let values: Vec<usize> = (0..33).collect();
        assert_eq!(sum(&values).as_ref().map(depth), Some(6));
        assert_eq!(sum(&values[..32]).as_ref().map(depth), Some(5));
        assert!(finite(&[], None, false).is_none());
    }
}
