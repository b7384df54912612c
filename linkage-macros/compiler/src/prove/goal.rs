//! The goal of a proof: some results of a graph, what it is given, the comparisons of its fast path; and which of the
//! results cannot be proved, with the reason.

use super::demand::Demand;
use super::outward::{OutwardInterval, above, below};
use super::premises::{Leaf, Premises};
use super::width::Precision;
use crate::exact::Exact;
use crate::function::Function;
use crate::ir::graph::{Graph, Id, Node, Path};
use crate::ir::liveness::{live, live_nodes};

/// The reason why there is no bound.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unproved {
    /// A function whose error nobody states.
    Function(Function),
    /// Amounts of friction, which are solved.
    SolvedAmount,
    /// An unknown, which a search finds.
    Unknown(u32),
    /// The unknowns of a group, all of which are solved at once: an index into `Program::groups`.
    Together(u32),
}

/// See the module's documentation.
pub struct Goal<'g> {
    pub graph: &'g Graph,
    pub width: Precision,
    pub given: &'g Premises,
    pub sinks: &'g [Id],
    pub demands: &'g [Demand],
    /// The computed nodes, operands before their users.
    pub nodes: Vec<(Id, Node)>,
    /// The place of each node of the graph among these.
    places: Vec<usize>,
    /// True for a node that depends on a rate whose bounds are wanted as multiples of it.
    pub scales: Vec<bool>,
    /// Constants and decimals: the computed less the exact, and the two together.
    known: Vec<Option<RoundedNumber>>,
    /// The operation whose rounding error the node is, and the constant whose rest it is.
    twins: Vec<Option<usize>>,
    unproved: Vec<Option<Unproved>>,
}

/// A number that is rounded, of which both are known.
#[derive(Clone, Copy, Debug)]
pub struct RoundedNumber {
    /// Computed less exact.
    pub error: OutwardInterval,
    /// Both.
    pub hull: OutwardInterval,
}

impl<'g> Goal<'g> {
    pub fn new(
        graph: &'g Graph,
        (sinks, demands): (&'g [Id], &'g [Demand]),
        given: &'g Premises,
        width: Precision,
    ) -> Self {
        let wanted: Vec<Id> =
            sinks.iter().copied().chain(demands.iter().flat_map(Demand::reads)).collect();
        let live = live(graph, &wanted, Path::Unchecked);
        let nodes: Vec<(Id, Node)> = live_nodes(graph, &live).collect();
        let mut places = vec![usize::MAX; graph.len()];
        nodes.iter().enumerate().for_each(|(place, (id, _))| places[id.index()] = place);
        let mut subject = Self {
            graph,
            width,
            given,
            sinks,
            demands,
            places,
            scales: Vec::new(),
            known: nodes.iter().map(|(_, node)| known(graph, width, given, *node)).collect(),
            twins: Vec::new(),
            unproved: Vec::new(),
            nodes,
        };
        subject.twins = subject.nodes.iter().map(|(_, node)| subject.twin(*node)).collect();
        for place in 0..subject.nodes.len() {
            let (scales, unproved) = subject.of_operands(subject.nodes[place].1);
            subject.scales.push(scales);
            subject.unproved.push(unproved);
        }
        subject
    }

    pub fn place(&self, id: Id) -> usize {
        self.places[id.index()]
    }

    pub fn known(&self, place: usize) -> Option<RoundedNumber> {
        self.known[place]
    }

    pub(crate) fn twin_of(&self, place: usize) -> Option<usize> {
        self.twins[place]
    }

    /// The reason why a node's value cannot be bounded.
    pub(crate) fn unproved(&self, id: Id) -> Option<Unproved> {
        self.unproved[self.place(id)]
    }

    /// The first reason why a comparison cannot be shown.
    pub(crate) fn undemanded(&self) -> Option<Unproved> {
        let certified = self.demands.iter().find_map(Demand::certified);
        let read = || self.demands.iter().flat_map(Demand::reads).find_map(|id| self.unproved(id));
        certified.map(Unproved::Together).or_else(read)
    }

    pub fn leaf(&self, node: Node) -> Option<&'g Leaf> {
        leaf(self.given, node)
    }

    /// True if a node scales with rates; and the reason why it cannot be proved.
    fn of_operands(&self, node: Node) -> (bool, Option<Unproved>) {
        let mut scales =
            matches!(node, Node::Input { order: 1 | 2, .. }) && self.given.scales_with_rates;
        let mut unproved = match node {
            Node::Apply(function, _) | Node::Apply2(function, ..) => {
                let is_stated = self.width.promised(function, 0.0).is_some();
                (!is_stated).then_some(Unproved::Function(function))
            }
            Node::Solved(solve, ..) => Some(match self.graph.implicit(solve).unknown() {
                Some(unknown) => Unproved::Unknown(unknown),
                None => Unproved::SolvedAmount,
            }),
            _ => None,
        };
        node.for_operands(&mut |operand| {
            let place = self.place(operand);
            scales |= self.scales[place];
            unproved = unproved.or(self.unproved[place]);
        });
        (scales, unproved)
    }

    /// The node whose rounding error this one is, if it is computed.
    fn twin(&self, node: Node) -> Option<usize> {
        let graph = self.graph;
        let either = |make: fn(Id, Id) -> Node, a, b| {
            graph.find(make(a, b)).or_else(|| graph.find(make(b, a)))
        };
        let of = match node {
            Node::MulErr(a, b) => either(Node::Mul, a, b),
            Node::AddErr(a, b) => either(Node::Add, a, b),
            Node::Low(constant) => graph.find(Node::Constant(constant)),
            _ => None,
        }?;
        let place = self.place(of);
        (place != usize::MAX).then_some(place)
    }
}

/// A leaf's premise.
fn leaf(given: &Premises, node: Node) -> Option<&Leaf> {
    match node {
        Node::Input { input, order } => Some(&given.inputs[input as usize][usize::from(order)]),
        Node::InputCos(input) | Node::InputSin(input) => Some(&given.inputs[input as usize][0]),
        Node::Param(param) | Node::Mode(param) => Some(&given.params[param as usize]),
        Node::Load(load) => Some(&given.loads[load as usize]),
        Node::Drive(input) => Some(&given.drives[input as usize]),
        _ => None,
    }
}

/// Both sides of a rounding that is known beforehand.
fn known(graph: &Graph, width: Precision, given: &Premises, node: Node) -> Option<RoundedNumber> {
    let value = match node {
        Node::Constant(constant) => graph.value(constant),
        Node::Low(constant) => {
            // In real numbers there is no rest.
            let rest = OutwardInterval::point(width.rest(graph.value(constant)));
            return Some(RoundedNumber { error: rest, hull: rest.hull(OutwardInterval::ZERO) });
        }
        _ => match leaf(given, node)? {
            Leaf::Decimal(value) => value,
            Leaf::Ranged(_) | Leaf::Within(_) => return None,
        },
    };
    let rounded = width.round(value);
    let exact = Exact::float(rounded)?;
    // Rounded once more, to far below either width's last place.
    let rest = value.sub(&exact).to_f64();
    let error = match rest == 0.0 {
        true => OutwardInterval::ZERO,
        false => OutwardInterval::between(below(-rest), above(-rest)),
    };
    let hull = OutwardInterval::point(rounded).hull(OutwardInterval::point(rounded).sub(error));
    Some(RoundedNumber {
        error,
        hull: if rest == 0.0 { OutwardInterval::point(rounded) } else { hull },
    })
}
