//! Tests of `lower/input_limits`.

use crate::ir::graph::Node;
use crate::lower::routine::{Bound, Sum};
pub(crate) use linkage_compiler::lower::input_limits::*;

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
    assert_eq!(
        crate::lower::input_limits::within(&beyond),
        [within(RATE, [f64::MAX, f32::MAX.into()])]
    );
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
        crate::lower::input_limits::on_circle(&wide),
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
