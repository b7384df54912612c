//! The parts of what a drawing becomes, before they stand in order.

use crate::syntax::tree::Statement;

/// A statement of the groups.
pub(in crate::model::drawn) struct Written {
    /// The statement of the drawing behind which it stands.
    pub behind: usize,
    /// The search that it is part of.
    pub search: Option<usize>,
    pub statement: Statement,
}
