//! Poses of a block: at random, next to where it begins to refuse, and of numbers that no machine has.

use super::evaluator::{Machine, Stopped, Value};
use super::in_c::answer;
use super::reader::{Basic, Unit};
use crate::random;

/// The tests' generator.
pub(crate) struct Random(random::Random);

impl Random {
    pub(crate) fn new(seed: u64) -> Self {
        Self(random::Random::new(seed))
    }

    /// Between −1 and 1.
    pub(crate) fn unit(&mut self) -> f64 {
        2.0 * self.0.unit() - 1.0
    }

    pub(crate) fn below(&mut self, end: usize) -> usize {
        (self.0.bits() % end as u64) as usize
    }
}

/// The answer of a block: its status, what it refuses, and its results.
#[derive(Clone, Debug)]
pub(crate) struct Told {
    pub status: i64,
    pub refused: String,
    pub numbers: Vec<f64>,
}

/// A call of a block with these numbers for its pins.
pub(crate) fn told(machine: &Machine<'_>, block: &Unit, given: &[f64]) -> Result<Told, Stopped> {
    let mut numbers = machine.fresh(block);
    let places = block.inputs.iter().flat_map(|(_, at, count)| *at..at + count);
    for (place, &number) in places.zip(given) {
        numbers[place] = Value::of(block.fields[place].basic, number);
    }
    // A block keeps what it said before.
    for (_, at, count) in &block.outputs {
        let said = numbers.iter_mut().zip(&block.fields).skip(*at).take(*count);
        for (number, field) in said {
            *number = match number {
                Value::Int(_) => Value::Int(77),
                Value::Text(_) => Value::Text("before".to_string()),
                _ => Value::of(field.basic, 0.5),
            };
        }
    }
    machine.run(block, &mut numbers)?;
    let (status, refused) = (block.outputs[0].1, block.outputs[1].1);
    let Value::Int(status) = numbers[status] else { panic!("a status is an integer") };
    let Value::Text(refused) = numbers[refused].clone() else { panic!("a name is a text") };
    let (at, count) = answer(block);
    let numbers = numbers[at..at + count].iter().map(Value::number).collect();
    Ok(Told { status, refused, numbers })
}

/// Numbers for the pins of a block: those of a machine of about a metre.
pub(crate) fn at_random(block: &Unit, random: &mut Random) -> Vec<f64> {
    let scale = [1.0, 0.4, 6.0, 0.05][random.below(4)];
    let angle = 7.0 * random.unit();
    let radius = 1.0 + 0.12 * random.unit();
    let mut given = Vec::new();
    for (pin, at, count) in &block.inputs {
        for field in &block.fields[*at..at + count] {
            given.push(match &pin[..] {
                "MECHANISM" if field.basic == Basic::Int => [1.0, -1.0, 1.0, 0.0][random.below(4)],
                "MECHANISM" if random.below(3) > 0 => field.first,
                "MECHANISM" => field.first * (1.0 + 0.3 * random.unit()),
                "COSINE" => radius * angle.cos(),
                "SINE" => radius * angle.sin(),
                _ => scale * random.unit(),
            });
        }
    }
    // A mode that is none is seldom.
    if random.below(8) > 0 {
        given.iter_mut().zip(fields(block)).for_each(|(number, field)| {
            if field == Basic::Int && *number == 0.0 {
                *number = 1.0;
            }
        });
    }
    given
}

fn fields(block: &Unit) -> impl Iterator<Item = Basic> {
    let places = block.inputs.iter().flat_map(|(_, at, count)| *at..at + count);
    places.map(|place| block.fields[place].basic)
}

/// Some of these numbers put in the place of others.
pub(crate) fn strange(block: &Unit, mut given: Vec<f64>, random: &mut Random) -> Vec<f64> {
    const NUMBERS: [f64; 18] = [
        f64::NAN,
        f64::INFINITY,
        f64::NEG_INFINITY,
        1e300,
        -1e300,
        1e-300,
        5e-324,
        1e-40,
        1e-12,
        0.0,
        -0.0,
        1e6,
        2e6,
        1e10,
        -1e12,
        3e19,
        1e21,
        3.4e38,
    ];
    let kinds: Vec<Basic> = fields(block).collect();
    for _ in 0..=random.below(3) {
        let at = random.below(given.len());
        if kinds[at] != Basic::Int {
            given[at] = NUMBERS[random.below(NUMBERS.len())];
        }
    }
    given
}

/// Poses on both sides of where a block begins to refuse, between one that it answers and one that it does not.
pub(crate) fn at_a_limit(
    machine: &Machine<'_>,
    block: &Unit,
    [inside, outside]: [&[f64]; 2],
    random: &mut Random,
) -> Result<Vec<Vec<f64>>, Stopped> {
    let between = |share: f64| -> Vec<f64> {
        inside.iter().zip(outside).map(|(a, b)| a + share * (b - a)).collect()
    };
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..40 {
        let middle = 0.5 * (low + high);
        match told(machine, block, &between(middle))?.status {
            0 => low = middle,
            _ => high = middle,
        }
    }
    // Within a few units in the last place of either type of numbers.
    let steps = [0.0, 1e-16, 3e-16, 2e-15, 6e-8, 2e-7, 1e-6];
    let beside = (0..6).map(|_| low + random.unit() * steps[random.below(steps.len())]);
    Ok(beside.chain([low, high]).map(between).collect())
}
