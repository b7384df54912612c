//! A mechanism as a model of FMI 3.0: its variables, their description in XML, and the function that computes them.
//!
//! Where there is forward dynamics the inputs and their rates are states, driven by efforts and loads; elsewhere the
//! inputs and both their rates are given. Everything else about FMI is the same for all mechanisms, in `fmi3.c`.

use super::c_names::{is_array, param as field_of_param};
use super::{FRICTION, In, ROOT, rubs};
use crate::codegen::arguments::{Arguments, Form};
use crate::codegen::c_export::c_identifiers::{Width, default, function, snake_case};
use crate::codegen::context::Context;
use crate::codegen::identifiers::text;
use crate::interface::entries::{Analysis, Entry, Given};
use crate::interface::quantity::Order;
use crate::interface::units_in_words::unit;
use crate::interface::{Interface, labels};
use crate::lower::routine::Lowered;
use crate::model::mechanism::{Mechanism, ParamKind};

/// The text that all FMUs share.
const FMI3: &str = include_str!("fmi/fmi3.c");

/// A quantity of the model; its value reference is its place in the list.
struct Variable {
    name: String,
    role: Role,
    unit: String,
    start: f64,
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Role {
    Time,
    Input,
    Parameter,
    /// A state, and the variable that it is the derivative of.
    State(Option<usize>),
    /// The derivative of a variable.
    Rate(usize),
    Output,
}

struct Model<'a> {
    to: In<'a>,
    variables: Vec<Variable>,
    is_dynamic: bool,
    /// The first variable of each kind of argument, and of the parameters.
    first: [usize; 7],
    outputs: usize,
}

const PARAMETERS: usize = 6;

/// The place of an argument's first variable in `first`.
fn kind(given: Given) -> usize {
    match given {
        Given::Value => 0,
        Given::Rate => 1,
        Given::Acceleration => 2,
        Given::Drives => 3,
        Given::Loads => 4,
        Given::Cosine | Given::Sine => 5,
    }
}

/// The entry point that computes second rates of the inputs from the efforts of their drives.
fn of_drives(interface: &Interface) -> Option<&Entry> {
    interface.entries.iter().find(|entry| entry.given.contains(&Given::Drives))
}

/// The names and texts of the files of an FMU, beside those of its solver.
pub(crate) fn generate(
    mechanism: &Mechanism,
    lowered: &Lowered<'_>,
    is_kinematic: bool,
) -> Vec<(String, String)> {
    let cx = Context::new(mechanism, lowered);
    let stem = snake_case(&text(&cx.names.solver));
    let model = Model::new(In { cx: &cx, width: Width::Double, stem: &stem }, is_kinematic);
    let own = format!("{stem}.c");
    let sources = ["fmi3.c", "linkage_run.c", &own].into_iter();
    let sources = sources.chain(cx.searches().then_some(ROOT));
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
        let is_dynamic = !is_kinematic && of_drives(to.cx.interface).is_some();
        let time = Variable { name: "time".into(), role: Role::Time, unit: "s".into(), start: 0.0 };
        let mut model = Self { to, variables: vec![time], is_dynamic, first: [0; 7], outputs: 0 };
        model.add_inputs();
        model.add_efforts();
        model.first[PARAMETERS] = model.variables.len();
        for param in &to.cx.mechanism.params {
            if let ParamKind::Number { dimension, default, .. } = &param.kind {
                let unit = unit(*dimension, Order::Position);
                model.add(text(&param.name), Role::Parameter, unit, default.to_f64());
            }
        }
        model.outputs = model.variables.len();
        model.add_outputs();
        model
    }

    fn add(&mut self, mut name: String, role: Role, unit: String, start: f64) {
        while self.variables.iter().any(|variable| variable.name == name) {
            name.push('_');
        }
        self.variables.push(Variable { name, role, unit, start });
    }

    /// The inputs, their rates and their second rates.
    fn add_inputs(&mut self) {
        let mechanism = self.to.cx.mechanism;
        let count = mechanism.inputs.len();
        for (order, ending) in Order::ALL.into_iter().zip(["", "_rate", "_acceleration"]) {
            let nth = kind([Given::Value, Given::Rate, Given::Acceleration][order as usize]);
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
                let unit = unit(input.dimension, order);
                self.add(format!("{}{ending}", text(&input.name)), role, unit, start);
            }
        }
    }

    /// The efforts of the drives, and the loads.
    fn add_efforts(&mut self) {
        let mechanism = self.to.cx.mechanism;
        self.first[kind(Given::Drives)] = self.variables.len();
        if !self.is_dynamic {
            return;
        }
        for input in &mechanism.inputs {
            let unit = if input.dimension.angle { "N·m" } else { "N" };
            self.add(format!("drive of {}", text(&input.name)), Role::Input, unit.into(), 0.0);
        }
        self.first[kind(Given::Loads)] = self.variables.len();
        for load in &mechanism.dynamics.loads {
            let unit = unit(load.dimension, Order::Position);
            self.add(text(&load.name), Role::Input, unit, 0.0);
        }
    }

    /// The entry point whose results are outputs.
    fn motion(&self) -> Option<&'a Entry> {
        let interface = self.to.cx.interface;
        Some(interface.entry(interface.find(Analysis::Motion.by_value())?))
    }

    fn add_outputs(&mut self) {
        let cx = self.to.cx;
        let Some(motion) = self.motion() else { return };
        for label in labels::of_result(cx.interface, cx.mechanism, motion) {
            self.add(label, Role::Output, String::new(), 0.0);
        }
    }

    /// The description of the model.
    fn description(&self) -> String {
        let stem = self.to.stem;
        let mut xml = format!(
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<fmiModelDescription fmiVersion=\"3.0\" modelName=\"{}\" \
             instantiationToken=\"{}\" generationTool=\"linkage\" variableNamingConvention=\"flat\">\n  \
             <ModelExchange modelIdentifier=\"{stem}\"/>\n  \
             <CoSimulation modelIdentifier=\"{stem}\" canHandleVariableCommunicationStepSize=\"true\"/>\n",
            escaped(&text(&self.to.cx.names.solver)),
            self.token()
        );
        xml += &self.units();
        xml += "  <ModelVariables>\n";
        let variables = self.variables.iter().enumerate();
        variables.clone().for_each(|(at, variable)| xml += &variable.in_xml(at));
        xml += "  </ModelVariables>\n  <ModelStructure>\n";
        let list = |tag: &str, is_it: &dyn Fn(Role) -> bool| {
            let these = self.variables.iter().enumerate().filter(|(_, v)| is_it(v.role));
            these
                .map(|(at, _)| format!("    <{tag} valueReference=\"{at}\"/>\n"))
                .collect::<String>()
        };
        xml += &list("Output", &|role| matches!(role, Role::Output | Role::State(_)));
        let is_rate = |role| matches!(role, Role::State(Some(_)) | Role::Rate(_));
        xml += &list("ContinuousStateDerivative", &is_rate);
        xml += &list("InitialUnknown", &|role| matches!(role, Role::Output | Role::Rate(_)));
        xml + "  </ModelStructure>\n</fmiModelDescription>\n"
    }

    fn token(&self) -> String {
        let mut hash = 0xcbf2_9ce4_8422_2325_u64;
        let names = self.variables.iter().map(|variable| &variable.name[..]);
        for byte in std::iter::once(self.to.stem).chain(names).flat_map(str::bytes) {
            hash = (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
        }
        format!("{{linkage-{hash:016x}}}")
    }

    fn units(&self) -> String {
        let mut units: Vec<&str> = self.variables.iter().map(|v| &v.unit[..]).collect();
        units.sort_unstable();
        units.dedup();
        let named = units.into_iter().filter(|unit| !unit.is_empty());
        let listed = named.map(|unit| format!("    <Unit name=\"{unit}\"/>\n"));
        format!("  <UnitDefinitions>\n{}  </UnitDefinitions>\n", listed.collect::<String>())
    }

    /// The header of what is the mechanism's own.
    fn table(&self) -> String {
        let states = |is_it: &dyn Fn(Role) -> bool| {
            let these = self.variables.iter().enumerate().filter(|(_, v)| is_it(v.role));
            let mut list: Vec<String> = these.map(|(at, _)| at.to_string()).collect();
            list.push("0".to_string());
            list.join(", ")
        };
        let kinds: Vec<&str> = self.variables.iter().map(|v| v.role.in_c()).collect();
        let starts: Vec<String> = self.variables.iter().map(|v| format!("{:?}", v.start)).collect();
        let is_state = |v: &&Variable| matches!(v.role, Role::State(_));
        format!(
            "/* fmi3_model.h: the variables of {}, printed by linkage; do not edit. */\n#include \"{}.h\"\n\n\
             #define TOKEN \"{}\"\n#define VARIABLES {}\n#define STATES {}\n\n\
             enum {{ GIVEN, COMPUTED, TIME }};\nstatic const unsigned char KIND[VARIABLES] = {{ {} }};\n\
             static const double START[VARIABLES] = {{ {} }};\n\
             static const uint32_t STATE[STATES + 1] = {{ {} }};\n\
             static const uint32_t DERIVATIVE[STATES + 1] = {{ {} }};\n\n{}",
            text(&self.to.cx.names.solver),
            self.to.stem,
            self.token(),
            self.variables.len(),
            self.variables.iter().filter(is_state).count(),
            kinds.join(", "),
            starts.join(", "),
            states(&|role| matches!(role, Role::State(_))),
            states(&|role| matches!(role, Role::State(Some(_)) | Role::Rate(_))),
            self.evaluation(),
        )
    }

    /// The function that computes what depends on what is given.
    fn evaluation(&self) -> String {
        let cx = self.to.cx;
        let mut lines =
            String::from("static LinkageStatus evaluate(double v[], LinkageError *error)\n{\n");
        if self.to.has_params() {
            let solver = self.to.params_type();
            lines += &format!(
                "    {solver} mechanism = {}();\n",
                default(&cx.names.solver, Width::Double)
            );
        }
        lines += "    LinkageStatus status = LINKAGE_OK;\n";
        let numbers = cx.mechanism.params.iter();
        let numbers = numbers.filter(|param| matches!(param.kind, ParamKind::Number { .. }));
        for (at, param) in numbers.enumerate() {
            let field = field_of_param(cx.mechanism, &text(&param.name));
            lines += &format!("    mechanism.{field} = v[{}];\n", self.first[PARAMETERS] + at);
        }
        if self.is_dynamic {
            let of_drives = of_drives(cx.interface).expect("it is dynamic");
            lines += &self.call(of_drives, "rates", self.first[kind(Given::Acceleration)]);
        }
        if let Some(motion) = self.motion() {
            lines += &self.call(motion, "moved", self.outputs);
        }
        lines += "    (void)v;\n    (void)error;\n    return status;\n}\n";
        lines
    }

    /// The call of an entry point, and where its numbers go.
    fn call(&self, entry: &Entry, result: &str, first: usize) -> String {
        let to = self.to;
        let mut lines = String::from("    if (status == LINKAGE_OK) {\n");
        let mut passed: Vec<String> =
            to.has_params().then(|| "&mechanism".to_string()).into_iter().collect();
        let arguments = Arguments::new(to.cx, &entry.given);
        for (&given, (_, form)) in entry.given.iter().zip(arguments.parts()) {
            let at = self.first[kind(given)];
            let values = (at..at + form.numbers()).map(|at| format!("v[{at}]"));
            let values: Vec<String> = values.collect();
            let name = format!("a{}", passed.len());
            let declared = match &form {
                Form::Number => {
                    passed.push(values.concat());
                    continue;
                }
                Form::Record(record, _) => {
                    passed.push(format!("&{name}"));
                    format!("const {} {name}", to.width.type_name(&text(record)))
                }
                Form::List(count) => {
                    passed.push(name.clone());
                    format!("const double {name}[{count}]")
                }
            };
            lines += &format!("        {declared} = {{ {} }};\n", values.join(", "));
        }
        let by = if is_array(entry.result) { "" } else { "&" };
        passed.extend([format!("{by}{result}"), "error".to_string()]);
        lines += &format!("        {};\n", to.result(entry.result, result));
        let name = function(&to.cx.names.solver, entry, Width::Double);
        lines += &format!(
            "        status = {name}({});\n        if (status == LINKAGE_OK) {{\n",
            passed.join(", ")
        );
        for (at, place) in to.components(entry.result, result).iter().enumerate() {
            lines += &format!("            v[{}] = {place};\n", first + at);
        }
        lines + "        }\n    }\n"
    }
}

impl Role {
    fn in_c(self) -> &'static str {
        match self {
            Self::Time => "TIME",
            Self::Input | Self::Parameter | Self::State(_) => "GIVEN",
            Self::Rate(_) | Self::Output => "COMPUTED",
        }
    }
}

impl Variable {
    fn in_xml(&self, at: usize) -> String {
        let start = format!(" start=\"{:?}\"", self.start);
        let rest = match self.role {
            Role::Time => "causality=\"independent\" variability=\"continuous\"".to_string(),
            Role::Input => format!("causality=\"input\" variability=\"continuous\"{start}"),
            Role::Parameter => format!("causality=\"parameter\" variability=\"tunable\"{start}"),
            Role::State(of) => {
                let derivative = of.map_or(String::new(), |of| format!(" derivative=\"{of}\""));
                format!(
                    "causality=\"output\" variability=\"continuous\" initial=\"exact\"{start}{derivative}"
                )
            }
            Role::Rate(of) => {
                format!(
                    "causality=\"local\" variability=\"continuous\" initial=\"calculated\" derivative=\"{of}\""
                )
            }
            Role::Output => {
                "causality=\"output\" variability=\"continuous\" initial=\"calculated\"".to_string()
            }
        };
        let unit = match &self.unit[..] {
            "" => String::new(),
            unit => format!(" unit=\"{unit}\""),
        };
        format!(
            "    <Float64 name=\"{}\" valueReference=\"{at}\" {rest}{unit}/>\n",
            escaped(&self.name)
        )
    }
}

/// Text inside of an attribute.
fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('"', "&quot;")
}
