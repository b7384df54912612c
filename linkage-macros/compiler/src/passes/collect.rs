//! Collects constant multiples of one value in a sum: c₁ x + y + c₂ x = (c₁ + c₂) x + y.
//!
//! Links that move alike put their weight and inertia into the equations of motion as multiples of
//! one cosine or one square. Written down link by link these stand apart; together they are one.
//!
//! # Where
//! In the equations of motion alone. Formulas of groups state an error that was measured in the form in
//! which they stand, so a sum that answers about motion need as well stays; and so does one whose rounding
//! error is asked for.
//!
//! # Error
//! In units of ε/2 a product c x is off by 2 |c x|, by its constant and by itself; where c is a power
//! of two it is not off at all. Terms are collected where the one product is off by no more than
//! the several were, and where that saves an operation: products of rounded constants always, but x + 0.1 x
//! stays, because 1.1 x is off by more than 0.1 x, which shows where y takes x away.

use std::cell::LazyCell;
use std::cmp::Ordering;

use super::{RULES, contract, in_dynamics};
use crate::exact::Exact;
use crate::interface::entries::EntryPoint;
use crate::ir::construct::{Maker, remade};
use crate::ir::graph::{Graph, Id, Node};
use crate::ir::hash::Map;
use crate::ir::liveness::{Path, live, live_nodes};
use crate::ir::program::{Clearance, Program};

/// The program with the sums of its equations of motion collected; everything else stands where it
/// stood.
pub fn collect_multiples(program: &Program) -> Program {
    // Not looked for where there are no equations of motion.
    let stays = LazyCell::new(|| stays(program));
    // Each answer for itself: what the one uses once, the other may use twice.
    in_dynamics(program, |graph, sinks| {
        Sums::of(&program.graph, sinks, &stays).collected(graph, sinks)
    })
}

/// For every node, whether it is to stay as it is written.
fn stays(program: &Program) -> Vec<bool> {
    let is_about_forces = EntryPoint::is_about_forces;
    let about_motion = program.answers.iter();
    let about_motion = about_motion.filter(|answer| !answer.entry.is_some_and(is_about_forces));
    let about_motion = about_motion.flat_map(|answer| &answer.sinks);
    let clearances = program.clearances.iter().flat_map(Clearance::sinks);
    let closures = program.closures.iter().map(|closure| closure.condition);
    let sinks: Vec<Id> = about_motion.copied().chain(clearances).chain(closures).collect();
    let mut stays = live(&program.graph, &sinks, Path::Slow);
    let asked = contract::asked_for_errors(program);
    stays.iter_mut().zip(asked).for_each(|(stays, asked)| *stays |= asked);
    stays
}

/// The sums of one answer.
struct Sums<'g> {
    graph: &'g Graph,
    stays: &'g [bool],
    /// Number of uses of each node.
    users: Vec<u32>,
    /// True if a node is part of the sum that uses it.
    is_inner: Vec<bool>,
}

/// An operand of a sum that is none itself.
struct Summand {
    /// The part of the sum that it is an operand of, and which operand.
    at: (Id, usize),
    /// The operand, a factor times a value.
    operand: Id,
    factor: Exact,
    value: Id,
    /// True if the sum subtracts the term.
    is_taken: bool,
}

impl<'g> Sums<'g> {
    fn of(graph: &'g Graph, sinks: &[Id], stays: &'g [bool]) -> Self {
        let live = live(graph, sinks, Path::Slow);
        let mut users = vec![0; graph.len()];
        let mut use_once = |id: Id| users[id.index()] += 1;
        sinks.iter().copied().for_each(&mut use_once);
        for (_, node) in live_nodes(graph, &live) {
            graph.for_operands(node, Path::Slow, &mut use_once);
        }
        let mut sums = Self { graph, stays, users, is_inner: vec![false; graph.len()] };
        for (id, _) in live_nodes(graph, &live) {
            for operand in sums.operands(id).into_iter().flatten() {
                let is_inner = sums.operands(operand).is_some() && sums.users[operand.index()] == 1;
                sums.is_inner[operand.index()] |= is_inner;
            }
        }
        sums
    }

    /// The operands of a sum, a difference or a negative that may be collected.
    fn operands(&self, id: Id) -> Option<Vec<Id>> {
        match self.graph.node(id) {
            _ if self.stays[id.index()] => None,
            Node::Add(a, b) | Node::Sub(a, b) => Some(vec![a, b]),
            Node::Neg(a) => Some(vec![a]),
            _ => None,
        }
    }

    /// Makes what changes of the answer anew in the graph, and gives the sinks.
    fn collected(&self, graph: &mut Graph, sinks: &[Id]) -> Vec<Id> {
        remade(graph, sinks, RULES, |maker, id, moved| {
            let instead = self.replacements(id, maker, moved)?;
            Some(self.rebuilt(id, maker, moved, &instead))
        })
    }

    /// The terms of the whole sum, those that are added last first; and its parts, operands first.
    fn terms(&self, root: Id) -> (Vec<Summand>, Vec<Id>) {
        let (mut terms, mut parts) = (Vec::new(), Vec::new());
        // Not by recursion: a sum may be as long as a declaration.
        let mut left = vec![(root, false)];
        while let Some((part, is_taken)) = left.pop() {
            parts.push(part);
            let operands = self.operands(part).expect("only sums have parts");
            let is_difference = !matches!(self.graph.node(part), Node::Add(..));
            let last = operands.len() - 1;
            let mut inner = Vec::new();
            for (place, operand) in operands.into_iter().enumerate() {
                // The last operand of a difference, and the only one of a negative.
                let is_taken = is_taken != (is_difference && place == last);
                if self.is_inner[operand.index()] {
                    inner.push((operand, is_taken));
                    continue;
                }
                let (factor, value) = self.factors(operand);
                terms.push(Summand { at: (part, place), operand, factor, value, is_taken });
            }
            left.extend(inner.into_iter().rev());
        }
        parts.sort();
        (terms, parts)
    }

    fn factors(&self, id: Id) -> (Exact, Id) {
        let one = || Exact::integer(1);
        match self.graph.node(id) {
            Node::Mul(a, b) => match self.graph.as_constant(a) {
                Some(constant) => (constant.clone(), b),
                None => (one(), id),
            },
            Node::Neg(a) if !self.stays[id.index()] => {
                let (factor, value) = self.factors(a);
                (factor.neg(), value)
            }
            _ => (one(), id),
        }
    }

    /// Replacements for terms of the sum, by their places; none where nothing is collected.
    fn replacements(
        &self,
        root: Id,
        maker: &mut Maker<'_>,
        moved: &dyn Fn(Id) -> Id,
    ) -> Option<Map<(Id, usize), Id>> {
        self.operands(root).filter(|_| !self.is_inner[root.index()])?;
        let (terms, _) = self.terms(root);
        let mut of_value: Map<Id, Vec<&Summand>> = Map::default();
        for term in &terms {
            of_value.or_insert(term.value, Vec::new()).push(term);
        }
        let mut instead = Map::default();
        // Where the last of them was added, so that no partial sum holds more than it did. In the order of
        // the sum, so that what is made is the same in every run.
        for (value, equal) in of_value.iter() {
            let Some(factor) = self.together(equal) else { continue };
            let first = if equal[0].is_taken { factor.neg() } else { factor };
            let factor = maker.constant(first);
            let product = maker.make(Node::Mul(factor, moved(*value)));
            let zero = maker.constant(Exact::integer(0));
            instead.extend(equal[1..].iter().map(|term| (term.at, zero)));
            instead.insert(equal[0].at, product);
        }
        (!instead.is_empty()).then_some(instead)
    }

    /// The sum of the factors, where collecting them adds no error and saves an operation.
    fn together(&self, equal: &[&Summand]) -> Option<Exact> {
        if equal.len() < 2 {
            return None;
        }
        let signed = equal.iter().map(|term| match term.is_taken {
            true => term.factor.neg(),
            false => term.factor.clone(),
        });
        let sum = signed.fold(Exact::integer(0), |sum, factor| sum.add(&factor));
        let apart: f64 = equal.iter().map(|term| error(&term.factor)).sum();
        // A product that something else uses is there anyway.
        let products = equal.iter().filter(|term| is_product(&term.factor));
        let mut products: Vec<Id> = products.map(|term| term.operand).collect();
        products.sort();
        let runs = products.chunk_by(|a, b| a == b);
        let saved = runs.filter(|run| self.users[run[0].index()] as usize == run.len()).count();
        let saves = saved + equal.len() - 1 > usize::from(is_product(&sum));
        // Half an ulp of slack for the rounding of these very numbers.
        (saves && error(&sum) <= apart * (1.0 + f64::EPSILON)).then_some(sum)
    }

    /// The sum with what stands in place of its terms.
    fn rebuilt(
        &self,
        root: Id,
        maker: &mut Maker<'_>,
        moved: &dyn Fn(Id) -> Id,
        instead: &Map<(Id, usize), Id>,
    ) -> Id {
        let (_, parts) = self.terms(root);
        let mut made: Map<Id, Id> = Map::default();
        for part in parts {
            let mut place = 0;
            let node = self.graph.node(part).map_operands(&mut |operand| {
                let known = instead.get(&(part, place)).or(made.get(&operand)).copied();
                place += 1;
                known.unwrap_or_else(|| moved(operand))
            });
            made.insert(part, maker.make(node));
        }
        made[&root]
    }
}

/// True if multiplying by the factor is an operation.
fn is_product(factor: &Exact) -> bool {
    factor.first_of(&[0, 1, -1]).is_none()
}

/// By how much a product with the factor is off, in units of ε/2 of the other factor.
fn error(factor: &Exact) -> f64 {
    let size = factor.to_f64().abs();
    let is_power_of_two = size.to_bits() & ((1 << 52) - 1) == 0
        && Exact::float(factor.to_f64())
            .is_some_and(|word| word.cmp_value(factor) == Ordering::Equal);
    if is_power_of_two { 0.0 } else { 2.0 * size }
}
