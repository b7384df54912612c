//! The equations of motion against the efforts that the same motion asks for, by the walk over joint after
//! joint, which is tested against Newton's and Euler's equations; and against the kinetic energy. On
//! every variant and on random topologies, with masses, springs, dampers and loads everywhere.

use crate::equations::declarations::VARIANTS;
use crate::equations::derive;
use crate::equations::forces::topologies::random_mechanism;
use crate::equations::forces::{
    Walk, accelerations, energy, equations, every_input_moves_mass, in_motion, loaded,
    share_of_a_pivot, with_every_input_asked,
};
use crate::equations::kinematics::{InputMotion, Kinematics};
use crate::equations::newton_euler::Motion;
use crate::equations::parallelograms::PARALLELOGRAMS;
use crate::equations::symbol::GraphBuilder;
use crate::exact::Exact;
use crate::interface::entries::Analysis;
use crate::ir::graph::{Check, Id, Node};
use crate::ir::interpret::{Number, ProgramValues, Searched, interpret};
use crate::ir::program::{EntryOutputs, Program};
use crate::model::mechanism::Mechanism;
use crate::oracle::{Digits, mechanism};
use crate::passes;

/// The places of the answers.
const FORWARD: usize = 0;
const EQUATIONS: usize = 1;
const ENERGY: usize = 2;
/// The efforts of the inputs' drives, by the walk.
const WALK: usize = 3;
/// The same by power.
const POWER: usize = 4;
/// For each input the terms of that power: of each action both components and the couple, at a unit
/// rate of the input.
const TERMS: usize = 5;

/// Everything that the tests compare, after all passes; nothing where an input moves no mass.
fn program(mechanism: &Mechanism) -> Option<Program> {
    let builder = GraphBuilder::new(passes::RULES);
    let kinematics = Kinematics::of(&builder, mechanism, InputMotion::free(mechanism, &builder));
    if !every_input_moves_mass(&kinematics) {
        return None;
    }
    let walk = Walk::of(&kinematics);
    let answers = [
        (Analysis::ForwardDynamics, accelerations(&kinematics)),
        (Analysis::EquationsOfMotion, equations(&kinematics)),
        (Analysis::Energy, energy(&kinematics)),
        (Analysis::Forces, walk.input_efforts().iter().map(|effort| effort.id).collect()),
        (Analysis::Forces, in_motion(&kinematics)),
        (Analysis::Forces, terms(&kinematics)),
    ];
    drop(walk);
    drop(kinematics);
    let answer = |(analysis, sinks): (Analysis, _)| {
        let entry = Some(analysis.by_value());
        EntryOutputs { entry, sinks }
    };
    let answers = answers.map(answer).into();
    let (closures, groups) = (Vec::new(), mechanism.titles());
    let program =
        Program { graph: builder.into_graph(), answers, clearances: Vec::new(), closures, groups };
    Some(passes::optimise(&program))
}

fn terms<'s>(kinematics: &Kinematics<'s>) -> Vec<Id> {
    let (builder, mechanism) = (kinematics.builder, kinematics.mechanism);
    let sym = |id: Id| builder.known(id);
    let actions = Motion::of(kinematics).applied;
    let mut terms = Vec::new();
    for moving in 0..mechanism.inputs.len() {
        let mut inputs = InputMotion::free(mechanism, builder);
        for (index, source) in inputs.iter_mut().enumerate() {
            source.jet.rate = builder.integer(i64::from(index == moving));
            source.jet.accel = builder.zero();
        }
        let unit = Motion::of(&Kinematics::of(builder, mechanism, inputs)).applied;
        for (action, unit) in actions.iter().zip(unit) {
            let [x, y] = [0, 1].map(|axis| sym(action.force[axis]) * sym(unit.velocity[axis]));
            terms.extend([x, y, sym(action.couple) * sym(unit.omega)].map(|term| term.id));
        }
    }
    terms
}

/// A state of some mechanism, with numbers of either kind.
struct State<'m, N> {
    mechanism: &'m Mechanism,
    program: &'m Program,
    inputs: Vec<[N; 3]>,
    drives: Vec<N>,
    params: Vec<N>,
}

/// Values of all answers in a state.
struct Found<'m, N> {
    program: &'m Program,
    values: Vec<N>,
}

impl<N: Searched> Found<'_, N> {
    fn of(&self, answer: usize) -> Vec<N> {
        let answer = &self.program.answers[answer];
        answer.sinks.iter().map(|sink| self.values[sink.index()].clone()).collect()
    }
}

impl<'m, N: Searched> State<'m, N> {
    /// Everything at these rates and accelerations.
    fn at(&self, rates: &[N], seconds: &[N]) -> Found<'m, N> {
        let inputs = self.inputs.iter().zip(rates).zip(seconds);
        let inputs =
            inputs.map(|(([q, ..], rate), second)| [q.clone(), rate.clone(), second.clone()]);
        let load = N::exact(&Exact::float(1.75).expect("finite"));
        let given = ProgramValues {
            inputs: inputs.collect(),
            params: self.params.clone(),
            loads: vec![load; self.mechanism.dynamics.loads.len()],
            drives: self.drives.clone(),
            unit: None,
        };
        Found { program: self.program, values: interpret(self.program, &given) }
    }

    fn rates(&self) -> Vec<N> {
        self.inputs.iter().map(|[_, rate, _]| rate.clone()).collect()
    }

    fn zeros(&self) -> Vec<N> {
        vec![N::exact(&Exact::integer(0)); self.inputs.len()]
    }
}

/// The numbers, with so much more in one place.
fn more(numbers: &[Digits], place: usize) -> Vec<Digits> {
    let mut numbers = numbers.to_vec();
    numbers[place] = numbers[place].add(&Digits::float(1.0));
    numbers
}

/// Compares in a hundred digits; 1e-40 of the largest number.
fn check_digits(name: &str, mechanism: &Mechanism, program: &Program, inputs: &[[f64; 3]]) {
    let count = inputs.len();
    let state = State {
        mechanism,
        program,
        inputs: inputs.iter().map(|q| q.map(Digits::float)).collect(),
        drives: (0..count).map(|input| Digits::float(0.65 - input as f64)).collect(),
        params: crate::oracle::defaults(mechanism),
    };
    let (rates, zeros) = (state.rates(), state.zeros());
    let coasting = state.at(&rates, &zeros);
    let [seconds, equations] = [FORWARD, EQUATIONS].map(|entry| coasting.of(entry));
    let (mass, force) = equations.split_at(count * count);
    let largest = equations.iter().chain(&seconds).map(|n| n.to_f64().abs()).fold(1.0, f64::max);
    let close = |what: &str, found: &Digits, truth: &Digits| {
        let apart = found.sub(truth).to_f64().abs();
        let (found, truth) = (found.to_f64(), truth.to_f64());
        assert!(apart < 1e-40 * largest, "{name}: {what} is {found} and should be {truth}");
    };
    let efforts = state.at(&rates, &seconds).of(WALK);
    for (effort, drive) in efforts.iter().zip(&state.drives) {
        close("the drive", effort, drive);
    }
    let kinetic = |rates: &[Digits]| state.at(rates, &zeros).of(ENERGY)[0].clone();
    let alone = kinetic(&rates);
    let one_more: Vec<_> = (0..count).map(|input| kinetic(&more(&rates, input))).collect();
    for column in 0..count {
        // Efforts are affine in accelerations, and the kinetic energy is quadratic in rates.
        let pushed = state.at(&rates, &more(&seconds, column)).of(WALK);
        for row in 0..=column {
            let by_efforts = pushed[row].sub(&efforts[row]);
            let both = kinetic(&more(&more(&rates, column), row)).sub(&one_more[row]);
            let by_energy = both.sub(&one_more[column].sub(&alone));
            for entry in [&mass[column * count + row], &mass[row * count + column]] {
                close("a mass by efforts", entry, &by_efforts);
                close("a mass by energy", entry, &by_energy);
            }
        }
    }
    for row in 0..count {
        let inertia = (0..count).map(|column| mass[column * count + row].mul(&seconds[column]));
        let inertia = inertia.fold(Digits::float(0.0), |sum, term| sum.add(&term));
        close("a force", &force[row].add(&state.drives[row]), &inertia);
    }
}

/// Checks that the given drives come back in double precision, by the walk and by power, within 64 ε of the
/// sizes of the power's terms.
fn check_rounding(
    name: &str,
    mechanism: &Mechanism,
    program: &Program,
    inputs: &[[f64; 3]],
) -> f64 {
    let state = State {
        mechanism,
        program,
        inputs: inputs.to_vec(),
        drives: (0..inputs.len()).map(|input| 0.65 - input as f64).collect(),
        params: crate::oracle::defaults(mechanism).iter().map(Digits::to_f64).collect(),
    };
    let rates = state.rates();
    let seconds = state.at(&rates, &state.zeros()).of(FORWARD);
    let moving = state.at(&rates, &seconds);
    let terms = moving.of(TERMS);
    let of_one = terms.len() / inputs.len();
    let mut worst = 0.0_f64;
    for way in [WALK, POWER] {
        let found = moving.of(way);
        for (input, (found, drive)) in found.iter().zip(&state.drives).enumerate() {
            let own = &terms[input * of_one..][..of_one];
            let size: f64 = drive.abs() + own.iter().map(|term| term.abs()).sum::<f64>();
            let apart = (found - drive).abs() / (f64::EPSILON * size);
            assert!(apart <= 64.0, "{name}: {way}: {found} for {drive}, {apart:.1} ε of {size}");
            worst = worst.max(apart);
        }
    }
    worst
}

/// Worst rounding of the equations of motion; none if there are none to compare.
fn check(name: &str, source: &str, inputs: &[[f64; 3]]) -> Option<f64> {
    let mut mechanism = with_every_input_asked(mechanism(source));
    mechanism.dynamics.energy = true;
    let program = program(&mechanism)?;
    check_digits(name, &mechanism, &program, inputs);
    Some(check_rounding(name, &mechanism, &program, inputs))
}

/// Every fourth variant; `.ci/nightly` takes all of them, and random topologies.
#[test]
fn variants_move_as_their_efforts_say() {
    assert!(count_of_variants(4) > 5);
}

#[test]
#[ignore = "minutes: `.ci/nightly` takes it"]
fn every_variant_moves_as_its_efforts_say() {
    assert!(count_of_variants(1) > 25);
}

/// The count of those with equations of motion among every nth variant.
fn count_of_variants(nth: usize) -> usize {
    let checked = VARIANTS
        .iter()
        .chain(PARALLELOGRAMS)
        .step_by(nth)
        .filter_map(|variant| check(variant.name, &loaded(variant.source), variant.inputs));
    checked.count()
}

#[test]
#[ignore = "minutes: `.ci/nightly` takes it"]
fn random_topologies_move_as_their_efforts_say() {
    const POSE: [[f64; 3]; 2] = [[0.7, 1.3, -0.6], [0.41, -0.4, 0.9]];
    let mut worst = 0.0_f64;
    for seed in 202..208 {
        let (source, _) = random_mechanism(seed, &POSE);
        let rounding = check(&format!("seed {seed}"), &source, &POSE);
        worst = worst.max(rounding.expect("crank and slider move mass"));
    }
    println!("{worst:.1} ε");
}

/// Two equal bars with one mass at the end, and a motor on the ground: with m l² = 1, M is
/// [2 + 2 cos b, 1 + cos b, 0; 1 + cos b, 1, 0; 0, 0, J].
const ARM: &str = "struct M { input a, b, c: angle; ground O(0, 0), D(1, 0);
    crank K(O) -> P { length: 2, angle: a } crank L(P) -> Q { length: 2, angle: b, relative_to: K }
    crank motor(D) { angle: c } mass 0.25 on Q; inertia 3 on motor; output a.drive, b.drive, c.drive; }";

/// The pivots that are asked for more than zero, and what rounding does to them over 16 ε.
#[test]
fn the_spread_of_a_pivot_is_as_by_hand() {
    let mechanism = mechanism(ARM);
    let program = passes::optimise(&derive(&mechanism, passes::RULES));
    for b in [0.0, 0.4, 2.5] {
        let (drives, cos) = (vec![1.0; 3], f64::cos(b));
        let inputs = vec![[0.3, 0.0, 0.0], [b, 0.0, 0.0], [0.0; 3]];
        let given =
            ProgramValues { inputs, params: Vec::new(), loads: Vec::new(), drives, unit: None };
        let values = interpret(&program, &given);
        let pivots = program.graph.iter().filter_map(|(_, node)| {
            let Node::Guard(pivot, guard) = node else { return None };
            let guard = program.graph.condition(guard);
            let is_spread = guard.check == Check::Moving;
            is_spread.then(|| [values[pivot.index()], values[guard.operands[0].index()]])
        });
        let pivots: Vec<_> = pivots.collect();
        // Eight terms at most: what turns with three links, what stands on the motor's pivot, and two
        // about the origin of each link that has mass. Of three inputs that is 36 + 24 + 12 u, which
        // three times 32 u are enough for.
        let (first, second) = (2.0, 2.0 * (1.0 + 0.25 * 2.0));
        let expected = [[2.0 + 2.0 * cos, 3.0 * first], [0.5 - 0.5 * cos, 3.0 * second]];
        assert_eq!(pivots.len(), 2, "the motor's pivot is a number");
        for (found, expected) in pivots.iter().flatten().zip(expected.iter().flatten()) {
            assert!((found - expected).abs() < 16.0 * f64::EPSILON, "{found} {expected}");
        }
    }
}

/// The run-time crate solves for some of the inputs under the same bound.
#[test]
fn pivots_of_told_motions_have_the_same_rounding() {
    let share = share_of_a_pivot(30, 5) as f64;
    assert_eq!(linkage_core::private::ROUNDINGS_OF_A_PIVOT, 16.0 * share);
    assert_eq!(share_of_a_pivot(31, 5), 5);
    assert!(share_of_a_pivot(40, 5) > 5);
}
