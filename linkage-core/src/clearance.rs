//! How clear of its limit each group is, with rates: what a solver says of itself to whoever follows its
//! motion.

mod jet;
mod told;

pub(crate) use jet::Jet;
pub(crate) use told::moving;
pub use told::told;

/// How clear of its limit a group is: zero at a toggle, negative out of reach.
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
