//! The state that the rules share while the statements of a declaration are resolved, one after the other.

use crate::diagnostics::{Diagnostics, Extent};
use crate::exact::Exact;
use crate::syntax::tree::Unread;

use crate::model::drawn_links::DrawnLinks;
use crate::model::facts::Facts;
use crate::model::mechanism::{Mechanism, ParamKind, Scalar};
use crate::model::names::Names;

/// All that is declared so far, and where mistakes are reported.
pub struct Scope<'d> {
    pub diagnostics: &'d mut Diagnostics,
    /// The tokens that the parser gave up. Nothing is known of a name among them.
    pub unread: &'d Unread,
    pub names: Names,
    pub mechanism: Mechanism,
    pub facts: Facts,
    /// The links of a drawing as groups have made them.
    pub drawn: Option<&'d DrawnLinks>,
}

impl Scope<'_> {
    /// The constant that a number at this place is, or the default of the parameter that it is, and where that is written.
    pub(super) fn constant_or_default<'s>(
        &'s self,
        value: &'s Scalar,
        at: Extent,
    ) -> Option<(&'s Exact, Extent)> {
        match value {
            Scalar::Constant(value) => Some((value, at)),
            Scalar::Param(id) => match &self.mechanism.params[id.index()].kind {
                ParamKind::Number { default, .. } => {
                    Some((default, self.facts.params[id.index()].span))
                }
                ParamKind::Mode { .. } => None,
            },
            _ => None,
        }
    }

    /// True if the default of the parameter that a number is was reported. It counts as reported from now on.
    pub(super) fn was_blamed(&mut self, value: &Scalar) -> bool {
        let Scalar::Param(id) = value else { return false };
        std::mem::replace(&mut self.facts.params[id.index()].blamed, true)
    }
}
