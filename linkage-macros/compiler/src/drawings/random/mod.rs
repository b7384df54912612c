//! Random drawn machines beside a truth that shares nothing with the compiler.
//!
//! A machine grows from the ground by a seed, and is written as a declaration. The truth takes the numbers of the
//! same statements: three coordinates for each link, two for each joint, an equation for all that a joint or a drive
//! holds, Newton's method on the whole, and full matrices for rates and forces. It knows no groups, no modes, no
//! frames but those that statements say.

mod comparing;
mod compiled;
mod drawing;
mod growing;
mod jet;
mod matrix;
mod text;
mod truth;
mod walking;

use std::collections::BTreeMap;

use super::machine::{Machine, machine};
use super::variants::Random;
use comparing::Off;
use drawing::Drawing;
use truth::Truth;
use walking::{Reach, free_reach};

/// What became of many machines.
#[derive(Debug, Default)]
struct Outcomes {
    compiled: usize,
    searched: usize,
    poses: usize,
    numbers: usize,
    links: [usize; 16],
    parts: BTreeMap<String, usize>,
    refused: BTreeMap<String, usize>,
    wrong: Vec<String>,
}

/// The kind of a refusal: its message without names.
fn reason(told: &[String]) -> String {
    let text = told.first().map_or("", |told| told.lines().next().unwrap_or_default());
    let parts =
        text.split('`').enumerate().map(|(nth, part)| if nth % 2 == 1 { "_" } else { part });
    parts.collect::<String>().replace("_, ", "")
}

/// How far the documentation says that searches were followed, as drawn beside the others.
fn reaches(drawing: &Drawing, machine: &Machine) -> Vec<Reach> {
    let docs = machine.docs();
    drawing
        .inputs
        .iter()
        .map(|input| {
            let mut reach = free_reach(input.is_angle);
            for who in
                [format!("`{}` goes from ", input.name), "the first drive goes from ".to_string()]
            {
                for rest in docs.split(&who).skip(1) {
                    let (from, rest) = rest.split_once(" to ").expect("two ends");
                    let end = |text: &str| {
                        let number = text.split(['°', ' ']).next().expect("a number");
                        let number: f64 = number.parse().expect("a number");
                        if text.starts_with(&format!("{number:.1}°")) {
                            number.to_radians()
                        } else {
                            number
                        }
                    };
                    // Drives are up to twice an input; the last part is left out, for it is written to a few digits.
                    reach[0] = reach[0].max(0.45 * end(from));
                    reach[1] = reach[1].min(0.45 * end(rest));
                }
            }
            reach
        })
        .collect()
}

impl Outcomes {
    fn take(&mut self, seed: u64, poses: usize) {
        let mut random = Random(seed);
        for _ in 0..8 {
            random.below(2);
        }
        let links = 3 + random.below(13);
        let growth = growing::grown(&mut random, links);
        let drawing = &growth.drawing;
        let statements = drawing.statements(&mut random);
        let source = format!("pub struct M {{\n{statements}\n}}");
        let machine = match machine(&source) {
            Ok(machine) => machine,
            Err(told) => {
                *self.refused.entry(reason(&told)).or_default() += 1;
                if std::env::var("LINKAGE_SHOW").is_ok() {
                    println!("seed {seed}: {told:?}\n{source}");
                }
                return;
            }
        };
        self.compiled += 1;
        self.searched += usize::from(!machine.mechanism.unknowns.is_empty());
        self.links[drawing.links.len().min(15)] += 1;
        for part in &growth.parts {
            *self.parts.entry(format!("{part:?}")).or_default() += 1;
        }
        let wrong = self.walk(drawing, &machine, &mut random, poses);
        if !wrong.is_empty() {
            let wrong = wrong.join("\n");
            self.wrong.push(format!(
                "seed {seed}, {:?}:\n{wrong}\n{source}\n{}",
                growth.parts,
                machine.docs()
            ));
        }
    }

    /// Compares poses along a walk, up to the first that does not agree.
    fn walk(
        &mut self,
        drawing: &Drawing,
        machine: &Machine,
        random: &mut Random,
        count: usize,
    ) -> Vec<String> {
        let truth = Truth::of(drawing);
        let params: Vec<_> = drawing.params.iter().map(|param| param.default).collect();
        let is_searched = !machine.mechanism.unknowns.is_empty();
        let reaches = reaches(drawing, machine);
        let drawn = machine.mechanism.drawn.clone().expect("drives determine the inputs");
        for (known, drawn) in drawing.drawn_inputs().iter().zip(&drawn) {
            if (known - drawn).abs() > 1e-12 {
                return vec![format!("drawn at {drawn} in place of {known}")];
            }
        }
        for pose in walking::poses(&truth, random, &reaches, is_searched, count) {
            let inputs: Vec<_> = pose.inputs.iter().map(|input| input.0).collect();
            let found = compiled::results(machine, &["motion"], &inputs, &params, &[]);
            let off = Off::of(&pose);
            let known = comparing::motion(&truth, &pose, &off);
            let (numbers, mut wrong) = comparing::compared(&found, &known);
            self.poses += 1;
            self.numbers += numbers;
            if !wrong.is_empty() {
                wrong.insert(
                    0,
                    format!("condition {:.1e}, at {inputs:?}, drawn at {drawn:?}", off.condition),
                );
                return wrong;
            }
        }
        Vec::new()
    }
}

/// A seed a machine.
fn outcomes(first: u64, count: u64, poses: usize) -> Outcomes {
    let mut outcomes = Outcomes::default();
    for nth in first..first + count {
        outcomes.take(nth.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1, poses);
    }
    outcomes
}

#[test]
fn random_machines_move_as_all_their_joints_say() {
    let first = std::env::var("LINKAGE_FIRST").ok().and_then(|text| text.parse().ok()).unwrap_or(1);
    let count =
        std::env::var("LINKAGE_COUNT").ok().and_then(|text| text.parse().ok()).unwrap_or(20);
    let outcomes = outcomes(first, count, 6);
    for wrong in &outcomes.wrong {
        println!("{wrong}\n");
    }
    println!("{:?}", Outcomes { wrong: Vec::new(), ..outcomes });
    assert!(outcomes.wrong.is_empty(), "{} are wrong", outcomes.wrong.len());
}
