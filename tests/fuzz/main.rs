//! Every public entry point of many mechanisms, called with numbers of any class and next to the
//! limits of assembly: nothing comes back but right answers and typed errors.
//!
//! The ordinary run makes 40,000 calls. `LINKAGE_FUZZ=100000000 cargo test --release -p
//! linkage-tests --test fuzz -- --nocapture` makes 10⁸, `LINKAGE_FUZZ_SEED` others.

#![allow(clippy::needless_update, reason = "a mechanism may have one parameter or several")]

mod calls;
#[macro_use]
mod mechanism;
mod declared;
mod driven;
mod moved;
mod numbers;
mod ranged;
mod state;
mod truth;

use calls::Calls;
use numbers::{Number, Source};

fn number_from(variable: &str, default: u64) -> u64 {
    let value = std::env::var(variable).ok();
    value.map_or(default, |value| value.parse().expect("a whole number"))
}

/// Half of all calls, in numbers of one width.
fn run<T: Number>() {
    let (count, seed) = (number_from("LINKAGE_FUZZ", 40_000), number_from("LINKAGE_FUZZ_SEED", 1));
    let mut calls = Calls::default();
    let mut source = Source::new(seed);
    declared::run::<T>(&mut source, count / 2, &mut calls);
    moved::run::<T>(&mut source, count / 4, &mut calls);
    ranged::run::<T>(&mut source, count / 8, &mut calls);
    driven::run::<T>(&mut source, count / 8, &mut calls);
    let report = calls.report(T::NAME);
    println!("{report}");
    assert!(calls.wrong.is_empty(), "{report}");
    // Calls that are all refused, or all answered, would try little.
    for kind in ["Ok", "OutOfReach", "Singular", "Invalid", "NotFinite", "OffCircle", "NoSolution"]
    {
        let share =
            calls.answers.get(kind).copied().unwrap_or_default() as f64 / calls.count as f64;
        assert!(share > 1e-4, "{share} of the calls are answered by {kind}");
    }
}

#[test]
fn nothing_but_right_answers_and_typed_errors_in_f64() {
    run::<f64>();
}

#[test]
fn nothing_but_right_answers_and_typed_errors_in_f32() {
    run::<f32>();
}
