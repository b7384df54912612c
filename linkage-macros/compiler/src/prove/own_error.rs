//! A node's own error: at most so much is what a node computes away from the same function of what its operands are
//! computed to.
//!
//! | node | error |
//! |---|---|
//! | sum, difference | half a last place, and never more than an operand; none within a factor of two (Sterbenz) |
//! | product, quotient, root | half a last place; of a product by a power of two what underflow takes |
//! | fused operation | that of its two parts, which is above that of one |
//! | a·b − c·d | 1.5 last places (Jeannerod, Louvet and Muller 2013), and underflow of its products |
//! | functions | what the run-time's kernels promise, or the target's in their place |
//! | the rounding of a product or a sum | minus the error of that operation |
//! | constants, decimals | known, with their sign |
//!
//! A node that depends on a rate whose bounds are wanted as multiples of it errs by u |v| in place of half a last place, so
//! that the bounds are multiples, too, and by what underflow takes.

use super::goal::Goal;
use super::outward::{OutwardInterval, above};
use super::premises::Leaf;
use super::sloped::SlopedValue;
use crate::function::Function;
use crate::ir::graph::{Id, Node};

/// The smallest numbers that the difference of two products loses where these underflow.
const DET_UNDERFLOWS: f64 = 8.0;

/// See the module's documentation. The value is that before the error, in one column.
pub(super) fn own_error(
    subject: &Goal<'_>,
    values: &[SlopedValue],
    place: usize,
    column: usize,
    value: OutwardInterval,
) -> f64 {
    let node = subject.nodes[place].1;
    let of = |id: Id| values[subject.place(id)].columns[column];
    let width = subject.width;
    let scales = subject.scales[place];
    let half = |size: f64| match scales {
        true => above(width.relative() * size),
        false => width.half_last_place(size),
    };
    // Half a last place has it.
    let underflow = if scales { width.underflow() } else { 0.0 };
    let size = value.magnitude();
    match node {
        Node::Constant(_)
        | Node::Low(_)
        | Node::Input { .. }
        | Node::Param(_)
        | Node::Load(_)
        | Node::Drive(_)
        | Node::Mode(_)
        | Node::Neg(_)
        | Node::Guard(..)
        | Node::Select(_)
        | Node::Solved(..)
        | Node::Trial(_) => 0.0,
        Node::InputCos(_) | Node::InputSin(_) => {
            promised(subject, Function::Sin, size, largest_angle(subject, node))
        }
        Node::Add(a, b) => half(size).min(of_sum(of(a), of(b))),
        Node::Sub(a, b) => half(size).min(of_sum(of(a), of(b).neg())),
        Node::Mul(a, b) if is_scaling(subject, a) || is_scaling(subject, b) => width.underflow(),
        Node::Mul(..) => half(size) + underflow,
        Node::Div(_, b) if is_scaling(subject, b) => width.underflow(),
        Node::Div(..) => half(size) + underflow,
        Node::Fused(a, b, _) => {
            let product = if a == b { of(a).square() } else { of(a).mul(of(b)) };
            let first = match is_scaling(subject, a) || is_scaling(subject, b) {
                true => width.underflow(),
                false => half(product.magnitude()) + underflow,
            };
            above(first + half(above(size + first))) + underflow
        }
        Node::Det(_) => above(3.0 * half(size) + DET_UNDERFLOWS * width.smallest()),
        Node::MulErr(a, b) => half(of(a).mul(of(b)).magnitude()) + width.smallest(),
        Node::AddErr(a, b) => half(of(a).add(of(b)).magnitude()).min(of_sum(of(a), of(b))),
        Node::Apply(function, a) => promised(subject, function, size, of(a).magnitude()),
        Node::Apply2(function, a, b) => {
            promised(subject, function, size, of(a).magnitude().max(of(b).magnitude()))
        }
    }
}

/// The largest angle whose cosine or sine is given.
fn largest_angle(subject: &Goal<'_>, node: Node) -> f64 {
    match subject.leaf(node) {
        Some(Leaf::Ranged(input)) => {
            let [from, to] = subject.given.ranges[*input];
            from.abs().max(to.abs())
        }
        _ => subject.width.largest_angle(),
    }
}

/// The error beside its twin's: the error of a product is a number unless it underflows.
pub(super) fn beside_twin(subject: &Goal<'_>, place: usize) -> f64 {
    match subject.nodes[place].1 {
        Node::MulErr(..) => subject.width.smallest(),
        _ => 0.0,
    }
}

/// The error of a sum is no larger than either operand, and nothing where the signs differ and neither is twice the
/// other.
fn of_sum(a: OutwardInterval, b: OutwardInterval) -> f64 {
    let cancels = |a: OutwardInterval, b: OutwardInterval| {
        a.low > 0.0 && b.low > 0.0 && 2.0 * b.low >= a.high && 2.0 * a.low >= b.high
    };
    if cancels(a, b.neg()) || cancels(a.neg(), b) {
        return 0.0;
    }
    a.magnitude().min(b.magnitude())
}

/// A kernel's promise, in last places of the largest value; that of the target's function where there is one.
fn promised(subject: &Goal<'_>, function: Function, size: f64, argument: f64) -> f64 {
    let hooks = &subject.given.hooks;
    if let (Some(error), true) = (hooks.sine, function.reduces_turns()) {
        return error;
    }
    let Some((mut last_places, beside)) = subject.width.promised(function, argument) else {
        return f64::INFINITY;
    };
    if let (Some(root), true) = (hooks.root, function.takes_a_root()) {
        // That of the run-time is rounded once, to half a last place.
        last_places += (root - 0.5).max(0.0);
    }
    above(2.0 * last_places * subject.width.half_last_place(size)) + beside
}

/// True for a power of two, by which a product is exact unless it underflows.
fn is_scaling(subject: &Goal<'_>, id: Id) -> bool {
    let Some(value) = subject.graph.as_constant(id) else { return false };
    let value = value.to_f64();
    let is_exact = subject.known(subject.place(id)).is_some_and(|known| known.error.is_zero());
    is_exact && value.is_normal() && value.to_bits() << 12 == 0
}
