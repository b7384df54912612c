//! `solve theta { ram.slide = x, mode: falling, near: seed }`: the equation that fixes an unknown.

use proc_macro2::Ident;
use syn::Attribute;

use crate::diagnostics::nearest;
use crate::syntax::anatomy::Modes;
use crate::syntax::tree::{Expr, Solve};

use crate::model::mechanism::{
    Dimension, Equation, Length, Mode, Operator, ParamKind, Scalar, UnknownId,
};
use crate::model::modes::{trend_word, words_of};
use crate::model::names::{Entity, Kind};
use crate::model::resolved_expr::{ResolvedExpr, bare_name};
use crate::model::scope::Scope;
use crate::model::searched::Searched;
use crate::model::statements::{Rules, unknowns};
use crate::model::{expressions, fits, numbers, uses};

/// The meaning of both modes.
const MODES: &str = "`rising` or `falling`: how left minus right goes at the root while the unknown \
                     grows";

impl Rules for Solve {
    fn title(&self, _name: &str) -> String {
        format!("solve {}", self.unknown)
    }

    fn builds_on(&self) -> Vec<&Ident> {
        vec![&self.unknown]
    }

    fn each_expression(&self, f: &mut dyn FnMut(&Expr)) {
        self.equation.iter().flatten().chain(&self.near).for_each(f);
    }

    fn resolve(&self, scope: &mut Scope<'_>, _docs: &[Attribute]) {
        solve(scope, self);
    }
}

fn solve(scope: &mut Scope<'_>, solve: &Solve) {
    let unknown = unknown_to_solve(scope, &solve.unknown);
    let equation = equation(scope, solve, unknown.is_some());
    let mode = trend(scope, solve);
    let dimension = unknown.map(|id| scope.mechanism.unknowns[id.index()].dimension);
    let near = match (&solve.near, dimension) {
        (Some(near), Some(dimension)) => self::near(scope, near, dimension).map(Some),
        (Some(near), None) => expressions::quantity(scope, near).map(|_| None),
        (None, _) => Some(None),
    };
    // Also where it is in error it ends the search.
    if let Some(searched) = scope.facts.searches.last_mut()
        && (unknown.is_some() || searched.name == solve.unknown)
    {
        searched.ended = true;
    }
    let Some(id) = unknown else { return };
    let steps = scope.mechanism.steps.len();
    let unknown = &mut scope.mechanism.unknowns[id.index()];
    unknown.steps[1] = steps;
    if let (Some((equation, measure)), Some(mode), Some(near)) = (equation, mode, near) {
        (unknown.equation, unknown.measure) = (equation, measure);
        (unknown.mode, unknown.near) = (mode, near);
    }
}

/// The unknown that is searched, which is solved once.
fn unknown_to_solve(scope: &mut Scope<'_>, name: &Ident) -> Option<UnknownId> {
    let Entity::Unknown(id) = uses::usable(scope, name, &[Kind::Unknown])? else { return None };
    if scope.facts.searched().is_some_and(|searched| searched.id == id) {
        return Some(id);
    }
    let message = format!("`{name}` is solved already; remove this statement");
    let reason = "one equation fixes one unknown";
    scope.diagnostics.error_because(name.span(), message, reason);
    None
}

/// The equation, and what its sides are.
fn equation(
    scope: &mut Scope<'_>,
    solve: &Solve,
    is_searched: bool,
) -> Option<(Equation, Dimension)> {
    let Some([left, right]) = &solve.equation else {
        if solve.is_read {
            let message = format!("missing equation of `{}`", solve.unknown);
            let reason = "it comes first, as in `solve theta { ram.slide = x, mode: falling }`";
            scope.diagnostics.error_because(solve.end, message, reason);
        }
        return None;
    };
    let sides = (expressions::quantity(scope, left), expressions::quantity(scope, right));
    let (Some(a), Some(b)) = sides else { return None };
    if a.measure.sum(b.measure).is_none() {
        let (found, wanted) = (b.measure.dimension(), a.measure.dimension());
        let message = format!("{} where {} belongs", found.words(), wanted.words());
        let reason = format!("what stands left of the `=` is {}", wanted.words());
        scope.diagnostics.error_because(right.span, message, reason);
        return None;
    }
    // Where one side is an angle, the other is a number that was meant as one.
    let [measure, other] = [&a, &b].map(|side| side.measure.dimension());
    let measure = if other.angle { other } else { measure };
    let equation = between_sides(scope, (left, a), (right, b))?;
    if is_searched {
        equation_moves(scope, solve, [left, right], &equation)?;
    }
    Some((equation, measure))
}

/// The equation of two sides: its expression is zero where they are equal.
fn between_sides(
    scope: &mut Scope<'_>,
    (left, a): (&Expr, ResolvedExpr),
    (right, b): (&Expr, ResolvedExpr),
) -> Option<Equation> {
    if !a.links.is_empty() || !b.links.is_empty() {
        let difference = expressions::sum(scope, Operator::Sub, (left.span, a), (right, b))?;
        return Some(Equation::Turn(difference.turn()));
    }
    let is_distance = |side: &ResolvedExpr| match side.rest {
        Scalar::Distance(points) => Some(points),
        _ => None,
    };
    let (points, written, length, is_left) = match (is_distance(&a), is_distance(&b)) {
        (Some(points), None) => (points, right, b.rest, true),
        (None, Some(points)) => (points, left, a.rest, false),
        _ => return Some(Equation::Difference([a.rest, b.rest])),
    };
    fits::length_is_positive(scope, written, &length, "the distance")?;
    let name = match bare_name(written) {
        Some(name) => name.to_string(),
        None => "distance in `solve`".to_string(),
    };
    let length = Length { value: length, name };
    Some(Equation::Distance { points, length, is_left })
}

/// The equation changes with the unknown.
fn equation_moves(
    scope: &mut Scope<'_>,
    solve: &Solve,
    [left, right]: [&Expr; 2],
    equation: &Equation,
) -> Option<()> {
    let searched = scope.facts.searched()?;
    let changes = |expr: &Scalar| unknowns::changes_with(searched, expr);
    let moves = match equation {
        Equation::Difference(sides) => sides.iter().any(changes),
        Equation::Turn(turn) => {
            let reaches = |searched: &Searched, link| searched.reaches(Entity::Link(link));
            changes(&turn.rest) || turn.links.iter().any(|&(link, _)| reaches(searched, link))
        }
        Equation::Distance { points, length, .. } => {
            changes(&Scalar::Distance(*points)) || changes(&length.value)
        }
    };
    if moves {
        return Some(());
    }
    let name = &solve.unknown;
    let message = format!("this equation does not move with `{name}`; name what `{name}` drives");
    let reason = format!(
        "what stands between `unknown {name}` and `solve {name}` moves with it, as far as it is \
         built on `{name}`"
    );
    scope.diagnostics.error_because(left.span.to(right.span), message, reason);
    None
}

/// `rising`, `falling` or a parameter that says which.
fn trend(scope: &mut Scope<'_>, solve: &Solve) -> Option<Mode> {
    let Some(word) = &solve.mode else {
        if solve.is_read {
            scope.diagnostics.error_because(solve.end, "missing field `mode`", MODES);
        }
        return None;
    };
    let text = word.to_string();
    if let Some(sign) = trend_word(&text) {
        return Some(Mode::Fixed(sign));
    }
    if scope.names.kind(word) == Some(Kind::Param) {
        return trend_param(scope, word);
    }
    if scope.unread.may_hold(&text) {
        return None;
    }
    let known = Modes::Trend.words().into_iter().chain(scope.names.of_kinds(&[Kind::Param]));
    let near = nearest(&text, known);
    let message = match near {
        Some(near) => {
            format!("no mode named `{text}`; a mode with a similar name exists: `{near}`")
        }
        None => format!("no mode named `{text}`; write `rising` or `falling`"),
    };
    scope.diagnostics.error_because(word.span(), message, MODES);
    None
}

/// A trend given by name is a mode parameter of an equation's own kind.
fn trend_param(scope: &mut Scope<'_>, word: &Ident) -> Option<Mode> {
    let Entity::Param(id) = uses::usable(scope, word, &[Kind::Param])? else { return None };
    match &scope.mechanism.params[id.index()].kind {
        ParamKind::Mode { of: Modes::Trend, .. } => return Some(Mode::Param(id)),
        ParamKind::Number { .. } => {
            let message = format!("`{word}` is a number, not a mode");
            let reason = format!("write `param {word}: mode = rising;`");
            scope.diagnostics.error_because(word.span(), message, reason);
        }
        kind => {
            let [plus, minus] = words_of(kind);
            let message = format!("`{word}` is `{plus}` or `{minus}`, no mode of `solve`");
            scope.diagnostics.error_because(word.span(), message, MODES);
        }
    }
    None
}

/// Where a search begins is known before it.
fn near(scope: &mut Scope<'_>, near: &Expr, dimension: Dimension) -> Option<Scalar> {
    let value = numbers::scalar(scope, near, dimension)?;
    let searched = scope.facts.searched()?;
    if !unknowns::changes_with(searched, &value) {
        return Some(value);
    }
    let message = format!("`near` cannot depend on `{}`", searched.name);
    let reason = "it says where the search begins: a parameter, say, that holds the last root";
    scope.diagnostics.error_because(near.span, message, reason);
    None
}
