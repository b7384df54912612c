//! The public function of an entry point: it tests what C may get wrong, asks the core, and where that says no,
//! the diagnosis.

use super::In;
use super::c_identifiers::{PARAMETERS as MECHANISM, arguments, function};
use super::c_names::{is_array, param, quoted};
use super::two_paths::indented;
use crate::codegen::arguments::{Arguments, Form};
use crate::codegen::identifiers::text;
use crate::interface::EntryId;
use crate::interface::entries::Entry;
use crate::lower::routine::{ArgumentAdapter, Compute};
use crate::model::mechanism::{Mechanism, ParamKind};

impl In<'_> {
    /// The public function.
    pub(super) fn entry(self, id: EntryId, to: &mut String) {
        let entry = self.interface().entry(id);
        let call = PublicFunction::new(self, id);
        let mut body = String::new();
        match self.lowered.compute(id) {
            Compute::Delegate { entry: velocity, given: ArgumentAdapter::UnitRate } => {
                call.at_unit_rate(self.interface().entry(*velocity), &mut body);
            }
            Compute::Delegate { entry: other, given: ArgumentAdapter::CosineAndSine } => {
                call.begin(&mut body);
                call.by_angle(*other, &mut body);
            }
            Compute::Own { .. } if entry.takes_cosine() => {
                call.begin(&mut body);
                call.on_circle(id, &mut body);
            }
            Compute::Own { .. } => {
                call.begin(&mut body);
                call.plainly(&mut body);
            }
        }
        *to += &format!(
            "\nLinkageStatus {}({})\n{{\n{}}}\n",
            function(&self.mechanism.name, entry, self.width),
            call.declared.join(", "),
            indented(&body)
        );
    }
}

/// The arguments by which a public function takes what it is given, the parameters first where there are any.
pub(super) struct GivenInC {
    /// With their types.
    pub declared: Vec<String>,
    pub names: Vec<String>,
    /// Pointers among them, and what an error calls them: the parameters last.
    pub pointers: Vec<(String, String)>,
}

impl GivenInC {
    /// Those with these names: the parameters', two of others, and those of what is given.
    pub(super) fn of(to: In<'_>, given: &Arguments<'_>, all: &[String]) -> Self {
        let (mut declared, mut names, mut pointers) = (Vec::new(), Vec::new(), Vec::new());
        if to.has_params() {
            declared.push(format!("const {} *{}", to.params_type(), all[0]));
            names.push(all[0].clone());
        }
        for ((argument, form), name) in given.parts().zip(&all[3..]) {
            declared.push(to.declare(&form, name));
            names.push(name.clone());
            if !matches!(form, Form::Number) {
                pointers.push((name.clone(), text(argument)));
            }
        }
        if to.has_params() {
            pointers.push((all[0].clone(), MECHANISM.to_string()));
        }
        Self { declared, names, pointers }
    }
}

/// A public function: its arguments, and names that are none of theirs.
struct PublicFunction<'a> {
    to: In<'a>,
    entry: &'a Entry,
    declared: Vec<String>,
    /// The arguments alone, the parameters first where there are any.
    names: Vec<String>,
    /// Pointers, and what an error calls them.
    pointers: Vec<(String, String)>,
    answer: &'static str,
    /// Names of locals: the result, whether it may be used, a cosine and a sine.
    own: [String; 4],
    /// True if the angle's cosine and sine are made here.
    makes_cosine: bool,
}

impl<'a> PublicFunction<'a> {
    fn new(to: In<'a>, id: EntryId) -> Self {
        let entry = to.interface().entry(id);
        let given = to.signatures.arguments(&entry.given);
        let answer = entry.point.answer();
        let own = ["result", "ok", "cosine", "sine"].map(str::to_string);
        let count = 3 + given.names().len();
        let others = given.names().iter().map(text).chain(own);
        let all = arguments(&to.mechanism.name, [MECHANISM, answer, "error"], others);
        let GivenInC { mut declared, names, mut pointers } = GivenInC::of(to, &given, &all);
        pointers.insert(0, (answer.to_string(), answer.to_string()));
        declared.push(to.returned(entry.result, answer));
        declared.push("LinkageError *error".to_string());
        let own = [0, 1, 2, 3].map(|at| all[count + at].clone());
        let is_via = |by: &Compute| {
            matches!(by, Compute::Delegate { given: ArgumentAdapter::CosineAndSine, .. })
        };
        let makes_cosine = entry.takes_cosine() || is_via(to.lowered.compute(id));
        Self { to, entry, declared, names, pointers, answer, own, makes_cosine }
    }

    /// Locals, and the tests of pointers and modes in the order of the Rust library.
    fn begin(&self, body: &mut String) {
        let [result, ok, cosine, sine] = &self.own;
        let real = self.to.real();
        *body += &format!("{};\nint {ok};\n", self.to.result(self.entry.result, result));
        if self.makes_cosine {
            *body += &format!("{real} {cosine}, {sine};\n");
        }
        self.pointers.iter().for_each(|(name, label)| *body += &pointer_test(name, label));
        if let Some(parameters) = self.names.first() {
            *body += &mode_tests(self.to.mechanism, parameters);
        }
    }

    /// The arguments of an inner function, with a cosine and a sine in the place of the first so many.
    fn by_cosine(&self, first: usize) -> Vec<String> {
        let [_, _, cosine, sine] = &self.own;
        let at = usize::from(self.to.has_params());
        let mut list = self.names.clone();
        list.splice(at..at + first, [cosine.clone(), sine.clone()]);
        list
    }

    /// The arguments and where the core puts the result.
    fn handed(&self, mut list: Vec<String>, square: Option<String>) -> String {
        list.extend(square);
        let by = if is_array(self.entry.result) { "" } else { "&" };
        list.push(format!("{by}{}", self.own[0]));
        list.join(", ")
    }

    fn answered(&self, body: &mut String) {
        let [result, ok, ..] = &self.own;
        *body += &format!("if ({ok}) {{\n");
        *body += &self.to.put(self.entry.result, result, self.answer);
        *body += "return LINKAGE_OK;\n}\n";
    }

    fn diagnosed(&self, own: &Entry, mut list: Vec<String>, body: &mut String) {
        list.extend([self.answer.to_string(), "error".to_string()]);
        *body += &format!("return {}({});\n", self.to.diagnosis_name(own), list.join(", "));
    }

    fn plainly(&self, body: &mut String) {
        let (ok, core) = (&self.own[1], self.to.core_name(self.entry));
        *body += &format!("{ok} = {core}({});\n", self.handed(self.names.clone(), None));
        self.answered(body);
        self.diagnosed(self.entry, self.names.clone(), body);
    }

    fn by_angle(&self, other: EntryId, body: &mut String) {
        let [_, ok, cosine, sine] = &self.own;
        let (ending, own) = (self.to.ending(), self.to.interface().entry(other));
        let angle = &self.names[usize::from(self.to.has_params())];
        let takes_square = self.to.lowered.takes_square(other);
        let square = takes_square.then(|| format!("{angle} * {angle}"));
        let (list, core) = (self.by_cosine(1), self.to.core_name(own));
        *body += &format!("linkage_sin_cos_near{ending}({angle}, &{sine}, &{cosine});\n");
        *body += &format!("{ok} = {core}({});\n", self.handed(list.clone(), square));
        if !takes_square {
            *body += &format!("{ok} &= linkage_is_near{ending}({angle});\n");
        }
        self.answered(body);
        *body += &format!(
            "if (!linkage_is_finite{ending}({angle})) {{\nreturn linkage_because(error, LINKAGE_NOT_FINITE, {});\n}}\n",
            quoted(&self.input())
        );
        *body += &format!("linkage_sin_cos{ending}({angle}, &{sine}, &{cosine});\n");
        self.diagnosed(own, list, body);
    }

    fn on_circle(&self, id: EntryId, body: &mut String) {
        let [_, ok, cosine, sine] = &self.own;
        let (ending, at) = (self.to.ending(), usize::from(self.to.has_params()));
        let (cos, sin) = (&self.names[at], &self.names[at + 1]);
        let takes_square = self.to.lowered.takes_square(id);
        // A sum with −0 is the other number, whatever it is.
        let square = takes_square.then(|| self.to.number(-0.0, -0.0));
        let (list, core) = (self.by_cosine(2), self.to.core_name(self.entry));
        *body += &format!("if (!linkage_on_circle{ending}({cos}, {sin}, &{cosine}, &{sine})) {{\n");
        *body += &format!(
            "return linkage_not_on_circle(error, {cos}, {sin}, {});\n}}\n",
            quoted(&self.input())
        );
        *body += &format!("{ok} = {core}({});\n", self.handed(list.clone(), square));
        self.answered(body);
        self.diagnosed(self.entry, list, body);
    }

    fn input(&self) -> String {
        text(&self.to.mechanism.inputs[0].name)
    }

    /// The velocities at a rate of one, by the public function.
    fn at_unit_rate(&self, velocity: &Entry, body: &mut String) {
        let result = &self.own[0];
        let public = function(&self.to.mechanism.name, velocity, self.to.width);
        *body += &format!("{};\nLinkageStatus status;\n", self.to.result(velocity.result, result));
        *body += &format!(
            "if ({0} == NULL) {{\nreturn linkage_because(error, LINKAGE_NULL_POINTER, {1});\n}}\n",
            self.answer,
            quoted(self.answer)
        );
        let mut list = self.names.clone();
        list.extend([self.to.number(1.0, 1.0), format!("&{result}"), "error".to_string()]);
        *body += &format!("status = {public}({});\n", list.join(", "));
        *body += "if (status == LINKAGE_OK) {\n";
        let places = self.to.components(self.entry.result, self.answer);
        let values = self.to.components(velocity.result, result);
        for (place, value) in places.iter().zip(&values) {
            *body += &format!("{place} = {value};\n");
        }
        *body += "}\nreturn status;\n";
    }
}

/// The test of a pointer, under the name by which an error tells it.
pub(super) fn pointer_test(name: &str, label: &str) -> String {
    format!(
        "if ({name} == NULL) {{\nreturn linkage_because(error, LINKAGE_NULL_POINTER, {});\n}}\n",
        quoted(label)
    )
}

/// The tests of all parameters that are modes, where this points to the parameters.
pub(super) fn mode_tests(mechanism: &Mechanism, parameters: &str) -> String {
    let modes = mechanism.params.iter().filter(|of| matches!(of.kind, ParamKind::Mode { .. }));
    let tests = modes.map(|mode| {
        let name = text(&mode.name);
        let place = format!("{parameters}->{}", param(mechanism, &name));
        format!(
            "if ({place} != 1 && {place} != -1) {{\nreturn linkage_because(error, LINKAGE_INVALID_MODE, {});\n}}\n",
            quoted(&name)
        )
    });
    tests.collect()
}
