//! The numbers a declaration takes from outside or names for itself: inputs, parameters and named
//! expressions.

use proc_macro2::Ident;
use syn::Attribute;

use crate::diagnostics::nearest;
use crate::exact::Exact;
use crate::syntax::tree::{Declaration, Expr, ExprKind, Statement, StatementKind};

use super::dimension::Measure;
use super::expressions::{self, bare_name};
use super::facts::ParamFacts;
use super::mechanism::{Dimension, Input, InputId, Param, ParamId, ParamKind};
use super::modes::{self, mode_word};
use super::names::Entity;
use super::references::{expressions, names_in};
use super::scope::Scope;
use super::units::unit;
use super::{numbers, uses};

pub(super) const KINDS: [&str; 2] = ["angle", "length"];

pub(super) fn input(
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

/// The word after the colon is one that exists.
pub(super) fn quantity_kind(
    scope: &mut Scope<'_>,
    kind: &Ident,
    what: &str,
    known: &[&'static str],
) -> Option<Dimension> {
    let text = kind.to_string();
    match text.as_str() {
        "angle" => return Some(Dimension::ANGLE),
        "length" => return Some(Dimension::LENGTH),
        "number" if known.contains(&"number") => return Some(Dimension::NUMBER),
        _ => {}
    }
    let kind_of_unit = unit(&text).and_then(|(dimension, _)| match dimension {
        Dimension::ANGLE => Some("angle"),
        Dimension::LENGTH => Some("length"),
        _ => None,
    });
    if let Some(kind_of_unit) = kind_of_unit {
        let message = format!("`{text}` is a unit; write `{kind_of_unit}`");
        let reason = "a value is in metres and radians; units stand behind numbers: `30deg`";
        scope.diagnostics.error_because(kind.span(), message, reason);
        return None;
    }
    let mut message = format!("no {what} named `{text}`");
    if let Some(near) = nearest(&text, known.iter().copied()) {
        message += &format!("; one with a similar name exists: `{near}`");
    }
    let known: Vec<_> = known.iter().map(|kind| format!("`{kind}`")).collect();
    let reason = format!("it is {}", super::names::listed(&known, "or"));
    scope.diagnostics.error_because(kind.span(), message, reason);
    None
}

pub(super) fn param(
    scope: &mut Scope<'_>,
    docs: &[Attribute],
    name: &Ident,
    kind: Option<&Ident>,
    default: &Expr,
) {
    let is_new = uses::name_is_new(scope, name).is_some();
    let resolved = match kind {
        Some(kind) if kind == "mode" => {
            modes::param_is_a_mode(scope, default).map(|kind| (kind, Measure::NUMBER))
        }
        _ => param_is_a_constant(scope, name, kind, default),
    };
    let (true, Some((kind, measure))) = (is_new, resolved) else {
        return;
    };
    let id = ParamId(scope.mechanism.params.len() as u32);
    scope.mechanism.params.push(Param { name: name.clone(), docs: docs.to_vec(), kind });
    scope.facts.params.push(ParamFacts { measure, span: default.span, blamed: false });
    scope.names.bind(name, Entity::Param(id));
}

/// The default of a numeric parameter is a constant, of the kind that was announced.
fn param_is_a_constant(
    scope: &mut Scope<'_>,
    name: &Ident,
    kind: Option<&Ident>,
    default: &Expr,
) -> Option<(ParamKind, Measure)> {
    if let Some(word) = bare_name(default).filter(|word| mode_word(word).is_some()) {
        let message = format!("`{word}` is a mode; write `param {name}: mode = {word};`");
        scope.diagnostics.error(word.span(), message);
        return None;
    }
    let wanted = match kind {
        // Where a search begins is of the kind of what it begins with.
        Some(kind) if kind == "near" => None,
        Some(kind) => {
            let kinds = ["angle", "length", "number", "mode"];
            Some(quantity_kind(scope, kind, "parameter kind", &kinds))
        }
        None => None,
    };
    let quantity = expressions::quantity(scope, default)?;
    let value = match quantity.rest.constant() {
        Some(value) if quantity.links.is_empty() => value.clone(),
        _ => {
            let message = format!("the default of `{name}` is not a constant");
            let reason = "`let` names an expression of inputs and parameters";
            scope.diagnostics.error_because(default.span, message, reason);
            return None;
        }
    };
    let measure = match wanted {
        None => quantity.measure,
        Some(wanted) => {
            numbers::dimension_fits(scope, default, &quantity, wanted?)?;
            Measure::Known(wanted?)
        }
    };
    let (dimension, written_in) = (measure.dimension(), unit_written(default));
    Some((ParamKind::Number { dimension, default: value, written_in }, measure))
}

/// A mechanism has at least one input. Nothing is said where one is used that was forgotten.
pub(super) fn an_input_is_declared(scope: &mut Scope<'_>, tree: &Declaration) {
    let is_input = |s: &Statement| matches!(s.kind, StatementKind::Input { .. });
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
pub(super) fn every_input_is_used(scope: &mut Scope<'_>, tree: &Declaration, is_drawn: bool) {
    if scope.names.use_is_hidden {
        return;
    }
    let mut used = Vec::new();
    for statement in &tree.statements {
        // A force moves nothing by itself.
        if !matches!(statement.kind, StatementKind::Let { .. } | StatementKind::Action(_)) {
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
pub(super) fn follow_lets(tree: &Declaration, used: &mut Vec<String>) {
    let mut next = 0;
    while let Some(name) = used.get(next).cloned() {
        next += 1;
        for statement in &tree.statements {
            match &statement.kind {
                StatementKind::Let { name: own, value } if *own == name => {
                    add_names(value, used);
                }
                _ => {}
            }
        }
    }
}

/// Adds the names in the expression that are not yet in the list.
pub(super) fn add_names(expr: &Expr, names: &mut Vec<String>) {
    names_in(expr, &mut |name| {
        let name = name.to_string();
        if !names.contains(&name) {
            names.push(name);
        }
    });
}

/// The unit behind a number.
fn unit_written(number: &Expr) -> Option<(String, Exact)> {
    match &number.kind {
        ExprKind::Negate(number) => unit_written(number),
        ExprKind::Number { units, .. } => match &units[..] {
            [(word, 1)] => Some((word.clone(), unit(word)?.1)),
            _ => None,
        },
        _ => None,
    }
}
