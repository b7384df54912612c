//! The values that one path of a routine reads. The fast path compares a condition's value, the slow path looks
//! at its operands: a language that writes a routine once for each path writes for each what it reads.

use super::routine::{Instruction, Lowered, Reading, Routine, Stage};
use crate::ir::graph::{Id, Node};
use crate::ir::hash::Set;

/// A path of a routine.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Asks {
    /// The fast path, which compares.
    Compares,
    /// The slow path, which diagnoses.
    Diagnoses,
}

/// The part of a routine that one path reads.
pub(crate) struct Used {
    /// The statements of each stage, without those that bind what nothing reads, and without clearances.
    pub stages: Vec<Vec<Instruction>>,
    locals: Set<Id>,
    leaves: Vec<Node>,
    constants: Set<Node>,
}

impl Used {
    pub(crate) fn on(lowered: &Lowered<'_>, routine: &Routine, asks: Asks) -> Self {
        let walk = Backwards { lowered, routine, asks, used: Self::nothing() };
        let sinks = routine.stages.iter().map(|stage| &stage.sinks[..]).collect::<Vec<_>>();
        Self::backwards(walk, &sinks)
    }

    /// What the fast path of a stage reads for these results alone.
    pub(crate) fn of_results(
        lowered: &Lowered<'_>,
        routine: &Routine,
        stage: usize,
        sinks: &[Id],
    ) -> Self {
        let walk = Backwards { lowered, routine, asks: Asks::Compares, used: Self::nothing() };
        let mut of_stages = vec![&[][..]; stage];
        of_stages.push(sinks);
        Self::backwards(walk, &of_stages)
    }

    /// The walk over as many stages as there are lists of results.
    fn backwards(mut walk: Backwards<'_>, sinks: &[&[Id]]) -> Self {
        let mut stages: Vec<Vec<Instruction>> = Vec::new();
        for (stage, sinks) in walk.routine.stages.iter().zip(sinks).rev() {
            sinks.iter().for_each(|&sink| walk.value(sink));
            let mut kept: Vec<Instruction> = Vec::new();
            for statement in stage.statements.iter().rev() {
                if walk.needs(statement) {
                    walk.statement(statement);
                    kept.push(statement.clone());
                }
            }
            kept.reverse();
            stages.push(kept);
        }
        stages.reverse();
        bind_once(&mut stages);
        Self { stages, ..walk.used }
    }

    fn nothing() -> Self {
        let (locals, constants) = (Set::default(), Set::default());
        Self { stages: Vec::new(), locals, leaves: Vec::new(), constants }
    }

    pub(crate) fn reads(&self, local: Id) -> bool {
        self.locals.contains(&local)
    }

    pub(crate) fn leaves(&self) -> &[Node] {
        &self.leaves
    }

    pub(crate) fn reads_constant(&self, constant: Node) -> bool {
        self.constants.contains(&constant)
    }
}

/// The statements of each stage for a language in which a name is bound once.
pub(crate) fn bound_once(stages: &[Stage]) -> Vec<Vec<Instruction>> {
    let mut stages: Vec<_> = stages.iter().map(|stage| stage.statements.clone()).collect();
    bind_once(&mut stages);
    stages
}

/// A stage that needs the sine of an angle whose cosine an earlier one has bound binds both: here the sine
/// alone, as few languages let a name be bound again.
fn bind_once(stages: &mut [Vec<Instruction>]) {
    let mut bound = Set::default();
    let mut binds = |statement: &mut Instruction| {
        let Instruction::SinCos { sin, cos, .. } = statement else { return true };
        for part in [&mut *sin, &mut *cos] {
            *part = part.filter(|&id| bound.insert(id));
        }
        sin.is_some() || cos.is_some()
    };
    stages.iter_mut().for_each(|stage| stage.retain_mut(&mut binds));
}

/// A walk from the results to what they are made of.
struct Backwards<'a> {
    lowered: &'a Lowered<'a>,
    routine: &'a Routine,
    asks: Asks,
    used: Used,
}

impl Backwards<'_> {
    /// True if the statement binds something that is read, or asks something.
    fn needs(&self, statement: &Instruction) -> bool {
        let reads = |id: &Id| self.used.reads(*id);
        match statement {
            Instruction::Let(id) => reads(id),
            Instruction::SinCos { sin, cos, is_checked, .. } => {
                *is_checked || sin.iter().chain(cos).any(reads)
            }
            Instruction::Length { id, .. } => self.asks == Asks::Compares || reads(id),
            Instruction::Check(condition) => {
                let compares = condition.comparison.is_some() || condition.above_rounding.is_some();
                self.asks == Asks::Diagnoses
                    || condition.check.is_of_both_paths()
                    || compares
                    || reads(&condition.id)
            }
            Instruction::Solve(_) => true,
            Instruction::ReportClearances { .. } => false,
        }
    }

    fn statement(&mut self, statement: &Instruction) {
        match statement {
            Instruction::Let(id) | Instruction::Length { id, .. } => self.operands(*id),
            Instruction::SinCos { angle, .. } => self.value(*angle),
            Instruction::Check(condition) => {
                self.value(condition.value);
                let reads = condition.check.is_of_both_paths()
                    || self.asks == Asks::Diagnoses && condition.check.row().reads_operands;
                if reads {
                    condition.operands.iter().for_each(|&operand| self.value(operand));
                }
                if self.asks == Asks::Compares {
                    condition.above_rounding.into_iter().for_each(|spread| self.value(spread));
                }
            }
            Instruction::Solve(solving) => {
                let compared = solving.compares.as_ref().filter(|_| self.asks == Asks::Compares);
                compared.unwrap_or(&solving.reads).iter().for_each(|&id| self.value(id));
                let chosen_by = self.lowered.implicit(solving).chosen_by();
                self.used.leaves.extend(chosen_by.map(Node::Param));
            }
            Instruction::ReportClearances { .. } => {}
        }
    }

    fn value(&mut self, id: Id) {
        let reading = self.routine.reading(&self.lowered.program.graph, id);
        self.reading(&reading);
    }

    fn reading(&mut self, reading: &Reading) {
        match reading {
            Reading::Leaf(node) => self.used.leaves.push(*node),
            Reading::Constant(node) => {
                self.used.constants.insert(*node);
            }
            Reading::Negated(inner) => self.reading(inner),
            Reading::Local(id) => {
                self.used.locals.insert(*id);
            }
            Reading::Nested(id) => self.operands(*id),
        }
    }

    fn operands(&mut self, id: Id) {
        let node = self.lowered.program.graph.node(id);
        if let Node::Mode(param) = node {
            self.used.leaves.push(Node::Param(param));
        }
        let mut operands = Vec::new();
        node.for_operands(&mut |operand| operands.push(operand));
        operands.into_iter().for_each(|operand| self.value(operand));
    }
}
