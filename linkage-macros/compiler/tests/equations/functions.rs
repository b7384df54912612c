//! Tests of `equations/functions`.

use crate::equations::jet::Jet;
use crate::equations::symbol::GraphBuilder;
use crate::function::Function;
use crate::ir::graph::Node;
use crate::ir::interpret::{ProgramValues, interpret};
use crate::ir::program::Program;

/// The values of abs a, sign a, min and max of a and b, in double precision.
fn corners(a: f64, b: f64) -> [f64; 4] {
    let builder = GraphBuilder::new(&[]);
    let [x, y] = [0, 1].map(|param| Jet::constant(builder.node(Node::Param(param))));
    let ids = [
        Jet::of(Function::Abs, &[x]),
        Jet::of(Function::Sign, &[x]),
        Jet::of(Function::Min, &[x, y]),
        Jet::of(Function::Max, &[x, y]),
    ]
    .map(|jet| jet.value.id);
    let program = Program { graph: builder.into_graph(), ..Program::of_zeros([].into_iter()) };
    let (inputs, loads, drives) = (Vec::new(), Vec::new(), Vec::new());
    let given = ProgramValues { inputs, params: vec![a, b], loads, drives, unit: None };
    let values = interpret(&program, &given);
    ids.map(|id| values[id.index()])
}

#[test]
fn corners_choose_the_value_and_hide_none() {
    assert_eq!(corners(-2.0, 3.0), [2.0, -1.0, -2.0, 3.0]);
    assert_eq!(corners(3.0, -2.0), [3.0, 1.0, -2.0, 3.0]);
    assert_eq!(corners(0.0, 0.0), [0.0; 4]);
    assert!(corners(f64::NAN, 1.0).iter().all(|value| value.is_nan()));
    assert!(corners(1.0, f64::NAN)[2..].iter().all(|value| value.is_nan()));
}
