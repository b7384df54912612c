//! `ground A(0, 0), D(…);`: points that stand still.

use proc_macro2::Ident;
use syn::Attribute;

use crate::syntax::tree::{Expr, GroundStatement};

use crate::model::assembly::constants;
use crate::model::mechanism::{Carrier, PartOf, Step};
use crate::model::names::{Entity, Kind};
use crate::model::scope::Scope;
use crate::model::statements::Rules;
use crate::model::{declared, numbers};

impl Rules for GroundStatement {
    fn declares(&self) -> Vec<(&Ident, Kind)> {
        self.points.iter().map(|(name, _)| (name, Kind::Point)).collect()
    }

    fn title(&self, name: &str) -> String {
        format!("ground {name}")
    }

    fn each_expression(&self, f: &mut dyn FnMut(&Expr)) {
        self.points.iter().flat_map(|(_, place)| place).for_each(f);
    }

    fn resolve(&self, scope: &mut Scope<'_>, docs: &[Attribute]) {
        ground(scope, docs, &self.points);
    }

    fn stand_in(&self, scope: &mut Scope<'_>, docs: &[Attribute], name: &Ident) -> Option<Entity> {
        declared::group_by_itself(scope, "point", name);
        Some(Entity::Point(declared::new_point(scope, docs, name, PartOf::Ground)))
    }
}

/// Points that stand still.
pub(in crate::model) fn ground(
    scope: &mut Scope<'_>,
    docs: &[Attribute],
    points: &[(Ident, [Expr; 2])],
) {
    for (name, place) in points {
        let point = declared::add_point(scope, docs, name, PartOf::Ground);
        let at = [0, 1].map(|i| {
            numbers::depends_on_no_input(scope, &place[i], name)?;
            numbers::length(scope, &place[i])
        });
        let at = match at {
            [Some(x), Some(y)] => Some([x, y]),
            _ => None,
        };
        let Some(point) = point else {
            continue;
        };
        scope.facts.fix(point, Carrier::Ground, at.as_ref().and_then(constants));
        scope.mechanism.steps.extend(at.map(|at| Step::Ground { point, at }));
    }
}
