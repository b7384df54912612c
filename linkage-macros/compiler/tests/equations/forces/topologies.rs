//! Random mechanisms: every driver and group on whatever stands before it.

use super::{check, loaded};
use crate::diagnostics::Diagnostics;
use crate::ir::interpret::{ProgramValues, interpret};
use crate::{equations, model, passes, syntax};

/// Numbers that repeat: Knuth's linear congruence.
#[derive(Clone)]
struct Random(u64);

impl Random {
    fn unit(&mut self) -> f64 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    /// To three decimals, so that a declaration stays readable.
    fn within(&mut self, low: f64, high: f64) -> f64 {
        ((low + (high - low) * self.unit()) * 1000.0).round() / 1000.0
    }

    fn one<'a, T>(&mut self, all: &'a [T]) -> &'a T {
        &all[((self.unit() * all.len() as f64) as usize).min(all.len() - 1)]
    }
}

/// A mechanism in the making: what new groups may stand on.
#[derive(Clone)]
struct Topology {
    random: Random,
    text: String,
    points: Vec<String>,
    links: Vec<String>,
    guides: Vec<String>,
    sliding: Vec<String>,
    count: usize,
}

impl Topology {
    fn of(seed: u64) -> Self {
        let text = "input q: angle; input s: length; ground A(0, 0), D(1.1, 0.1);\
             guide rail through (0.3, -0.6) along 10deg;\
             crank AB(A) -> B { length: 0.3, angle: q } slider ram(rail) -> P { slide: s }";
        let names = |names: &[&str]| names.iter().map(ToString::to_string).collect();
        let mut topology = Self {
            random: Random(seed),
            text: text.to_string(),
            points: names(&["A", "B", "D", "P"]),
            links: names(&["AB", "ram"]),
            guides: names(&["rail"]),
            sliding: names(&["ram"]),
            count: 0,
        };
        topology.random.unit();
        topology
    }

    /// A length that may be driven.
    fn length(&mut self, low: f64, high: f64) -> String {
        let constant = self.random.within(low, high);
        let kind = self.random.unit();
        let sliding = self.random.one(&self.sliding).clone();
        match kind {
            kind if kind < 0.12 => format!("{constant} + 0.2 * s"),
            kind if kind < 0.24 => format!("{constant} + 0.05m * q"),
            kind if kind < 0.32 => format!("{constant} + 0.1 * {sliding}.slide"),
            _ => format!("{constant}"),
        }
    }

    fn angle(&mut self) -> String {
        let constant = self.random.within(-2.0, 2.0);
        let kind = self.random.unit();
        let link = self.random.one(&self.links).clone();
        let sliding = self.random.one(&self.sliding).clone();
        match kind {
            kind if kind < 0.2 => format!("{constant} + 0.3 * q"),
            kind if kind < 0.35 => format!("{constant} - 2 * {link}.angle"),
            kind if kind < 0.5 => format!("{constant} + {sliding}.slide / 0.7m"),
            _ => format!("{constant}"),
        }
    }

    fn two_points(&mut self) -> [String; 2] {
        loop {
            let pair = [(); 2].map(|()| self.random.one(&self.points).clone());
            if pair[0] != pair[1] {
                return pair;
            }
        }
    }

    /// The declaration with one statement more.
    fn grown(&mut self) {
        self.count += 1;
        let n = self.count;
        let (l, m, pin) = (format!("l{n}"), format!("m{n}"), format!("C{n}"));
        let [b, d] = self.two_points();
        let guide = self.random.one(&self.guides).clone();
        let [first, second] = [self.length(0.7, 1.4), self.length(0.7, 1.4)];
        let offset = self.length(-0.1, 0.1);
        let side = *self.random.one(&["left", "right"]);
        let sense = *self.random.one(&["ahead", "behind"]);
        let mut made = vec![l.clone()];
        let statement = match self.random.within(0.0, 9.0) as u32 {
            0 => {
                let (angle, against) = (self.angle(), self.random.one(&self.links).clone());
                self.points.push(pin.clone());
                format!(
                    "crank {l}({b}) -> {pin} {{ length: {offset} + 0.3, angle: {angle}, relative_to: {against} }}"
                )
            }
            1 => {
                self.points.push(pin.clone());
                self.sliding.push(l.clone());
                format!("slider {l}({guide}) -> {pin} {{ slide: {first}, offset: {offset} }}")
            }
            2 | 3 => {
                self.points.push(pin.clone());
                made.push(m.clone());
                format!(
                    "rrr {l}({b}), {m}({d}) -> {pin} {{ lengths: ({first}, {second}), mode: {side} }}"
                )
            }
            4 => {
                self.points.push(pin.clone());
                self.sliding.push(m.clone());
                made.push(m.clone());
                format!(
                    "rrp {l}({b}), {m}({guide}) -> {pin} {{ length: {first}, offset: {offset}, mode: {sense} }}"
                )
            }
            5 => {
                self.sliding.push(l.clone());
                made.push(m.clone());
                format!("rpr {l}({b}), {m}({d}) {{ offset: {offset}, mode: {sense} }}")
            }
            6 => {
                self.sliding.extend([l.clone(), m.clone()]);
                made.push(m.clone());
                let angle = self.angle();
                format!(
                    "rpp {l}({b}), {m}({guide}) {{ slot: {angle}, offsets: ({offset}, {first} / 5) }}"
                )
            }
            7 => {
                let (on, angle) = (self.random.one(&self.links).clone(), self.angle());
                let (x, y) = (self.length(-0.1, 0.1), self.length(0.1, 0.3));
                self.guides.push(format!("g{n}"));
                made.clear();
                format!("guide g{n} on {on} through ({x}, {y}) along {angle};")
            }
            _ => {
                let on = self.random.one(&self.links).clone();
                let (x, y) = (self.length(-0.1, 0.1), self.length(0.1, 0.3));
                self.points.push(pin.clone());
                made.clear();
                format!("point {pin} on {on} at ({x}, {y});")
            }
        };
        self.text += &statement;
        self.links.extend(made);
    }
}

/// True if the declaration is valid and assembles at the pose, well off its limits.
fn assembles(source: &str, inputs: &[[f64; 3]]) -> bool {
    let mut diagnostics = Diagnostics::new();
    let tree = syntax::parse(source.parse().expect("tokens"), &mut diagnostics);
    let mechanism = tree.and_then(|tree| model::resolve(&tree, &mut diagnostics).ok());
    drop(diagnostics.into_mistakes());
    let Some(mechanism) = mechanism else { return false };
    let program = equations::derive(&mechanism, passes::RULES);
    let inputs = inputs.to_vec();
    let given = ProgramValues {
        inputs,
        params: Vec::new(),
        loads: vec![0.0; 9],
        drives: vec![0.0; 9],
        unit: None,
    };
    let values = interpret(&program, &given);
    let motion = program.answer("motion").expect("there is a motion");
    // Accelerations grow next to limits, and what stands on them loses digits.
    motion.sinks.iter().all(|sink| values[sink.index()].abs() < 300.0)
}

/// A random mechanism of up to a dozen links that assembles, and its number of statements.
pub(in crate::equations) fn random_mechanism(seed: u64, inputs: &[[f64; 3]]) -> (String, usize) {
    let mut topology = Topology::of(seed * 7919 + 1);
    let mut statements = 0;
    for _ in 0..30 {
        let before = topology.clone();
        topology.grown();
        if assembles(&format!("struct M {{ {} }}", topology.text), inputs) {
            statements += 1;
        } else {
            let random = Random(topology.random.0);
            topology = Topology { random, count: topology.count, ..before };
        }
        if topology.links.len() > 12 {
            break;
        }
    }
    // A mass at a place that reads an earlier link.
    topology.text += "mass 0.7 on AB at (0.1 + 0.3 * ram.slide, -0.2 * ram.slide) inertia 0.02;";
    (loaded(&format!("struct M {{ {} }}", topology.text)), statements)
}

const POSE: [[f64; 3]; 2] = [[0.7, 1.3, -0.6], [0.41, -0.4, 0.9]];

/// Two topologies; `.ci/nightly` takes eleven.
#[test]
fn two_topologies_agree_with_newton_and_euler() {
    assert!(statements_that_agree([0, 100]) > 8);
}

#[test]
#[ignore = "minutes: `.ci/nightly` takes it"]
fn random_topologies_agree_with_newton_and_euler() {
    assert!(statements_that_agree((0..8).chain(100..103)) > 60);
}

fn statements_that_agree(seeds: impl IntoIterator<Item = u64>) -> usize {
    let mut statements = 0;
    for seed in seeds {
        let (source, count) = random_mechanism(seed, &POSE);
        check(&format!("seed {seed}"), &source, &POSE);
        statements += count;
    }
    statements
}
