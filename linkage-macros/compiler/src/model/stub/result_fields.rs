//! Outputs of a stub: a field for each, however much of it was understood.

use proc_macro2::Ident;
use quote::format_ident;

use crate::syntax::tree::{self, Declaration, ExprKind, LetStatement, OutputItem, StatementKind};

use crate::model::acting::{Effort, Formula};
use crate::model::ids::FormulaId;
use crate::model::machine_functions::point_function;
use crate::model::mechanism::{AngleSum, DeclaredOutput, OutputKind, Scalar};
use crate::model::names::Kind;
use crate::model::rates::is_rate;
use crate::model::ratios::is_a_quotient_of_rates;
use crate::model::resolved_expr::bare_name;
use crate::model::scope::Scope;
use crate::model::stub::{self, NUMBER, number};
use crate::model::{fits, given, laws};

/// A field for an output whose name is known, if not its value.
pub(super) fn named_output_of_stub(scope: &mut Scope<'_>, tree: &Declaration, item: &OutputItem) {
    let named = bare_name(&item.value);
    let is_number =
        |name: &&Ident| matches!(scope.names.kind(name), Some(Kind::Let | Kind::Unknown));
    let Some(name) = item.name.as_ref().or(named.filter(is_number)) else { return };
    if has_field(scope, name) || is_formula(scope, name) {
        return;
    }
    let point = point_function(&item.value);
    if point.is_none() && reads_forces(scope, &item.value) && !is_a_quotient_of_rates(&item.value) {
        let effort = Effort::Formula(FormulaId(scope.mechanism.dynamics.formulas.len() as u32));
        let formula = Formula { value: Scalar::zero(), dimension: NUMBER, reads: Vec::new() };
        scope.mechanism.dynamics.formulas.push(formula);
        return stub::ask_once(scope, name, name.clone(), effort);
    }
    // A point under another name is a mistake, and its coordinates may be asked for.
    let whole =
        named.and_then(|value| scope.names.made(value)).and_then(|it| given::whole(scope, it));
    let kind = match (point, whole) {
        (Some(point), _) => (point.stand_in)(),
        (None, Some(output)) => output.kind,
        (None, None) if holds_angle(scope, tree, &item.value, tree.statements.len()) => {
            OutputKind::Angle(AngleSum { links: Vec::new(), rest: Scalar::zero() })
        }
        (None, None) => number(),
    };
    scope.mechanism.outputs.push(DeclaredOutput { field: name.clone(), docs: Vec::new(), kind });
}

/// True if an expression holds the angle of a link, directly or under a name that an earlier
/// statement gives it.
fn holds_angle(scope: &Scope<'_>, tree: &Declaration, value: &tree::Expr, before: usize) -> bool {
    match &value.kind {
        ExprKind::Member(_, member) => member == "angle",
        ExprKind::Name(name) => {
            let maker = scope.names.symbol(name).map(|symbol| symbol.statement);
            let maker = maker.filter(|&maker| maker < before);
            maker.is_some_and(|maker| match &tree.statements[maker].kind {
                StatementKind::Let(LetStatement { value, .. }) => {
                    holds_angle(scope, tree, value, maker)
                }
                _ => false,
            })
        }
        _ => value.parts().any(|part| holds_angle(scope, tree, part, before)),
    }
}

fn is_formula(scope: &Scope<'_>, name: &Ident) -> bool {
    scope.mechanism.dynamics.asked.iter().any(|asked| asked.is_formula(name))
}

/// True if an expression reads forces as far as it shows.
fn reads_forces(scope: &Scope<'_>, value: &tree::Expr) -> bool {
    let reads = |scope: &Scope<'_>, part: &tree::Expr| match &part.kind {
        ExprKind::Part(..) => true,
        ExprKind::Name(name) => name == "losses" || scope.names.kind(name) == Some(Kind::Load),
        ExprKind::Member(_, member) => member == "drive" || member == "push",
        _ => is_rate(part),
    };
    fits::first(scope, value, &|scope, part| {
        reads(scope, part) || laws::is_law(scope, part, |reads| reads.is_of_forces())
    })
    .is_some()
}

pub(super) fn has_field(scope: &Scope<'_>, name: &Ident) -> bool {
    scope.mechanism.outputs.iter().any(|output| output.field == *name)
}

/// True if an output has become a field.
pub(super) fn is_given(scope: &Scope<'_>, item: &OutputItem) -> bool {
    let dynamics = &scope.mechanism.dynamics;
    let owns = |name: &Ident| dynamics.asked.iter().any(|asked| asked.owner == *name);
    match (&item.name, &item.value.kind) {
        (Some(name), _) => has_field(scope, name) || is_formula(scope, name),
        (None, ExprKind::Name(name)) => {
            has_field(scope, name) || owns(name) || name == "energy" && dynamics.energy
        }
        (None, ExprKind::Part(path)) => owns(&path[0]),
        (None, ExprKind::Member(owner, member)) => {
            let of_both = format_ident!("{owner}_{member}");
            has_field(scope, owner) || has_field(scope, &of_both) || owns(owner)
        }
        _ => false,
    }
}
