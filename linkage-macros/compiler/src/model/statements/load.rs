//! `load cut: force;`: a number that each call is given, and that only forces and outputs read.

use proc_macro2::Ident;
use syn::Attribute;

use crate::diagnostics::nearest;
use crate::syntax::tree::LoadStatement;

use crate::model::acting::Load;
use crate::model::mechanism::{Dimension, LoadId};
use crate::model::names::{Entity, Kind};
use crate::model::scope::Scope;
use crate::model::statements::Rules;
use crate::model::units::unit;
use crate::model::uses;

const LOAD_KINDS: [&str; 3] = ["force", "torque", "number"];

impl Rules for LoadStatement {
    fn declares(&self) -> Vec<(&Ident, Kind)> {
        self.names.iter().map(|name| (name, Kind::Load)).collect()
    }

    fn resolve(&self, scope: &mut Scope<'_>, docs: &[Attribute]) {
        load(scope, docs, &self.names, self.kind.as_ref());
    }

    fn stand_in(&self, scope: &mut Scope<'_>, docs: &[Attribute], name: &Ident) -> Option<Entity> {
        let (name, docs) = (name.clone(), docs.to_vec());
        Some(new_load(scope, Load { name, docs, dimension: Dimension::NUMBER }))
    }
}

fn load(scope: &mut Scope<'_>, docs: &[Attribute], names: &[Ident], kind: Option<&Ident>) {
    let dimension = kind.and_then(|kind| load_kind(scope, kind));
    for name in names {
        let is_new = uses::name_is_new(scope, name).is_some();
        let (true, Some(dimension)) = (is_new, dimension) else { continue };
        let load = Load { name: name.clone(), docs: docs.to_vec(), dimension };
        let entity = new_load(scope, load);
        scope.names.bind(name, entity);
    }
}

/// A load that each call is given, or the one that drives an input.
fn new_load(scope: &mut Scope<'_>, load: Load) -> Entity {
    let dynamics = &mut scope.mechanism.dynamics;
    if scope.facts.driving.as_deref() == Some(&load.name.to_string()) && dynamics.pull.is_none() {
        dynamics.pull = Some(load);
        return Entity::Pull;
    }
    dynamics.loads.push(load);
    Entity::Load(LoadId(dynamics.loads.len() as u32 - 1))
}

fn load_kind(scope: &mut Scope<'_>, kind: &Ident) -> Option<Dimension> {
    let text = kind.to_string();
    match text.as_str() {
        "force" => return Some(Dimension::FORCE),
        "torque" => return Some(Dimension::TORQUE),
        "number" => return Some(Dimension::NUMBER),
        _ => {}
    }
    if let Some((dimension, _)) = unit(&text)
        && dimension == Dimension::FORCE
    {
        let message = format!("`{text}` is a unit; write `force`");
        let reason = "a load is in newtons or newton metres; units stand behind numbers: `2kN`";
        scope.diagnostics.error_because(kind.span(), message, reason);
        return None;
    }
    let mut message = format!("no load kind named `{text}`");
    if let Some(near) = nearest(&text, LOAD_KINDS.into_iter()) {
        message += &format!("; one with a similar name exists: `{near}`");
    }
    let reason = "it is `force`, `torque` or `number`";
    scope.diagnostics.error_because(kind.span(), message, reason);
    None
}
