//! Elementary functions on `f32` and `f64`: straight line, no branch, no library call.
//!
//! A kernel states its precondition, its error bound and where the method comes from, and is
//! tested against more digits than it has. It knows nothing of mechanisms, and it is generic only
//! in whether multiplications and additions are fused ([`Fusion`]), so that a lane computes the
//! same bits as a single number.

mod arc;
pub(crate) mod arithmetic;
mod error_free;
mod far;
mod float;
mod fusion;
mod native;
mod sin_cos_f32;
mod sin_cos_f64;

#[cfg(test)]
mod accuracy;
#[cfg(test)]
pub(crate) mod double_word;
#[cfg(test)]
mod far_arguments;
#[cfg(test)]
mod hard_arguments;

pub(crate) use error_free::{det, exact_sum, mul_err, two_sum};
pub(crate) use float::Elementary;
pub use float::Float;
pub(crate) use fusion::Native;
pub use fusion::{Fused, Fusion, Plain};
pub(crate) use native::{sqrt, sqrtf};
pub(crate) use sin_cos_f32::LIMIT as NEAR_F32;
pub(crate) use sin_cos_f64::LIMIT as NEAR_F64;
