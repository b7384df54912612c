//! Removes what an exact rule of arithmetic makes superfluous, and brings signs and the order of
//! operands into one form, so that equal values become equal nodes.

use std::cmp::Ordering;

use crate::exact::Exact;
use crate::function::Function;
use crate::ir::construct::Maker;
use crate::ir::graph::{Id, Node, OperandForm};

/// Simpler equivalent of the node, if there is one.
pub fn simplify(maker: &mut Maker<'_>, node: Node) -> Option<Id> {
    match node {
        Node::Neg(a) => negation(maker, a),
        Node::Add(a, b) => sum(maker, a, b),
        Node::Sub(a, b) => difference(maker, a, b),
        Node::Mul(a, b) => product(maker, a, b),
        Node::Div(a, b) => quotient(maker, a, b),
        Node::Det(operands) => determinant(maker, operands),
        Node::MulErr(a, b) => product_error(maker, a, b),
        Node::AddErr(a, b) => sum_error(maker, a, b),
        Node::Select([_, _, x, y]) if x == y => Some(x),
        Node::Apply2(Function::Hypot, a, b) if is_zero(maker, b) => absolute(maker, a),
        Node::Fused(a, b, c) if is_zero(maker, a) || is_zero(maker, b) => Some(c),
        Node::Fused(a, b, c) if is_zero(maker, c) => Some(maker.make(Node::Mul(a, b))),
        _ => None,
    }
}

fn is_zero(maker: &Maker<'_>, id: Id) -> bool {
    maker.graph.is_zero(id)
}

/// Operand of a negation; none for any other node.
fn negated(maker: &Maker<'_>, id: Id) -> Option<Id> {
    match maker.graph.node(id) {
        Node::Neg(a) => Some(a),
        _ => None,
    }
}

fn zero(maker: &mut Maker<'_>) -> Id {
    maker.constant(Exact::integer(0))
}

fn negate(maker: &mut Maker<'_>, id: Id) -> Id {
    maker.make(Node::Neg(id))
}

/// −(−a) = a. Signs of differences and products stay outside, where a later sum or product takes
/// them up: the value itself is then shared with whoever needs it without the sign.
fn negation(maker: &mut Maker<'_>, a: Id) -> Option<Id> {
    negated(maker, a)
}

fn sum(maker: &mut Maker<'_>, a: Id, b: Id) -> Option<Id> {
    match [maker.graph.form(a), maker.graph.form(b)] {
        [OperandForm::Zero, _] => Some(b),
        [_, OperandForm::Zero] => Some(a),
        [_, OperandForm::Negative(b)] => Some(maker.make(Node::Sub(a, b))),
        [OperandForm::Negative(a), _] => Some(maker.make(Node::Sub(b, a))),
        forms => {
            constant_sum(maker, a, b, forms).or_else(|| ordered(maker, a, b, forms, Node::Add))
        }
    }
}

/// c₁ + (c₂ + x) = (c₁ + c₂) + x: one rounding less.
fn constant_sum(maker: &mut Maker<'_>, a: Id, b: Id, forms: [OperandForm; 2]) -> Option<Id> {
    let (constant, other) = constant_first(a, b, forms)?;
    let outer = maker.graph.as_constant(constant)?.clone();
    let Node::Add(x, y) = maker.graph.node(other) else { return None };
    let inner = maker.graph.as_constant(x)?;
    let folded = outer.add(inner);
    let folded = maker.constant(folded);
    Some(maker.make(Node::Add(folded, y)))
}

fn constant_first(a: Id, b: Id, [first, second]: [OperandForm; 2]) -> Option<(Id, Id)> {
    match (first.is_constant(), second.is_constant()) {
        (true, _) => Some((a, b)),
        (false, true) => Some((b, a)),
        (false, false) => None,
    }
}

/// Constants first, then the earlier operand: equal sums and products become equal nodes.
fn ordered(
    maker: &mut Maker<'_>,
    a: Id,
    b: Id,
    [first, second]: [OperandForm; 2],
    node: fn(Id, Id) -> Node,
) -> Option<Id> {
    let is_behind = match (first.is_constant(), second.is_constant()) {
        (true, false) => false,
        (false, true) => true,
        _ => b < a,
    };
    if is_behind { Some(maker.make(node(b, a))) } else { None }
}

fn difference(maker: &mut Maker<'_>, a: Id, b: Id) -> Option<Id> {
    if a == b {
        return Some(zero(maker));
    }
    match [maker.graph.form(a), maker.graph.form(b)] {
        [_, OperandForm::Zero] => return Some(a),
        [OperandForm::Zero, _] => return Some(negate(maker, b)),
        [_, OperandForm::Negative(b)] => return Some(maker.make(Node::Add(a, b))),
        [OperandForm::Negative(a), _] => {
            let sum = maker.make(Node::Add(a, b));
            return Some(negate(maker, sum));
        }
        _ => {}
    }
    // a − b = −(b − a), where somebody has made the latter.
    let mirrored = maker.graph.find(Node::Sub(b, a))?;
    Some(negate(maker, mirrored))
}

fn product(maker: &mut Maker<'_>, a: Id, b: Id) -> Option<Id> {
    let forms = [maker.graph.form(a), maker.graph.form(b)];
    match forms {
        [OperandForm::Zero, _] | [_, OperandForm::Zero] => return Some(zero(maker)),
        [OperandForm::One, _] => return Some(b),
        [_, OperandForm::One] => return Some(a),
        _ => {}
    }
    if let Some((constant, other)) = constant_first(a, b, forms) {
        let factor = maker.graph.as_constant(constant)?.clone();
        if let Some(folded) = constant_product(maker, &factor, other) {
            return Some(folded);
        }
    }
    match forms {
        [OperandForm::Negative(a), _] => {
            let product = maker.make(Node::Mul(a, b));
            return Some(negate(maker, product));
        }
        [_, OperandForm::Negative(b)] => {
            let product = maker.make(Node::Mul(a, b));
            return Some(negate(maker, product));
        }
        _ => {}
    }
    if a == b && matches!(maker.graph.node(a), Node::Mode(_)) {
        return Some(maker.constant(Exact::integer(1)));
    }
    ordered(maker, a, b, forms, Node::Mul)
}

/// c₁·(c₂·x) = (c₁ c₂)·x, no rounding more and often one less; (−c)·x = −(c·x), so that a
/// product and its negative are one operation.
fn constant_product(maker: &mut Maker<'_>, factor: &Exact, other: Id) -> Option<Id> {
    if factor.signum() == Ordering::Less {
        let positive = maker.constant(factor.neg());
        let product = maker.make(Node::Mul(positive, other));
        return Some(negate(maker, product));
    }
    let Node::Mul(x, y) = maker.graph.node(other) else { return None };
    let folded = factor.mul(maker.graph.as_constant(x)?);
    let folded = maker.constant(folded);
    Some(maker.make(Node::Mul(folded, y)))
}

fn quotient(maker: &mut Maker<'_>, a: Id, b: Id) -> Option<Id> {
    if is_zero(maker, a) && !is_zero(maker, b) {
        return Some(zero(maker));
    }
    if let OperandForm::One = maker.graph.form(b) {
        return Some(a);
    }
    if let Some(a) = negated(maker, a) {
        let quotient = maker.make(Node::Div(a, b));
        return Some(negate(maker, quotient));
    }
    if let Some(b) = negated(maker, b) {
        let quotient = maker.make(Node::Div(a, b));
        return Some(negate(maker, quotient));
    }
    // A mode is ±1: dividing by it is multiplying by it.
    matches!(maker.graph.node(b), Node::Mode(_)).then(|| maker.make(Node::Mul(a, b)))
}

/// A difference of products with one product gone is the other product.
fn determinant(maker: &mut Maker<'_>, [a, b, c, d]: [Id; 4]) -> Option<Id> {
    let trivial = |maker: &Maker<'_>, id: Id| maker.graph.is_one_or_minus_one(id);
    if is_zero(maker, c) || is_zero(maker, d) {
        return Some(maker.make(Node::Mul(a, b)));
    }
    if is_zero(maker, a) || is_zero(maker, b) {
        let product = maker.make(Node::Mul(c, d));
        return Some(negate(maker, product));
    }
    let first = trivial(maker, a) || trivial(maker, b);
    let second = trivial(maker, c) || trivial(maker, d);
    if first && second {
        let (left, right) = (maker.make(Node::Mul(a, b)), maker.make(Node::Mul(c, d)));
        return Some(maker.make(Node::Sub(left, right)));
    }
    None
}

/// A product with 0 or ±1 has no error; the error has the product's sign.
fn product_error(maker: &mut Maker<'_>, a: Id, b: Id) -> Option<Id> {
    let exact = |id: Id| maker.graph.is_zero(id) || maker.graph.is_one_or_minus_one(id);
    if exact(a) || exact(b) {
        return Some(zero(maker));
    }
    if let Some(inner) = negated(maker, a) {
        let error = maker.make(Node::MulErr(inner, b));
        return Some(negate(maker, error));
    }
    if let Some(inner) = negated(maker, b) {
        let error = maker.make(Node::MulErr(a, inner));
        return Some(negate(maker, error));
    }
    let forms = [maker.graph.form(a), maker.graph.form(b)];
    ordered(maker, a, b, forms, Node::MulErr)
}

fn sum_error(maker: &mut Maker<'_>, a: Id, b: Id) -> Option<Id> {
    if is_zero(maker, a) || is_zero(maker, b) || negated(maker, a) == Some(b) {
        return Some(zero(maker));
    }
    if negated(maker, b) == Some(a) {
        return Some(zero(maker));
    }
    let forms = [maker.graph.form(a), maker.graph.form(b)];
    ordered(maker, a, b, forms, Node::AddErr)
}

/// |x| of a root or of an absolute value is the value itself.
fn absolute(maker: &mut Maker<'_>, a: Id) -> Option<Id> {
    match maker.graph.node(a) {
        Node::Apply(Function::Sqrt, _) | Node::Apply2(Function::Hypot, ..) => Some(a),
        Node::Neg(inner) => {
            let zero = zero(maker);
            Some(maker.make(Node::Apply2(Function::Hypot, inner, zero)))
        }
        _ => None,
    }
}
