//! Named expressions, and laws among them: those that read rates or loads, which stand in what acts
//! and in outputs, and are refused where something is made of them.

use proc_macro2::Ident;
use syn::Attribute;

use crate::syntax::tree::{Expr, ExprKind, LetStatement};

use crate::model::drawn::printed::text;
use crate::model::expressions::{self, ResolvedExpr};
use crate::model::facts::LetFacts;
use crate::model::mechanism::{LawId, LetId, Scalar};
use crate::model::names::{Entity, Kind};
use crate::model::reads::{Allowed, Reads};
use crate::model::scope::Scope;
use crate::model::uses;

use super::{Rules, drive_by};

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

    fn resolve(&self, scope: &mut Scope<'_>, _docs: &[Attribute], moves: bool) {
        named_expression(scope, &self.name, &self.value, moves);
    }

    fn written(&self) -> String {
        format!("let {} = {};", self.name, text(&self.value))
    }

    fn expressions_mut(&mut self) -> Vec<&mut Expr> {
        vec![&mut self.value]
    }
}

pub(in crate::model) fn named_expression(
    scope: &mut Scope<'_>,
    name: &Ident,
    value: &Expr,
    moves: bool,
) {
    let is_new = uses::name_is_new(scope, name).is_some();
    // It is refused where it is used, if it does not stand there.
    let quantity = expressions::expression(scope, value, Allowed::IN_FORCES);
    let (true, Some(quantity)) = (is_new, quantity) else { return };
    let pull = drive_by::degree(scope, &quantity.rest);
    let (measure, reads) = (quantity.measure, quantity.reads.clone());
    let is_law = reads.is_of_forces();
    let facts = LetFacts { measure, moves, reads, pull };
    let entity = match is_law {
        true => {
            scope.facts.laws.push(facts);
            let laws = &mut scope.mechanism.dynamics.laws;
            laws.push(quantity.turn());
            Entity::Law(LawId(laws.len() as u32 - 1))
        }
        false => {
            scope.facts.lets.push(facts);
            scope.mechanism.lets.push(quantity.turn());
            Entity::Let(LetId(scope.mechanism.lets.len() as u32 - 1))
        }
    };
    scope.names.bind(name, entity);
}

/// The value of a `let`, where it may stand here.
pub(in crate::model) fn value_of_let(
    scope: &mut Scope<'_>,
    name: &Ident,
    entity: Entity,
    allowed: Allowed,
) -> Option<ResolvedExpr> {
    let (facts, sum, rest) = match entity {
        Entity::Let(id) => {
            let sum = &scope.mechanism.lets[id.index()];
            let rest = if sum.rest.is_constant() { sum.rest.clone() } else { Scalar::Let(id) };
            (&scope.facts.lets[id.index()], sum, rest)
        }
        Entity::Law(id) => {
            let sum = &scope.mechanism.dynamics.laws[id.index()];
            (&scope.facts.laws[id.index()], sum, Scalar::Law(id))
        }
        _ => return None,
    };
    let (measure, links, reads) = (facts.measure, sum.links.clone(), facts.reads.clone());
    law_stands_here(scope, name, &reads, allowed)?;
    Some(ResolvedExpr { measure, links, rest, reads })
}

/// A law of rates or loads stands in forces, torques and outputs.
pub(in crate::model) fn law_stands_here(
    scope: &mut Scope<'_>,
    name: &Ident,
    reads: &Reads,
    allowed: Allowed,
) -> Option<()> {
    let (message, reason) = match (reads.corner, reads.is_of_forces()) {
        (_, true) if !allowed.forces => {
            let what = match (reads.load, reads.rate) {
                (true, true) => "loads and rates",
                (true, false) => "a load",
                (false, _) => "a rate",
            };
            (
                format!("`{name}` reads {what}, and stands in forces, torques and outputs alone"),
                "what the mechanism is made of and how it moves depends on no load and no rate",
            )
        }
        (Some(function), false) if !allowed.corners => (
            format!(
                "`{name}` has a corner by `{function}`, and stands in forces, torques and outputs \
                 alone"
            ),
            "a dimension is smooth: write `hypot(x, e)` with a small `e` for `abs(x)`",
        ),
        _ => return Some(()),
    };
    scope.diagnostics.error_because(name.span(), message, reason);
    None
}

/// The part of an expression is a law of which this is true.
pub(in crate::model) fn is_law(
    scope: &Scope<'_>,
    part: &Expr,
    reads: impl Fn(&Reads) -> bool,
) -> bool {
    let ExprKind::Name(name) = &part.kind else { return false };
    match scope.names.entity(name) {
        Some(Entity::Law(id)) => reads(&scope.facts.laws[id.index()].reads),
        _ => false,
    }
}
