//! Where a declaration makes its names and where it uses them, so that every one of them reaches
//! the generated code and editors find their way from one to the other.

use std::collections::HashSet;

use proc_macro2::Ident;

use crate::syntax::tree::{
    Course, Declaration, Expr, ExprKind, GroupStatement, GuideAnchor, PointPlace, Statement,
    StatementKind,
};

use super::mechanism::References;
use super::names::{declared_by, title};

impl References {
    pub(super) fn of(tree: &Declaration) -> Self {
        let mut references = Self::default();
        for statement in &tree.statements {
            for (name, _) in declared_by(statement) {
                references.made.push((name.clone(), title(statement, &name.to_string())));
            }
        }
        let known: HashSet<_> = references.made.iter().map(|(name, _)| name.to_string()).collect();
        for statement in &tree.statements {
            let mut used = |name: &Ident| {
                // Modes and what a crank's angle is relative to may also be words.
                if known.contains(&name.to_string()) {
                    references.used.push(name.clone());
                }
            };
            joints(statement).into_iter().for_each(&mut used);
            expressions(statement, &mut |expr| names_in(expr, &mut used));
        }
        references
    }
}

/// Every name that a statement uses, as written.
pub(super) fn names_used(statement: &Statement) -> Vec<Ident> {
    let mut names = Vec::new();
    each_name_used(statement, &mut |name| names.push(name.clone()));
    names
}

/// Calls `f` with every name that a statement uses.
pub(super) fn each_name_used(statement: &Statement, f: &mut impl FnMut(&Ident)) {
    joints(statement).into_iter().for_each(&mut *f);
    expressions(statement, &mut |expr| names_in(expr, &mut *f));
}

/// The points, links and guides that a statement builds on.
fn joints(statement: &Statement) -> Vec<&Ident> {
    match &statement.kind {
        StatementKind::Guide { on, through, course, .. } => {
            let through = match through {
                GuideAnchor::Point(point) => Some(point),
                GuideAnchor::At(_) | GuideAnchor::Mistake => None,
            };
            let towards = match course {
                Course::Towards(point) => Some(point),
                Course::Along(_) | Course::Mistake => None,
            };
            on.iter().chain(through).chain(towards).collect()
        }
        StatementKind::Point { on, .. } => on.iter().collect(),
        StatementKind::Link { links, .. } => {
            links.iter().flat_map(|link| link.pins.iter().chain(&link.on)).collect()
        }
        StatementKind::Drive(drive) => {
            [&drive.link].into_iter().chain(drive.to.iter().map(|(link, _)| link)).collect()
        }
        StatementKind::DriveBy { input, load } => vec![input, load],
        StatementKind::Solve(solve) => vec![&solve.unknown],
        StatementKind::Action(action) => action.names(),
        StatementKind::Group(group) => {
            group.legs.iter().filter_map(|leg| leg.joint.as_ref()).collect()
        }
        _ => Vec::new(),
    }
}

/// Calls `f` with every expression of the statement.
pub(super) fn expressions(statement: &Statement, f: &mut impl FnMut(&Expr)) {
    match &statement.kind {
        StatementKind::Param { default: value, .. } | StatementKind::Let { value, .. } => f(value),
        StatementKind::Drive(drive) => f(&drive.value),
        StatementKind::Link { fields, .. } => {
            fields.iter().flat_map(GroupStatement::values).for_each(f);
        }
        StatementKind::Ground { points } | StatementKind::Pin { points } => {
            points.iter().flat_map(|(_, place)| place).for_each(f);
        }
        StatementKind::Guide { through, course, .. } => {
            if let GuideAnchor::At(place) = through {
                place.iter().for_each(&mut *f);
            }
            if let Course::Along(angle) = course {
                f(angle);
            }
        }
        StatementKind::Point { place, .. } => match place {
            PointPlace::Cartesian(values)
            | PointPlace::Polar(values)
            | PointPlace::Distances(values, _) => {
                values.iter().for_each(f);
            }
            PointPlace::Mistake => {}
        },
        StatementKind::Group(group) => group.values().for_each(f),
        StatementKind::Unknown { between, .. } => between.iter().flatten().for_each(f),
        StatementKind::Solve(solve) => {
            solve.equation.iter().flatten().chain(&solve.near).for_each(f);
        }
        StatementKind::Output { items } => items.iter().for_each(|item| f(&item.value)),
        StatementKind::Action(action) => action.expressions().into_iter().for_each(f),
        StatementKind::Input { .. }
        | StatementKind::Load { .. }
        | StatementKind::DriveBy { .. }
        | StatementKind::Numerics { .. }
        | StatementKind::Crate { .. }
        | StatementKind::Export { .. } => {}
    }
}

/// Calls `f` with every name in the expression.
pub(super) fn names_in(expr: &Expr, f: &mut impl FnMut(&Ident)) {
    expr.each_part(&mut |part| match &part.kind {
        ExprKind::Name(name) | ExprKind::Member(name, _) => f(name),
        ExprKind::Part(path) => path[..2].iter().for_each(&mut *f),
        _ => {}
    });
}
