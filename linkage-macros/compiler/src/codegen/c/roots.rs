//! The functions that find roots: a trial, which computes both sides and the slope of an equation, and the search
//! that calls it, which is the run-time's.

use super::In;
use super::c_identifiers::{Width, ascii};
use super::c_names::{PARAMETERS, param, quoted};
use super::in_c::InC;
use super::two_paths::indented;
use crate::codegen::identifiers::text;
use crate::codegen::printer::{Dialect, Printer};
use crate::codegen::text::Text;
use crate::ir::graph::Id;
use crate::lower::TRIAL;
use crate::lower::routine::{Instruction, Search};
use crate::lower::used::{Asks, Used};

impl<'a> In<'a> {
    /// The functions of the roots that printed routines ask for.
    pub(super) fn roots(self, to: &mut String) {
        for search in &self.lowered.searches {
            if self.is_searched(search) {
                self.trial(search, to);
                self.root(search, to);
            }
        }
    }

    fn is_searched(self, search: &Search) -> bool {
        let stages = self.lowered.routines.iter().flat_map(|routine| &routine.stages);
        stages.flat_map(|stage| &stage.statements).any(|statement| {
            matches!(statement, Instruction::Solve(solving) if solving.implicit == search.implicit)
        })
    }

    pub(super) fn root_name(self, search: &Search) -> String {
        self.name_of("", search)
    }

    fn trial_name(self, search: &Search) -> String {
        self.name_of("_trial", search)
    }

    /// The name of a function of a search. It ends in the unknown's, and one may be called `x`, another `xf` or
    /// `x_trial`.
    fn name_of(self, action: &str, search: &Search) -> String {
        let width = if self.width == Width::Single { "_f32" } else { "" };
        let name = ascii(search.routine.name.trim_end_matches('_'));
        format!("{}{action}{width}_{name}", self.stem)
    }

    fn trial(self, search: &Search, to: &mut String) {
        let used = Used::on(self.lowered, &search.routine, Asks::Compares);
        let printer = self.printer(search, &used);
        let mut lines = Text::default();
        self.given(&printer, search, |id| used.reads(id), &mut lines);
        for stage in &used.stages {
            printer.statements(stage, &mut lines);
        }
        for (nth, &side) in search.sought.sides.iter().enumerate() {
            lines.put(&format!("sides[{nth}] = "));
            printer.value(side, &mut lines);
            lines.put(";\n");
        }
        // Equations that nothing given changes, or no trial.
        lines.put(&format!("(void)given;\n(void){TRIAL};\n"));
        let (name, real) = (self.trial_name(search), self.real());
        *to += &format!(
            "\nstatic void {name}(const {real} *given, {real} {TRIAL}, {real} *sides)\n{{\n{}}}\n",
            indented(lines.as_str())
        );
    }

    fn root(self, search: &Search, to: &mut String) {
        let used = Used::on(self.lowered, &search.routine, Asks::Compares);
        let (printer, sought) = (self.printer(search, &used), &search.sought);
        let graph = &self.lowered.program.graph;
        let places = || sought.between.into_iter().chain(sought.near);
        let is_read =
            |id: Id| places().any(|place| search.routine.reading(graph, place).local() == Some(id));
        let mut lines = Text::default();
        self.given(&printer, search, is_read, &mut lines);
        let [from, to_end] = sought.between.map(|end| printer.value_alone(end));
        let near = sought.near.map(|near| printer.value_alone(near));
        let (near, has_near) = match &near {
            Some(near) => (near.as_str(), 1),
            None => (from.as_str(), 0),
        };
        let sign = sought.trend.sign().map(|sign| self.number(sign, sign as f32));
        let chosen =
            if sign.is_none() { format!("{} trend, ", self.real()) } else { String::new() };
        let trend = sign.unwrap_or_else(|| "trend".to_string());
        let (ending, is_turn) = (self.ending(), u8::from(search.checks_span_at_run_time));
        let is_steady = u8::from(search.is_steady());
        let unknown = &self.mechanism.unknowns[sought.unknown as usize];
        let unknown = self.mechanism.title_of_unknown(unknown);
        let [name, trial] = [self.root_name(search), self.trial_name(search)];
        let (real, unknown) = (self.real(), quoted(unknown));
        lines.put(&format!(
            "const LinkageBetween{ending} between = {{ {}, {}, {trend}, {near}, {has_near}, {is_turn}, {is_steady} }};\n\
             return linkage_root{ending}(why, {unknown}, &between, {trial}, given, found);\n",
            from.as_str(),
            to_end.as_str(),
        ));
        *to += &format!(
            "\nstatic int {name}(LinkageWhy *why, {chosen}const {real} *given, {real} *found)\n{{\n{}}}\n",
            indented(lines.as_str())
        );
    }

    fn printer<'p>(self, search: &'p Search, used: &'p Used) -> Printer<'p, InC<'p>>
    where
        'a: 'p,
    {
        let (asks, binding) = (Asks::Compares, self.width.binding());
        let dialect = InC { to: self, given: &[], asks, used, binding };
        Printer { lowered: self.lowered, routine: &search.routine, dialect }
    }

    /// Binds the values that no trial changes and that are read.
    fn given(
        self,
        printer: &Printer<'_, InC<'_>>,
        search: &Search,
        is_read: impl Fn(Id) -> bool,
        to: &mut Text,
    ) {
        for (nth, &id) in search.given.iter().enumerate().filter(|&(_, &id)| is_read(id)) {
            to.put(printer.dialect.binding()).put(&printer.local(id));
            to.put(&format!(" = given[{nth}];\n"));
        }
    }

    /// The trend that is passed to a search, where a parameter chooses it.
    pub(super) fn chosen_trend(self, search: &Search) -> String {
        let Some(of) = search.sought.trend.param() else { return String::new() };
        let mechanism = self.mechanism;
        let field = param(mechanism, &text(&mechanism.params[of as usize].name));
        format!("({}){PARAMETERS}->{field}, ", self.real())
    }
}
