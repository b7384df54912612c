//! A mechanism as a model of FMI 3.0: its variables, their description in XML, and the function that computes them.
//!
//! Where there is forward dynamics the inputs and their rates are states, driven by efforts and loads; elsewhere the
//! inputs and both their rates are given. Everything else about FMI is the same for all mechanisms, in `fmi3.c`.

mod model_description;
mod model_table;

use super::c_identifiers::{Width, file_stem, snake_case};
use super::in_c::rubs;
use super::{FRICTION, In, ROOT};
use crate::codegen::arguments::Signatures;
use crate::codegen::identifiers::text;
use crate::interface::components::Component;
use crate::interface::dimensions::of_result;
use crate::interface::entries::{Analysis, ArgumentKind, Entry};
use crate::interface::quantity::Order;
use crate::interface::{Interface, labels};
use crate::lower::routine::Lowered;
use crate::model::effort_dimensions::effort_along;
use crate::model::mechanism::{Dimension, Mechanism, ParamKind};

/// The text that all FMUs share.
const FMI3: &str = include_str!("fmi/fmi3.c");

/// A quantity of the model; its value reference is its place in the list.
struct Variable {
    name: String,
    role: Role,
    measure: VariableUnit,
    start: f64,
}

/// A dimension, and the order of the derivative by time.
type VariableUnit = (Dimension, Order);

#[derive(Clone, Copy, PartialEq, Eq)]
enum Role {
    Time,
    Input,
    Parameter,
    /// A state, and the variable that it is the derivative of.
    State(Option<usize>),
    /// The derivative of a variable.
    Rate(usize),
    /// A number that is computed with others, in the group of this index.
    Output(usize),
}

/// Results of one entry point as outputs. Where one is refused, the others are not.
struct Computed<'a> {
    entry: &'a Entry,
    first: usize,
}

struct Model<'a> {
    to: In<'a>,
    variables: Vec<Variable>,
    is_dynamic: bool,
    /// The first variable of each kind of argument, and of the parameters.
    first: [usize; 7],
    groups: Vec<Computed<'a>>,
}

/// The analyses whose results are outputs, where they are offered. Those behind the first need what it computes.
const SHOWN: [Analysis; 3] = [Analysis::Motion, Analysis::Forces, Analysis::Energy];

const PARAMETERS: usize = 6;

/// The place of an argument's first variable in `first`.
fn kind(given: ArgumentKind) -> usize {
    match given {
        ArgumentKind::Value => 0,
        ArgumentKind::Rate => 1,
        ArgumentKind::Acceleration => 2,
        ArgumentKind::Drives => 3,
        ArgumentKind::Loads => 4,
        ArgumentKind::Cosine | ArgumentKind::Sine => 5,
    }
}

/// The entry point that computes accelerations of the inputs from the efforts of their drives.
fn of_drives(interface: &Interface) -> Option<&Entry> {
    interface.entries.iter().find(|entry| entry.given.contains(&ArgumentKind::Drives))
}

/// The names and texts of the files of an FMU, beside those of its solver.
pub(crate) fn generate(
    mechanism: &Mechanism,
    lowered: &Lowered<'_>,
    is_kinematic: bool,
) -> Vec<(String, String)> {
    let (signatures, solver) =
        (Signatures::new(mechanism, &lowered.interface), text(&mechanism.name));
    let (stem, own) = (snake_case(&solver), format!("{}.c", file_stem(&solver)));
    let to = In { mechanism, lowered, signatures: &signatures, width: Width::Double, stem: &stem };
    let model = Model::new(to, is_kinematic);
    let sources = ["fmi3.c", "linkage_run.c", &own].into_iter();
    let sources = sources.chain((!mechanism.unknowns.is_empty()).then_some(ROOT));
    let sources = sources.chain(rubs(lowered).then_some(FRICTION));
    let files: String =
        sources.map(|name| format!("      <SourceFile name=\"{name}\"/>\n")).collect();
    let build = format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<fmiBuildDescription fmiVersion=\"3.0\">\n  \
         <BuildConfiguration modelIdentifier=\"{stem}\">\n    <SourceFileSet language=\"C99\">\n{files}    \
         </SourceFileSet>\n  </BuildConfiguration>\n</fmiBuildDescription>\n"
    );
    vec![
        ("modelDescription.xml".to_string(), model.description()),
        ("sources/buildDescription.xml".to_string(), build),
        ("sources/fmi3_model.h".to_string(), model.table()),
        ("sources/fmi3.c".to_string(), FMI3.to_string()),
    ]
}

impl<'a> Model<'a> {
    fn new(to: In<'a>, is_kinematic: bool) -> Self {
        let is_dynamic = !is_kinematic && of_drives(to.interface()).is_some();
        let time = Variable {
            name: "time".into(),
            role: Role::Time,
            measure: (Dimension::TIME, Order::Position),
            start: 0.0,
        };
        let mut model =
            Self { to, variables: vec![time], is_dynamic, first: [0; 7], groups: Vec::new() };
        model.add_inputs();
        model.add_efforts();
        model.first[PARAMETERS] = model.variables.len();
        for param in &to.mechanism.params {
            if let ParamKind::Number { dimension, default, .. } = &param.kind {
                let measure = (*dimension, Order::Position);
                model.add(text(&param.name), Role::Parameter, measure, default.to_f64());
            }
        }
        model.add_outputs();
        model
    }

    fn add(&mut self, mut name: String, role: Role, measure: VariableUnit, start: f64) {
        while self.variables.iter().any(|variable| variable.name == name) {
            name.push('_');
        }
        self.variables.push(Variable { name, role, measure, start });
    }

    /// The inputs, their rates and their accelerations.
    fn add_inputs(&mut self) {
        let mechanism = self.to.mechanism;
        let count = mechanism.inputs.len();
        for (order, ending) in Order::ALL.into_iter().zip(["", "_rate", "_acceleration"]) {
            let nth = kind(
                [ArgumentKind::Value, ArgumentKind::Rate, ArgumentKind::Acceleration]
                    [order as usize],
            );
            self.first[nth] = self.variables.len();
            for (at, input) in mechanism.inputs.iter().enumerate() {
                let drawn = mechanism.drawn.as_ref().map_or(0.0, |drawn| drawn[at]);
                let start = if order == Order::Position { drawn } else { 0.0 };
                let lower = self.variables.len().wrapping_sub(count);
                let role = match order {
                    _ if !self.is_dynamic => Role::Input,
                    Order::Position => Role::State(None),
                    Order::Velocity => Role::State(Some(lower)),
                    Order::Acceleration => Role::Rate(lower),
                };
                let measure = (input.dimension, order);
                self.add(format!("{}{ending}", text(&input.name)), role, measure, start);
            }
        }
    }

    /// The efforts of the drives, and the loads.
    fn add_efforts(&mut self) {
        let mechanism = self.to.mechanism;
        self.first[kind(ArgumentKind::Drives)] = self.variables.len();
        let driven = if self.is_dynamic { &mechanism.inputs[..] } else { &[] };
        for input in driven {
            let measure = (effort_along(input.dimension), Order::Position);
            self.add(format!("drive of {}", text(&input.name)), Role::Input, measure, 0.0);
        }
        self.first[kind(ArgumentKind::Loads)] = self.variables.len();
        if !self.is_dynamic && !self.to.interface().has(Analysis::Forces) {
            return;
        }
        for load in &mechanism.dynamics.loads {
            let measure = (load.dimension, Order::Position);
            self.add(text(&load.name), Role::Input, measure, 0.0);
        }
    }

    fn add_outputs(&mut self) {
        let interface = self.to.interface();
        for entry in SHOWN.iter().filter_map(|of| interface.find(of.by_value())) {
            let entry = interface.entry(entry);
            let group = Computed { entry, first: self.variables.len() };
            let measures = of_result(interface, self.to.mechanism, entry);
            for (name, measure) in self.names(entry).into_iter().zip(measures) {
                self.add(name, Role::Output(self.groups.len()), measure, 0.0);
            }
            self.groups.push(group);
        }
    }

    /// The names of a result's numbers. Errors call both parts of a direction by one name.
    fn names(&self, entry: &Entry) -> Vec<String> {
        let interface = self.to.interface();
        let labels = labels::of_result(interface, self.to.mechanism, entry);
        let ways = interface.components(entry.result);
        let name = |(label, way): (&String, Vec<Component>)| {
            let is_shared = labels.iter().filter(|other| *other == label).count() > 1;
            match (way.last(), label.rsplit_once('.')) {
                (Some(Component::Field(part)), Some((link, _))) if is_shared => {
                    format!("{link}.{part}")
                }
                _ => label.clone(),
            }
        };
        labels.iter().zip(ways).map(name).collect()
    }
}
