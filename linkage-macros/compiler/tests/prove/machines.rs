//! Machines whose bounds are compared with what is computed.

use crate::ir::graph::Id;
use crate::ir::program::Program;
use crate::model::mechanism::{Mechanism, ParamKind, Sign};
use crate::oracle::mechanism;
use crate::prove::outward::OutwardInterval;
use crate::prove::premises::{Hooks, Leaf, Premises};
use crate::{equations, passes};

/// A machine, and the range of each input that its bounds are wanted over.
pub(crate) struct Machine {
    pub name: &'static str,
    pub source: &'static str,
    pub ranges: &'static [[f64; 2]],
    pub entry: &'static str,
    pub dyads: usize,
}

const TURN: &[[f64; 2]] = &[[-core::f64::consts::PI, core::f64::consts::PI]];

const fn turning(name: &'static str, source: &'static str) -> Machine {
    Machine { name, source, ranges: TURN, entry: "motion", dyads: 2 }
}

/// All groups of two links, chains of up to three of them, a parameter, compensated numerics, several inputs.
pub(crate) const MACHINES: &[Machine] = &[
    turning(
        "flying shear",
        "struct M { input theta: angle; ground A(0, 0), D(665.7mm, 0);
         crank AB(A) -> B { length: 80mm, angle: theta }
         rrr BC(B), DC(D) -> C { lengths: (632mm, 374mm), mode: right }
         point blade on BC at (500mm, -60mm); }",
    ),
    turning(
        "four-bar with parameters",
        "struct M { input theta: angle; param crank: length = 81.3mm; param rod: length = 420mm;
         ground A(0, 0), D(500mm, 35mm);
         crank AB(A) -> B { length: crank, angle: theta }
         rrr BC(B), DC(D) -> C { lengths: (rod, 300mm), mode: left } }",
    ),
    turning(
        "slider-crank",
        "struct M { input theta: angle; ground A(0, 0); guide rail through (0, 12mm) along 0deg;
         crank AB(A) -> B { length: 43mm, angle: theta }
         rrp rod(B), piston(rail) -> C { length: 136mm, mode: ahead } }",
    ),
    turning(
        "shaper",
        "struct M { input theta: angle; ground A(0, 0), D(0, -1m);
         guide rail through (0, 0.8m) along 0deg;
         crank AB(A) -> B { length: 0.4m, angle: theta }
         rpr block(B), rod(D) { mode: ahead }
         point E on rod at (1.6m, 0);
         rpp pin(E), ram(rail) { slot: 90deg } }",
    ),
    turning(
        "Scotch yoke and a follower",
        "struct M { input theta: angle; ground A(0, 0); guide rail through (0, 0.31) along 5deg;
         guide bed through (0, -0.2) along 0deg;
         crank AB(A) -> B { length: 0.1, angle: 2 * theta + 0.3 }
         rpp pin(B), ram(rail) { slot: 80deg }
         rrp rod(B), block(bed) -> C { length: 0.7, offset: 0.03, mode: behind } }",
    ),
    turning(
        "compensated four-bar",
        "struct M { input theta: angle; numerics compensated; ground A(0, 0), D(665.7mm, 0);
         crank AB(A) -> B { length: 80mm, angle: theta }
         rrr BC(B), DC(D) -> C { lengths: (632mm, 374mm), mode: right } }",
    ),
    turning(
        "two dyads",
        "struct M { input theta: angle; ground A(0, 0), D(0.6, 0.1), F(0.9, -0.2);
         crank AB(A) -> B { length: 0.11, angle: theta }
         rrr BC(B), DC(D) -> C { lengths: (0.53, 0.37), mode: left }
         point P on BC at (0.3, 0.12);
         rrr PE(P), FE(F) -> E { lengths: (0.71, 0.47), mode: right } }",
    ),
    Machine {
        name: "Jansen's leg",
        source: "struct M { input theta: angle; ground A(0, 0), D(-38cm, -7.8cm);
         crank AB(A) -> B { length: 15cm, angle: theta }
         rrr upper(B), b(D) -> U { lengths: (50cm, 41.5cm), mode: right }
         rrr lower(B), c(D) -> L { lengths: (61.9cm, 39.3cm), mode: left }
         point E on b at distances (40.1cm, 55.8cm) left;
         rrr f(E), g(L) -> F { lengths: (39.4cm, 36.7cm), mode: right }
         point foot on g at distances (49cm, 65.7cm) left;
         output foot; }",
        ranges: TURN,
        entry: "motion",
        dyads: 3,
    },
    Machine {
        name: "five-bar",
        source: "struct M { input q: angle; input r: angle; ground A(0, 0), D(0.2, 0);
         crank AB(A) -> B { length: 0.15, angle: q } crank DE(D) -> E { length: 0.15, angle: r }
         rrr BC(B), EC(E) -> C { lengths: (0.25, 0.25), mode: left } output C; }",
        ranges: &[[1.6, 2.0], [1.0, 1.4]],
        entry: "motion",
        dyads: 1,
    },
    // From a hundredth of a radian after its dead point at 33.1538°, where the offset is what the rod lacks.
    Machine {
        name: "slider-crank next to its limit",
        source:
            "struct M { input theta: angle; ground A(0, 0); guide rail through (0, 0) along 0deg;
         crank AB(A) -> B { length: 43mm, angle: theta }
         rrp rod(B), piston(rail) -> C { length: 136mm, offset: -100mm, mode: ahead } }",
        ranges: &[[-2.2, 0.98]],
        entry: "motion",
        dyads: 1,
    },
    Machine {
        name: "cylinder",
        source: "struct M { input s: length; ground A(0, 0), D(0.9, 0.15);
         rrr AC(A), DC(D) -> C { lengths: (s, 0.5), mode: left }
         point P on DC at (0.3, 0.1); }",
        ranges: &[[0.55, 1.1]],
        entry: "motion",
        dyads: 1,
    },
    Machine { name: "forces", source: LOADED, ranges: TURN, entry: "forces", dyads: 1 },
    Machine {
        name: "forward dynamics",
        source: LOADED,
        ranges: TURN,
        entry: "forward_dynamics",
        dyads: 1,
    },
];

/// A four-bar with masses, a spring and gravity.
const LOADED: &str = "struct M { input theta: angle; ground A(0, 0), D(750mm, 0);
    crank AB(A) -> B { length: 250mm, angle: theta }
    rrr BC(B), DC(D) -> C { lengths: (510mm, 500mm), mode: left }
    point P on BC at (0.2, 0.05);
    gravity (0, -9.81(m/s^2)); mass 0.5kg on AB uniform; mass 1.2kg on BC at (0.25, 0) inertia 0.02(kg*m^2);
    mass 0.8kg on DC uniform;
    spring s between P and D { stiffness: 300(N/m), free_length: 0.2 }
    output AB.drive, AB.A, AB.B, BC.C, DC.D; }";

/// A machine's program.
pub(crate) fn program(mechanism: &Mechanism) -> Program {
    passes::optimise(&equations::derive(mechanism, passes::RULES))
}

/// A machine's program and premises: the motion at these rates.
pub(crate) struct Case {
    pub program: Program,
    pub given: Premises,
    pub sinks: Vec<Id>,
}

impl Machine {
    pub(crate) fn case(&self, rates: [f64; 2]) -> Case {
        case(self.source, self.ranges, self.entry, rates)
    }
}

/// An entry point's results at these rates of every input, over ranges of these.
pub(crate) fn case(source: &str, ranges: &[[f64; 2]], entry: &str, rates: [f64; 2]) -> Case {
    let mechanism = mechanism(source);
    let program = program(&mechanism);
    let sinks = program.answer(entry).expect("every machine moves").sinks.clone();
    let leaf = |kind: &ParamKind| match kind {
        ParamKind::Number { default, .. } => Leaf::Decimal(default.clone()),
        ParamKind::Mode { default: Sign::Plus, .. } => Leaf::number(1.0),
        ParamKind::Mode { .. } => Leaf::number(-1.0),
    };
    let [rate, second] = rates.map(|rate| Leaf::Within(OutwardInterval::point(rate)));
    let inputs = (0..ranges.len()).map(|input| [Leaf::Ranged(input), rate.clone(), second.clone()]);
    let given = Premises {
        hooks: Hooks::default(),
        ranges: ranges.to_vec(),
        inputs: inputs.collect(),
        params: mechanism.params.iter().map(|param| leaf(&param.kind)).collect(),
        loads: mechanism.dynamics.loads.iter().map(|_| Leaf::number(2.5)).collect(),
        drives: vec![Leaf::number(0.75); ranges.len()],
        scales_with_rates: entry == "motion",
    };
    Case { program, given, sinks }
}
