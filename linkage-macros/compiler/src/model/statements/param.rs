//! `param l = 632mm;`: a number or a mode that is set before the calls, with its default.

use proc_macro2::Ident;
use syn::Attribute;

use crate::exact::Exact;
use crate::syntax::anatomy::Modes;
use crate::syntax::tree::{Expr, ExprKind, ParamStatement};

use crate::model::dimension::Measure;
use crate::model::facts::ParamFacts;
use crate::model::mechanism::{Dimension, Param, ParamId, ParamKind, Sign};
use crate::model::modes::{self, mode_word};
use crate::model::names::{Entity, Kind};
use crate::model::resolved_expr::bare_name;
use crate::model::scope::Scope;
use crate::model::statements::Rules;
use crate::model::units::unit;
use crate::model::{expressions, fits, kinds, uses};

impl Rules for ParamStatement {
    fn declares(&self) -> Vec<(&Ident, Kind)> {
        vec![(&self.name, Kind::Param)]
    }

    fn title(&self, name: &str) -> String {
        format!("param {name}")
    }

    fn each_expression(&self, f: &mut dyn FnMut(&Expr)) {
        f(&self.default);
    }

    fn resolve(&self, scope: &mut Scope<'_>, docs: &[Attribute]) {
        param(scope, docs, &self.name, self.kind.as_ref(), &self.default);
    }

    fn stand_in(&self, scope: &mut Scope<'_>, docs: &[Attribute], name: &Ident) -> Option<Entity> {
        let is_mode = self.kind.as_ref().is_some_and(|kind| kind == "mode");
        let kind = match bare_name(&self.default).and_then(mode_word) {
            Some(mode) => mode,
            None if is_mode => ParamKind::Mode { of: Modes::ALL[0], default: Sign::Plus },
            None => ParamKind::Number {
                dimension: Dimension::NUMBER,
                default: Exact::integer(0),
                written_in: None,
            },
        };
        let params = &mut scope.mechanism.params;
        params.push(Param { name: name.clone(), docs: docs.to_vec(), kind });
        let (measure, span) = (Measure::NUMBER, self.default.span);
        scope.facts.params.push(ParamFacts { measure, span, blamed: true });
        Some(Entity::Param(ParamId(params.len() as u32 - 1)))
    }
}

fn param(
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
            Some(kinds::quantity_kind(scope, kind, "parameter kind", &kinds))
        }
        None => None,
    };
    let quantity = expressions::quantity(scope, default)?;
    let value = match quantity.rest.constant() {
        Some(value) if quantity.links.is_empty() => value.clone(),
        _ => {
            report_no_constant(scope, name, default);
            return None;
        }
    };
    let measure = match wanted {
        None => quantity.measure,
        Some(wanted) => {
            fits::dimension_fits(scope, default, &quantity, wanted?)?;
            Measure::Known(wanted?)
        }
    };
    let (dimension, written_in) = (measure.dimension(), unit_written(default));
    Some((ParamKind::Number { dimension, default: value, written_in }, measure))
}

/// Reports a default that is no constant.
pub(in crate::model) fn report_no_constant(scope: &mut Scope<'_>, name: &Ident, default: &Expr) {
    let message = format!("the default of `{name}` is not a constant");
    let reason = "`let` names an expression of inputs and parameters";
    scope.diagnostics.error_because(default.span, message, reason);
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
