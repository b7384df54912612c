//! Amounts that straight-line code finds, against their own equations: in both precisions and in a hundred digits.
//!
//! The run-time crate searches where the proofs fail, so that a wrong step would show in no answer. Here nothing
//! searches: what the steps have found is held to the equation, and how often the proofs fail is counted.

pub(crate) mod posed;

use crate::equations::forces::amounts_of;
use crate::equations::symbol::{GraphBuilder, Sym};
use crate::interface::entries::EntryPoint;
use crate::ir::graph::Node;
use crate::ir::interpret::ProgramValues;
use crate::ir::program::{EntryOutputs, Program};
use crate::oracle::mechanism;
use crate::{equations, passes};
use posed::Case;

/// A group behind a crank, with friction at each joint of its own.
struct Machine {
    name: &'static str,
    /// By three coefficients of pins and guides, the radius of all pins, the length of all blocks, two lengths of
    /// the group, and an angle.
    statements: &'static str,
    /// Coefficients with which ρ is about one.
    full: f64,
    /// All poses with a smaller ρ are proven in double precision, and in single precision.
    proven_below: [f64; 2],
    /// With a smaller ρ no pivot refuses.
    positive_below: f64,
}

const MACHINES: [Machine; 6] = [
    Machine {
        name: "rrr",
        statements: "ground D(0.9m, -0.1m); rrr BC(B), DC(D) -> C { lengths: (0.8m + a, 0.5m + b), mode: left }
         mass 2kg on BC at (0.4m, 0.02m) inertia 0.1; mass 3kg on DC at (0.2m, 0) inertia 0.1;
         force (f, g) on C; torque 0.2m * g on DC;
         friction k at B radius r; friction m on BC at C radius r; friction n at D radius r;",
        full: 16.0,
        proven_below: [0.1, 0.6],
        positive_below: 0.8,
    },
    Machine {
        name: "rrp",
        statements: "guide rail through (0, 0.1m) along phi;
         rrp BC(B), ram(rail) -> C { length: 0.8m + a, offset: b, mode: ahead }
         mass 2kg on BC at (0.4m, 0.02m) inertia 0.1; mass 5kg on ram at (0, 0.03m) inertia 0.05;
         force (f, g) on C; torque 0.1m * g on ram;
         friction k at B radius r; friction m on BC at C radius r; friction n on ram length l;",
        full: 2.5,
        proven_below: [0.7, 0.95],
        positive_below: 0.95,
    },
    Machine {
        name: "rpr",
        statements: "ground F(-0.7m, 0.3m); rpr block(B), rod(F) { offset: b }
         mass 1kg on block at (0.01m, 0) inertia 0.01; mass 2kg on rod at (0.4m, 0) inertia 0.2;
         force (f, g) on B; torque 0.1m * g on rod;
         friction k on block at B radius r; friction m on block length l; friction n at F radius r;",
        full: 4.0,
        proven_below: [0.55, 0.9],
        positive_below: 0.9,
    },
    Machine {
        name: "prp",
        statements: "guide post through (1.2m, 0) along 80deg; guide arm on AB through B along phi;
         prp shoe(arm), follower(post) -> H { offsets: (a, b) }
         mass 0.5kg on shoe at (0, 0) inertia 0.01; mass 2kg on follower at (0.02m, 0.1m) inertia 0.02;
         force (f, g) on H;
         friction k on shoe length l; friction n on follower length 2 * l; friction m on shoe at H radius r;",
        full: 0.6,
        proven_below: [1.0, 1.0],
        positive_below: 1.0,
    },
    Machine {
        name: "rpp",
        statements: "guide rail through (0, 0.9m) along 5deg;
         rpp slider(B), yoke(rail) { slot: 70deg + phi, offsets: (a, b) }
         mass 1.5kg on slider at (0, 0.005m) inertia 0.01; mass 4kg on yoke at (0.1m, -0.2m) inertia 0.1;
         force (f, g) on B; torque 0.1m * g on yoke;
         friction k on slider at B radius r; friction m on slider; friction n on yoke length 3 * l;",
        full: 0.5,
        proven_below: [1.0, 1.0],
        positive_below: 1.0,
    },
    Machine {
        name: "rrr of two pins",
        statements: "ground D(0.9m, -0.1m); rrr BC(B), DC(D) -> C { lengths: (0.8m + a, 0.5m + b), mode: right }
         mass 2kg on BC at (0.4m, 0.02m) inertia 0.1; mass 3kg on DC at (0.2m, 0) inertia 0.1;
         force (f, g) on C; friction k at B radius r; friction n at D radius r;",
        full: 24.0,
        proven_below: [0.1, 0.27],
        positive_below: 0.9,
    },
];

/// A declaration, and the program of its answers.
fn program(rest: &str) -> Program {
    let source = format!(
        "struct M {{ input q: angle; load f: force; load g: force;
         param k = 0.1; param m = 0.1; param n = 0.1; param r = 0.01m; param l = 0.1m;
         param a = 0.0m; param b = 0.0m; param phi = 0rad;
         ground A(0, 0); crank AB(A) -> B {{ length: 0.2m, angle: q }} gravity (0, -9.81);
         {rest} output q.drive; }}"
    );
    equations::derive(&mechanism(&source), passes::RULES)
}

/// Numbers that repeat: Knuth's linear congruence.
struct Drawn(u64);

impl Drawn {
    fn between(&mut self, low: f64, high: f64) -> f64 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        low + (high - low) * ((self.0 >> 11) as f64 / (1u64 << 53) as f64)
    }

    /// A machine and its state: ρ from some hundredths to above one.
    fn given(&mut self, machine: &Machine) -> ProgramValues<f64> {
        let most = machine.full * 10.0_f64.powf(self.between(-2.0, 0.2));
        let inputs = [(-3.1, 3.1), (-9.0, 9.0), (-40.0, 40.0)].map(|(a, b)| self.between(a, b));
        let mut params: Vec<f64> = (0..3).map(|_| most * self.between(0.2, 1.0)).collect();
        params.push(self.between(0.005, 0.02));
        params.push(self.between(0.05, 0.3));
        params.extend([(); 2].map(|()| self.between(-0.04, 0.04)));
        params.push(self.between(-0.3, 0.3));
        let loads = [(); 2].map(|()| self.between(-300.0, 300.0)).into();
        ProgramValues { inputs: vec![inputs], params, loads, drives: vec![0.0], unit: None }
    }
}

/// Calls `f` with so many poses of each machine, of those in reach, in both widths, and their ρ.
fn each(draws: usize, mut f: impl FnMut(&Machine, &Case<'_>, usize, f64)) {
    for machine in &MACHINES {
        let (program, mut drawn) = (program(machine.statements), Drawn(7));
        for _ in 0..draws {
            let given = drawn.given(machine);
            let cases = [Case::of::<f64>(&program, &given), Case::of::<f32>(&program, &given)];
            for (width, case) in cases.into_iter().enumerate() {
                if let Some(case) = case {
                    f(machine, &case, width, case.radius());
                }
            }
        }
    }
}

/// The count of poses; `.ci/nightly` draws more.
const DRAWS: usize = 25;
const MANY_DRAWS: usize = 60;

const EPSILONS: [f64; 2] = [f64::EPSILON, f32::EPSILON as f64];

/// The error that steps leave is no more than the proof says, whatever ε is.
///
/// A guide's size is known: the pair is Φ less the amount, and what that is compared with. A pin's is larger than its
/// slope tells by no more than half of the pair, the step's square over twice the size.
fn steps_leave_what_the_proof_says(draws: usize) {
    let mut sharpest = 0.0_f64;
    each(draws, |machine, case, width, rho| {
        if rho > 0.99 {
            return;
        }
        let (residuals, name) = (case.residuals(), machine.name);
        let rounding = ROUNDINGS * EPSILONS[width];
        let mut small = case.small.iter();
        for (j, &residual) in residuals.iter().enumerate() {
            let row = &case.rows[j];
            if row[3..].iter().all(|change| *change == 0.0) {
                assert!(residual.abs() <= rounding * case.scale(j), "{name}: {residual}");
                continue;
            }
            let &[less, more] = small.next().expect("a contact that depends on others has a pair");
            let is_guide = case.contacts.joints[j].1;
            let bound = if is_guide { row[0] * less } else { case.starts[j] * less / more / 2.0 };
            let slack = rounding * (case.scale(j) + bound);
            let shown = -slack..=bound + slack;
            assert!(shown.contains(&residual), "{name}: {residual} of {bound} at {rho}");
            // As far as rounding tells.
            if bound > 1e4 * rounding * case.scale(j) {
                sharpest = sharpest.max(residual / bound);
            }
        }
        assert!(small.next().is_none(), "{name}: a pair of no contact");
    });
    // A bound that is far above what is left would send answers to the search for nothing.
    assert!(sharpest > 0.9, "{sharpest:?}");
}

/// Roundings that a size, its slope times the step, and its amount leave: three in each component of a reaction, two
/// of a length, three of a slope, and that of the product; each half an ε.
const ROUNDINGS: f64 = 4.0;

/// Amounts that the fast path takes are within (I − L)⁻¹ |Φ(x) − x| of the solution, which is 4ε and what rounding leaves
/// of Φ, amplified.
fn proven_amounts_are_the_solution(draws: usize) {
    let mut taken = [0; 2];
    each(draws, |machine, case, width, rho| {
        let (epsilon, name) = (EPSILONS[width], machine.name);
        if !case.is_proven(epsilon) {
            return;
        }
        assert!(rho < 1.0, "{name}: {rho}");
        let residuals = case.residuals();
        let sizes: Vec<f64> = residuals.iter().map(|residual| residual.abs()).collect();
        let shown = case.amplified(&sizes);
        let roundings = (0..sizes.len()).map(|j| (4.0 + ROUNDINGS) * epsilon * case.scale(j));
        let bound = case.amplified(&roundings.collect::<Vec<_>>());
        for j in 0..sizes.len() {
            assert!(case.found[j] >= 0.0, "{name}: {}", case.found[j]);
            assert!(shown[j] <= bound[j], "{name}: {} {} at {rho}", shown[j], bound[j]);
        }
        // One amount of some poses: a hundred digits take their time.
        taken[width] += 1;
        if taken[width] % 12 == 0 {
            let j = taken[width] / 12 % sizes.len();
            // The sum of powers of L is rounded.
            assert!(case.apart(j) <= shown[j] * (1.0 + 1e-9), "{name}: {} at {rho}", shown[j]);
        }
    });
    assert!(taken.iter().all(|taken| *taken > 4 * draws), "{taken:?}");
}

/// Where friction is moderate, nothing is left to the search: neither for want of a step nor for want of a pivot.
fn moderate_friction_is_proven(draws: usize) {
    each(draws, |machine, case, width, rho| {
        let name = machine.name;
        let is_positive = case.positive.iter().all(|pivot| *pivot > 0.0);
        assert!(is_positive || rho >= machine.positive_below, "{name}: no pivot at {rho}");
        assert!(!is_positive || rho < 1.0 + 1e-6, "{name}: a pivot at {rho}");
        let is_proven = case.is_proven(EPSILONS[width]);
        assert!(is_proven || rho >= machine.proven_below[width], "{name}: no proof at {rho}");
    });
}

#[test]
fn what_steps_leave_is_what_the_proof_says() {
    steps_leave_what_the_proof_says(DRAWS);
}

#[test]
fn amounts_that_are_proven_are_the_solution() {
    proven_amounts_are_the_solution(DRAWS);
}

#[test]
fn moderate_friction_needs_no_search() {
    moderate_friction_is_proven(DRAWS);
}

#[test]
#[ignore = "minutes: `.ci/nightly` takes it"]
fn proofs_hold_in_many_poses() {
    steps_leave_what_the_proof_says(MANY_DRAWS);
    proven_amounts_are_the_solution(MANY_DRAWS);
    moderate_friction_is_proven(MANY_DRAWS);
}

/// Three guides whose forces and couples all depend on each other, by numbers that are given: c, G and A of each.
fn guides() -> Program {
    let builder = GraphBuilder::new(passes::RULES);
    let number = |at: usize| builder.node(Node::Param(at as u32));
    let row = |j: usize| -> Vec<Sym<'_>> { (9 * j..9 * (j + 1)).map(number).collect() };
    let amounts = amounts_of(&[0, 1, 2].map(row), &[true; 3]);
    let sinks = amounts.iter().map(|amount| amount.id).collect();
    let answers = vec![EntryOutputs { entry: Some(EntryPoint::named("forces")), sinks }];
    let (graph, groups) = (builder.graph(), vec![String::new()]);
    Program { graph, answers, clearances: Vec::new(), closures: Vec::new(), groups }
}

/// Tenths of the numbers of guides that four steps do not solve, among many that they do: the last step
/// moves the third, the first or the second of them to another side.
#[rustfmt::skip]
const UNSOLVED: [[i8; 27]; 3] = [
    [4, 4, 6, 7, 9, -1, -1, 1, -7, 13, 7, -4, -8, 6, 5, 5, 8, 2, 2, 0, -8, -1, 2, -6, 7, 9, 3],
    [3, 2, -9, 8, 9, -1, 1, -5, 7, 9, -7, 7, 0, -2, -9, 9, 6, 7, 3, 8, 2, 2, 4, -7, 8, -1, -1],
    [13, 4, 1, -2, 2, -3, 8, -2, -1, 2, 0, 5, 6, -7, -7, -3, -5, -8, 13, -2, -6, 2, -1, 6, 4, -1, -4],
];

/// Guides that change sides from step to step are not through after four, and the proof says by how much.
#[test]
fn guides_that_change_sides_are_told() {
    let program = guides();
    for (tenths, off) in UNSOLVED.iter().zip([2, 0, 1]) {
        let params = tenths.iter().map(|&tenths| 0.1 * f64::from(tenths)).collect();
        let [loads, drives] = [Vec::new(), Vec::new()];
        let given = ProgramValues { inputs: Vec::new(), params, loads, drives, unit: None };
        let case = Case::of::<f64>(&program, &given).expect("numbers");
        assert!(case.radius() < 1.0 && !case.is_proven(f64::EPSILON), "{:?}", case.small);
        for (j, residual) in case.residuals().into_iter().enumerate() {
            let (left, scale) = (case.rows[j][0] * case.small[j][0], case.scale(j));
            assert_eq!(residual > 1e-3 * scale, j == off, "{j}: {residual}");
            // Three steps of sizes, each with some roundings, amplified by 1/(1 - ρ).
            assert!((residual - left).abs() <= 1e-13 * scale, "{j}: {residual} {left}");
            let compared = case.small[j][1];
            assert!((compared * case.rows[j][0] - case.starts[j] - case.found[j]).abs() < 1e-13);
        }
    }
}
