//! A machine of the tests, its drawing and its poses in any kind of number.

use crate::codegen::docs::found_groups;
use crate::diagnostics::Diagnostics;
use crate::exact::Exact;
use crate::ir::graph::{Check, Node};
use crate::ir::interpret::{ProgramValues, Searched, interpret};
use crate::ir::program::Program;
use crate::model::mechanism::{LinkId, Mechanism, OutputKind, Step};
use crate::syntax::tree::{
    Declaration, DrawnLink, GroundStatement, LinkStatement, PinStatement, StatementKind,
};
use crate::{equations, model, passes, syntax};

/// Pins by name.
pub(super) type Places<N> = [(String, [N; 2])];

/// A machine as it is declared, and the program of its solver.
pub(super) struct Machine {
    tree: Declaration,
    pub mechanism: Mechanism,
    program: Program,
}

/// The machine that a text declares, or what is said of it.
pub(super) fn machine(source: &str) -> Result<Machine, Vec<String>> {
    let mut diagnostics = Diagnostics::new();
    let tokens = source.parse().expect("these are tokens");
    let tree = syntax::parse(tokens, &mut diagnostics).expect("it has a name");
    let mechanism = model::resolve(&tree, &mut diagnostics).ok();
    let mistakes = diagnostics.into_mistakes();
    let Some(mechanism) = mechanism else {
        return Err(mistakes.iter().map(|mistake| mistake.text()).collect());
    };
    let program = equations::derive(&mechanism, passes::RULES);
    Ok(Machine { tree, mechanism, program })
}

/// The documentation of a solver, a line each.
pub(super) fn documentation(mechanism: &Mechanism) -> String {
    let line = |docs: &syn::Attribute| match &docs.meta {
        syn::Meta::NameValue(value) => match &value.value {
            syn::Expr::Lit(syn::ExprLit { lit: syn::Lit::Str(text), .. }) => text.value(),
            _ => String::new(),
        },
        _ => String::new(),
    };
    found_groups::all_docs(mechanism).iter().map(line).collect::<Vec<_>>().join("\n")
}

impl Machine {
    /// The machine with something of it changed behind the rules.
    pub(super) fn changed(mut self, change: impl FnOnce(&mut Mechanism)) -> Self {
        change(&mut self.mechanism);
        let program = equations::derive(&self.mechanism, passes::RULES);
        Self { program, ..self }
    }

    /// The inputs of the pose in which it is drawn.
    pub(super) fn drawn_inputs(&self) -> Vec<f64> {
        self.mechanism.drawn.clone().expect("drives determine the inputs")
    }

    pub(super) fn docs(&self) -> String {
        documentation(&self.mechanism)
    }

    pub(super) fn program(&self) -> &Program {
        &self.program
    }

    /// The values of all nodes at these inputs. The machine has no parameters.
    fn values<N: Searched>(&self, inputs: &[f64]) -> Vec<N> {
        let float = |value: f64| N::exact(&Exact::float(value).expect("finite"));
        let given = ProgramValues {
            inputs: inputs.iter().map(|&value| [value, 0.0, 0.0].map(float)).collect(),
            params: Vec::new(),
            loads: Vec::new(),
            drives: Vec::new(),
            unit: None,
        };
        interpret(&self.program, &given)
    }

    /// True if every certificate of Newton's method holds there.
    pub(super) fn is_certified(&self, inputs: &[f64]) -> bool {
        self.all_certified(&self.values::<f64>(inputs))
    }

    fn all_certified<N: Searched>(&self, values: &[N]) -> bool {
        let (graph, zero) = (&self.program.graph, N::exact(&Exact::integer(0)));
        graph.nodes().iter().all(|node| match *node {
            Node::Guard(under, guard) if graph.condition(guard).check == Check::Certified => {
                // No number is at least what is not a number.
                let under = &values[under.index()];
                under.is_at_least(&zero) && !zero.is_at_least(under)
            }
            _ => true,
        })
    }

    /// The pins by name at these inputs, if every certificate of Newton's method holds there.
    pub(super) fn certified<N: Searched>(&self, inputs: &[f64]) -> Option<Vec<(String, [N; 2])>> {
        let values = self.values::<N>(inputs);
        self.all_certified(&values).then(|| self.pins_of(&values))
    }

    /// The pins by name, at these inputs. The machine has no parameters.
    pub(super) fn pins<N: Searched>(&self, inputs: &[f64]) -> Vec<(String, [N; 2])> {
        self.pins_of(&self.values::<N>(inputs))
    }

    fn pins_of<N: Searched>(&self, values: &[N]) -> Vec<(String, [N; 2])> {
        let entry = self.program.answer("position").expect("the entry exists");
        let all: Vec<_> = entry.sinks.iter().map(|sink| values[sink.index()].clone()).collect();
        let (mut row, mut pins) = (0, Vec::new());
        for output in &self.mechanism.outputs {
            match &output.kind {
                OutputKind::Point(_) => {
                    let at = [all[row].clone(), all[row + 1].clone()];
                    pins.push((output.field.to_string(), at));
                    row += 2;
                }
                OutputKind::Link { direction, slide, .. } => {
                    row += 2 * usize::from(*direction) + usize::from(*slide);
                }
                OutputKind::Angle(_) => row += 2,
                _ => row += 1,
            }
        }
        pins.extend(self.drawn(true));
        pins
    }

    /// The links of groups behind all searches: where these end is none of a search's business.
    fn links_behind(&self) -> Vec<String> {
        let Some(last) = self.mechanism.unknowns.last() else { return Vec::new() };
        let name = |link: &LinkId| self.mechanism.links[link.index()].name.to_string();
        let groups = self.mechanism.steps[last.steps[1]..].iter().filter_map(|step| match step {
            Step::Group(group) => Some(group.links.iter().map(name).collect::<Vec<_>>()),
            _ => None,
        });
        // The link that was left out hangs on a block of its own.
        let later = groups.filter(|links| !links.iter().any(|link| link.ends_with("_end")));
        later.flatten().collect()
    }

    /// The pins in double precision, if all bodies that searches place and that stand before are as
    /// rigid as drawn there, to a part `off` of their size. What is out of reach, or has no root, is not.
    pub(super) fn rigid(&self, inputs: &[f64], off: f64) -> Option<Vec<(String, [f64; 2])>> {
        let now = self.pins::<f64>(inputs);
        self.are_rigid(&now, off).then_some(now)
    }

    /// True if these pins keep all those bodies as rigid as drawn.
    pub(super) fn are_rigid(&self, now: &Places<f64>, off: f64) -> bool {
        let drawn = [self.drawn::<f64>(true), self.drawn::<f64>(false)].concat();
        let at = |pins: &Places<f64>, name: &str| {
            pins.iter().find(|(known, _)| known == name).expect("every pin is an output").1
        };
        let vector = |pins: &Places<f64>, from: &str, to: &str| {
            let [from, to] = [at(pins, from), at(pins, to)];
            [to[0] - from[0], to[1] - from[1]]
        };
        let products =
            |[a, b]: [[f64; 2]; 2]| [a[0] * b[0] + a[1] * b[1], a[0] * b[1] - a[1] * b[0]];
        let size = drawn.iter().flat_map(|(_, at)| at).fold(0.0_f64, |size, x| size.max(x.abs()));
        let behind = self.links_behind();
        self.links().iter().all(|(name, pins)| {
            let [first, rest @ ..] = &pins[..] else { return true };
            if behind.contains(name) {
                return true;
            }
            let pairs =
                rest.iter().enumerate().flat_map(|(i, a)| rest[i..].iter().map(move |b| (a, b)));
            pairs.into_iter().all(|(a, b)| {
                let of = |pins: &Places<f64>| products([a, b].map(|to| vector(pins, first, to)));
                let (was, is) = (of(&drawn), of(now));
                was.iter().zip(is).all(|(was, is)| (was - is).abs() <= off * size * size)
            })
        })
    }

    /// The places of the drawing: those of the ground, or of the pins.
    pub(super) fn drawn<N: Searched>(&self, of_ground: bool) -> Vec<(String, [N; 2])> {
        let points = self.tree.statements.iter().flat_map(|statement| match &statement.kind {
            StatementKind::Ground(GroundStatement { points }) if of_ground => &points[..],
            StatementKind::Pin(PinStatement { points }) if !of_ground => &points[..],
            _ => &[],
        });
        let number = |expr: &syntax::tree::Expr| N::exact(&literal(expr));
        points.map(|(name, at)| (name.to_string(), at.each_ref().map(number))).collect()
    }

    /// Every link that is as drawn, with its pins.
    pub(super) fn links(&self) -> Vec<(String, Vec<String>)> {
        let links = self.tree.statements.iter().flat_map(|statement| match &statement.kind {
            StatementKind::Link(LinkStatement { links, fields: None }) => &links[..],
            _ => &[],
        });
        let pins = |link: &DrawnLink| link.pins.iter().map(ToString::to_string).collect();
        links.map(|link| (link.name.to_string(), pins(link))).collect()
    }
}

/// The value of a decimal.
fn literal(expr: &syntax::tree::Expr) -> Exact {
    use syntax::tree::ExprKind;
    match &expr.kind {
        ExprKind::Number { digits, .. } => Exact::decimal(digits).expect("a decimal"),
        ExprKind::Negate(inner) => literal(inner).neg(),
        _ => panic!("the drawings of these tests are decimals"),
    }
}
