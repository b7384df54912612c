//! Computes a program's values with any kind of number. In real numbers a rounding error is zero and a fused operation
//! is its two parts.

use crate::exact::Exact;
use crate::function::{Floating, Function};
use crate::ir::graph::{Id, Node};
use crate::ir::program::Program;

/// A number that a program can be computed with.
pub trait Number: Clone {
    fn exact(value: &Exact) -> Self;
    fn neg(&self) -> Self;
    fn add(&self, other: &Self) -> Self;
    fn sub(&self, other: &Self) -> Self;
    fn mul(&self, other: &Self) -> Self;
    fn div(&self, other: &Self) -> Self;
    /// The function of one number or two.
    fn of(function: Function, operands: &[&Self]) -> Self;
    fn is_at_least(&self, other: &Self) -> bool;

    fn sin(&self) -> Self {
        Self::of(Function::Sin, &[self])
    }
    fn cos(&self) -> Self {
        Self::of(Function::Cos, &[self])
    }
}

/// Values given to the program.
pub struct ProgramValues<N> {
    /// Value, rate and acceleration of each input.
    pub inputs: Vec<[N; 3]>,
    pub params: Vec<N>,
    pub loads: Vec<N>,
    pub drives: Vec<N>,
    /// Cosine and sine in place of the only input's value, where they are given: whatever numbers
    /// these are, so that it shows what is made of each.
    pub unit: Option<[N; 2]>,
}

impl<N: Number> ProgramValues<N> {
    fn cos(&self, input: u32) -> N {
        let of_value = || self.inputs[input as usize][0].cos();
        self.unit.as_ref().map_or_else(of_value, |[cos, _]| cos.clone())
    }

    fn sin(&self, input: u32) -> N {
        let of_value = || self.inputs[input as usize][0].sin();
        self.unit.as_ref().map_or_else(of_value, |[_, sin]| sin.clone())
    }
}

/// The numbers of these nodes, of which none stands on a search, by the nodes that they need.
pub fn straight<N: Number>(
    program: &Program,
    given: &ProgramValues<N>,
    (sinks, is_needed): (&[Id], &[bool]),
) -> Vec<N> {
    let graph = &program.graph;
    let mut values = vec![N::exact(&Exact::integer(0)); graph.len()];
    for (id, node) in graph.iter() {
        if is_needed[id.index()] {
            values[id.index()] = value(program, given, &values, node, None);
        }
    }
    sinks.iter().map(|sink| values[sink.index()].clone()).collect()
}

/// The value of a node by those of its operands.
pub fn value<N: Number>(
    program: &Program,
    given: &ProgramValues<N>,
    values: &[N],
    node: Node,
    trial: Option<&N>,
) -> N {
    let graph = &program.graph;
    let v = |id: Id| &values[id.index()];
    match node {
        Node::Constant(constant) => N::exact(graph.value(constant)),
        Node::Input { input, order } => given.inputs[input as usize][usize::from(order)].clone(),
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
        Node::Apply(function, a) => N::of(function, &[v(a)]),
        Node::Apply2(function, a, b) => N::of(function, &[v(a), v(b)]),
        Node::Det([a, b, c, d]) => v(a).mul(v(b)).sub(&v(c).mul(v(d))),
        Node::Select([a, b, x, y]) => if v(a).is_at_least(v(b)) { v(x) } else { v(y) }.clone(),
        Node::MulErr(..) | Node::AddErr(..) | Node::Low(_) => N::exact(&Exact::integer(0)),
        Node::Fused(a, b, c) => v(a).mul(v(b)).add(v(c)),
        Node::Guard(value, _) => v(value).clone(),
        Node::Trial(_) => trial.expect("a trial is made in a search").clone(),
        Node::Solved(..) => unreachable!("solved by itself"),
    }
}

/// Floats, in which a group out of reach is not a number.
macro_rules! floats {
    ($($float:ident)+) => {$(
impl Number for $float {
    fn exact(value: &Exact) -> Self {
        value.to_f64() as Self
    }
    fn neg(&self) -> Self {
        -self
    }
    fn add(&self, other: &Self) -> Self {
        self + other
    }
    fn sub(&self, other: &Self) -> Self {
        self - other
    }
    fn mul(&self, other: &Self) -> Self {
        self * other
    }
    fn div(&self, other: &Self) -> Self {
        self / other
    }
    fn of(function: Function, operands: &[&Self]) -> Self {
        match operands {
            [x] => Floating::of(function, **x, **x),
            [x, y] => Floating::of(function, **x, **y),
            _ => unreachable!("a function has one argument or two"),
        }
    }
    fn is_at_least(&self, other: &Self) -> bool {
        self >= other
    }
}
    )+};
}

floats! { f32 f64 }
