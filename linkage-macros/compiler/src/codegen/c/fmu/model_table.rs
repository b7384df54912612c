//! The header of what is a model's own: its variables, and the functions that compute them.

use super::{Model, PARAMETERS, Role, Variable, kind, of_drives};
use crate::codegen::arguments::Form;
use crate::codegen::c::c_identifiers::{Width, default, file_stem, function};
use crate::codegen::c::c_names::{is_array, param as field_of_param};
use crate::codegen::identifiers::text;
use crate::interface::entries::{ArgumentKind, Entry};
use crate::model::mechanism::ParamKind;

impl Model<'_> {
    /// The header of what is the mechanism's own.
    pub(super) fn table(&self) -> String {
        let states = |is_it: &dyn Fn(Role) -> bool| {
            let these = self.variables.iter().enumerate().filter(|(_, v)| is_it(v.role));
            let mut list: Vec<String> = these.map(|(at, _)| at.to_string()).collect();
            list.push("0".to_string());
            list.join(", ")
        };
        let kinds: Vec<String> = self.variables.iter().map(|v| v.role.in_c()).collect();
        let starts: Vec<String> = self.variables.iter().map(|v| format!("{:?}", v.start)).collect();
        let solver = text(&self.to.mechanism.name);
        // Fields may be named like the macros behind these functions.
        let (functions, names) = self.evaluation();
        let is_state = |v: &&Variable| matches!(v.role, Role::State(_));
        format!(
            "/* fmi3_model.h: the variables of {}, printed by linkage; do not edit. */\n#include \"{}.h\"\n\n{}\
             #define TOKEN \"{}\"\n#define VARIABLES {}\n#define STATES {}\n#define GROUPS {}\n\n\
             enum {{ GIVEN, TIME, COMPUTED }};\nstatic const unsigned char KIND[VARIABLES] = {{ {} }};\n\
             static const double START[VARIABLES] = {{ {} }};\n\
             static const uint32_t STATE[STATES + 1] = {{ {} }};\n\
             static const uint32_t DERIVATIVE[STATES + 1] = {{ {} }};\n\
             static LinkageStatus (*const EVALUATE[GROUPS])(double v[], LinkageError *error) = {{ {} }};\n",
            solver,
            file_stem(&solver),
            functions,
            self.token(),
            self.variables.len(),
            self.variables.iter().filter(is_state).count(),
            self.groups.len().max(1),
            kinds.join(", "),
            starts.join(", "),
            states(&|role| matches!(role, Role::State(_))),
            states(&|role| matches!(role, Role::State(Some(_)) | Role::Rate(_))),
            names,
        )
    }

    /// The functions that compute what depends on what is given, one a group, and the list of their names.
    fn evaluation(&self) -> (String, String) {
        let groups = 0..self.groups.len().max(1);
        let functions: String = groups.clone().map(|nth| self.evaluation_of(nth)).collect();
        let names: Vec<String> = groups.map(|nth| format!("evaluate_{nth}")).collect();
        (functions, names.join(", "))
    }

    /// The function of a group. The first one's also computes the accelerations of the inputs.
    fn evaluation_of(&self, nth: usize) -> String {
        let (mechanism, interface) = (self.to.mechanism, self.to.interface());
        let mut lines =
            format!("static LinkageStatus evaluate_{nth}(double v[], LinkageError *error)\n{{\n");
        if self.to.has_params() {
            let solver = self.to.params_type();
            let declared = default(&mechanism.name, Width::Double);
            lines += &format!("    {solver} mechanism = {declared}();\n");
        }
        lines += "    LinkageStatus status = LINKAGE_OK;\n";
        let numbers = mechanism.params.iter();
        let numbers = numbers.filter(|param| matches!(param.kind, ParamKind::Number { .. }));
        for (at, param) in numbers.enumerate() {
            let field = field_of_param(mechanism, &text(&param.name));
            lines += &format!("    mechanism.{field} = v[{}];\n", self.first[PARAMETERS] + at);
        }
        if self.is_dynamic && nth == 0 {
            let of_drives = of_drives(interface).expect("it is dynamic");
            lines += &self.call(of_drives, "rates", self.first[kind(ArgumentKind::Acceleration)]);
        }
        if let Some(group) = self.groups.get(nth) {
            lines += &self.call(group.entry, "found", group.first);
        }
        lines + "    (void)v;\n    (void)error;\n    return status;\n}\n\n"
    }

    /// The call of an entry point, and where its numbers go.
    fn call(&self, entry: &Entry, result: &str, first: usize) -> String {
        let to = self.to;
        let mut lines = String::from("    if (status == LINKAGE_OK) {\n");
        let mut passed: Vec<String> =
            to.has_params().then(|| "&mechanism".to_string()).into_iter().collect();
        let arguments = to.signatures.arguments(&entry.given);
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
        let name = function(&to.mechanism.name, entry, Width::Double);
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
    fn in_c(self) -> String {
        match self {
            Self::Time => "TIME".to_string(),
            Self::Input | Self::Parameter | Self::State(_) => "GIVEN".to_string(),
            Self::Rate(_) => "COMPUTED".to_string(),
            Self::Output(group) => format!("COMPUTED + {group}"),
        }
    }
}
