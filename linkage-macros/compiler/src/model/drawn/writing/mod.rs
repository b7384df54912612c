//! Makes groups of the steps of a cut, in solving order.

pub(in crate::model::drawn) mod as_unknown;
pub(in crate::model::drawn) mod bars;
pub(in crate::model::drawn) mod followed;
pub(in crate::model) mod free_names;
pub(in crate::model::drawn) mod held;
pub(in crate::model::drawn) mod modes_as_drawn;
pub(in crate::model::drawn) mod placed;
pub(in crate::model::drawn) mod rails;
pub(in crate::model::drawn) mod sorted;
pub(in crate::model::drawn) mod writer;
