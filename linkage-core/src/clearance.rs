//! Clearances of the groups and their rates, by which a solver reports how near each group is to its
//! limit.

mod jet;
mod told;

pub(crate) use jet::Jet;
pub(crate) use told::moving;
pub use told::told;

/// The distance of a group from its limit: zero at a toggle, negative out of reach.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Clearance<T> {
    /// The value under the square root of the group's height.
    pub value: T,
    /// Its rate.
    pub rate: T,
    /// Its second rate, the inputs' rates being constant.
    pub second_rate: T,
    /// Against this the rounding of `value` is a few ε.
    pub scale: T,
}
