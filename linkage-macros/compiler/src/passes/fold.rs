//! Folds operations on constants, exactly: the generated code rounds the result once.

use crate::exact::Exact;
use crate::ir::construct::Maker;
use crate::ir::graph::{Graph, Id, Node};

/// The constant that the operation makes, if all its operands are constants.
pub fn fold_constants(maker: &mut Maker<'_>, node: Node) -> Option<Id> {
    if let Node::Guard(value, guard) = node {
        let check = &maker.graph.condition(guard).check;
        return (check.row().holds)(maker.graph.as_constant(value)?).then_some(value);
    }
    // A value that is too long is left to run time: it would grow without bounds along a chain of groups of
    // constants.
    let value = evaluate(maker.graph, node).filter(|value| !value.is_too_long_for_formulas())?;
    Some(maker.constant(value))
}

fn evaluate(graph: &Graph, node: Node) -> Option<Exact> {
    let value = |id: Id| graph.as_constant(id);
    match node {
        Node::Neg(a) => Some(value(a)?.neg()),
        Node::Add(a, b) => Some(value(a)?.add(value(b)?)),
        Node::Sub(a, b) => Some(value(a)?.sub(value(b)?)),
        Node::Mul(a, b) => Some(value(a)?.mul(value(b)?)),
        Node::Div(a, b) => value(a)?.div(value(b)?),
        Node::Apply(function, a) => Exact::of(function, &[value(a)?]),
        Node::Apply2(function, a, b) => Exact::of(function, &[value(a)?, value(b)?]),
        Node::Det([a, b, c, d]) => Some(value(a)?.mul(value(b)?).sub(&value(c)?.mul(value(d)?))),
        // The product or sum of two constants is itself a constant without error.
        Node::MulErr(a, b) | Node::AddErr(a, b) => {
            value(a)?;
            value(b)?;
            Some(Exact::integer(0))
        }
        Node::Fused(a, b, c) => Some(value(a)?.mul(value(b)?).add(value(c)?)),
        Node::Select([a, b, x, y]) => {
            Some(if value(a)?.cmp_value(value(b)?).is_ge() { value(x)? } else { value(y)? }.clone())
        }
        Node::Low(constant) => {
            let value = graph.value(constant);
            (value.low_f64() == 0.0 && value.low_f32() == 0.0).then(|| Exact::integer(0))
        }
        Node::Constant(_)
        | Node::Input { .. }
        | Node::InputCos(_)
        | Node::InputSin(_)
        | Node::Param(_)
        | Node::Load(_)
        | Node::Drive(_)
        | Node::Mode(_)
        | Node::Guard(..)
        | Node::Trial(_)
        | Node::Solved(..) => None,
    }
}
