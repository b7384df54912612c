//! Things that a drawing became. They are resolved among the statements, and nobody has written them.

use proc_macro2::Ident;
use syn::Attribute;

use crate::syntax::tree::Expr;

use crate::model::figures::Figure;
use crate::model::names::Kind;
use crate::model::scope::Scope;
use crate::model::statements::{Rules, titled};

/// Makes a thing, told whether anything that it is built on moves.
type Resolving = dyn Fn(&mut Scope<'_>, bool);

/// A thing that a drawing became.
pub(in crate::model) struct MadeItem {
    /// A group as messages call it; empty of what has one name.
    title: String,
    makes: Vec<(Ident, Kind)>,
    builds_on: Vec<Ident>,
    numbers: Vec<Figure>,
    resolve: Box<Resolving>,
}

impl MadeItem {
    /// A thing that makes these, is built on those and given by numbers.
    pub(super) fn new(
        makes: Vec<(Ident, Kind)>,
        builds_on: Vec<Ident>,
        numbers: Vec<Figure>,
        resolve: impl Fn(&mut Scope<'_>, bool) + 'static,
    ) -> Self {
        Self { title: String::new(), makes, builds_on, numbers, resolve: Box::new(resolve) }
    }

    pub(super) fn called(self, title: String) -> Self {
        Self { title, ..self }
    }
}

impl Rules for MadeItem {
    fn declares(&self) -> Vec<(&Ident, Kind)> {
        self.makes.iter().map(|(name, kind)| (name, *kind)).collect()
    }

    fn title(&self, name: &str) -> String {
        if self.title.is_empty() { titled(&self.declares(), name) } else { self.title.clone() }
    }

    fn builds_on(&self) -> Vec<&Ident> {
        self.builds_on.iter().collect()
    }

    fn each_expression(&self, f: &mut dyn FnMut(&Expr)) {
        self.numbers.iter().flat_map(Figure::parts).for_each(f);
    }

    fn resolve(&self, scope: &mut Scope<'_>, _docs: &[Attribute]) {
        (self.resolve)(scope, self.moves(scope));
    }
}
