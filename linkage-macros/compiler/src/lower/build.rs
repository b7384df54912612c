//! A program made into routines.

use super::nesting::{nest, reads};
use super::overflow::Overflow;
use super::plan::{Plan, Strategy};
use super::routine::{
    ArgumentAdapter, Compute, FinitenessChecks, Instruction, Locals, Lowered, Routine, Search,
    Stage,
};
use super::schedule::{Schedule, defines};
use super::searches::searches;
use super::witnesses::witnesses;
use super::{constants, input_limits, locals};
use crate::interface::entries::ArgumentKind;
use crate::interface::records::Shape;
use crate::interface::{EntryId, Interface};
use crate::ir::cost::{Costs, Operations};
use crate::ir::graph::{Graph, Id, Node};
use crate::ir::hash::Set;
use crate::ir::liveness::{Path, live, live_nodes, tried};
use crate::ir::program::{Clearance, Liveness, Program};
use crate::lower::routine::is_leaf;
use crate::model::mechanism::Mechanism;

/// The routines of everything that the program has answers for.
pub fn lower<'p>(mechanism: &Mechanism, program: &'p Program) -> Lowered<'p> {
    let points = program.answers.iter().filter_map(|answer| answer.entry);
    let interface = Interface::of(mechanism).limited_to(points);
    let (plan, locals) = (Plan::of(&interface), locals::named(mechanism, program));
    let tried = tried(&program.graph);
    let of_nodes = Costs::of(&program.graph, &tried);
    let searches = searches(mechanism, program, "root", (&tried, &of_nodes));
    let needs = program.answers.iter().map(|answer| Liveness::of(program, &answer.sinks)).collect();
    let builder = Builder { program, interface, locals, searches, tried: &tried, needs };
    let overflows: Vec<_> = plan.routines.iter().map(|entries| builder.overflow(entries)).collect();
    let routines = plan.routines.iter().zip(&overflows);
    let routines = routines.map(|(entries, overflow)| builder.routine(entries, overflow.as_ref()));
    let routines = routines.collect();
    let ids: Vec<EntryId> = builder.interface.ids().collect();
    let costs = ids.iter().map(|&id| builder.cost(id, &plan, &of_nodes)).collect();
    let entries = ids.iter().map(|&id| match plan.strategies[id.index()] {
        Strategy::Delegate { entry, given } => Compute::Delegate { entry, given },
        Strategy::Own { routine, stage } => {
            let asked = builder.asked(id, overflows[routine].as_ref());
            Compute::Own { routine, stage, asked }
        }
    });
    let (entries, clearances) = (entries.collect(), builder.clearances());
    let Builder { interface, searches, .. } = builder;
    Lowered { program, interface, routines, entries, costs, clearances, searches }
}

/// The routine of a placing program that says where everything stands, …
pub const PLACED: usize = 0;
/// … and the one that says which forces are applied, if any are.
pub const APPLIED: usize = 1;

/// The routines of a program that places what is drawn: where everything stands, and the forces on it.
pub fn lower_placing<'p>(mechanism: &Mechanism, program: &'p Program) -> Lowered<'p> {
    // `PLACED` and `APPLIED`.
    let kinds = [("placed_", vec![ArgumentKind::Value]), ("forces_applied_", acting(mechanism))];
    let lists = kinds.into_iter().zip(&program.answers);
    let lists = lists.map(|((name, given), answer)| (name, given, answer.sinks.clone()));
    listed(mechanism, program, Some("placed_root"), lists)
}

/// The routine of a program that says where masses, couples and wheels are drawn. `placing` has a search of each name
/// of its own.
pub fn lower_marks<'p>(mechanism: &Mechanism, program: &'p Program) -> Lowered<'p> {
    let list = ("marked_", acting(mechanism), all_sinks(program));
    listed(mechanism, program, Some("marked_root"), [list])
}

/// The routine of the numbers by which assemblies are listed, which stand in front of every search.
pub fn lower_pinned<'p>(mechanism: &Mechanism, program: &'p Program) -> Lowered<'p> {
    let list = ("pinned_", vec![ArgumentKind::Value], all_sinks(program));
    listed(mechanism, program, None, [list])
}

fn all_sinks(program: &Program) -> Vec<Id> {
    program.answers.iter().flat_map(|answer| answer.sinks.iter().copied()).collect()
}

/// Routines by name, what they are given, and the numbers that they return. Where they search, what a search is called,
/// and clearances as well.
fn listed<'p, 'n>(
    mechanism: &Mechanism,
    program: &'p Program,
    root: Option<&str>,
    lists: impl IntoIterator<Item = (&'n str, Vec<ArgumentKind>, Vec<Id>)>,
) -> Lowered<'p> {
    // There are no entry points: the records of the solver's own are enough.
    let interface = Interface::of(mechanism).limited_to(std::iter::empty());
    // The solver's own searches are given other values: those of its own graph.
    let tried = tried(&program.graph);
    let searches = root.map(|root| {
        searches(mechanism, program, root, (&tried, &Costs::of(&program.graph, &tried)))
    });
    let (locals, needs, searches) = (Locals::default(), Vec::new(), searches.unwrap_or_default());
    let builder = Builder { program, interface, locals, searches, tried: &tried, needs };
    let routines = lists.into_iter();
    let routines =
        routines.map(|(name, given, sinks)| builder.listing(name, &given, Path::Slow, &sinks));
    let routines = routines.collect();
    let clearances = root.and_then(|_| builder.clearances());
    let Builder { interface, searches, .. } = builder;
    let (entries, costs) = (Vec::new(), Vec::new());
    Lowered { program, interface, routines, entries, costs, clearances, searches }
}

/// The arguments of what acts.
fn acting(mechanism: &Mechanism) -> Vec<ArgumentKind> {
    let drives = mechanism.dynamics.driven().map(|_| ArgumentKind::Drives);
    let loads = (!mechanism.dynamics.loads.is_empty()).then_some(ArgumentKind::Loads);
    [ArgumentKind::Value, ArgumentKind::Rate].into_iter().chain(drives).chain(loads).collect()
}

/// Puts clearances behind the last statement of the stage that they need. Operands used only by clearances
/// belong to them: a later statement that needs one computes it again.
fn tell(schedule: &Schedule<'_>, clearances: &[Id], stage: &mut Vec<Instruction>) {
    let statements = schedule.clone().stage(&live(schedule.graph, clearances, schedule.path));
    let told = Instruction::ReportClearances { statements, clearances: clearances.to_vec() };
    let mut needed = Set::default();
    schedule.for_uses(&told, &mut |id| {
        needed.insert(id);
    });
    let is_needed = |id: &Id| needed.contains(id);
    let last = stage.iter().rposition(|statement| defines(statement).iter().any(is_needed));
    stage.insert(last.map_or(0, |last| last + 1), told);
}

struct Builder<'p> {
    program: &'p Program,
    interface: Interface,
    locals: Locals,
    searches: Vec<Search>,
    /// Nodes that only a search computes.
    tried: &'p [bool],
    /// The nodes that each answer of the program needs.
    needs: Vec<Liveness>,
}

impl Builder<'_> {
    fn graph(&self) -> &Graph {
        &self.program.graph
    }

    fn sinks(&self, entry: EntryId) -> &[Id] {
        &self.program.answers[entry.index()].sinks
    }

    fn needs(&self, entry: EntryId) -> &Liveness {
        &self.needs[entry.index()]
    }

    /// The last stage is everything that a routine computes.
    fn overflow(&self, entries: &[EntryId]) -> Option<Overflow> {
        let last = *entries.last()?;
        Overflow::of(self.graph(), self.sinks(last), &self.needs(last).fast)
    }

    fn routine(&self, entries: &[EntryId], overflow: Option<&Overflow>) -> Routine {
        let last = *entries.last().expect("a routine has a stage");
        let given = self.interface.entry(last).given.clone();
        let name = match (entries, given.first()) {
            ([only], _) => format!("formulas_{}_", self.interface.entry(*only).name()),
            (_, Some(ArgumentKind::Cosine)) => "formulas_at_".to_string(),
            _ => "formulas_".to_string(),
        };
        let (graph, searches, fast) = (self.graph(), &self.searches, &self.needs(last).fast);
        let (locals, tried) = (&self.locals, self.tried);
        let mut schedule =
            Schedule::new(graph, locals, Path::Slow, overflow, searches, tried, fast);
        let clear = self.clear_in(entries);
        let mut statements: Vec<Vec<Instruction>> = Vec::new();
        for &entry in entries {
            let mut stage = schedule.stage(&self.needs(entry).slow);
            if statements.is_empty() && !clear.is_empty() {
                tell(&schedule, &clear, &mut stage);
            }
            statements.push(stage);
        }
        let mut locals =
            locals::with_letters(&self.locals, self.graph(), statements.iter().flatten());
        let reads = reads(&schedule, &statements, self.sinks(last));
        let result = self.interface.entry(last).result;
        let mut stages = Vec::new();
        let mut rest = self.sinks(last);
        for (shape, statements) in self.parts(entries, result).into_iter().zip(statements) {
            let (sinks, further) = rest.split_at(self.interface.numbers(shape));
            let statements = nest(&schedule, &reads, &mut locals, statements);
            stages.push(Stage { result: shape, sinks: sinks.to_vec(), statements });
            rest = further;
        }
        let tells = !clear.is_empty();
        let Schedule { reads, has_checks, path, .. } = schedule;
        let constants = constants::shared(graph, &locals, &stages);
        Routine { name, given, result, path, stages, tells, reads, has_checks, locals, constants }
    }

    /// Values and scales of clearances, where they are functions of the pose and these are its formulas.
    fn clear_in(&self, entries: &[EntryId]) -> Vec<Id> {
        let is_posed = |clearance: &&Clearance| entries.len() > 1 && clearance.rates.is_none();
        self.program.clearances.iter().filter(is_posed).flat_map(Clearance::sinks).collect()
    }

    /// Shape that each stage adds to the result: with several stages, a field of its record.
    fn parts(&self, entries: &[EntryId], result: Shape) -> Vec<Shape> {
        match (entries, result) {
            ([_, _, ..], Shape::Record(record)) => {
                self.interface.record(record).fields.iter().map(|field| field.shape).collect()
            }
            _ => vec![result],
        }
    }

    /// A routine without checks, because out of reach is a number below zero here.
    fn clearances(&self) -> Option<Routine> {
        let has_rates = self.program.clearances.iter().any(|clearance| clearance.rates.is_some());
        let sinks: Vec<Id> = self.program.clearances.iter().flat_map(Clearance::sinks).collect();
        let given = &[ArgumentKind::Value, ArgumentKind::Rate];
        has_rates.then(|| self.listing("clearances", given, Path::Unchecked, &sinks))
    }

    /// A routine that returns the sinks in a list.
    fn listing(&self, name: &str, given: &[ArgumentKind], path: Path, sinks: &[Id]) -> Routine {
        let (graph, locals, searches) = (self.graph(), &self.locals, &self.searches);
        // A routine without checks asks for no conditions.
        let (live, fast) = match path {
            Path::Unchecked => (live(graph, sinks, path), Vec::new()),
            Path::Fast | Path::Slow => {
                let Liveness { slow, fast, .. } = Liveness::of(self.program, sinks);
                (slow, fast)
            }
        };
        let mut schedule = Schedule::new(graph, locals, path, None, searches, self.tried, &fast);
        let statements = schedule.stage(&live);
        let mut locals = locals::with_letters(&self.locals, self.graph(), &statements);
        let reads = reads(&schedule, std::slice::from_ref(&statements), sinks);
        let statements = nest(&schedule, &reads, &mut locals, statements);
        let Schedule { reads, has_checks, path, .. } = schedule;
        let result = Shape::List(sinks.len());
        let stages = vec![Stage { result, sinks: sinks.to_vec(), statements }];
        let constants = constants::shared(self.graph(), &locals, &stages);
        let (name, given, tells) = (name.to_string(), given.to_vec(), false);
        Routine { name, given, result, path, stages, tells, reads, has_checks, locals, constants }
    }

    fn asked(&self, entry: EntryId, overflow: Option<&Overflow>) -> FinitenessChecks {
        let (graph, sinks) = (self.graph(), self.sinks(entry));
        let place = |id| sinks.iter().position(|&sink| sink == id);
        let needs = self.needs(entry);
        let read =
            live_nodes(graph, &needs.slow).map(|(_, node)| node).filter(|&node| is_leaf(node));
        let mut seen = Set::default();
        let is_known = |id| matches!(graph.node(id), Node::Constant(_) | Node::Mode(_));
        let results = sinks.iter().enumerate();
        let results = results.filter(|&(_, &sink)| !is_known(sink) && seen.insert(sink));
        let witnesses: Vec<usize> = witnesses(graph, sinks).into_iter().filter_map(place).collect();
        let limits = overflow.map(|overflow| overflow.limits(graph, sinks, &needs.fast));
        let takes_cosine = self.interface.entry(entry).takes_cosine();
        FinitenessChecks {
            finite: input_limits::finite(&witnesses, limits, takes_cosine),
            given: read.collect(),
            results: results.map(|(at, _)| at).collect(),
        }
    }

    /// Cost of an entry point. One that goes by the angle's cosine and sine makes them first.
    fn cost(&self, entry: EntryId, plan: &Plan, of_nodes: &Costs<'_>) -> Operations {
        let way = |entry: EntryId| plan.strategies[entry.index()];
        let mut cost = of_nodes.operations(&self.needs(entry).counted);
        let last = match way(entry) {
            Strategy::Delegate { entry, given: ArgumentAdapter::UnitRate } => way(entry),
            other => other,
        };
        cost.sines += u32::from(matches!(
            last,
            Strategy::Delegate { given: ArgumentAdapter::CosineAndSine, .. }
        ));
        cost
    }
}
