//! Computes a program's values with any kind of number: the oracle for everything that rewrites
//! programs. In real numbers a rounding error is zero and a fused operation is its two parts.

#[cfg(test)]
mod amounts;

use crate::exact::Exact;
use crate::function::Function;
#[cfg(test)]
use crate::ir::graph::Graph;
use crate::ir::graph::{Id, Node};
#[cfg(test)]
use crate::ir::graph::{RootSearch, Target};
#[cfg(test)]
use crate::ir::implicit::Contacts;
#[cfg(test)]
use crate::ir::liveness::{trial_nodes, tried};
use crate::ir::program::Program;

/// A number that a program can be computed with.
pub(crate) trait Number: Clone {
    fn exact(value: &Exact) -> Self;
    fn neg(&self) -> Self;
    fn add(&self, other: &Self) -> Self;
    fn sub(&self, other: &Self) -> Self;
    fn mul(&self, other: &Self) -> Self;
    fn div(&self, other: &Self) -> Self;
    /// The function of one number or two.
    fn of(function: Function, operands: &[&Self]) -> Self;
    fn is_at_least(&self, other: &Self) -> bool;
    /// The midpoint of what the number is known to lie in.
    #[cfg(test)]
    fn point(&self) -> Self;

    fn sin(&self) -> Self {
        Self::of(Function::Sin, &[self])
    }
    fn cos(&self) -> Self {
        Self::of(Function::Cos, &[self])
    }
    /// The angle of the vector (x, self).
    #[cfg(test)]
    fn atan2(&self, x: &Self) -> Self {
        Self::of(Function::Atan2, &[self, x])
    }
    #[cfg(test)]
    fn hypot(&self, other: &Self) -> Self {
        Self::of(Function::Hypot, &[self, other])
    }
}

/// Values given to the program.
pub(crate) struct ProgramValues<N> {
    /// Value, rate and second rate of each input.
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

/// The value of every node.
#[cfg(test)]
pub(crate) fn interpret<N: Number>(program: &Program, given: &ProgramValues<N>) -> Vec<N> {
    let graph = &program.graph;
    let tried = tried(graph);
    let mut values: Vec<N> = Vec::with_capacity(graph.len());
    let mut last = None;
    for (id, node) in graph.iter() {
        let value = match node {
            // Nodes that depend on a trial are computed inside the search.
            _ if tried[id.index()] => N::exact(&Exact::integer(0)),
            Node::Solved(solve, output, on) => match graph.implicit(solve).contacts() {
                None => match graph.search(id) {
                    Some((_, sought)) => root(program, given, &tried, &mut values, &sought),
                    // The size of a root.
                    None => N::exact(&Exact::integer(1)),
                },
                Some(contacts) => {
                    // The numbers of one system follow each other, and are solved once.
                    if last.as_ref().is_none_or(|(known, _)| *known != solve) {
                        let operands = contacts.equations.iter().map(|id| &values[id.index()]);
                        let operands: Vec<_> = operands.collect();
                        last = Some((solve, amounts::all(contacts, &operands).ok()));
                    }
                    let all = last.as_ref().and_then(|(_, all)| all.as_ref());
                    let found = all.map(|all| &all[output as usize]);
                    let on = on.map(|on| &values[on.index()]);
                    found.or(on).expect("an amount stands on a value").clone()
                }
            },
            _ => value(program, given, &values, node, None),
        };
        values.push(value);
    }
    values
}

/// The joint at which friction may hold itself in a pose, if there is one.
#[cfg(test)]
pub(crate) fn jams<N: Number>(graph: &Graph, values: &[N]) -> Option<String> {
    graph.iter().find_map(|(_, node)| {
        let Node::Solved(solve, ..) = node else { return None };
        let contacts = graph.implicit(solve).contacts()?;
        let operands: Vec<_> = contacts.equations.iter().map(|id| &values[id.index()]).collect();
        amounts::all(contacts, &operands).err().map(|at| contacts.joints[at].0.clone())
    })
}

/// The amounts of friction by their equations, given the values of the rows and where steps begin.
#[cfg(test)]
pub(crate) fn amounts<N: Number>(contacts: &Contacts, operands: &[&N]) -> Option<Vec<N>> {
    amounts::all(contacts, operands).ok()
}

/// Newton's method from where the root is expected, or from the middle: declarations of tests are
/// such that it converges.
#[cfg(test)]
fn root<N: Number>(
    program: &Program,
    given: &ProgramValues<N>,
    tried: &[bool],
    values: &mut [N],
    sought: &RootSearch,
) -> N {
    let half = N::exact(&Exact::float(0.5).expect("finite"));
    let [from, to] = sought.between.map(|end| values[end.index()].clone());
    // As far as rewriting goes, the end of the interval is as good a place as a dead point.
    match sought.wanted {
        Target::End(0) => return from,
        Target::End(_) => return to,
        Target::Root => {}
    }
    let middle = from.add(&to).mul(&half);
    let mut trial = sought.near.map_or(middle, |near| values[near.index()].clone()).point();
    let nodes = trial_nodes(&program.graph, tried, &sought.sides);
    if sought.near.is_none() {
        trial = halved(program, given, values, sought, &nodes);
    }
    for _ in 0..STEPS {
        for &(id, node) in &nodes {
            values[id.index()] = value(program, given, values, node, Some(&trial));
        }
        let [left, right, slope] = sought.sides.map(|side| values[side.index()].clone());
        trial = trial.sub(&left.sub(&right).div(&slope)).point();
    }
    trial
}

/// The middle of a small interval around the root, at whose ends the equation changes its sign.
#[cfg(test)]
fn halved<N: Number>(
    program: &Program,
    given: &ProgramValues<N>,
    values: &mut [N],
    sought: &RootSearch,
    nodes: &[(Id, Node)],
) -> N {
    let half = N::exact(&Exact::float(0.5).expect("finite"));
    let [mut from, mut to] = sought.between.map(|end| values[end.index()].point());
    let mut is_above = |trial: &N| {
        for &(id, node) in nodes {
            values[id.index()] = value(program, given, values, node, Some(trial));
        }
        values[sought.sides[0].index()].is_at_least(&values[sought.sides[1].index()])
    };
    let first = is_above(&from);
    for _ in 0..HALVINGS {
        let middle = from.add(&to).mul(&half).point();
        if is_above(&middle) == first {
            from = middle;
        } else {
            to = middle;
        }
    }
    from.add(&to).mul(&half).point()
}

/// Enough for Newton's method to converge.
#[cfg(test)]
const HALVINGS: usize = 16;

/// More than Newton's method takes to a hundred digits from the first.
#[cfg(test)]
const STEPS: usize = 14;

pub(super) fn value<N: Number>(
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
    #[cfg(test)]
    fn point(&self) -> Self {
        *self
    }
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
            [x] => function.value([**x, **x]),
            [x, y] => function.value([**x, **y]),
            _ => unreachable!("a function has one argument or two"),
        }
    }
    fn is_at_least(&self, other: &Self) -> bool {
        self >= other
    }
}
    )+};
}

floats! { f64 }
#[cfg(test)]
floats! { f32 }
