//! Computes a program's values with any kind of number: the oracle for everything that rewrites
//! programs. In real numbers a rounding error is zero and a fused operation is its two parts.

use crate::exact::Exact;
use crate::ir::graph::{Id, Node};
use crate::ir::program::Program;

/// A number that a program can be computed with.
pub(crate) trait Number: Clone {
    fn exact(value: &Exact) -> Self;
    fn neg(&self) -> Self;
    fn add(&self, other: &Self) -> Self;
    fn sub(&self, other: &Self) -> Self;
    fn mul(&self, other: &Self) -> Self;
    fn div(&self, other: &Self) -> Self;
    fn sqrt(&self) -> Self;
    fn sin(&self) -> Self;
    fn cos(&self) -> Self;
    fn tan(&self) -> Self;
    fn asin(&self) -> Self;
    fn acos(&self) -> Self;
    fn atan(&self) -> Self;
    /// The angle of the vector (x, self).
    fn atan2(&self, x: &Self) -> Self;
    fn hypot(&self, other: &Self) -> Self;
}

/// What the program is given.
pub(crate) struct Given<N> {
    /// Value, rate and second rate of each input.
    pub inputs: Vec<[N; 3]>,
    pub params: Vec<N>,
    pub loads: Vec<N>,
    pub drives: Vec<N>,
    /// Cosine and sine in place of the only input's value, where they are given: whatever numbers
    /// these are, so that it shows what is made of each.
    pub unit: Option<[N; 2]>,
}

impl<N: Number> Given<N> {
    fn cos(&self, input: u32) -> N {
        let of_value = || self.inputs[input as usize][0].cos();
        self.unit.as_ref().map_or_else(of_value, |[cos, _]| cos.clone())
    }

    fn sin(&self, input: u32) -> N {
        let of_value = || self.inputs[input as usize][0].sin();
        self.unit.as_ref().map_or_else(of_value, |[_, sin]| sin.clone())
    }
}

/// The value of every node.
pub(crate) fn interpret<N: Number>(program: &Program, given: &Given<N>) -> Vec<N> {
    let graph = &program.graph;
    let mut values: Vec<N> = Vec::with_capacity(graph.len());
    for (_, node) in graph.iter() {
        let v = |id: Id| &values[id.index()];
        let value = match node {
            Node::Constant(constant) => N::exact(graph.value(constant)),
            Node::Input { input, order } => {
                given.inputs[input as usize][usize::from(order)].clone()
            }
            Node::InputCos(input) => given.cos(input),
            Node::InputSin(input) => given.sin(input),
            Node::Param(param) | Node::Mode(param) => given.params[param as usize].clone(),
            Node::Load(load) => given.loads[load as usize].clone(),
            Node::Drive(input) => given.drives[input as usize].clone(),
            Node::Neg(a) => v(a).neg(),
            Node::Add(a, b) => v(a).add(v(b)),
            Node::Sub(a, b) => v(a).sub(v(b)),
            Node::Mul(a, b) => v(a).mul(v(b)),
            Node::Div(a, b) => v(a).div(v(b)),
            Node::Sqrt(a) => v(a).sqrt(),
            Node::Sin(a) => v(a).sin(),
            Node::Cos(a) => v(a).cos(),
            Node::Tan(a) => v(a).tan(),
            Node::Asin(a) => v(a).asin(),
            Node::Acos(a) => v(a).acos(),
            Node::Atan(a) => v(a).atan(),
            Node::Atan2(a, b) => v(a).atan2(v(b)),
            Node::Hypot(a, b) => v(a).hypot(v(b)),
            Node::Det([a, b, c, d]) => v(a).mul(v(b)).sub(&v(c).mul(v(d))),
            Node::MulErr(..) | Node::AddErr(..) | Node::Low(_) => N::exact(&Exact::integer(0)),
            Node::Fused(a, b, c) => v(a).mul(v(b)).add(v(c)),
            Node::Guard(value, _) => v(value).clone(),
        };
        values.push(value);
    }
    values
}
