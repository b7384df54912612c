//! The numbers a declaration takes from outside or names for itself: inputs, parameters and named
//! expressions.

use proc_macro2::Ident;
use syn::Attribute;

use crate::syntax::tree::{
    Declaration, Expr, InputStatement, LetStatement, Statement, StatementKind,
};

use crate::model::drawn::printed;
use crate::model::kinds::{KINDS, quantity_kind};
use crate::model::mechanism::{Dimension, Input, InputId};
use crate::model::names::{Entity, Kind};
use crate::model::references::{expressions, names_in};
use crate::model::scope::Scope;
use crate::model::uses;

use super::Rules;

impl Rules for InputStatement {
    fn declares(&self) -> Vec<(&Ident, Kind)> {
        self.names.iter().map(|name| (name, Kind::Input)).collect()
    }

    fn title(&self, name: &str) -> String {
        format!("input {name}")
    }

    fn resolve(&self, scope: &mut Scope<'_>, docs: &[Attribute], _moves: bool) {
        input(scope, docs, &self.names, self.kind.as_ref());
    }

    fn stand_in(&self, scope: &mut Scope<'_>, docs: &[Attribute], name: &Ident) -> Option<Entity> {
        let (name, docs) = (name.clone(), docs.to_vec());
        let inputs = &mut scope.mechanism.inputs;
        inputs.push(Input { name, docs, dimension: Dimension::NUMBER });
        Some(Entity::Input(InputId(inputs.len() as u32 - 1)))
    }

    fn written(&self) -> String {
        format!("input {}{};", printed::names(&self.names), printed::kind(&self.kind))
    }
}

pub(in crate::model) fn input(
    scope: &mut Scope<'_>,
    docs: &[Attribute],
    names: &[Ident],
    kind: Option<&Ident>,
) {
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

/// A mechanism has at least one input. Nothing is said where one is used that was forgotten.
pub(in crate::model) fn an_input_is_declared(scope: &mut Scope<'_>, tree: &Declaration) {
    let is_input = |s: &Statement| matches!(s.kind, StatementKind::Input(_));
    let may_have_been = scope.names.number_is_unknown || tree.unread.may_hold("input");
    if !may_have_been && !tree.statements.iter().any(is_input) {
        let name = &tree.name;
        let message = format!("`{name}` has no input; declare what drives it");
        let reason = "an angle, `input theta: angle;`, or a length, `input s: length;`";
        scope.diagnostics.error_because(name.span(), message, reason);
    }
}

/// Every input is used by something other than a `let` that nothing uses. Nothing is said
/// where another mistake may have hidden the use.
pub(in crate::model) fn every_input_is_used(
    scope: &mut Scope<'_>,
    tree: &Declaration,
    is_drawn: bool,
) {
    if scope.names.use_is_hidden {
        return;
    }
    let mut used = Vec::new();
    for statement in &tree.statements {
        // A force moves nothing by itself.
        if !matches!(statement.kind, StatementKind::Let(_) | StatementKind::Action(_)) {
            expressions(statement, &mut |expr| add_names(expr, &mut used));
        }
    }
    follow_lets(tree, &mut used);
    for input in &scope.mechanism.inputs {
        let name = &input.name;
        if used.iter().any(|used| name == used) || tree.unread.may_hold(&name.to_string()) {
            continue;
        }
        let message = format!("nothing uses the input `{name}`; use it or remove it");
        let reason = match (input.dimension, is_drawn) {
            (Dimension::ANGLE, true) => {
                format!("a drive takes it: `drive AB.angle = {name};`")
            }
            (_, true) => format!(
                "a cylinder takes it, `link lift(F, G) {{ length: {name} }}`, or a drive: `drive \
                 ram.slide = {name};`"
            ),
            (Dimension::ANGLE, false) => {
                format!("a driver takes it: `crank AB(A) {{ angle: {name} }}`")
            }
            (_, false) => format!("a driver takes it: `slider ram(rail) {{ slide: {name} }}`"),
        };
        scope.diagnostics.error_because(name.span(), message, reason);
    }
}

/// A name that is used makes the names in its own `let` used: the list grows as it is read.
pub(in crate::model) fn follow_lets(tree: &Declaration, used: &mut Vec<String>) {
    let mut next = 0;
    while let Some(name) = used.get(next).cloned() {
        next += 1;
        for statement in &tree.statements {
            match &statement.kind {
                StatementKind::Let(LetStatement { name: own, value }) if *own == name => {
                    add_names(value, used);
                }
                _ => {}
            }
        }
    }
}

/// Adds the names in the expression that are not yet in the list.
pub(in crate::model) fn add_names(expr: &Expr, names: &mut Vec<String>) {
    names_in(expr, &mut |name| {
        let name = name.to_string();
        if !names.contains(&name) {
            names.push(name);
        }
    });
}
