//! `solve theta { ram.slide = x, mode: falling, near: seed }`: the equation that fixes an unknown.

use proc_macro2::{Ident, Span};
use syn::Attribute;

use crate::diagnostics::{Extent, nearest};
use crate::syntax::anatomy::Modes;
use crate::syntax::tree::{Expr, Solve};

use crate::model::figures::Figure;
use crate::model::mechanism::{
    Dimension, Equation, Length, Mode, Operator, ParamKind, Scalar, Sign, UnknownId,
};
use crate::model::modes::{trend_word, words_of};
use crate::model::names::{Entity, Kind};
use crate::model::resolved_expr::{ResolvedExpr, bare_name};
use crate::model::scope::Scope;
use crate::model::searched::Searched;
use crate::model::statements::made::MadeItem;
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
    let Some(id) = unknown else {
        // Also where it is in error it ends the search.
        let searched = scope.facts.searches.last_mut();
        if let Some(searched) = searched.filter(|searched| searched.name == solve.unknown) {
            searched.ended = true;
        }
        return;
    };
    let solved = equation.zip(mode).zip(near);
    is_solved(scope, id, solved.map(|((equation, mode), near)| (equation, mode, near)));
}

/// Ends the search of an unknown, with what fixes it where that is known.
fn is_solved(
    scope: &mut Scope<'_>,
    id: UnknownId,
    solved: Option<((Equation, Dimension), Mode, Option<Scalar>)>,
) {
    if let Some(searched) = scope.facts.searches.last_mut() {
        searched.ended = true;
    }
    let steps = scope.mechanism.steps.len();
    let unknown = &mut scope.mechanism.unknowns[id.index()];
    unknown.steps[1] = steps;
    if let Some(((equation, measure), mode, near)) = solved {
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
    let [first, second] =
        [(left.span, a.rest, bare_name(left)), (right.span, b.rest, bare_name(right))];
    of_numbers(scope, [first, second])
}

/// A side of an equation: where it is written, its value, and its name where it is one.
type EquationSide<'n> = (Extent, Scalar, Option<&'n Ident>);

/// The equation of two numbers: one side may be a distance of points, which the other is then to be.
fn of_numbers(scope: &mut Scope<'_>, [left, right]: [EquationSide<'_>; 2]) -> Option<Equation> {
    let points = |(_, value, _): &EquationSide<'_>| match value {
        Scalar::Distance(points) => Some(*points),
        _ => None,
    };
    let (points, (at, value, name), is_left) = match (points(&left), points(&right)) {
        (Some(points), None) => (points, right, true),
        (None, Some(points)) => (points, left, false),
        _ => return Some(Equation::Difference([left.1, right.1])),
    };
    fits::length_is_positive(scope, at, &value, "the distance")?;
    let name = name.map_or("distance in `solve`".to_string(), Ident::to_string);
    Some(Equation::Distance { points, length: Length { value, name }, is_left })
}

/// The equation of a search that a group of a drawing became: a point has this distance from another or from a guide.
pub(in crate::model) fn made_equation(
    unknown: Ident,
    between: [Ident; 2],
    wanted: Figure,
    mode: Sign,
) -> MadeItem {
    let builds_on = [&unknown].into_iter().chain(&between).cloned().collect();
    MadeItem::new(Vec::new(), builds_on, vec![wanted.clone()], move |scope, _| {
        let Some(id) = unknown_to_solve(scope, &unknown) else { return };
        let sides = sides(scope, &between, (&wanted, unknown.span()));
        let equation = sides.and_then(|sides| of_numbers(scope, sides));
        let solved = equation.map(|equation| (equation, Dimension::LENGTH));
        is_solved(scope, id, solved.map(|solved| (solved, Mode::Fixed(mode), None)));
    })
}

fn sides<'f>(
    scope: &mut Scope<'_>,
    [point, other]: &[Ident; 2],
    (wanted, at): (&'f Figure, Span),
) -> Option<[EquationSide<'f>; 2]> {
    let (value, point) = (wanted.length(scope, at)?, uses::point(scope, point)?);
    let distance = match uses::usable(scope, other, &[Kind::Point, Kind::Guide])? {
        Entity::Point(other) => Scalar::Distance([point, other]),
        Entity::Guide(guide) => Scalar::Offset(point, guide),
        _ => return None,
    };
    Some([(at.into(), distance, None), (wanted.at(at), value, wanted.name())])
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
