//! A group of a drawing that is solved by all its unknowns at once: where it begins, and the points that close its loops. Nobody
//! writes these statements.

use proc_macro2::{Ident, Span};
use syn::Attribute;

use crate::syntax::tree::{CloseStatement, Expr, TrackStatement};

use crate::model::dimension::Measure;
use crate::model::facts::{Degree, LetFacts};
use crate::model::mechanism::{
    AngleSum, Dimension, GroupName, LetId, Scalar, Tracked, TrackedClosing, TrackedId,
};
use crate::model::names::{Entity, Kind};
use crate::model::reads::Reads;
use crate::model::scope::Scope;
use crate::model::solved_at_once::TrackedFit;
use crate::model::statements::Rules;
use crate::model::{declared, drawn_sliding, expressions, uses};

impl Rules for TrackStatement {
    fn declares(&self) -> Vec<(&Ident, Kind)> {
        self.unknowns.iter().map(|name| (name, Kind::Let)).collect()
    }

    fn title(&self, name: &str) -> String {
        format!("unknown {name}")
    }

    fn each_expression(&self, f: &mut dyn FnMut(&Expr)) {
        f(&self.drive);
    }

    fn resolve(&self, scope: &mut Scope<'_>, _docs: &[Attribute]) {
        let drive = expressions::quantity(scope, &self.drive);
        let found = scope.drawn.and_then(|drawn| drawn.tracked.get(self.group));
        let (Some(drive), Some((links, fit))) = (drive, found) else { return };
        track(scope, &self.unknowns, drive.turn(), (links, fit));
    }
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
        let (measure, reads, pull) = (Measure::Known(of), Reads::default(), Degree::Free);
        scope.facts.lets.push(LetFacts { measure, moves: true, reads, pull });
        let rest = Scalar::Tracked(id, index);
        scope.mechanism.lets.push(AngleSum { links: Vec::new(), rest });
        let entity = Entity::Let(LetId(scope.mechanism.lets.len() as u32 - 1));
        scope.names.bind(name, entity);
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

impl Rules for CloseStatement {
    fn builds_on(&self) -> Vec<&Ident> {
        self.unknowns.iter().chain(self.points.iter().flatten()).collect()
    }

    fn resolve(&self, scope: &mut Scope<'_>, _docs: &[Attribute]) {
        let mut closings = Vec::new();
        for ([made, met], &bend) in self.points.iter().zip(&self.bends) {
            if let (Some(made), Some(met)) = (uses::point(scope, made), uses::point(scope, met)) {
                closings.push(TrackedClosing { points: [made, met], bend });
            }
        }
        let steps = scope.mechanism.steps.len();
        if let Some(tracked) = scope.mechanism.tracked.last_mut() {
            tracked.closings = closings;
            tracked.steps[1] = steps;
        }
    }
}
