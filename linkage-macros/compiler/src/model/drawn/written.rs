//! The parts of what a drawing becomes, before they stand in order.

use proc_macro2::Ident;

use crate::syntax::tree::Statement;

/// A statement of the groups.
pub(super) struct Written {
    /// The statement of the drawing behind which it stands.
    pub behind: usize,
    /// The search that it is part of.
    pub search: Option<usize>,
    pub statement: Statement,
}

/// An unknown, and how far the machine was followed with it.
pub(super) struct Sought {
    pub unknown: Ident,
    /// The name of what it is measured from, where that follows the drive.
    pub traced: Option<Ident>,
    pub stretches: Vec<Stretch>,
}

/// The ends to which a motion was followed, from the drawing.
pub(super) struct Stretch {
    /// The input, where several drive the machine.
    pub input: Option<Ident>,
    pub ends: [f64; 2],
    pub is_angle: bool,
}
