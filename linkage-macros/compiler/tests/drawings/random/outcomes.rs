//! Many machines: each compiled as it has grown, with its pins a little moved, with other parameters, and driven at
//! another link, and all of them compared along a walk.

use std::collections::BTreeMap;

use super::super::machine::{Machine, machine};
use super::super::variants::Random;
use super::acting::{Acting, Ends};
use super::comparing::{self, Off};
use super::compiled;
use super::drawing::{Drawing, Place, Read, Value};
use super::growing::{self, DRAWN_CONDITION, Growth, Part, between};
use super::truth::Truth;
use super::walking::{self, Reach, free_reach};

/// The outcome of many machines.
#[derive(Debug, Default)]
pub(super) struct Outcomes {
    /// The last one taken.
    seed: u64,
    pub compiled: usize,
    pub searched: usize,
    pub poses: usize,
    pub with_forces: usize,
    pub numbers: usize,
    pub moved: usize,
    pub with_other_params: usize,
    pub driven_elsewhere: usize,
    pub searched_elsewhere: usize,
    /// Machines without the frictions that they had at first.
    pub without_friction: usize,
    pub links: [usize; 16],
    pub parts: BTreeMap<String, usize>,
    /// Refusals of machines as they have grown.
    pub refused: BTreeMap<String, usize>,
    /// Refusals of what is driven at another link.
    pub refused_elsewhere: BTreeMap<String, usize>,
    pub wrong: Vec<String>,
}

/// The share that is taken of each machine.
#[derive(Clone, Copy)]
pub(super) struct Sample {
    pub poses: usize,
    pub most_links: usize,
    /// True if other parameters, moved pins and another drive are tried.
    pub twins: [bool; 3],
}

/// A drawing with all that acts, compiled.
struct Declared {
    machine: Machine,
    acting: Acting,
    source: String,
}

/// The kind of a refusal: its message without names.
fn reason(told: &[String]) -> String {
    let text = told.first().map_or("", |told| told.lines().next().unwrap_or_default());
    let parts = text.split('`').enumerate();
    parts
        .map(|(nth, part)| if nth % 2 == 1 { "_" } else { part })
        .collect::<String>()
        .replace("_, ", "")
}

/// A value that is computed only where it is asked for.
fn asked(acting: &Acting, has_losses: bool) -> String {
    let mut asked = Vec::new();
    for (nth, spring) in acting.springs.iter().enumerate() {
        let kind = if matches!(spring.ends, Ends::Pins(_)) { "force" } else { "torque" };
        asked.push(format!("spring{nth}.{kind}"));
    }
    for nth in 0..acting.stops.len() {
        asked.push(format!("stop{nth}.force"));
        asked.push(format!("stop{nth}.gap"));
    }
    if has_losses {
        asked.push("losses".to_string());
    }
    asked.push("energy".to_string());
    format!("output {};", asked.join(", "))
}

/// The stretch about the drawing along which searches were followed, as the documentation says.
fn reaches(drawing: &Drawing, machine: &Machine) -> Vec<Reach> {
    let docs = machine.docs();
    let of = |name: &str, is_angle: bool| {
        let mut reach = free_reach(is_angle);
        for who in [format!("`{name}` goes from "), "the first drive goes from ".to_string()] {
            for rest in docs.split(&who).skip(1) {
                let (from, rest) = rest.split_once(" to ").expect("two ends");
                // Drives are up to twice an input, and the ends are written to a few digits.
                reach[0] = reach[0].max(0.45 * end(from));
                reach[1] = reach[1].min(0.45 * end(rest));
            }
        }
        reach
    };
    drawing.inputs.iter().map(|input| of(&input.name, input.is_angle)).collect()
}

/// The number of degrees or metres with which a text begins.
fn end(text: &str) -> f64 {
    let (number, rest) = text.split_at(text.find(['°', ' ']).expect("a unit"));
    let number: f64 = number.parse().expect("a number");
    if rest.starts_with('°') { number.to_radians() } else { number }
}

/// The drawing with its pins moved by one or two nanometres. What turns by another link is drawn there.
fn moved(drawing: &Drawing, random: &mut Random) -> Drawing {
    let mut moved = drawing.clone();
    for pin in &mut moved.pins {
        if let Place::Drawn(at, _) = &mut pin.place {
            at.iter_mut().for_each(|part| *part += 1e-9 * [-2.0, -1.0, 1.0, 2.0][random.below(4)]);
        }
    }
    for index in 0..moved.drives.len() {
        let drive = &moved.drives[index];
        if let Value { factor, of: read @ Read::Angle(_), .. } = drive.value {
            let constant = moved.driven(drive) - factor * moved.drawn(read);
            moved.drives[index].value.constant = constant;
        }
    }
    moved
}

/// The drawing with another angle or slide given in place of one that is.
fn driven_elsewhere(drawing: &Drawing, random: &mut Random) -> Option<Drawing> {
    for _ in 0..8 {
        let mut other = drawing.clone();
        let index = random.below(other.drives.len().max(1));
        let drive = other.drives.get_mut(index)?;
        let Read::Input(input) = drive.value.of else { continue };
        let link = random.below(drawing.links.len());
        let slides = !drawing.links[link].on.is_empty();
        drive.driven =
            if slides && random.below(2) == 0 { Read::Slide(link) } else { Read::Angle(link) };
        if drive.driven == drawing.drives[index].driven
            || drawing.drives.iter().any(|known| known.driven == drive.driven)
        {
            continue;
        }
        drive.against = None;
        drive.value = Value { factor: 1.0, of: Read::Input(input), constant: 0.0 };
        other.inputs[input].is_angle = matches!(drive.driven, Read::Angle(_));
        if Truth::of(&other).drawn().is_some_and(|pose| pose.condition() < DRAWN_CONDITION) {
            return Some(other);
        }
    }
    None
}

impl Outcomes {
    /// The machine, without friction where that is refused, or what is told of it.
    fn declared(
        &mut self,
        drawing: &Drawing,
        acting: &Acting,
        is_asked: bool,
        random: &mut Random,
    ) -> Result<Declared, String> {
        let mut acting = drawing.without_turns(acting);
        let statements = drawing.statements(random);
        loop {
            let forces = drawing.acting_statements(&acting, random);
            // Where a drive holds links together, what is lost is not known.
            let holds = drawing.drives.iter().any(|drive| drive.against.is_some());
            let has_losses = !acting.frictions.is_empty() && !holds;
            let asked = if is_asked { asked(&acting, has_losses) } else { String::new() };
            let source = format!("pub struct M {{\n{statements}\n{forces}\n{asked}\n}}");
            match machine(&source) {
                Ok(machine) => return Ok(Declared { machine, acting, source }),
                // Beside a search friction is refused.
                Err(told)
                    if !acting.frictions.is_empty()
                        && told.iter().any(|told| told.contains("friction")) =>
                {
                    self.without_friction += 1;
                    acting.frictions.clear();
                }
                Err(told) => {
                    println!("seed {} is refused: {told:?}\n{source}", self.seed);
                    return Err(reason(&told));
                }
            }
        }
    }

    /// Takes the machine of a seed.
    pub(super) fn take(&mut self, seed: u64, Sample { poses, most_links, twins }: Sample) {
        self.seed = seed;
        let mut random = Random(seed);
        // The first numbers of seeds that differ little do so, too.
        for _ in 0..8 {
            random.below(2);
        }
        let links = 3 + random.below(most_links - 2);
        let growth = growing::grown(&mut random, links);
        let (drawing, random) = (&growth.drawing, &mut random);
        let acting = drawing.acting(random);
        let declared = match self.declared(drawing, &acting, seed % 4 == 1, random) {
            Ok(declared) => declared,
            Err(reason) => return *self.refused.entry(reason).or_default() += 1,
        };
        self.compiled += 1;
        self.links[drawing.links.len().min(15)] += 1;
        for part in &growth.parts {
            *self.parts.entry(format!("{part:?}")).or_default() += 1;
        }
        let is_searched = !declared.machine.mechanism.unknowns.is_empty();
        self.searched += usize::from(is_searched);
        let wrong = self.walk([drawing; 2], &declared, random, poses);
        self.wrong_of(seed, &growth.parts, &declared, wrong);
        if twins[0] && !drawing.params.is_empty() && !is_searched {
            self.with_other_params += 1;
            let mut other = drawing.clone();
            for param in &mut other.params {
                param.default += between(random, [-0.005, 0.005]);
            }
            let wrong = self.walk([drawing, &other], &declared, random, poses.div_ceil(4));
            self.wrong_of(seed, &growth.parts, &declared, wrong);
        }
        if twins[1] {
            let moved = moved(drawing, random);
            let declared = self.declared(&moved, &acting, seed % 4 == 3, random);
            let declared = declared.unwrap_or_else(|told| panic!("seed {seed}, moved: {told}"));
            self.moved += 1;
            let wrong = self.walk([&moved; 2], &declared, random, poses.div_ceil(4));
            self.wrong_of(seed, &growth.parts, &declared, wrong);
        }
        if twins[2] {
            self.take_driven_elsewhere(seed, &growth, &acting, random, poses.div_ceil(4));
        }
    }

    fn take_driven_elsewhere(
        &mut self,
        seed: u64,
        growth: &Growth,
        acting: &Acting,
        random: &mut Random,
        poses: usize,
    ) {
        let Some(elsewhere) = driven_elsewhere(&growth.drawing, random) else { return };
        match self.declared(&elsewhere, acting, false, random) {
            Ok(declared) => {
                self.driven_elsewhere += 1;
                self.searched_elsewhere +=
                    usize::from(!declared.machine.mechanism.unknowns.is_empty());
                let wrong = self.walk([&elsewhere; 2], &declared, random, poses);
                self.wrong_of(seed, &growth.parts, &declared, wrong);
            }
            Err(reason) => *self.refused_elsewhere.entry(reason).or_default() += 1,
        }
    }

    fn wrong_of(&mut self, seed: u64, parts: &[Part], declared: &Declared, wrong: Vec<String>) {
        if !wrong.is_empty() {
            let (wrong, source, docs) =
                (wrong.join("\n"), &declared.source, declared.machine.docs());
            self.wrong.push(format!("seed {seed}, {parts:?}:\n{wrong}\n{source}\n{docs}"));
        }
    }

    /// Compares poses along a walk, up to the first that does not agree: of the machine as it is declared, and as its
    /// parameters draw it.
    fn walk(
        &mut self,
        [as_declared, as_set]: [&Drawing; 2],
        Declared { machine, acting, .. }: &Declared,
        random: &mut Random,
        count: usize,
    ) -> Vec<String> {
        let truth = Truth::of(as_set);
        let params: Vec<_> = as_set.params.iter().map(|param| param.default).collect();
        let is_searched = !machine.mechanism.unknowns.is_empty();
        let drawn = machine.drawn_inputs();
        for (known, drawn) in as_declared.drawn_inputs().iter().zip(&drawn) {
            if (known - drawn).abs() > 1e-12 {
                return vec![format!("drawn at {drawn} in place of {known}")];
            }
        }
        let reaches = reaches(as_declared, machine);
        for pose in walking::poses(&truth, random, &reaches, is_searched, count) {
            let inputs: Vec<_> = pose.inputs.iter().map(|input| input.0).collect();
            let loads: Vec<_> = acting.loads.iter().map(|_| between(random, [-9.0, 9.0])).collect();
            let off = Off::of(&pose);
            let mut known = comparing::motion(&truth, &pose, &off);
            let mut entries = vec!["motion"];
            if let Some(efforts) = truth.efforts(acting, &pose, &loads) {
                self.with_forces += 1;
                entries.extend(["forces", "energy"]);
                known.extend(comparing::efforts(&truth, acting, &efforts, &off));
            }
            let found = compiled::results(machine, &entries, &inputs, &params, &loads);
            let (numbers, mut wrong) = comparing::compared(&found, &known);
            self.poses += 1;
            self.numbers += numbers;
            if !wrong.is_empty() {
                let condition = off.condition;
                let at = format!(
                    "condition {condition:.1e}, at {inputs:?} {loads:?}, drawn at {drawn:?}"
                );
                wrong.insert(0, at);
                return wrong;
            }
        }
        Vec::new()
    }
}
