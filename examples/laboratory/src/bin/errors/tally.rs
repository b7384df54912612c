//! The results of all poses of a group, and the tables of them.

use linkage_tests::measured::Width;

use crate::measure::Sample;
use crate::poses::{Place, Pose};
use crate::twins::{Twin, WAYS};

/// The largest error of an order, and where it was found.
#[derive(Clone, Default)]
struct Worst {
    error: f64,
    at: String,
}

/// Everything about a group in one width.
pub(crate) struct Tally {
    pub(crate) group: &'static str,
    width: Width,
    poses: usize,
    /// By way and order.
    errors: [[Vec<f32>; 3]; WAYS.len()],
    worst: [[Worst; 3]; WAYS.len()],
    /// The largest by place, for the table of places.
    places: [[[f64; 3]; WAYS.len()]; 4],
    refused: [usize; WAYS.len()],
    /// Solved with constants alone, with parameters alone, and refused for different reasons.
    differences: [usize; 3],
    /// The number of these poses that the data decide.
    decided: usize,
    different: Vec<String>,
}

impl Tally {
    pub(crate) fn new(group: &'static str, width: Width) -> Self {
        Self {
            group,
            width,
            poses: 0,
            errors: Default::default(),
            worst: Default::default(),
            places: Default::default(),
            refused: Default::default(),
            differences: Default::default(),
            decided: 0,
            different: Vec::new(),
        }
    }

    pub(crate) fn note(&mut self, twin: &Twin, pose: &Pose, sample: Sample) {
        self.poses += 1;
        for (way, errors) in sample.errors.iter().enumerate() {
            let Some(errors) = errors else { continue };
            for (order, &error) in errors.iter().enumerate() {
                self.errors[way][order].push(error as f32);
                let place = &mut self.places[pose.place as usize][way][order];
                *place = place.max(error);
                let worst = &mut self.worst[way][order];
                if error > worst.error {
                    *worst = Worst { error, at: format!("{} {pose:?}", twin.name) };
                }
            }
        }
        let [_, motions] = &sample.refusals;
        self.refused
            .iter_mut()
            .zip(motions)
            .for_each(|(count, refusal)| *count += usize::from(refusal.is_some()));
        self.decided += usize::from(sample.is_decided);
        for [first, second] in &sample.refusals {
            let kind = match (first, second) {
                (None, Some(_)) => 0,
                (Some(_), None) => 1,
                (Some(a), Some(b)) if core::mem::discriminant(a) != core::mem::discriminant(b) => 2,
                _ => continue,
            };
            self.differences[kind] += 1;
            if sample.is_decided && self.different.len() < 3 {
                self.different.push(format!("{} {first:?} {second:?} {pose:?}", twin.name));
            }
        }
    }
}

const ORDERS: [&str; 3] = ["position", "velocity", "acceleration"];
const PLACES: [Place; 4] = [Place::Anywhere, Place::ManyTurns, Place::QuarterTurn, Place::Limit];

/// The error that one of a thousand exceeds.
fn high(errors: &[f32]) -> f32 {
    let mut errors = errors.to_vec();
    errors.sort_by(f32::total_cmp);
    errors.get(errors.len() * 999 / 1000).copied().unwrap_or_default()
}

pub(crate) fn report(tallies: &[Vec<Tally>; 2]) {
    let all = || tallies.iter().flatten();
    let (poses, measured) =
        (all().map(|tally| tally.poses), all().map(|tally| tally.errors[0][0].len()));
    println!("{} poses, {} of them measured\n", poses.sum::<usize>(), measured.sum::<usize>());
    println!("Worst error and the one that a thousandth exceeds:\n");
    println!("{:25} {:7} {:8} {:^18} {:^18} {:^18}", "", "", "", ORDERS[0], ORDERS[1], ORDERS[2]);
    for tally in all() {
        for (way, name) in WAYS.iter().enumerate() {
            print!("{:25} {:7} {name:8}", tally.group, format!("{:?}", tally.width));
            for order in 0..3 {
                let high = high(&tally.errors[way][order]);
                print!(" {:9.2} {high:8.2}", tally.worst[way][order].error);
            }
            println!();
        }
    }
    places(tallies);
    refusals(tallies);
    println!("\nTunable worse than constant by more than 1.3, in the worst or in a thousandth:");
    all().for_each(Tally::print_worse);
}

fn places(tallies: &[Vec<Tally>; 2]) {
    println!("\nWorst errors by where the poses are:\n");
    for place in PLACES {
        for (way, name) in WAYS.iter().enumerate() {
            print!("{:12} {name:8}", format!("{place:?}"));
            for order in 0..3 {
                let of = |tally: &Tally| tally.places[place as usize][way][order];
                let worst = tallies.iter().flatten().map(of).fold(0.0, f64::max);
                print!(" {worst:9.2}");
            }
            println!();
        }
    }
}

fn refusals(tallies: &[Vec<Tally>; 2]) {
    println!(
        "\nRefused, constant and tunable; solved by the first alone, by the last alone, refused otherwise, decided by the data:\n"
    );
    for tally in tallies.iter().flatten() {
        let ([first, last, otherwise], decided) = (tally.differences, tally.decided);
        print!("{:25} {:7}", tally.group, format!("{:?}", tally.width));
        println!(" {:?} of {}; {first} {last} {otherwise} {decided}", tally.refused, tally.poses);
        tally.different.iter().for_each(|text| println!("    {text}"));
    }
}

impl Tally {
    fn print_worse(&self) {
        let [first, last] = [&self.worst[0], &self.worst[WAYS.len() - 1]];
        for (order, name) in ORDERS.iter().enumerate() {
            let highs = [0, WAYS.len() - 1].map(|way| high(&self.errors[way][order]));
            let worse = last[order].error / first[order].error;
            let often = highs[1] / highs[0];
            if worse > 1.3 || often > 1.3 {
                println!(
                    "{} {:?} {name}: worst {worse:.2} times, a thousandth {often:.2} times\n    {:.2} at {}",
                    self.group, self.width, last[order].error, last[order].at
                );
            }
        }
    }
}
