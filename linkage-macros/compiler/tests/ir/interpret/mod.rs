//! Programs computed whole, as the oracle of what rewrites them.

pub(crate) mod whole_program;

use crate::function::Function;
pub(crate) use linkage_compiler::ir::interpret::*;
pub(crate) use whole_program::{amounts, interpret, jams};

/// A number that is searched for.
pub(crate) trait Searched: Number {
    /// The midpoint of what the number is known to lie in.
    fn point(&self) -> Self;

    /// The angle of the vector (x, self).
    fn atan2(&self, x: &Self) -> Self {
        Self::of(Function::Atan2, &[self, x])
    }
    fn hypot(&self, other: &Self) -> Self {
        Self::of(Function::Hypot, &[self, other])
    }
}

macro_rules! floats {
    ($($float:ty)+) => {$(
impl Searched for $float {
    fn point(&self) -> Self {
        *self
    }
}
    )+};
}

floats! { f32 f64 }
