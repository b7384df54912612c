//! Random drawn machines beside a truth that shares nothing with the compiler.
//!
//! A machine grows from the ground by a seed, and is written as a declaration. The truth takes the numbers of the
//! same statements: three coordinates for each link, two for each joint, an equation for all that a joint or a drive
//! holds, Newton's method on the whole, and full matrices for rates and forces. It knows no groups, no modes, no
//! frames but those that statements say.

mod acting;
mod acting_text;
mod comparing;
mod compiled;
mod drawing;
mod efforts;
mod growing;
mod jet;
mod loading;
mod matrix;
mod outcomes;
mod text;
mod truth;
mod walking;

use outcomes::Outcomes;

/// A seed a machine.
fn outcomes(first: u64, count: u64, poses: usize) -> Outcomes {
    let mut outcomes = Outcomes::default();
    for nth in first..first + count {
        // Seeds of the same distance from each other, none of them zero.
        outcomes.take(nth.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1, poses);
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

#[test]
fn random_machines_move_as_all_their_joints_say() {
    let first = std::env::var("LINKAGE_FIRST").ok().and_then(|text| text.parse().ok()).unwrap_or(1);
    let count =
        std::env::var("LINKAGE_COUNT").ok().and_then(|text| text.parse().ok()).unwrap_or(20);
    let poses = std::env::var("LINKAGE_POSES").ok().and_then(|text| text.parse().ok()).unwrap_or(2);
    outcomes(first, count, poses);
}
