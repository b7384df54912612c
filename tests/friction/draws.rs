//! Random machines in both widths, with coefficients from none to far beyond what jams: a number or a refusal.
//!
//! An ordinary run makes 4,000 calls of each kind, and `.ci/nightly` 20,000.
//! `LINKAGE_FRICTION=1000000 cargo test --release -p linkage-tests --test dynamics friction::draws -- --nocapture` makes 10⁶.

use linkage_core::{Float, Record, SolveError};
use linkage_tests::mechanisms::friction::*;
use linkage_tests::random::{Random, cases};

fn count() -> usize {
    let asked = std::env::var("LINKAGE_FRICTION").ok();
    asked.map_or(cases(4000, 20_000), |count| count.parse().expect("a whole number"))
}

fn number<T: Float>(x: f64) -> T {
    T::lit(x, x as f32)
}

/// Answers, jammed machines, poses out of reach.
#[derive(Debug, Default)]
struct Counts {
    answered: usize,
    jams: usize,
    out_of_reach: usize,
}

impl Counts {
    fn count<T: Float>(&mut self, found: Result<&[T], SolveError>) {
        match found {
            Ok(numbers) => {
                assert!(numbers.iter().all(|number| number.value().is_finite()));
                self.answered += 1;
            }
            Err(SolveError::Jams { .. }) => self.jams += 1,
            Err(SolveError::OutOfReach { .. }) => self.out_of_reach += 1,
            Err(error) => panic!("{error}"),
        }
    }

    fn report(&self, name: &str) {
        println!("{name}: {self:?}");
        let all = self.answered + self.jams + self.out_of_reach;
        // A run of one kind of answer would try little.
        assert!(10 * self.answered > all && 10 * self.jams > all, "{self:?}");
    }
}

/// Coefficients whose logarithm is uniform, so that ρ is on both sides of one.
fn coefficient(random: &mut Random) -> f64 {
    10.0_f64.powf(random.between(-3.0, 1.5))
}

fn inverse<T: Float>(name: &str) {
    let (mut random, mut counts) = (Random::new(31), Counts::default());
    for nth in 0..count() {
        let groups = RubbingGroups::<T> {
            mu: number(coefficient(&mut random)),
            radius: number(random.between(0.0, 0.03)),
        };
        let mut draw = |size: f64| number::<T>(random.between(-size, size));
        let (q, rate, accel, push) = (draw(3.2), draw(9.0), draw(40.0), draw(500.0));
        let found = match nth % 3 {
            0 => groups.forces(q, rate, accel, push),
            1 => groups.forces(q, number(0.0), accel, push),
            _ => groups.statics(q, rate, push),
        };
        let found = found.map(Record::into_array);
        counts.count(found.as_ref().map(|numbers| &numbers[..]).map_err(|error| *error));
    }
    counts.report(name);
}

fn forward<T: Float>(name: &str) {
    let (mut random, mut counts) = (Random::new(37), Counts::default());
    for nth in 0..count() {
        let mu = number(coefficient(&mut random));
        let press = RubbingPress::<T> { pins: mu, ways: mu, ..RubbingPress::default() };
        let mut draw = |size: f64| number::<T>(random.between(-size, size));
        let (q, rate, drive, push) = (draw(3.2), draw(9.0), draw(90.0), draw(500.0));
        let rate = if nth % 5 == 0 { number(0.0) } else { rate };
        let found = press.forward_dynamics(q, rate, drive, push).map(|second| [second]);
        counts.count(found.as_ref().map(|numbers| &numbers[..]).map_err(|error| *error));
        let held = press.holding(q, push);
        counts.count(held.as_ref().map(|numbers| &numbers[..]).map_err(|error| *error));
        if let Ok([backwards, forwards]) = held {
            assert!(backwards.value() <= forwards.value(), "{q:?} {mu:?}");
        }
    }
    counts.report(name);
}

#[test]
fn draws_of_a_motion_are_answered_or_jam() {
    inverse::<f64>("inverse, f64");
    inverse::<f32>("inverse, f32");
}

#[test]
fn draws_of_drives_are_answered_or_jam() {
    forward::<f64>("forward, f64");
    forward::<f32>("forward, f32");
}

/// Single precision is double precision to its own last places: the full matrix checks the latter.
///
/// Reactions are sums of some thirty terms, each within ε of the largest, next to a toggle over its
/// sine, and amounts add 10ε/(1 − ρ). Both are unknown here, so 19 of 20 answers are held to 200 ε. An ordinary run
/// samples what `.ci/nightly` draws whole.
#[test]
fn single_precision_follows_double_precision() {
    let (mut random, mut compared, mut off) = (Random::new(41), 0, 0);
    let draws = cases(3000, 20_000);
    for _ in 0..draws {
        let (mu, radius) = (random.between(0.0, 0.3), random.between(0.0, 0.03));
        let mut draw = |size: f64| random.between(-size, size);
        let (q, rate, accel, push) = (draw(3.2), draw(9.0), draw(40.0), draw(500.0));
        let wide = RubbingGroups { mu, radius }.forces(q, rate, accel, push);
        let single = [q, rate, accel, push].map(|x| x as f32);
        let narrow = RubbingGroups::<f32> { mu: mu as f32, radius: radius as f32 };
        let narrow = narrow.forces(single[0], single[1], single[2], single[3]);
        let (Ok(wide), Ok(narrow)) = (wide, narrow) else { continue };
        let (wide, narrow) = (wide.into_array(), narrow.into_array());
        let largest = wide.iter().fold(0.0_f64, |size, value| size.max(value.abs()));
        let apart = wide.iter().zip(narrow).map(|(wide, narrow)| (wide - f64::from(narrow)).abs());
        let apart = apart.fold(0.0, f64::max) / largest;
        compared += 1;
        off += usize::from(apart > 200.0 * f64::from(f32::EPSILON));
    }
    assert!(compared > draws * 3 / 10 && 20 * off < compared, "{off} of {compared}");
}
