//! Springs and dampers: between two points, or between two bodies.

use proc_macro2::Ident;
use syn::Attribute;

use crate::syntax::anatomy::{FieldRule, GroupSpec, Pin, optional};
use crate::syntax::tree::{Expr, GroupStatement, SpringStatement};

use crate::model::acting::{Ends, Magnitude, Spring};
use crate::model::mechanism::{self, Carrier, Dimension, PointId, SpringId};
use crate::model::names::{Entity, Kind};
use crate::model::parts_of_groups::Fields;
use crate::model::scope::Scope;
use crate::model::statements::{Rules, acts, mass};
use crate::model::{fields, numbers, uses};

const DAMPING: FieldRule = optional("damping", "what it exerts against its rate, `10(N*s/m)`");

const BETWEEN_POINTS: GroupSpec = GroupSpec {
    keyword: "spring",
    class: None,
    joints: &[],
    pin: Pin::Optional,
    fields: &[
        optional("stiffness", "the force over the length, `15(N/m)`"),
        optional("free_length", "the length at which it is slack"),
        DAMPING,
    ],
    modes: None,
    form: "spring between P and Q { stiffness: 15(N/m), free_length: 0.3m }",
};

const BETWEEN_BODIES: GroupSpec = GroupSpec {
    fields: &[
        optional("stiffness", "the couple over the angle, `5(N*m/rad)`"),
        optional("free_angle", "the angle of the second body against the first where it is slack"),
        DAMPING,
    ],
    form: "spring between AB and DC { stiffness: 5(N*m/rad), free_angle: 30deg }",
    ..BETWEEN_POINTS
};

impl Rules for SpringStatement {
    fn declares(&self) -> Vec<(&Ident, Kind)> {
        self.name.iter().map(|name| (name, Kind::Spring)).collect()
    }

    fn builds_on(&self) -> Vec<&Ident> {
        self.ends.iter().collect()
    }

    fn each_expression(&self, f: &mut dyn FnMut(&Expr)) {
        self.fields.values().for_each(f);
    }

    fn resolve(&self, scope: &mut Scope<'_>, docs: &[Attribute]) {
        spring(scope, docs, &self.name, &self.ends, &self.fields);
    }

    fn stand_in(&self, scope: &mut Scope<'_>, docs: &[Attribute], name: &Ident) -> Option<Entity> {
        let ends = match is_between_bodies(scope, &self.ends) || scope.mechanism.points.is_empty() {
            true => Ends::Bodies([Carrier::Ground; 2]),
            false => Ends::Points([PointId(0); 2]),
        };
        let [stiffness, damping, free] = [(); 3].map(|()| Magnitude::zero());
        let (title, name, docs) =
            (self.title(&name.to_string()), Some(name.clone()), docs.to_vec());
        let springs = &mut scope.mechanism.dynamics.springs;
        springs.push(Spring { name, docs, title, ends, stiffness, damping, free });
        Some(Entity::Spring(SpringId(springs.len() as u32 - 1)))
    }
}

fn spring(
    scope: &mut Scope<'_>,
    docs: &[Attribute],
    name: &Option<Ident>,
    ends: &[Ident; 2],
    fields: &GroupStatement,
) {
    let is_new = name.as_ref().is_none_or(|name| uses::name_is_new(scope, name).is_some());
    let spring = match is_between_bodies(scope, ends) {
        true if ends_are_alike(scope, ends).is_none() => None,
        true => torsion_spring(scope, ends, fields),
        false => straight_spring(scope, ends, fields),
    };
    if let (true, Some(spring)) = (is_new, spring) {
        let known = match name {
            Some(name) => name.to_string(),
            None => scope.mechanism.both(spring.ends),
        };
        let springs = &mut scope.mechanism.dynamics.springs;
        let id = SpringId(springs.len() as u32);
        springs.push(Spring {
            name: name.clone(),
            docs: docs.to_vec(),
            title: format!("spring {known}"),
            ..spring
        });
        name.iter().for_each(|name| scope.names.bind(name, Entity::Spring(id)));
    }
}

/// True if one of the ends is a body: the other should then be one, too.
fn is_between_bodies(scope: &Scope<'_>, ends: &[Ident; 2]) -> bool {
    ends.iter().any(|end| end == "ground" || scope.names.kind(end) == Some(Kind::Link))
}

/// Reports a spring between a point and a body: of the body, it needs a point.
fn ends_are_alike(scope: &mut Scope<'_>, ends: &[Ident; 2]) -> Option<()> {
    let is_point = |end: &&Ident| scope.names.kind(end) == Some(Kind::Point);
    let (Some(point), Some(body)) =
        (ends.iter().find(is_point), ends.iter().find(|end| !is_point(end)))
    else {
        return Some(());
    };
    let message =
        format!("`{point}` is a point and `{body}` a body; name two points or two bodies");
    let reason = match body == "ground" {
        true => "a point of the ground is declared: `ground G(x, y);`".to_string(),
        false => format!("a point of `{body}` is declared: `point P on {body} at (x, y);`"),
    };
    scope.diagnostics.error_because(body.span(), message, reason);
    None
}

fn straight_spring(
    scope: &mut Scope<'_>,
    names: &[Ident; 2],
    group: &GroupStatement,
) -> Option<Spring> {
    let ends = acts::two_points(scope, names, "a spring is");
    let fields = fields::fields(scope, group, &BETWEEN_POINTS);
    let per_length = Dimension::FORCE.times(Dimension::LENGTH, -1);
    let stiffness = number_of_spring(scope, &fields, "stiffness", "a stiffness", per_length);
    let free = number_of_spring(scope, &fields, "free_length", "a free length", Dimension::LENGTH);
    let damping = damping(scope, &fields, per_length);
    spring_does_something(scope, group, &fields)?;
    if fields.one("stiffness").is_some() && fields.is_left_out("free_length") {
        let message = "missing field `free_length`";
        let reason = "a spring is measured from the length at which it is slack; `0` will do";
        scope.diagnostics.error_because(group.end, message, reason);
        return None;
    }
    let spring = Spring {
        name: None,
        docs: Vec::new(),
        title: String::new(),
        ends: Ends::Points(ends?),
        stiffness: stiffness?,
        damping: damping?,
        free: free?,
    };
    damper_has_a_length(scope, &fields, &spring)?;
    Some(spring)
}

/// A damper acts along a line, and where its ends may meet there is none.
fn damper_has_a_length(scope: &mut Scope<'_>, fields: &Fields, spring: &Spring) -> Option<()> {
    let is_damped = !spring.damping.value.is_zero();
    let meets = fields.one("free_length").is_some() && spring.free.value.is_zero();
    if !is_damped || !meets {
        return Some(());
    }
    let message = "a spring of no free length has no damping; leave it out";
    let reason = "where its ends meet, a damper has no direction: what brakes a point in every \
                  direction is `force (-c * rate(P.x), -c * rate(P.y)) on P`";
    let at = fields.one("damping").map(|damping| damping.span)?;
    scope.diagnostics.error_because(at, message, reason);
    None
}

fn torsion_spring(
    scope: &mut Scope<'_>,
    names: &[Ident; 2],
    group: &GroupStatement,
) -> Option<Spring> {
    let ends = acts::two_bodies(scope, names, "a spring between links is");
    let fields = fields::fields(scope, group, &BETWEEN_BODIES);
    let stiffness = number_of_spring(scope, &fields, "stiffness", "a stiffness", Dimension::TORQUE);
    let damping = damping(scope, &fields, Dimension::TORQUE);
    let free = match fields.one("free_angle") {
        None => Some(mechanism::Scalar::zero()),
        Some(angle) => {
            let fixed = acts::changes_with_no_input(scope, angle, "a free angle");
            let angle = numbers::plain_angle(scope, angle);
            fixed.and(angle)
        }
    };
    spring_does_something(scope, group, &fields)?;
    Some(Spring {
        name: None,
        docs: Vec::new(),
        title: String::new(),
        ends: Ends::Bodies(ends?),
        stiffness: stiffness?,
        damping: damping?,
        free: Magnitude { value: free?, name: "free_angle".to_string() },
    })
}

fn damping(scope: &mut Scope<'_>, fields: &Fields, stiffness: Dimension) -> Option<Magnitude> {
    let dimension = stiffness.times(Dimension::TIME, 1);
    number_of_spring(scope, fields, "damping", "a damping", dimension)
}

/// A number that is zero where it is left out.
fn number_of_spring(
    scope: &mut Scope<'_>,
    fields: &Fields,
    field: &str,
    what: &str,
    dimension: Dimension,
) -> Option<Magnitude> {
    match fields.one(field) {
        Some(value) => mass::not_negative(scope, value, dimension, what, field.to_string()),
        None => Some(Magnitude::zero()),
    }
}

/// A spring without stiffness and damping is none.
fn spring_does_something(
    scope: &mut Scope<'_>,
    group: &GroupStatement,
    fields: &Fields,
) -> Option<()> {
    if !fields.is_left_out("stiffness") || !fields.is_left_out("damping") {
        return Some(());
    }
    let message = "a spring of no stiffness and no damping does nothing";
    let reason = "write `stiffness: …`, `damping: …` or both";
    scope.diagnostics.error_because(group.end, message, reason);
    None
}
