//! The types of what is printed: routines, stages, statements, and what an entry point asks.
//!
//! A statement names nodes of the graph; there is no second language of expressions.

use syn::ext::IdentExt;

use crate::interface::entries::ArgumentKind;
use crate::interface::records::Shape;
use crate::interface::{EntryId, Interface};
use crate::ir::check::{Check, Comparison};
use crate::ir::cost::Operations;
use crate::ir::graph::{Graph, Id, ImplicitId, Node, RootSearch, Target};
use crate::ir::hash::{Map, Set};
use crate::ir::implicit::Implicit;
use crate::ir::liveness::{Path, unguarded};
use crate::ir::program::Program;
use crate::model::mechanism::Mechanism;

/// A program, ready to be printed.
pub struct Lowered<'p> {
    pub program: &'p Program,
    /// Interface of the entry points that the program answers.
    pub interface: Interface,
    pub routines: Vec<Routine>,
    /// Source of each entry point's numbers.
    pub entries: Vec<Compute>,
    /// Cost of one call of each entry point.
    pub costs: Vec<Operations>,
    /// Clearances of the groups, for following a motion, with rates. There are no checks: out of reach, a
    /// clearance is a number below zero. Only beside an unknown: elsewhere a routine computes them on the
    /// way.
    pub clearances: Option<Routine>,
    /// Searches for roots, in the order of the graph.
    pub searches: Vec<Search>,
}

/// A function that finds the root of an equation.
pub struct Search {
    /// Routine of a trial: both sides and the slope.
    pub routine: Routine,
    pub implicit: ImplicitId,
    pub sought: RootSearch,
    /// Arguments of a trial: values that no trial changes.
    pub given: Vec<Id>,
    /// Cost of one trial.
    pub cost: Operations,
    /// True if at most one root is proved; none where more than constants decide.
    pub has_one_root: Option<bool>,
    /// Present if the equation stands apart: a sweep then searches by the root before.
    pub apart: Option<Apart>,
    /// True if the ends are angles whose distance, at most a turn, is known at run time alone.
    pub checks_span_at_run_time: bool,
}

impl Search {
    /// True if the slope is proved to have one sign between the ends, and the equation one root at most.
    pub(crate) fn is_steady(&self) -> bool {
        self.apart.is_some_and(|apart| apart.has_one_root)
    }
}

/// An equation that stands apart.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Apart {
    /// The side that no trial changes: 0 for the left one, 1 for the right one.
    pub given: usize,
    /// True if one root is proved, with a slope that changes its sign next to an end alone.
    pub has_one_root: bool,
}

/// Source of an entry point's numbers.
pub enum Compute {
    /// By formulas of its own, as a stage of a routine.
    Own { routine: usize, stage: usize, asked: FinitenessChecks },
    /// By those of another entry point, which is given what was made of its own arguments.
    Delegate { entry: EntryId, given: ArgumentAdapter },
}

/// Arguments given in place of an entry point's own.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ArgumentAdapter {
    /// The only input's cosine and sine: where they can be given, its value is needed nowhere
    /// else, so the formulas are written once, for them.
    CosineAndSine,
    /// A rate of one: the only input's coefficients are the velocities at its unit rate.
    UnitRate,
}

/// A function that holds formulas.
pub struct Routine {
    pub name: String,
    pub given: Vec<ArgumentKind>,
    /// Result of all stages together.
    pub result: Shape,
    pub path: Path,
    /// One after the other: each uses what those before it have computed.
    pub stages: Vec<Stage>,
    /// True if the routine computes clearances on the way, at one order more than it has stages.
    pub tells: bool,
    /// The inputs and parameters it reads, in the order of the graph.
    pub reads: Vec<Node>,
    /// True if the routine contains a check: of a guard, a search, a hypotenuse or an angle.
    pub has_checks: bool,
    pub locals: Locals,
    /// The constants that are bound to names where it begins, in order.
    pub constants: Map<Node, String>,
}

/// Statements that end in a result.
pub struct Stage {
    pub result: Shape,
    pub sinks: Vec<Id>,
    pub statements: Vec<Instruction>,
}

#[derive(Clone, Debug)]
pub enum Instruction {
    Let(Id),
    /// Sine and cosine of one angle in one call, at the place of whichever comes first.
    SinCos {
        angle: Id,
        sin: Option<Id>,
        cos: Option<Id>,
        is_checked: bool,
    },
    /// A hypotenuse that the fast path needs: it asks for one whose square is in range.
    Length {
        id: Id,
        least_square: Threshold,
    },
    Check(Condition),
    Solve(Solving),
    /// Where clearances are asked for: values and scales in turn, and what they need beside. There it
    /// ends.
    ReportClearances {
        statements: Vec<Instruction>,
        clearances: Vec<Id>,
    },
}

/// A condition on a value. The fast path compares; the slow path diagnoses.
#[derive(Clone, Debug)]
pub struct Condition {
    /// The node that goes on: the value, or what stands for it at a limit.
    pub id: Id,
    pub value: Id,
    /// Comparison of the fast path; none where the condition is known to hold.
    pub comparison: Option<(Comparison, Threshold)>,
    /// Spread whose rounding the value has to exceed on the fast path.
    pub above_rounding: Option<Id>,
    /// The slow path's question, and the numbers it looks at beside the value.
    pub check: Check,
    pub operands: Vec<Id>,
    /// Whose failure it is: an index into `Program::groups`.
    pub group: u32,
}

/// Equations that are solved, and what each path reads for that.
#[derive(Clone, Debug)]
pub struct Solving {
    pub implicit: ImplicitId,
    /// By output, the node that goes on; none where nothing needs it.
    pub outputs: Vec<Option<Id>>,
    pub reads: Vec<Id>,
    /// The values that the fast path reads, where it asks for proofs alone.
    pub compares: Option<Vec<Id>>,
}

impl Solving {
    /// The values that the outputs stand on, others for those that nothing needs.
    pub(crate) fn found(&self, graph: &Graph, others: &[Id]) -> Vec<Id> {
        let found = self.outputs.iter().map(|id| graph.beneath((*id)?));
        found.zip(others).map(|(found, other)| found.unwrap_or(*other)).collect()
    }

    /// The locals that are bound.
    pub(crate) fn bound(&self) -> impl Iterator<Item = Id> {
        self.outputs.iter().flatten().copied()
    }
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Threshold {
    /// The smallest square of full precision of the number's own width.
    SmallestSquare,
    /// In double and in single precision.
    Number(f64, f64),
}

/// Tests beside the conditions on the way, before a result may be used. Results and witnesses are indices
/// into the stage's sinks and those of the stages before it.
#[derive(Clone, Debug)]
pub struct FinitenessChecks {
    /// The fast path asks this; nothing where no result can be other than finite.
    pub finite: Option<Finite>,
    /// The slow path asks these whether they are finite: first what is given, …
    pub given: Vec<Node>,
    /// … in the end what comes out.
    pub results: Vec<usize>,
}

/// Test that a sum of results is finite.
#[derive(Clone, Debug)]
pub struct Finite {
    pub sum: Sum,
    /// The widths that need no such test, double and single precision, where these bounds are kept.
    pub instead: Option<([bool; 2], Vec<Bound>)>,
}

/// A sum in the order in which it is added up.
#[derive(Clone, Debug)]
pub enum Sum {
    One(usize),
    Of(Box<[Self; 2]>),
}

/// A comparison of inputs with a limit, in double and in single precision.
#[derive(Clone, Debug, PartialEq)]
pub enum Bound {
    /// |value| ≤ limit
    Within { value: Node, limit: [f64; 2] },
    /// |second| ≤ limit − rate²
    WithRate { rate: Node, second: Node, limit: [f64; 2] },
    /// s + rate² ≤ limit, or with an acceleration (s + rate²)² + second² ≤ limit, where s is the square of the
    /// angle that cosine and sine were made of, zero where they are given.
    OnCircle { rate: Option<Node>, second: Option<Node>, limit: [f64; 2] },
}

/// Names of a routine's values, and the values that are written where they are used.
#[derive(Clone, Debug, Default)]
pub struct Locals {
    pub names: Map<Id, String>,
    /// Components of results: these are bound to a name even where a sign alone makes them.
    pub components: Set<Id>,
    /// Those that are no locals for the sake of their names.
    pub in_passing: Set<Id>,
    /// Values that a function is given in place of their operands.
    pub given: Set<Id>,
    /// Values written where they are read, without a name.
    pub nested: Set<Id>,
}

/// Form in which a value is read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Reading {
    /// An input or a parameter.
    Leaf(Node),
    /// A number.
    Constant(Node),
    /// Another reading behind a sign.
    Negated(Box<Reading>),
    Local(Id),
    /// An operation.
    Nested(Id),
}

/// True if the node is an input or a parameter.
pub(crate) fn is_leaf(node: Node) -> bool {
    matches!(
        node,
        Node::Input { .. }
            | Node::InputCos(_)
            | Node::InputSin(_)
            | Node::Param(_)
            | Node::Load(_)
            | Node::Drive(_)
    )
}

/// Name of an input or a parameter in an error.
pub(crate) fn label(mechanism: &Mechanism, leaf: Node) -> Option<String> {
    let input = |input: u32| mechanism.inputs[input as usize].name.unraw();
    Some(match leaf {
        Node::Param(param) => mechanism.params[param as usize].name.unraw().to_string(),
        Node::Load(load) => mechanism.dynamics.loads[load as usize].name.unraw().to_string(),
        Node::Drive(of) => match mechanism.dynamics.driven() {
            Some((driven, load)) if driven.0 == of => load.name.unraw().to_string(),
            _ => format!("drive of {}", input(of)),
        },
        Node::InputCos(_) => "cos".to_string(),
        Node::InputSin(_) => "sin".to_string(),
        Node::Input { input: of, order } => {
            format!("{}{}", input(of), ["", "_rate", "_acceleration"][usize::from(order)])
        }
        _ => return None,
    })
}

impl Locals {
    pub(crate) fn name(&self, id: Id) -> String {
        self.names.get(&id).cloned().unwrap_or_else(|| format!("v{}_", id.0))
    }

    /// Form in which a node's value is read: constants and signs say more where they are used than a name
    /// would. A routine without checks looks through conditions.
    pub(crate) fn reading(&self, graph: &Graph, path: Path, id: Id) -> Reading {
        if self.given.contains(&id) {
            return Reading::Local(id);
        }
        let id = match path {
            Path::Fast | Path::Unchecked => unguarded(graph, id),
            Path::Slow => id,
        };
        match graph.node(id) {
            node if is_leaf(node) => Reading::Leaf(node),
            node @ (Node::Constant(_) | Node::Low(_)) => Reading::Constant(node),
            Node::Neg(operand) if !self.components.contains(&id) => {
                Reading::Negated(Box::new(self.reading(graph, path, operand)))
            }
            _ if self.nested.contains(&id) => Reading::Nested(id),
            _ => Reading::Local(id),
        }
    }
}

impl Reading {
    /// The local that is read, if one is.
    pub(crate) fn local(&self) -> Option<Id> {
        match self {
            Self::Leaf(_) | Self::Constant(_) | Self::Nested(_) => None,
            Self::Negated(inner) => inner.local(),
            Self::Local(id) => Some(*id),
        }
    }
}

impl Lowered<'_> {
    /// The source of an entry point's numbers.
    pub(crate) fn compute(&self, id: EntryId) -> &Compute {
        &self.entries[id.index()]
    }

    /// True if an entry point compares the square of the angle, which its caller gives.
    pub(crate) fn takes_square(&self, id: EntryId) -> bool {
        let Compute::Own { asked, .. } = &self.entries[id.index()] else { return false };
        let bounds = asked.finite.iter().filter_map(|finite| finite.instead.as_ref());
        bounds.flat_map(|(_, bounds)| bounds).any(|bound| matches!(bound, Bound::OnCircle { .. }))
    }

    /// The equations that a statement solves.
    pub(crate) fn implicit(&self, solving: &Solving) -> &Implicit {
        self.program.graph.implicit(solving.implicit)
    }

    /// The search of these equations, and its index.
    pub(crate) fn search_by(&self, solving: &Solving) -> (usize, &Search) {
        let mut searches = self.searches.iter().enumerate();
        let search = searches.find(|(_, search)| search.implicit == solving.implicit);
        search.expect("every root of the program has a search")
    }

    /// The search of an unknown's root, where anything asks for it.
    pub(crate) fn search(&self, unknown: usize) -> Option<&Search> {
        let is_it = |sought: &RootSearch| {
            sought.unknown as usize == unknown && sought.wanted == Target::Root
        };
        self.searches.iter().find(|search| is_it(&search.sought))
    }
}

impl Routine {
    pub(crate) fn reading(&self, graph: &Graph, id: Id) -> Reading {
        self.locals.reading(graph, self.path, id)
    }
}
