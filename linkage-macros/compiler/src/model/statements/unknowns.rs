//! `unknown theta: angle between (…, …);`: what an equation is to fix, and where it is looked for.

use std::collections::HashSet;

use proc_macro2::Ident;
use syn::Attribute;

use crate::diagnostics::Extent;
use crate::exact::Exact;
use crate::reach::turn::Range;
use crate::syntax::tree::{Declaration, Expr, UnknownStatement};

use crate::model::as_written::text;
use crate::model::figures::Figure;
use crate::model::folding::shown_in_degrees;
use crate::model::kinds::{KINDS, quantity_kind};
use crate::model::mechanism::{
    AngleSum, Dimension, Drive, Equation, GroupName, Mode, ParamKind, Scalar, Sign, Unknown,
    UnknownId,
};
use crate::model::names::{Entity, Kind};
use crate::model::scope::Scope;
use crate::model::searched::Searched;
use crate::model::statements::Rules;
use crate::model::statements::made::MadeItem;
use crate::model::{declared, drawn_sliding, fits, numbers, uses};

impl Rules for UnknownStatement {
    fn declares(&self) -> Vec<(&Ident, Kind)> {
        vec![(&self.name, Kind::Unknown)]
    }

    fn each_expression(&self, f: &mut dyn FnMut(&Expr)) {
        self.between.iter().flatten().for_each(f);
    }

    fn resolve(&self, scope: &mut Scope<'_>, docs: &[Attribute]) {
        unknown(scope, docs, &self.name, self.kind.as_ref(), self.between.as_ref());
    }
}

fn unknown(
    scope: &mut Scope<'_>,
    docs: &[Attribute],
    name: &Ident,
    kind: Option<&Ident>,
    between: Option<&[Expr; 2]>,
) {
    let is_new = uses::name_is_new(scope, name).is_some() && one_is_searched_at_a_time(scope, name);
    let dimension = kind.and_then(|kind| quantity_kind(scope, kind, "kind of unknown", &KINDS));
    let ends = between.zip(dimension).and_then(|(ends, of)| self::ends(scope, name, ends, of));
    let (true, Some(dimension), Some(written), Some(between)) = (is_new, dimension, between, ends)
    else {
        return;
    };
    let ends = written.each_ref().map(|end| end.span);
    new_unknown(scope, docs, name, (dimension, between), ends);
}

/// An unknown of a drawing, which nobody has written.
pub(in crate::model) fn made_unknown(name: Ident, of: Dimension, between: [Figure; 2]) -> MadeItem {
    MadeItem::new(vec![(name.clone(), Kind::Unknown)], Vec::new(), Vec::new(), move |scope, _| {
        let [Some(from), Some(to)] = between.each_ref().map(|end| end.number(scope)) else {
            return;
        };
        if one_is_searched_at_a_time(scope, &name) {
            new_unknown(scope, &[], &name, (of, [from, to]), [name.span().into(); 2]);
        }
    })
}

fn new_unknown(
    scope: &mut Scope<'_>,
    docs: &[Attribute],
    name: &Ident,
    (dimension, between): (Dimension, [Scalar; 2]),
    ends: [Extent; 2],
) {
    let id = UnknownId(scope.mechanism.unknowns.len() as u32);
    let group = declared::next_group(scope);
    scope.mechanism.groups.push(GroupName {
        keyword: Ident::new("unknown", name.span()),
        title: drawn_sliding::title_as_drawn(scope, std::iter::once(name)),
    });
    let steps = [scope.mechanism.steps.len(); 2];
    // Nothing is solved by it: what has no `solve` is reported.
    let equation = Equation::Turn(AngleSum { links: Vec::new(), rest: Scalar::zero() });
    scope.mechanism.unknowns.push(Unknown {
        name: name.clone(),
        docs: docs.to_vec(),
        dimension,
        group,
        between,
        steps,
        equation,
        measure: Dimension::NUMBER,
        mode: Mode::Fixed(Sign::Plus),
        near: None,
    });
    declared::note(scope, name, Entity::Unknown(id));
    scope.names.bind(name, Entity::Unknown(id));
    let follows = HashSet::from([Entity::Unknown(id)]);
    scope.facts.ends_of_unknowns.push(ends);
    scope.facts.searches.push(Searched { id, name: name.clone(), follows, ended: false });
}

/// An unknown is solved before the next begins.
fn one_is_searched_at_a_time(scope: &mut Scope<'_>, name: &Ident) -> bool {
    let Some(searched) = scope.facts.searched() else { return true };
    let first = &searched.name;
    let message = format!("solve `{first}` before this: one unknown is searched at a time");
    let reason = format!("move `unknown {name}` behind `solve {first} {{ … }}`");
    scope.diagnostics.error_because(name.span(), message, reason);
    false
}

/// Both ends are known before anything moves, in order, and within a turn.
fn ends(
    scope: &mut Scope<'_>,
    name: &Ident,
    written: &[Expr; 2],
    dimension: Dimension,
) -> Option<[Scalar; 2]> {
    let ends = written.each_ref().map(|end| {
        end_depends_on_no_input(scope, end, name)?;
        numbers::scalar(scope, end, dimension)
    });
    let [Some(from), Some(to)] = ends else { return None };
    let (Some(low), Some(high)) = (declared(scope, &from), declared(scope, &to)) else {
        return Some([from, to]);
    };
    let [first, second] = [&written[1], &written[0]].map(text);
    let reason = format!("the lower end comes first, as in `between ({first}, {second})`");
    if !low.cmp_value(&high).is_lt() {
        let message = format!("the ends of `{name}` are not in order; write the lower one first");
        scope.diagnostics.error_because(written[1].span, message, reason);
        return None;
    }
    let turn = Exact::pi().mul(&Exact::integer(2));
    let width = high.sub(&low);
    if dimension.angle && width.cmp_value(&turn).is_gt() {
        let width = shown_in_degrees(&width);
        let message = format!("the ends of `{name}` are {width}° apart; stay within a turn");
        let reason = "beyond a turn every pose comes once more";
        scope.diagnostics.error_because(written[1].span, message, reason);
        return None;
    }
    Some([from, to])
}

/// The declared value of a constant or a parameter, or of the negative of one.
fn declared(scope: &Scope<'_>, expr: &Scalar) -> Option<Exact> {
    match expr {
        Scalar::Constant(value) => Some(value.clone()),
        Scalar::Negate(value) => Some(declared(scope, value)?.neg()),
        Scalar::Param(id) => match &scope.mechanism.params[id.index()].kind {
            ParamKind::Number { default, .. } => Some(default.clone()),
            _ => None,
        },
        _ => None,
    }
}

/// Ends are constants and parameters.
fn end_depends_on_no_input(scope: &mut Scope<'_>, end: &Expr, name: &Ident) -> Option<()> {
    let Some(at) = fits::moving_part(scope, end) else { return Some(()) };
    let message = format!("the ends of `{name}` depend on no input; write constants or parameters");
    let reason = "the machine has to be assembled from end to end, whatever the inputs are";
    scope.diagnostics.error_because(at, message, reason);
    None
}

/// True if the value changes with the unknown that is searched.
pub(in crate::model) fn changes_with(searched: &Searched, expr: &Scalar) -> bool {
    let reaches = |entity| searched.reaches(entity);
    expr.any_leaf(&|leaf| match leaf {
        Scalar::Unknown(id) => *id == searched.id,
        Scalar::Let(id) => reaches(Entity::Let(*id)),
        Scalar::Slide(link) => reaches(Entity::Link(*link)),
        Scalar::Coordinate(point, _) => reaches(Entity::Point(*point)),
        Scalar::Distance(points) => points.iter().any(|&point| reaches(Entity::Point(point))),
        Scalar::Offset(point, guide) => {
            reaches(Entity::Point(*point)) || reaches(Entity::Guide(*guide))
        }
        // Only forces read others that a motion changes.
        _ => false,
    })
}

/// Every unknown is solved.
pub(in crate::model) fn every_unknown_is_solved(scope: &mut Scope<'_>, tree: &Declaration) {
    let Some(Searched { name, .. }) = scope.facts.searched() else { return };
    if tree.unread.may_hold("solve") || tree.unread.may_hold(&name.to_string()) {
        return;
    }
    // The equation that is missing may be what uses an input.
    scope.names.use_is_hidden = true;
    let message = format!("`{name}` is never solved; end its search with `solve {name} {{ … }}`");
    let reason = "an equation fixes it, as in `solve theta { ram.slide = x, mode: falling }`";
    scope.diagnostics.error_because(name.span(), message, reason);
}

/// Where a dyad of constants stops the crank that an unknown turns, both ends lie on one side.
pub(in crate::model) fn ends_can_be_assembled(scope: &mut Scope<'_>) {
    for group in scope.mechanism.group_steps() {
        let Some(Drive::Angle { angle: AngleSum { links, rest: Scalar::Unknown(id) }, .. }) =
            &group.outer[0].drive
        else {
            continue;
        };
        let link = group.links[0];
        if scope.mechanism.is_searched_for(link) {
            // Both ends were looked at in the drawing.
            continue;
        }
        let ends = &scope.mechanism.unknowns[id.index()].between;
        let [Some(from), Some(to)] = ends.each_ref().map(Scalar::constant) else { continue };
        let [from, to] = [from, to].map(|end| end.to_f64().to_degrees());
        let found =
            scope.mechanism.rotatabilities.iter().find_map(|found| match &found.turn.range {
                Range::Within(stretches)
                    if found.crank == link
                        && links.is_empty()
                        && scope.mechanism.is_tried(found.group, *id) =>
                {
                    let outside = outside(stretches, [from, to])?;
                    Some((found, outside, stretches))
                }
                _ => None,
            });
        let Some((found, end, stretches)) = found else { continue };
        let crank = &scope.mechanism.links[link.index()].name;
        let title = &scope.mechanism.groups[found.group.index()].title;
        let stretches: Vec<_> =
            stretches.iter().map(|[a, b]| format!("from {a:.3}° to {b:.3}°")).collect();
        let message = format!("at this end `{title}` cannot be assembled; move it in");
        let reason = format!("`{crank}` turns {}", stretches.join(" or "));
        let at = scope.facts.ends_of_unknowns[id.index()][end];
        scope.diagnostics.error_because(at, message, reason);
    }
}

/// Which of the two angles, in degrees, lies on no stretch that holds the other.
fn outside(stretches: &[[f64; 2]], [from, to]: [f64; 2]) -> Option<usize> {
    // Angles shown in degrees are rounded.
    const ROOM: f64 = 1e-9;
    let reaches = |[low, high]: &[f64; 2]| {
        let turns = ((from - low + ROOM) / 360.0).floor() * 360.0;
        (from - turns <= high + ROOM).then(|| to - turns <= high + ROOM)
    };
    match stretches.iter().find_map(reaches) {
        Some(true) => None,
        Some(false) => Some(1),
        None => Some(0),
    }
}
