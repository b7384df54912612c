//! How tabulated truth is written down: numbers only, no comparison.

/// A number to about 22 digits: high part, low part, and its condition.
///
/// The condition is the absolute change of the number per unit relative change of every
/// dimension, input and rate, added up over all of them, plus the number's own size: rounding
/// every one of those once, to a width with spacing ε, may change the number by half ε times it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Truth(pub(crate) f64, pub(crate) f64, pub(crate) f64);

/// One pose of a table: where the inputs are, how fast they move, how they accelerate.
#[derive(Debug)]
pub(crate) struct Row {
    pub(crate) input: &'static [f64],
    pub(crate) rate: &'static [f64],
    pub(crate) second: &'static [f64],
    /// In the order of the table's outputs.
    pub(crate) position: &'static [Truth],
    pub(crate) velocity: &'static [Truth],
    pub(crate) acceleration: &'static [Truth],
}

/// Poses of one mechanism.
#[derive(Debug)]
pub(crate) struct Table {
    /// Names as in the mechanism's `OUTPUTS`, in the table's own order.
    pub(crate) outputs: &'static [&'static str],
    pub(crate) rows: &'static [Row],
}
