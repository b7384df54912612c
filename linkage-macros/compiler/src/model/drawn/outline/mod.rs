//! The drawing: the frames of its links and the lines of its guides, its bodies by name, and what
//! messages say of them.

pub(in crate::model::drawn) mod bodies;
pub(in crate::model::drawn) mod frames;
pub(in crate::model::drawn) mod lengths;
pub(in crate::model::drawn) mod listed_assemblies;
pub(in crate::model::drawn) mod loose;
pub(in crate::model::drawn) mod messages;
