//! Checks that what is declared has a use: inputs, loads and gravity.

use crate::syntax::tree::{
    Action, Declaration, Expr, LetStatement, OutputStatement, Statement, StatementKind,
};

use crate::model::acting::Dynamics;
use crate::model::dimension::Dimension;
use crate::model::references::expressions;
use crate::model::scope::Scope;

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

/// Every input is used by something other than a `let` that nothing uses. It waits for other mistakes, which may
/// have hidden the use.
pub(in crate::model) fn every_input_is_used(scope: &mut Scope<'_>, tree: &Declaration) {
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
        let reason = match (input.dimension, scope.drawn.is_some()) {
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
fn follow_lets(tree: &Declaration, used: &mut Vec<String>) {
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
fn add_names(expr: &Expr, names: &mut Vec<String>) {
    expr.each_name(&mut |name| {
        let name = name.to_string();
        if !names.contains(&name) {
            names.push(name);
        }
    });
}

/// Every load is used, and gravity has a mass to pull.
pub(in crate::model) fn actions_have_an_effect(scope: &mut Scope<'_>, tree: &Declaration) {
    let (mut acting, mut named) = (Vec::new(), Vec::new());
    let mut masses = tree.unread.may_hold("mass");
    for statement in &tree.statements {
        match &statement.kind {
            StatementKind::Action(action) => {
                masses |= matches!(action, Action::Mass(_));
                expressions(statement, &mut |expr| add_names(expr, &mut acting));
            }
            StatementKind::Output(OutputStatement { items, .. }) => {
                items.iter().for_each(|item| add_names(&item.value, &mut named));
            }
            _ => {}
        }
    }
    follow_lets(tree, &mut acting);
    follow_lets(tree, &mut named);
    let Dynamics { loads, pull, .. } = &scope.mechanism.dynamics;
    for load in loads.iter().chain(pull) {
        let name = load.name.to_string();
        // A load that drives has to act.
        let is_given = scope.facts.driving.as_deref() != Some(&name);
        let is_used = acting.contains(&name) || is_given && named.contains(&name);
        // It may stand in what is in error.
        if is_used || tree.unread.may_hold(&name) || scope.names.use_is_hidden {
            continue;
        }
        let message = format!("nothing uses the load `{name}`; use it or remove it");
        let reason = match load.dimension {
            Dimension::TORQUE => format!("as in `torque {name} on BC`"),
            _ => format!("as in `force (0, -{name}) on P`"),
        };
        scope.diagnostics.error_because(load.name.span(), message, reason);
    }
    if let Some(at) = scope.facts.gravity_at.filter(|_| !masses) {
        let message = "gravity without a mass does nothing; declare one or remove it";
        scope.diagnostics.error_because(at, message, "as in `mass 2kg on BC uniform`");
    }
}
