//! Stops: the two ends of an angle, a slide or a distance.

use proc_macro2::Ident;
use syn::Attribute;

use crate::syntax::anatomy::{GroupSpec, Pin, needed, optional};
use crate::syntax::tree::{Expr, StopStatement};

use crate::model::acting::{Magnitude, Stop, Stopped};
use crate::model::as_written::text;
use crate::model::mechanism::{AngleSum, Dimension, Scalar, StopId};
use crate::model::names::{Entity, Kind};
use crate::model::scope::Scope;
use crate::model::statements::{Rules, acts, mass};
use crate::model::{expressions, fields, numbers, uses};

const STOP: GroupSpec = GroupSpec {
    keyword: "stop",
    class: None,
    joints: &[],
    pin: Pin::Optional,
    fields: &[
        needed("stiffness", "the force or couple over the way beyond an end, `2e4(N*m/rad)`"),
        optional("damping", "what it exerts against the rate beyond an end, `50(N*m*s/rad)`"),
    ],
    modes: None,
    form: "stop DC.angle between (20deg, 110deg) { stiffness: 2e4(N*m/rad) }",
};

impl Rules for StopStatement {
    fn declares(&self) -> Vec<(&Ident, Kind)> {
        self.name.iter().map(|name| (name, Kind::Stop)).collect()
    }

    fn each_expression(&self, f: &mut dyn FnMut(&Expr)) {
        f(&self.of);
        self.ends.iter().chain(self.fields.values()).for_each(f);
    }

    fn resolve(&self, scope: &mut Scope<'_>, docs: &[Attribute]) {
        stop(scope, docs, self);
    }

    fn stand_in(&self, scope: &mut Scope<'_>, docs: &[Attribute], name: &Ident) -> Option<Entity> {
        let of = Stopped::Angle(AngleSum { links: Vec::new(), rest: Scalar::zero() });
        let ends = [(); 2].map(|()| Scalar::zero());
        let [stiffness, damping] = [(); 2].map(|()| Magnitude::zero());
        let (title, name, docs) =
            (self.title(&name.to_string()), Some(name.clone()), docs.to_vec());
        let stops = &mut scope.mechanism.dynamics.stops;
        stops.push(Stop { name, docs, title, of, ends, stiffness, damping });
        Some(Entity::Stop(StopId(stops.len() as u32 - 1)))
    }
}

fn stop(scope: &mut Scope<'_>, docs: &[Attribute], written: &StopStatement) {
    let name = &written.name;
    let is_new = name.as_ref().is_none_or(|name| uses::name_is_new(scope, name).is_some());
    let stop = stop_of(scope, docs, written);
    if let (true, Some(stop)) = (is_new, stop) {
        let stops = &mut scope.mechanism.dynamics.stops;
        let id = StopId(stops.len() as u32);
        stops.push(stop);
        name.iter().for_each(|name| scope.names.bind(name, Entity::Stop(id)));
    }
}

fn stop_of(scope: &mut Scope<'_>, docs: &[Attribute], written: &StopStatement) -> Option<Stop> {
    let of = stopped(scope, &written.of)?;
    let ends = ends_of_stop(scope, &written.ends, of.dimension());
    let fields = fields::fields(scope, &written.fields, &STOP);
    let per_unit = match &of {
        Stopped::Angle(_) => Dimension::TORQUE,
        Stopped::Slide(_) | Stopped::Distance(_) => Dimension::FORCE.times(Dimension::LENGTH, -1),
    };
    let stiffness = fields.one("stiffness").and_then(|value| {
        mass::not_negative(scope, value, per_unit, "a stiffness", "stiffness".to_string())
    });
    let damping = match fields.one("damping") {
        Some(value) => {
            let dimension = per_unit.times(Dimension::TIME, 1);
            mass::not_negative(scope, value, dimension, "a damping", "damping".to_string())
        }
        None => Some(Magnitude::zero()),
    };
    let title = match &written.name {
        Some(name) => written.title(&name.to_string()),
        None => "stop".to_string(),
    };
    Some(Stop {
        name: written.name.clone(),
        docs: docs.to_vec(),
        title,
        of,
        ends: ends?,
        stiffness: stiffness?,
        damping: damping?,
    })
}

/// A stop pushes on what it stops: on links by their angles or a slide, or on two points.
fn stopped(scope: &mut Scope<'_>, of: &Expr) -> Option<Stopped> {
    let sum = expressions::quantity(scope, of)?.turn();
    match (sum.links.is_empty(), &sum.rest) {
        (true, Scalar::Slide(link)) => Some(Stopped::Slide(*link)),
        (true, Scalar::Distance(points)) => Some(Stopped::Distance(*points)),
        (false, rest) if !scope.mechanism.moves(rest) => Some(Stopped::Angle(sum)),
        _ => {
            let message = "a stop cannot push on this";
            let reason = "it is of a link's `angle`, a sum of links' angles, a `slide` or a \
                          `distance(P, Q)`; of an input, name its link: `stop AB.angle between …`";
            scope.diagnostics.error_because(of.span, message, reason);
            None
        }
    }
}

/// The ends, the lower one first.
fn ends_of_stop(
    scope: &mut Scope<'_>,
    written: &[Expr; 2],
    dimension: Dimension,
) -> Option<[Scalar; 2]> {
    let [from, to] = [0, 1].map(|end| {
        let fixed = acts::changes_with_no_input(scope, &written[end], "an end of a stop");
        let value = numbers::scalar(scope, &written[end], dimension);
        fixed.and(value)
    });
    let ends = [from?, to?];
    if let [Scalar::Constant(from), Scalar::Constant(to)] = &ends
        && !from.cmp_value(to).is_lt()
    {
        let message = "the second end of a stop lies above the first";
        let [low, high] = [&written[1], &written[0]].map(text);
        let reason = format!("the motion is free between them: `between ({low}, {high})`");
        scope.diagnostics.error_because(written[1].span, message, reason);
        return None;
    }
    Some(ends)
}
