//! How tabulated truth is written down: numbers only, no comparison.

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
