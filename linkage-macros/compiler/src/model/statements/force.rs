//! `force (fx, fy) on P;` and `force f between P and Q;`.

use proc_macro2::Ident;
use syn::Attribute;

use crate::syntax::tree::{Expr, ForceBetweenStatement, ForceStatement};

use crate::model::acting::{Axes, Force};
use crate::model::mechanism::{Body, Carrier, Dimension, PointId};
use crate::model::names::{Entity, Kind};
use crate::model::scope::Scope;
use crate::model::statements::{Rules, acts};
use crate::model::uses;

impl Rules for ForceStatement {
    fn builds_on(&self) -> Vec<&Ident> {
        self.axes.iter().chain([&self.on]).collect()
    }

    fn each_expression(&self, f: &mut dyn FnMut(&Expr)) {
        self.value.iter().for_each(f);
    }

    fn resolve(&self, scope: &mut Scope<'_>, _docs: &[Attribute]) {
        let force = force(scope, &self.value, self.axes.as_ref(), &self.on);
        scope.mechanism.dynamics.forces.extend(force);
    }
}

impl Rules for ForceBetweenStatement {
    fn builds_on(&self) -> Vec<&Ident> {
        self.points.iter().collect()
    }

    fn each_expression(&self, f: &mut dyn FnMut(&Expr)) {
        f(&self.value);
    }

    fn resolve(&self, scope: &mut Scope<'_>, _docs: &[Attribute]) {
        let force = force_between(scope, &self.value, &self.points);
        scope.mechanism.dynamics.forces.extend(force);
    }
}

fn force(
    scope: &mut Scope<'_>,
    value: &[Expr; 2],
    axes: Option<&Ident>,
    on: &Ident,
) -> Option<Force> {
    let value = [0, 1].map(|k| acts::acting(scope, &value[k], Dimension::FORCE));
    let axes = match axes {
        None => Some(Axes::Body(Carrier::Ground)),
        Some(name) => match uses::usable(scope, name, &[Kind::Link, Kind::Guide]) {
            Some(Entity::Link(link)) => Some(Axes::Body(Carrier::Link(link))),
            Some(Entity::Guide(guide)) => Some(Axes::Guide(guide)),
            _ => None,
        },
    };
    let point = moved_point(scope, on);
    let ([x, y], axes) = (value, axes?);
    let value = match axes {
        Axes::Body(body) => match scope.mechanism.frame_shift(body) {
            Some(shift) => shift.components([x?, y?]),
            None => [x?, y?],
        },
        Axes::Guide(_) => [x?, y?],
    };
    Some(Force::At { point: point?, value, axes })
}

/// A point that a force moves, or tries to.
fn moved_point(scope: &mut Scope<'_>, name: &Ident) -> Option<PointId> {
    let point = uses::point(scope, name)?;
    match scope.mechanism.owner(point)? {
        Body::Ground => acts::ground_moves_nothing(scope, name, "force"),
        _ => Some(point),
    }
}

fn force_between(scope: &mut Scope<'_>, value: &Expr, names: &[Ident; 2]) -> Option<Force> {
    let value = acts::acting(scope, value, Dimension::FORCE);
    let points = acts::two_points(scope, names, "a force acts")?;
    Some(Force::Between { points, value: value? })
}
