//! The functions behind an entry point: its core, which compares, and its diagnosis.

use super::In;
use super::c_identifiers::default;
use super::c_names::{is_array, quoted};
use super::two_paths::{Destination, indented};
use crate::codegen::printer::sum;
use crate::interface::entries::{ArgumentKind, Entry};
use crate::interface::records::Shape;
use crate::interface::{EntryId, labels};
use crate::ir::graph::Node;
use crate::lower::label;
use crate::lower::routine::{Bound, Compute, Finite, FinitenessChecks, Routine};
use crate::lower::used::Asks;
use crate::model::mechanism::{ParamKind, Sign};

/// The end of a diagnosis that something has refused.
pub(super) const REFUSED: &str =
    "if (why.status != LINKAGE_OK) {\nreturn linkage_refused(&why, error);\n}\n";

impl In<'_> {
    pub(super) fn core_name(self, entry: &Entry) -> String {
        format!("{}_try_{}{}", self.stem, entry.name(), self.ending())
    }

    pub(super) fn diagnosis_name(self, entry: &Entry) -> String {
        format!("{}_why_{}{}", self.stem, entry.name(), self.ending())
    }

    /// The fast path of an entry point that has formulas of its own.
    pub(super) fn core(self, id: EntryId, to: &mut String) {
        let Compute::Own { routine, stage, asked } = self.lowered.compute(id) else { return };
        let (entry, routine) = (self.interface().entry(id), &self.lowered.routines[*routine]);
        let mut list = self.declared(&entry.given);
        if self.lowered.takes_square(id) {
            list.push(format!("{} square", self.real()));
        }
        list.push(self.returned(entry.result, "to"));
        let mut body = self.earlier_results(routine, *stage);
        let call =
            self.call(routine, *stage, Asks::Compares, &entry.given, Destination::Pointer("to"));
        match &asked.finite {
            None => body += &format!("return {call};\n"),
            Some(finite) => {
                body += &format!("int ok = {call};\n");
                self.finite(entry, finite)
                    .iter()
                    .for_each(|test| body += &format!("ok &= {test};\n"));
                body += "return ok;\n";
            }
        }
        *to += &format!(
            "\nstatic LINKAGE_INLINE int {}({})\n{{\n{}}}\n",
            self.core_name(entry),
            list.join(", "),
            indented(&body)
        );
    }

    /// The tests that every number of a result is finite.
    fn finite(self, entry: &Entry, finite: &Finite) -> Vec<String> {
        let components = self.components_behind(entry.result, "to");
        let ending = self.ending();
        let sum = format!("linkage_is_finite{ending}({})", sum(&finite.sum, &components));
        let Some(([wide, narrow], bounds)) = &finite.instead else { return vec![sum] };
        let kept = bounds.iter().map(|bound| self.kept(&entry.given, bound));
        let is_plain = if ending.is_empty() { wide } else { narrow };
        kept.chain((!is_plain).then_some(sum)).collect()
    }

    /// A comparison of inputs with a limit.
    fn kept(self, given: &[ArgumentKind], bound: &Bound) -> String {
        let read = |node| self.leaf(given, node).expect("what is asked is given");
        let ending = self.ending();
        match *bound {
            Bound::Within { value, limit } => {
                format!("linkage_is_within{ending}({}, {})", read(value), self.limit(limit))
            }
            Bound::WithRate { rate, second, limit } => {
                let (rate, second, limit) = (read(rate), read(second), self.limit(limit));
                format!(
                    "linkage_is_within{ending}({second}, linkage_fused{ending}(-{rate}, {rate}, {limit}))"
                )
            }
            Bound::OnCircle { rate, second, limit } => {
                let limit = self.limit(limit);
                let squares = match rate.map(read) {
                    Some(rate) => format!("linkage_fused{ending}({rate}, {rate}, square)"),
                    None => "square".to_string(),
                };
                match second.map(read) {
                    Some(second) => format!(
                        "{limit} >= linkage_fused{ending}({squares}, {squares}, {second} * {second})"
                    ),
                    None => format!("{limit} >= {squares}"),
                }
            }
        }
    }

    /// The slow path of such an entry point. It writes the result where there is one.
    pub(super) fn diagnosis(self, id: EntryId, to: &mut String) {
        let Compute::Own { routine, stage, asked } = self.lowered.compute(id) else { return };
        let (entry, routine) = (self.interface().entry(id), &self.lowered.routines[*routine]);
        let mut list = self.declared(&entry.given);
        list.push(self.returned(entry.result, "to"));
        list.push("LinkageError *error".to_string());
        let is_single = usize::from(!self.ending().is_empty());
        let mut body = format!("LinkageWhy why = linkage_why({is_single});\n");
        body += &self.earlier_results(routine, *stage);
        body += &format!("{};\n", self.result(entry.result, "found"));
        let checked = self.given_finite(&entry.given, &asked.given, &mut body);
        let found = Destination::Local("found");
        let call = self.call(routine, *stage, Asks::Diagnoses, &entry.given, found);
        body += &format!("{call};\n");
        body += &self.results_finite(entry, asked, &checked);
        if entry.point.row().is_known_in_part {
            body += &self.in_part(entry, routine, *stage);
        }
        body += REFUSED;
        body += &self.copied(entry.result, "found", "to");
        body += "return LINKAGE_OK;\n";
        *to += &format!(
            "\nstatic LINKAGE_COLD LinkageStatus {}({})\n{{\n{}}}\n",
            self.diagnosis_name(entry),
            list.join(", "),
            indented(&body)
        );
    }

    /// The numbers where a group has no pose: NaN behind it, the others as they are.
    fn in_part(self, entry: &Entry, routine: &Routine, stage: usize) -> String {
        let (is_single, real) = (usize::from(!self.ending().is_empty()), self.real());
        let call = |found| {
            let to = Destination::Local(found);
            self.call(routine, stage, Asks::Diagnoses, &entry.given, to)
        };
        let [found, possible] = ["found", "possible"].map(|of| self.components(entry.result, of));
        let count = found.len();
        let mut text = format!(
            "if (linkage_lacks_a_pose(&why)) {{\nconst LinkageWhy refusal = why;\n{};\nint is_open;\n\
             LinkageWide told[{count}], others[{count}];\n\
             why = linkage_why_behind({is_single}, (LinkageWide)NAN);\n{};\nis_open = why.is_open;\n\
             why = linkage_why_behind({is_single}, 1);\n{};\n",
            self.result(entry.result, "possible"),
            call("found"),
            call("possible"),
        );
        for (at, (found, possible)) in found.iter().zip(&possible).enumerate() {
            text += &format!("told[{at}] = {found};\nothers[{at}] = {possible};\n");
            text += &format!("{found} = {found} == {found} ? {found} : ({real})NAN;\n");
        }
        text + &format!(
            "if (is_open || !linkage_is_told(told, others, {count})) {{\nwhy = refusal;\n}}\n}}\n"
        )
    }

    /// The test that what is given is finite, and the list of it with its length, as the run-time takes it.
    pub(super) fn given_finite(
        self,
        given: &[ArgumentKind],
        asked: &[Node],
        to: &mut String,
    ) -> String {
        let list = match self.named_given(given, asked, to) {
            0 => "NULL, 0".to_string(),
            count => format!("given, {count}"),
        };
        *to += &format!("linkage_given_finite(&why, {list});\n{REFUSED}");
        list
    }

    /// The list of what is given that has to be finite, and its length.
    fn named_given(self, given: &[ArgumentKind], asked: &[Node], to: &mut String) -> usize {
        let named = |&node: &Node| {
            let value = self.leaf(given, node)?;
            Some((value, label(self.mechanism, node)?))
        };
        let named: Vec<_> = asked.iter().filter_map(named).collect();
        if !named.is_empty() {
            *to += &format!("LinkageNamed given[{}];\n", named.len());
        }
        named.iter().enumerate().for_each(|(at, (value, name))| set(at, "given", value, name, to));
        named.len()
    }

    /// The test that the results are finite.
    fn results_finite(self, entry: &Entry, asked: &FinitenessChecks, given: &str) -> String {
        let components = self.components(entry.result, "found");
        let all = labels::of_result(self.interface(), self.mechanism, entry);
        let wanted: Vec<usize> = match entry.result {
            Shape::Record(_) => (0..components.len()).collect(),
            _ => asked.results.clone(),
        };
        if wanted.is_empty() {
            return format!("linkage_results_finite(&why, NULL, 0, {given});\n");
        }
        let count = wanted.len();
        let mut text = format!("{{\nLinkageNamed results[{count}];\n");
        for (nth, &at) in wanted.iter().enumerate() {
            set(nth, "results", &components[at], &all[at], &mut text);
        }
        text + &format!("linkage_results_finite(&why, results, {count}, {given});\n}}\n")
    }

    /// A result whose numbers are copied one by one: a compiler keeps them in registers, and writes each once.
    pub(super) fn put(self, shape: Shape, from: &str, to: &str) -> String {
        let pairs = self.components_behind(shape, to).into_iter().zip(self.components(shape, from));
        pairs.map(|(to, from)| format!("{to} = {from};\n")).collect()
    }

    fn copied(self, shape: Shape, from: &str, to: &str) -> String {
        if !is_array(shape) {
            return format!("*{to} = {from};\n");
        }
        let pairs = self.components(shape, to).into_iter().zip(self.components(shape, from));
        pairs.map(|(to, from)| format!("{to} = {from};\n")).collect()
    }

    /// The function that returns the parameters as declared.
    pub(super) fn defaults(self, to: &mut String) {
        let mechanism = self.mechanism;
        if !self.has_params() {
            return;
        }
        let (ty, name) = (self.params_type(), default(&mechanism.name, self.width));
        let values = mechanism.params.iter().map(|param| match &param.kind {
            ParamKind::Number { default, .. } => self.number(default.to_f64(), default.to_f32()),
            ParamKind::Mode { default: Sign::Plus, .. } => "1".to_string(),
            ParamKind::Mode { default: Sign::Minus, .. } => "-1".to_string(),
        });
        let values: Vec<String> = values.collect();
        *to += &format!(
            "\n{ty} {name}(void)\n{{\n    const {ty} declared = {{ {} }};\n    return declared;\n}}\n",
            values.join(", ")
        );
    }
}

/// A line that names a number.
fn set(at: usize, list: &str, value: &str, name: &str, to: &mut String) {
    *to += &format!("{list}[{at}].value = {value};\n{list}[{at}].name = {};\n", quoted(name));
}
