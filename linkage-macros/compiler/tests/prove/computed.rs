//! A subject's nodes as the generated code computes them, in either width, fused or not.

use crate::exact::Exact;
use crate::function::Function;
use crate::ir::graph::{Id, Node};
use crate::prove::goal::Goal;
use crate::prove::premises::Leaf;
use linkage_core::Scalar;

/// A number of the generated code.
pub(crate) trait Float: Scalar {
    fn wide(self) -> f64;
    fn of(value: f64) -> Self;
    fn fused_once(self, b: Self, c: Self) -> Self;
    fn is_at_least(self, other: Self) -> bool;
    /// Sine and cosine by the standard library.
    fn library_sin_cos(self) -> (Self, Self);
    fn epsilon() -> f64;
}

macro_rules! float {
    ($type:ty) => {
        impl Float for $type {
            fn wide(self) -> f64 {
                self.into()
            }
            fn of(value: f64) -> Self {
                value as Self
            }
            fn fused_once(self, b: Self, c: Self) -> Self {
                self.mul_add(b, c)
            }
            fn is_at_least(self, other: Self) -> bool {
                self >= other
            }
            fn library_sin_cos(self) -> (Self, Self) {
                <$type>::sin_cos(self)
            }
            fn epsilon() -> f64 {
                <$type>::EPSILON.into()
            }
        }
    };
}
float!(f32);
float!(f64);

/// The value of every node of a subject for a pose, and one node's value changed by so much.
pub(crate) fn computed<T: Float>(
    subject: &Goal<'_>,
    pose: &[f64],
    is_fused: bool,
    changed: Option<(usize, f64)>,
) -> Vec<T> {
    let mut values: Vec<T> = Vec::with_capacity(subject.nodes.len());
    for place in 0..subject.nodes.len() {
        let mut value = of_node(subject, &values, subject.nodes[place].1, pose, is_fused);
        if let Some((_, by)) = changed.filter(|(which, _)| *which == place) {
            value = T::of(value.wide() + by);
        }
        values.push(value);
    }
    values
}

fn rounded<T: Float>(value: &Exact) -> T {
    T::lit(value.to_f64(), value.to_f32())
}

fn leaf<T: Float>(subject: &Goal<'_>, node: Node, pose: &[f64]) -> T {
    match subject.leaf(node).expect("a leaf") {
        Leaf::Ranged(input) => T::of(pose[*input]),
        Leaf::Within(interval) => T::of(interval.low),
        Leaf::Decimal(value) => rounded(value),
    }
}

pub(super) fn of_node<T: Float>(
    subject: &Goal<'_>,
    values: &[T],
    node: Node,
    pose: &[f64],
    is_fused: bool,
) -> T {
    let v = |id: Id| values[subject.place(id)];
    match node {
        Node::Constant(constant) => rounded(subject.graph.value(constant)),
        Node::Low(constant) => {
            let value = subject.graph.value(constant);
            T::lit(value.low_f64(), value.low_f32())
        }
        Node::InputCos(_) => leaf::<T>(subject, node, pose).sin_cos().1,
        Node::InputSin(_) => leaf::<T>(subject, node, pose).sin_cos().0,
        Node::Input { .. } | Node::Param(_) | Node::Load(_) | Node::Drive(_) | Node::Mode(_) => {
            leaf(subject, node, pose)
        }
        Node::Neg(a) => -v(a),
        Node::Add(a, b) => v(a) + v(b),
        Node::Sub(a, b) => v(a) - v(b),
        Node::Mul(a, b) => v(a) * v(b),
        Node::Div(a, b) => v(a) / v(b),
        Node::Fused(a, b, c) if is_fused => v(a).fused_once(v(b), v(c)),
        Node::Fused(a, b, c) => v(a) * v(b) + v(c),
        Node::Det([a, b, c, d]) if is_fused => {
            let second = v(c) * v(d);
            v(a).fused_once(v(b), -second) - v(c).fused_once(v(d), -second)
        }
        Node::Det([a, b, c, d]) => T::det(v(a), v(b), v(c), v(d)),
        Node::MulErr(a, b) => T::mul_err(v(a), v(b)),
        Node::AddErr(a, b) => T::add_err(v(a), v(b)),
        Node::Select([a, b, x, y]) => {
            if v(a).is_at_least(v(b)) {
                v(x)
            } else {
                v(y)
            }
        }
        Node::Apply(function, a) => applied(function, v(a), v(a)),
        Node::Apply2(function, a, b) => applied(function, v(a), v(b)),
        Node::Guard(a, _) => v(a),
        Node::Trial(_) | Node::Solved(..) => unreachable!("machines of these tests search nothing"),
    }
}

pub(super) fn applied<T: Float>(function: Function, a: T, b: T) -> T {
    match function {
        Function::Sqrt => a.sqrt(),
        Function::Sin => a.sin_cos().0,
        Function::Cos => a.sin_cos().1,
        Function::Tan => a.tan(),
        Function::Hypot => (a * a + b * b).sqrt(),
        Function::Asin => a.asin(),
        Function::Acos => a.acos(),
        Function::Atan => a.atan(),
        Function::Atan2 => a.atan2(b),
        Function::Exp => a.exp(),
        Function::Ln => a.ln(),
        Function::Tanh => a.tanh(),
        Function::Pow => a.pow(b),
        Function::Abs if a.is_at_least(T::of(0.0)) => a,
        Function::Abs => -a,
        Function::Min if b.is_at_least(a) => a,
        Function::Min => b,
        Function::Max if a.is_at_least(b) => a,
        Function::Max => b,
        Function::Sign => T::of(a.wide().partial_cmp(&0.0).map_or(0.0, |order| order as i8 as f64)),
    }
}
