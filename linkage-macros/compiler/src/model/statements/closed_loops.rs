//! A group of a drawing that is solved by all its unknowns at once: where it begins, and the points that close its
//! loops.

use proc_macro2::{Ident, Span};

use crate::syntax::tree::Expr;

use crate::model::facts::LetFacts;
use crate::model::figures::Figure;
use crate::model::mechanism::{
    AngleSum, Dimension, GroupName, Scalar, Tracked, TrackedClosing, TrackedId,
};
use crate::model::names::Kind;
use crate::model::scope::Scope;
use crate::model::solved_at_once::TrackedFit;
use crate::model::statements::made::MadeItem;
use crate::model::statements::named;
use crate::model::{declared, drawn_sliding, expressions, uses};

/// The unknowns of a group that is solved by all of them at once, links that are known over the value of a drive.
pub(in crate::model) fn made_tracking(
    unknowns: Vec<Ident>,
    drive: Expr,
    (links, fit): (Vec<Ident>, TrackedFit),
) -> MadeItem {
    let makes = unknowns.iter().map(|name| (name.clone(), Kind::Unknown)).collect();
    let numbers = vec![Figure::written(drive.clone(), None)];
    MadeItem::new(makes, Vec::new(), numbers, move |scope, _| {
        if let Some(drive) = expressions::quantity(scope, &drive) {
            track(scope, &unknowns, drive.turn(), (&links, &fit));
        }
    })
}

fn track(
    scope: &mut Scope<'_>,
    names: &[Ident],
    drive: AngleSum,
    (links, fit): (&[Ident], &TrackedFit),
) {
    let id = TrackedId(scope.mechanism.tracked.len() as u32);
    for (index, (name, unknown)) in names.iter().zip(&fit.unknowns).enumerate() {
        let of = if unknown.is_angle { Dimension::ANGLE } else { Dimension::LENGTH };
        let value = AngleSum { links: Vec::new(), rest: Scalar::Tracked(id, index) };
        named::new_let(scope, name, value, LetFacts::of_a_pose(of, true));
    }
    let group = declared::next_group(scope);
    let span = names.first().map_or(Span::call_site(), Ident::span);
    scope.mechanism.groups.push(GroupName {
        keyword: Ident::new("group", span),
        title: drawn_sliding::title_as_drawn(scope, links.iter()),
    });
    let steps = [scope.mechanism.steps.len(); 2];
    let (fit, closings) = (fit.clone(), Vec::new());
    scope.mechanism.tracked.push(Tracked { group, drive, fit, steps, closings });
}

/// The pairs of points that close the loops of such a group, each with a bound on the second derivatives of the vector
/// between both.
pub(in crate::model) fn made_closing(
    unknowns: Vec<Ident>,
    pairs: Vec<([Ident; 2], f64)>,
) -> MadeItem {
    let points = pairs.iter().flat_map(|(points, _)| points.clone());
    let builds_on = unknowns.into_iter().chain(points).collect();
    MadeItem::new(Vec::new(), builds_on, Vec::new(), move |scope, _| {
        let mut closings = Vec::new();
        for ([made, met], bend) in &pairs {
            if let (Some(made), Some(met)) = (uses::point(scope, made), uses::point(scope, met)) {
                closings.push(TrackedClosing { points: [made, met], bend: *bend });
            }
        }
        let steps = scope.mechanism.steps.len();
        if let Some(tracked) = scope.mechanism.tracked.last_mut() {
            tracked.closings = closings;
            tracked.steps[1] = steps;
        }
    })
}
