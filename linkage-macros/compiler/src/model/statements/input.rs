//! `input theta: angle;`: the numbers that drive a mechanism.

use proc_macro2::Ident;
use syn::Attribute;

use crate::syntax::tree::{InputSetStatement, InputStatement};

use crate::model::kinds::{KINDS, quantity_kind};
use crate::model::mechanism::{Dimension, Input, InputId};
use crate::model::names::{Entity, Kind};
use crate::model::scope::Scope;
use crate::model::statements::Rules;
use crate::model::uses;

impl Rules for InputStatement {
    fn declares(&self) -> Vec<(&Ident, Kind)> {
        self.names.iter().map(|name| (name, Kind::Input)).collect()
    }

    fn resolve(&self, scope: &mut Scope<'_>, docs: &[Attribute]) {
        input(scope, docs, &self.names, self.kind.as_ref());
    }

    fn stand_in(&self, scope: &mut Scope<'_>, docs: &[Attribute], name: &Ident) -> Option<Entity> {
        let (name, docs) = (name.clone(), docs.to_vec());
        let inputs = &mut scope.mechanism.inputs;
        inputs.push(Input { name, docs, dimension: Dimension::NUMBER });
        Some(Entity::Input(InputId(inputs.len() as u32 - 1)))
    }
}

/// A declaration with sets is resolved once a set, each with inputs of its own.
impl Rules for InputSetStatement {}

fn input(scope: &mut Scope<'_>, docs: &[Attribute], names: &[Ident], kind: Option<&Ident>) {
    let dimension = kind.and_then(|kind| quantity_kind(scope, kind, "input kind", &KINDS));
    for name in names {
        let is_new = uses::name_is_new(scope, name).is_some();
        let (true, Some(dimension)) = (is_new, dimension) else {
            continue;
        };
        let id = InputId(scope.mechanism.inputs.len() as u32);
        scope.mechanism.inputs.push(Input { name: name.clone(), docs: docs.to_vec(), dimension });
        scope.names.bind(name, Entity::Input(id));
    }
}
