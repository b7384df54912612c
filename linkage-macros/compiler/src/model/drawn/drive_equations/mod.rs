//! The inputs at which the drives are as drawn, and how each input moves what is driven.

pub(in crate::model::drawn) mod agreement;
pub(in crate::model::drawn) mod bent;
pub mod motions;
