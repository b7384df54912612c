//! Bounds of the rounding of slips: no slip is further from itself in a hundred digits, in single or in double precision.
//!
//! The bounds are no formula of the numbers that they bound, and the hundred digits know of neither.

use crate::equations::declarations::VARIANTS;
use crate::equations::forces::topologies::random_mechanism;
use crate::equations::forces::{evaluated, slip};
use crate::equations::friction::rubbing;
use crate::equations::kinematics::{InputMotion, Kinematics};
use crate::equations::parallelograms::PARALLELOGRAMS;
use crate::equations::slip_rounding::SlipRounding;
use crate::equations::symbol::GraphBuilder;
use crate::ir::graph::{Graph, Id};
use crate::ir::interpret::{Number, ProgramValues, Searched, interpret};
use crate::ir::program::{EntryOutputs, Program};
use crate::model::mechanism::Mechanism;
use crate::oracle::{Digits, defaults, mechanism};
use crate::passes;
pub(crate) use linkage_compiler::equations::slip_rounding::*;

/// The number of slips and of their rates, and the largest parts of its bound by which one is off
/// in double and in single precision, and of its size that its bound is in double precision.
#[derive(Debug, Default)]
struct Found {
    count: usize,
    off: [f64; 2],
    widest: f64,
}

impl Found {
    fn add(&mut self, other: &Self) {
        self.count += other.count;
        self.off = [0, 1].map(|width| self.off[width].max(other.off[width]));
        self.widest = self.widest.max(other.widest);
    }
}

const EPSILON: [f64; 2] = [f64::EPSILON, f32::EPSILON as f64];

/// The units of both widths.
const UNITS: [f64; 2] = [8.0 * EPSILON[0], 8.0 * EPSILON[1]];

fn interpreted<T: Searched>(
    mechanism: &Mechanism,
    graph: Graph,
    inputs: &[[f64; 3]],
    number: impl Fn(f64) -> T,
) -> Vec<T> {
    let groups = mechanism.titles();
    let answers = vec![EntryOutputs { entry: None, sinks: Vec::new() }];
    let program = Program { graph, answers, clearances: Vec::new(), closures: Vec::new(), groups };
    let given = ProgramValues {
        inputs: inputs.iter().map(|q| q.map(&number)).collect(),
        params: defaults(mechanism).iter().map(|value| number(value.to_f64())).collect(),
        loads: Vec::new(),
        drives: Vec::new(),
        unit: None,
    };
    interpret(&program, &given)
}

/// The declaration with something that presses on its joints, where it has nothing.
fn pressed(source: &str) -> String {
    if source.contains("mass ") || source.contains("force ") {
        return source.to_string();
    }
    let (_, friction) = source.split_once("friction ").expect("something rubs");
    let link = friction.split(' ').nth(2).expect("it rubs on a link");
    let inner = source.trim_end().strip_suffix('}').expect("a declaration ends with a brace");
    format!("{inner} mass 1kg on {link} at (0.1, 0.2); }}")
}

fn found(source: &str, inputs: &[[f64; 3]]) -> Found {
    let mechanism = mechanism(&pressed(source));
    let builder = GraphBuilder::new(passes::RULES);
    let moving = Kinematics::of(&builder, &mechanism, InputMotion::free(&mechanism, &builder));
    let rounding = SlipRounding::of(&moving);
    let contacts = mechanism.dynamics.frictions.iter().map(|friction| friction.contact);
    let pairs = contacts.flat_map(|contact| {
        let (slips, bounds) = (slip(&moving, contact), rounding.units_of_slip(contact));
        [0, 1].map(|order| [slips[order].id, bounds[order].id])
    });
    let pairs: Vec<[Id; 2]> = pairs.collect();
    // Inputs that single precision has, too.
    let inputs: Vec<_> = inputs.iter().map(|q| q.map(|x| f64::from(x as f32))).collect();
    let (_, truths) = evaluated(&mechanism, builder.graph(), &inputs);
    let double = interpreted(&mechanism, builder.graph(), &inputs, |x| x);
    let single = interpreted(&mechanism, builder.graph(), &inputs, |x| x as f32);
    let mut found = Found { count: pairs.len(), ..Found::default() };
    for [slip, bound] in pairs.iter().map(|pair| pair.map(Id::index)) {
        let truth = &truths[slip];
        let bound = truths[bound].to_f64();
        let off = |x: f64| Digits::float(x).sub(truth).to_f64().abs();
        let off = [off(double[slip]), off(f64::from(single[slip]))];
        let size = truth.to_f64().abs();
        for (width, off) in off.into_iter().enumerate().filter(|(_, off)| *off > 0.0) {
            // A multiple of an input has the roundings of its factors and its own, and no bound.
            let least =
                if bound == 0.0 { 2.0 * EPSILON[width] * size } else { bound * UNITS[width] };
            found.off[width] = found.off[width].max(off / least);
        }
        // Some joints do not move at all: of a hundred digits nothing is left there.
        if size > 1e-50 {
            found.widest = found.widest.max(bound * UNITS[0] / size);
        }
    }
    found
}

#[test]
fn slips_of_every_variant_are_off_by_less_than_their_bounds() {
    let mut all = Found::default();
    // An expression counts as if what it reads were exact.
    let reads = ["dimensions of offsets from guides"];
    for variant in
        VARIANTS.iter().chain(PARALLELOGRAMS).filter(|variant| !reads.contains(&variant.name))
    {
        let found = found(&rubbing(variant.source), variant.inputs);
        println!("{}: {found:?}", variant.name);
        all.add(&found);
    }
    println!("{all:?}");
    assert!(all.count > 100 && all.off.iter().all(|off| *off < 1.0), "{all:?}");
}

#[test]
fn slips_of_random_topologies_are_off_by_less_than_their_bounds() {
    let inputs = [[0.7, 1.3, -0.6], [0.41, -0.4, 0.9]];
    let mut all = Found::default();
    // An expression counts as if what it reads were exact; the fourth has angles that read slides, one behind the other.
    for seed in [0, 1, 2, 3, 5] {
        let (source, _) = random_mechanism(seed, &inputs);
        let found = found(&rubbing(&source), &inputs);
        println!("{seed}: {found:?}");
        all.add(&found);
    }
    println!("{all:?}");
    assert!(all.count > 100 && all.off.iter().all(|off| *off < 1.0), "{all:?}");
}
