//! The notation of tabulated truth: numbers only, no comparison.

use super::text::{after, all_of, lines_of, numbers, parts};

/// A number to about 22 digits: high part, low part, and its condition.
///
/// The condition is the absolute change of the number per unit relative change of every
/// dimension, input and rate, added up over all of them, plus the number's own size: rounding
/// every one of those once, to a width with spacing ε, may change the number by half ε times it.
#[derive(Clone, Copy, Debug)]
pub struct Truth(pub f64, pub f64, pub f64);

/// One pose of a table: where the inputs are, how fast they move, how they accelerate.
#[derive(Debug)]
pub struct Row {
    pub input: &'static [f64],
    pub rate: &'static [f64],
    pub second: &'static [f64],
    /// In the order of the table's outputs.
    pub position: &'static [Truth],
    pub velocity: &'static [Truth],
    pub acceleration: &'static [Truth],
}

/// Poses of one mechanism.
#[derive(Debug)]
pub struct Table {
    /// Names as in the mechanism's `OUTPUTS`, in the table's own order.
    pub outputs: &'static [&'static str],
    pub rows: &'static [Row],
}

impl Table {
    /// The table of this name in the text of a file: a line `outputs …`, and for every pose a line
    /// `pose inputs | rates | accelerations` and for every output a line
    /// `position | velocity | acceleration`, each a high part, a low part and a condition.
    pub fn read(text: &'static str, name: &str) -> Self {
        let mut lines = lines_of(text, name);
        let outputs: Vec<_> = after("outputs", lines.next()).split(' ').collect();
        let mut rows = Vec::new();
        while let Some(pose) = lines.next() {
            let truths = lines.by_ref().take(outputs.len());
            rows.push(Row::read(after("pose", Some(pose)), truths));
        }
        assert!(!rows.is_empty(), "no poses in {name}");
        Self { outputs: outputs.leak(), rows: rows.leak() }
    }
}

impl Row {
    fn read<'t>(pose: &str, truths: impl Iterator<Item = &'t str>) -> Self {
        let [input, rate, second] = all_of(parts(pose).map(|part| &*numbers(part).leak()));
        let mut orders = [const { Vec::new() }; 3];
        for truth in truths {
            for (order, part) in orders.iter_mut().zip(all_of::<_, 3>(parts(truth))) {
                let [high, low, condition] = all_of(numbers(part));
                order.push(Truth(high, low, condition));
            }
        }
        let [position, velocity, acceleration] = orders.map(|order| &*order.leak());
        Self { input, rate, second, position, velocity, acceleration }
    }
}
