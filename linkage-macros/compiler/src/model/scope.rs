//! The state that the rules share while the statements of a declaration are resolved, one after the other.

use crate::diagnostics::Diagnostics;
use crate::syntax::tree::Unread;

use crate::model::drawn_links::DrawnLinks;
use crate::model::facts::Facts;
use crate::model::mechanism::Mechanism;
use crate::model::names::Names;

/// All that is declared so far, and where mistakes are reported.
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
