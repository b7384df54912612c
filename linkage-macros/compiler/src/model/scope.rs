//! The state that the rules share while the statements of a declaration are resolved, one after the other.

use crate::diagnostics::Diagnostics;
use crate::syntax::tree::{Declaration, Unread};

use super::drawn::DrawnLinks;
use super::facts::Facts;
use super::mechanism::{Mechanism, References};
use super::names::Names;

/// What is declared so far, and where mistakes are reported.
pub(super) struct Scope<'d> {
    pub diagnostics: &'d mut Diagnostics,
    /// The tokens that the parser gave up. Nothing is known of a name among them.
    pub unread: &'d Unread,
    pub names: Names,
    pub mechanism: Mechanism,
    pub facts: Facts,
    /// The links of a drawing as groups have made them.
    pub drawn: Option<&'d DrawnLinks>,
}

impl<'d> Scope<'d> {
    /// The scope in front of the first statement.
    pub(super) fn new(
        tree: &Declaration,
        unread: &'d Unread,
        diagnostics: &'d mut Diagnostics,
    ) -> Self {
        let empty = Mechanism::empty(tree.docs.clone(), tree.visibility.clone(), tree.name.clone());
        Self {
            diagnostics,
            unread,
            names: Names::collect(tree),
            mechanism: Mechanism { references: References::of(tree), ..empty },
            facts: Facts::of(tree),
            drawn: None,
        }
    }
}
