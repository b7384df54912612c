//! Random drawn machines beside a truth that shares nothing with the compiler.
//!
//! A machine grows from the ground by a seed, and is written as a declaration. The truth takes the numbers of the
//! same statements: three coordinates for each link, two for each joint, an equation for all that a joint or a drive
//! holds, Newton's method on the whole, and full matrices for rates and forces. It knows no groups, no modes, no
//! frames but those that statements say.

pub(crate) mod acting;
pub(crate) mod acting_sum;
pub(crate) mod acting_text;
pub(crate) mod comparing;
pub(crate) mod compiled;
pub(crate) mod drawing;
pub(crate) mod efforts;
pub(crate) mod growing;
pub(crate) mod jet;
pub(crate) mod loading;
pub(crate) mod matrix;
pub(crate) mod outcomes;
pub(crate) mod parts;
pub(crate) mod text;
pub(crate) mod truth;
pub(crate) mod walking;

use growing::PARTS;
use outcomes::{Outcomes, Sample};

/// Messages about machines that are driven at a link at random: that one unknown does not solve them, that a gear turns
/// what it is read from, which is not followed backwards, or that the drawing is next to a limit.
const REFUSED: [&str; 6] = [
    "class III or higher",
    "fight",
    "a dead point",
    "draw another pose",
    "close to the drawing",
    "what pushes in its joints is not known",
];

/// Machines of consecutive seeds, every number of which is right.
fn outcomes(seeds: std::ops::Range<u64>, sample: impl Fn(u64) -> Sample) -> Outcomes {
    let mut outcomes = Outcomes::default();
    for nth in seeds {
        outcomes.take(nth.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1, sample(nth));
    }
    for wrong in &outcomes.wrong {
        println!("{wrong}\n");
    }
    let is_right = outcomes.wrong.is_empty();
    outcomes.wrong.clear();
    println!("{outcomes:?}");
    assert!(is_right, "numbers are wrong");
    outcomes
}

/// Small machines, and one twin of each. `.ci/nightly` takes all twins of ten times as many.
#[test]
fn random_machines_are_what_all_their_joints_say() {
    let twins = |nth| [0, 1, 2].map(|twin| nth % 3 == twin);
    let found = outcomes(1..21, |nth| Sample { poses: 2, most_links: 10, twins: twins(nth) });
    assert_eq!(found.compiled, 20, "{:?}", found.refused);
    assert!(found.numbers > 4_000 && found.with_forces > 40, "{found:?}");
}

#[test]
#[ignore = "minutes: `.ci/nightly` takes it"]
fn many_random_machines_are_what_all_their_joints_say() {
    let found = outcomes(1..201, |_| Sample { poses: 60, most_links: 15, twins: [true; 3] });
    assert!(found.compiled > 190, "{:?}", found.refused);
    assert!(found.searched > 10 && found.searched_elsewhere > 30, "{found:?}");
    for refused in found.refused.keys().chain(found.refused_elsewhere.keys()) {
        assert!(REFUSED.iter().any(|known| refused.contains(known)), "{refused}");
    }
    assert!(found.refused_elsewhere.values().sum::<usize>() < 25, "{found:?}");
    for part in PARTS {
        assert!(found.parts.get(&format!("{part:?}")).is_some_and(|&count| count > 4), "{part:?}");
    }
}
