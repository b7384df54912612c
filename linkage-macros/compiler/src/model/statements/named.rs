//! `let half = l / 2;`: named expressions, and laws among them, which read rates or loads.

use proc_macro2::Ident;
use syn::Attribute;

use crate::syntax::tree::{Expr, LetStatement};

use crate::model::facts::LetFacts;
use crate::model::figures::Figure;
use crate::model::mechanism::{AngleSum, Dimension, LawId, LetId};
use crate::model::names::{Entity, Kind};
use crate::model::reads::Allowed;
use crate::model::scope::Scope;
use crate::model::statements::Rules;
use crate::model::statements::made::MadeItem;
use crate::model::{expressions, loads_in_forces, uses};

impl Rules for LetStatement {
    fn declares(&self) -> Vec<(&Ident, Kind)> {
        vec![(&self.name, Kind::Let)]
    }

    fn title(&self, name: &str) -> String {
        format!("let {name}")
    }

    fn each_expression(&self, f: &mut dyn FnMut(&Expr)) {
        f(&self.value);
    }

    fn resolve(&self, scope: &mut Scope<'_>, _docs: &[Attribute]) {
        named_expression(scope, &self.name, &self.value, self.moves(scope));
    }
}

/// A number of a drawing with a name that nobody has written.
pub(in crate::model) fn made_let(name: Ident, value: Figure, of: Dimension) -> MadeItem {
    let (makes, numbers) = (vec![(name.clone(), Kind::Let)], vec![value.clone()]);
    MadeItem::new(makes, Vec::new(), numbers, move |scope, moves| {
        if let Some(value) = value.turn(scope) {
            new_let(scope, &name, value, LetFacts::of_a_pose(of, moves));
        }
    })
}

/// Gives the name to the number.
pub(super) fn new_let(scope: &mut Scope<'_>, name: &Ident, value: AngleSum, facts: LetFacts) {
    scope.facts.lets.push(facts);
    scope.mechanism.lets.push(value);
    let id = LetId(scope.mechanism.lets.len() as u32 - 1);
    scope.names.bind(name, Entity::Let(id));
}

fn named_expression(scope: &mut Scope<'_>, name: &Ident, value: &Expr, moves: bool) {
    let is_new = uses::name_is_new(scope, name).is_some();
    // It is refused where it is used, if it does not stand there.
    let quantity = expressions::expression(scope, value, Allowed::IN_FORCES);
    let (true, Some(quantity)) = (is_new, quantity) else { return };
    let pull = loads_in_forces::degree(scope, &quantity.rest);
    let (measure, reads) = (quantity.measure, quantity.reads.clone());
    let is_law = reads.is_of_forces();
    let facts = LetFacts { measure, moves, reads, pull };
    if !is_law {
        return new_let(scope, name, quantity.turn(), facts);
    }
    scope.facts.laws.push(facts);
    let laws = &mut scope.mechanism.dynamics.laws;
    laws.push(quantity.turn());
    let id = LawId(laws.len() as u32 - 1);
    scope.names.bind(name, Entity::Law(id));
}
