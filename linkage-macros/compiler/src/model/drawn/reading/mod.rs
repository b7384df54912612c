//! Reads a drawing: its numbers, its names, and the frames and lines that these mean.

pub(in crate::model::drawn) mod bare_links;
pub(in crate::model::drawn) mod couplings;
pub mod framing;
pub(in crate::model::drawn) mod incidences;
pub(in crate::model::drawn) mod read_guides;
pub mod reader;
pub(in crate::model::drawn) mod shared_params;
pub mod values;
