//! Two frictions in one routine: where either leaves the fast path, the slow one computes both.

use std::vec::Vec;

use super::amounts;
use super::cases::{Case, Random, bits};
use crate::friction::System;

/// The first has amounts of straight-line code, which are told from the slow path's by a share of 2⁻²⁰, and which
/// its own conditions or the steps of the second refuse now and then.
pub(super) fn routines() -> impl Iterator<Item = Case> {
    let mut random = Random::new(37);
    (0..6_000).map(move |_| {
        let [first, second] = [(); 2].map(|()| amounts::system(&mut random, 2, false));
        let slow = [&first, &second].map(|of| amounts::answer(of));
        let told = |amount: &f64| amount * (1.0 + 2.0_f64.powi(-20));
        let found = numbers(&slow[0]).map(|amounts| amounts.iter().map(told).collect::<Vec<_>>());
        let [is_positive, small] = [(); 2].map(|()| !random.bits().is_multiple_of(8));
        // Straight-line code finds no amounts of joints that jam.
        let positive = is_positive && found.is_some();
        let found = found.unwrap_or_else(|| [1.0, 2.0].into());
        let is_fast = positive && small && found.iter().all(|x| x.is_finite());
        let answer = match slow.each_ref().map(|answer| numbers(answer)) {
            [None, _] => slow[0].clone(),
            [_, None] => slow[1].clone(),
            [Some(exact), Some(other)] => {
                let first = if is_fast && ends_at_once(&second) { found.clone() } else { exact };
                first.into_iter().chain(other).map(bits).collect::<Vec<_>>().join(" ")
            }
        };
        let conditions = [if positive { 1.0 } else { 0.0 }, if small { 1e-17 } else { 1e-15 }];
        Case { name: "routine", given: [&conditions[..], &found, &first, &second].concat(), answer }
    })
}

/// The amounts of an answer, or none where it is a refusal.
fn numbers(answer: &str) -> Option<Vec<f64>> {
    answer.split(' ').map(|word| u64::from_str_radix(word, 16).ok().map(f64::from_bits)).collect()
}

/// True if the steps of the fast path are enough.
fn ends_at_once(given: &[f64]) -> bool {
    let rows = core::array::from_fn(|j| core::array::from_fn(|i| given[4 + 7 * j + i]));
    let (amounts, is_met) =
        System::<f64, 7, 2> { rows, guides: given[1] as u32 }.stepped([given[2], given[3]]);
    is_met && amounts.iter().all(|amount| amount.is_finite())
}

/// Both answers of a routine, as the script has them.
pub(super) const ROUTINE: &str = r#"
const routine = ([positive, small, ...numbers]) => {
  const found = numbers.slice(0, 2), systems = [numbers.slice(2, 20), numbers.slice(20)];
  const formulas = (checks) => systems.flatMap(([, guides, ...given], nth) => {
    const rows = [given.slice(2, 9), given.slice(9)], own = nth === 0 ? [found, [positive], [[small, 1]]] : [];
    return amountsOf(checks, given.slice(0, 2), rows, guides, ["0", "1"], ...own);
  });
  const { numbers: amounts, error } = solved([], formulas, String);
  return error ? `${error.kind} ${error.group}` : amounts.map(bits).join(" ");
};
"#;
