//! Conditions that the fast path does not ask hold in every pose that it answers, of whole machines.

use super::Values;
use crate::equations;
use crate::equations::declarations::VARIANTS;
use crate::ir::check::{Comparison, Least};
use crate::ir::graph::{Graph, Id, Node};
use crate::ir::interpret::{Number, ProgramValues, straight};
use crate::ir::liveness::{Path, live, unguarded};
use crate::ir::program::Program;
use crate::lower::lower;
use crate::lower::overflow::NARROW;
use crate::lower::routine::{Condition, Instruction, Lowered};
use crate::oracle::mechanism;
use crate::passes;

/// Random numbers of a seed.
struct Random(u64);

impl Random {
    /// Between 0 and 1.
    fn share(&mut self) -> f64 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn between(&mut self, from: f64, to: f64) -> f64 {
        from + (to - from) * self.share()
    }
}

/// A crank and two dyads behind each other: the second is an `rrr`, an `rrp` or an `rpr`.
fn six_bar(random: &mut Random, kind: usize) -> String {
    let mut of = |from, to| random.between(from, to);
    let crank = of(0.05, 0.25);
    let (dx, dy, rod, rocker) = (of(0.4, 0.8), of(-0.2, 0.2), of(0.4, 0.7), of(0.35, 0.6));
    let (px, py) = (of(0.1, 0.6), of(-0.3, 0.3));
    let second = match kind % 3 {
        0 => format!(
            "rrr PE(P), FE(F) -> E {{ lengths: ({:?}, {:?}), mode: right }}",
            of(0.4, 0.8),
            of(0.4, 0.8)
        ),
        1 => format!(
            "rrp PE(P), ram(bed) -> E {{ length: {:?}, offset: {:?}, mode: ahead }}",
            of(0.4, 0.9),
            of(-0.1, 0.1)
        ),
        _ => format!("rpr block(P), arm(F) {{ offset: {:?}, mode: ahead }}", of(-0.1, 0.1)),
    };
    format!(
        "struct M {{ input q: angle; ground A(0, 0), D({dx:?}, {dy:?}), F({:?}, {:?});
         guide bed through (0, {:?}) along 10deg;
         crank AB(A) -> B {{ length: {crank:?}, angle: q }}
         rrr BC(B), DC(D) -> C {{ lengths: ({rod:?}, {rocker:?}), mode: left }}
         point P on BC at ({px:?}, {py:?}); {second} }}",
        of(0.6, 1.2),
        of(-0.4, 0.4),
        of(-0.4, 0.4),
    )
}

/// The conditions of the routines, each once.
fn conditions<'l>(lowered: &'l Lowered<'_>) -> Vec<&'l Condition> {
    let stages = lowered.routines.iter().flat_map(|routine| &routine.stages);
    let statements = stages.flat_map(|stage| &stage.statements);
    let of_statement = |statement: &'l Instruction| match statement {
        Instruction::Check(condition) => Some(condition),
        _ => None,
    };
    statements.filter_map(of_statement).collect()
}

/// The values of nodes at angles of the inputs, at rest.
fn values<N: Number>(program: &Program, inputs: usize, angles: &[N], ids: &[Id]) -> Vec<N> {
    let zero = N::exact(&crate::exact::Exact::integer(0));
    let given = ProgramValues {
        inputs: angles.iter().map(|angle| [angle.clone(), zero.clone(), zero.clone()]).collect(),
        params: Vec::new(),
        loads: Vec::new(),
        drives: vec![zero; inputs],
        unit: None,
    };
    straight(program, &given, (ids, &live(&program.graph, ids, Path::Slow)))
}

/// True if the slow path would find the condition met for certain, by the value in single precision.
fn is_met(condition: &Condition, value: f32, spread: Option<f32>) -> bool {
    let Some((comparison, least)) = condition.check.row().comparison else { return true };
    let least = match (least, spread) {
        (Least::Rounding, Some(spread)) => 16.0 * f32::EPSILON * spread,
        _ => 0.0,
    };
    if comparison == Comparison::Away { value.abs() > least } else { value > least }
}

/// The number of conditions that are not asked, and of those of which one interval does not show it.
fn assert_sound(source: &str, poses: usize) -> [usize; 2] {
    let mechanism = mechanism(source);
    let program = passes::optimise(&equations::derive(&mechanism, passes::RULES));
    let lowered = lower(&mechanism, &program);
    let graph = &program.graph;
    let all = conditions(&lowered);
    let is_solved = |id: Id| {
        let nodes = live(graph, &[id], Path::Slow);
        graph.iter().any(|(id, node)| nodes[id.index()] && matches!(node, Node::Solved(..)))
    };
    if !mechanism.params.is_empty() || all.iter().any(|condition| is_solved(condition.value)) {
        return [0; 2];
    }
    let of_spread = |condition: &Condition| graph.spread(graph.node(condition.id));
    let ids: Vec<Id> = all.iter().map(|condition| unguarded(graph, condition.value)).collect();
    let spreads: Vec<Id> = all.iter().filter_map(|condition| of_spread(condition)).collect();
    let wanted = [&ids[..], &spreads[..]].concat();
    let inputs = mechanism.inputs.len();
    let mut random = Random(7);
    for pose in 0..poses {
        let angle = |random: &mut Random| match inputs {
            1 => -std::f64::consts::PI + std::f64::consts::TAU * pose as f64 / poses as f64,
            _ => random.between(-3.2, 3.2),
        };
        let angles: Vec<f32> = (0..inputs).map(|_| angle(&mut random) as f32).collect();
        let found = values(&program, inputs, &angles, &wanted);
        let mut of_spreads = found[ids.len()..].iter();
        let met: Vec<bool> = (all.iter().zip(&found))
            .map(|(condition, &value)| {
                let spread = of_spread(condition).and_then(|_| of_spreads.next().copied());
                is_met(condition, value, spread)
            })
            .collect();
        let is_asked = |condition: &Condition| {
            condition.comparison.is_some() || condition.above_rounding.is_some()
        };
        let is_answered =
            all.iter().zip(&met).all(|(condition, is_met)| *is_met || !is_asked(condition));
        for (condition, is_met) in all.iter().zip(&met) {
            assert!(*is_met || !is_answered, "{source}: {condition:?} at {angles:?}");
        }
    }
    left_out(&program, graph, &all)
}

fn left_out(program: &Program, graph: &Graph, all: &[&Condition]) -> [usize; 2] {
    let Some(answer) = program.answer("motion") else { return [0; 2] };
    let values = Values::new(graph, &live(graph, &answer.sinks, Path::Fast));
    let Some((one_interval, _)) = NARROW.iter().find_map(|limits| values.thresholds(limits)) else {
        return [0; 2];
    };
    let mut ids: Vec<Id> = (all.iter())
        .filter(|condition| {
            condition.comparison.is_none() && condition.check.row().comparison.is_some()
        })
        .map(|condition| unguarded(graph, condition.value))
        .collect();
    ids.sort();
    ids.dedup();
    let by_arcs = |id: &&Id| matches!(one_interval.get(id), Some(Some(_)));
    [ids.len(), ids.iter().filter(by_arcs).count()]
}

/// Some of the random six-bars; `.ci/nightly` takes sixty.
#[test]
fn conditions_that_are_not_asked_hold_over_whole_turns() {
    conditions_of_six_bars_hold(8);
}

#[test]
#[ignore = "five seconds: `.ci/nightly` takes it"]
fn conditions_of_sixty_six_bars_that_are_not_asked_hold() {
    conditions_of_six_bars_hold(60);
}

/// Random six-bars, most of which have limits in one dyad or the other.
fn conditions_of_six_bars_hold(machines: usize) {
    let (mut random, mut sums) = (Random(56), [0; 2]);
    for machine in 0..machines {
        let counts = assert_sound(&six_bar(&mut random, machine), 1440);
        sums = [0, 1].map(|of| sums[of] + counts[of]);
    }
    println!("{} conditions are not asked, {} of them by arcs", sums[0], sums[1]);
    assert!(sums[1] > machines * 2 / 3, "{sums:?}");
}

#[test]
fn conditions_of_every_group_that_are_not_asked_hold() {
    let of_variants = VARIANTS.iter().map(|variant| assert_sound(variant.source, 720));
    let sums = of_variants.fold([0; 2], |sums, counts| [0, 1].map(|of| sums[of] + counts[of]));
    assert!(sums[0] > 10 && sums[1] > 2, "{sums:?}");
}
