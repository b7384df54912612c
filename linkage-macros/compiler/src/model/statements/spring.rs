//! Springs and dampers: between two points, or between two bodies.

use proc_macro2::Ident;
use quote::format_ident;
use syn::Attribute;

use crate::syntax::anatomy::{FieldRule, GroupSpec, Pin, optional};
use crate::syntax::tree::{Expr, ExprKind, GroupStatement, SpringStatement};

use crate::model::acting::{Effort, Ends, Magnitude, Spring};
use crate::model::drawn::printed::{self, braces};
use crate::model::drawn::{Bodies, FrameShifts};
use crate::model::expressions::{self, RATE, ResolvedExpr, counted};
use crate::model::fields::{self, Fields};
use crate::model::mechanism::{self, Carrier, Dimension, OutputKind, PointId, SpringId};
use crate::model::names::{Entity, Kind};
use crate::model::reads::Allowed;
use crate::model::scope::Scope;
use crate::model::{dynamics_outputs, given, numbers, uses};

use super::{Rules, acts, mass, named};

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

    fn title(&self, name: &str) -> String {
        format!("spring {name}")
    }

    fn builds_on(&self) -> Vec<&Ident> {
        self.ends.iter().collect()
    }

    fn each_expression(&self, f: &mut dyn FnMut(&Expr)) {
        self.fields.values().for_each(f);
    }

    fn resolve(&self, scope: &mut Scope<'_>, docs: &[Attribute], _moves: bool) {
        spring(scope, docs, &self.name, &self.ends, &self.fields);
    }

    fn stand_in(&self, scope: &mut Scope<'_>, docs: &[Attribute], name: &Ident) -> Option<Entity> {
        let ends = match is_between_bodies(scope, &self.ends) || scope.mechanism.points.is_empty() {
            true => Ends::Bodies([Carrier::Ground; 2]),
            false => Ends::Points([PointId(0); 2]),
        };
        let [stiffness, damping, free] = [(); 3].map(|()| Magnitude::zero());
        let (name, docs) = (Some(name.clone()), docs.to_vec());
        let springs = &mut scope.mechanism.dynamics.springs;
        springs.push(Spring { name, docs, ends, stiffness, damping, free });
        Some(Entity::Spring(SpringId(springs.len() as u32 - 1)))
    }

    fn acts(&self) -> bool {
        true
    }

    fn written(&self) -> String {
        let ([a, b], name) = (&self.ends, printed::own_name(&self.name));
        format!("spring{name} between {a} and {b} {}", braces(&self.fields))
    }

    fn shift(&mut self, shifts: &FrameShifts, _bodies: &Bodies<'_>) {
        shifts.group(&mut self.fields);
    }
}

pub(in crate::model) fn spring(
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
        let springs = &mut scope.mechanism.dynamics.springs;
        let id = SpringId(springs.len() as u32);
        springs.push(Spring { name: name.clone(), docs: docs.to_vec(), ..spring });
        name.iter().for_each(|name| scope.names.bind(name, Entity::Spring(id)));
    }
}

/// True if one of the ends is a body: the other should then be one, too.
pub(in crate::model) fn is_between_bodies(scope: &Scope<'_>, ends: &[Ident; 2]) -> bool {
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

/// `rate(x)`: in forces, torques and outputs, of what moves.
pub(in crate::model) fn rate(
    scope: &mut Scope<'_>,
    name: &Ident,
    arguments: &[Expr],
    allowed: Allowed,
) -> Option<ResolvedExpr> {
    let argument = match arguments {
        [argument] => argument_of_rate(scope, argument, Allowed { forces: false, ..allowed }),
        _ => {
            let found = counted(arguments.len());
            let message = format!("`{name}` takes one argument, and {found} given");
            scope.diagnostics.error(name.span(), message);
            None
        }
    };
    if !allowed.forces {
        let message = "a `rate` stands in forces, torques and outputs alone";
        let reason = "what the mechanism is made of depends on no rate";
        scope.diagnostics.error_because(name.span(), message, reason);
        return None;
    }
    let mut argument = argument?;
    argument.reads = argument.reads.of_a_rate();
    Some(argument)
}

fn argument_of_rate(
    scope: &mut Scope<'_>,
    argument: &Expr,
    allowed: Allowed,
) -> Option<ResolvedExpr> {
    let load = numbers::first(scope, argument, &|scope, part| match &part.kind {
        ExprKind::Name(name) if scope.names.kind(name) == Some(Kind::Load) => true,
        _ => named::is_law(scope, part, |reads| reads.load),
    });
    let nested = numbers::first(scope, argument, &|scope, part| {
        is_rate(part) || named::is_law(scope, part, |reads| reads.rate)
    });
    let mistake = match (load, nested) {
        (Some(at), _) => Some((at, "a load has no rate", "it is a number that each call is given")),
        (None, Some(at)) => Some((
            at,
            "a rate of a rate is an acceleration, on which no force may depend",
            "what resists acceleration is a mass, `mass 2kg on P`, or an inertia",
        )),
        (None, None) => None,
    };
    if let Some((at, message, reason)) = mistake {
        scope.diagnostics.error_because(at, message, reason);
        return None;
    }
    let quantity = expressions::expression(scope, argument, allowed)?;
    if !quantity.reads.efforts.is_empty() {
        let message = "the rate of an effort is not known";
        let reason = "it would follow from the rates of second rates, which no call is given";
        scope.diagnostics.error_because(argument.span, message, reason);
        return None;
    }
    if quantity.links.is_empty() && !scope.mechanism.moves(&quantity.rest) {
        let message = "nothing here moves, and its rate is zero";
        let reason = "a rate is that of an input, a link's `angle` or `slide`, a point's `x` or \
                      `y`, or a `distance`";
        scope.diagnostics.error_because(argument.span, message, reason);
        return None;
    }
    let measure = quantity.measure.per_time();
    let rate = mechanism::Scalar::Rate(Box::new(quantity.turn()));
    Some(ResolvedExpr::plain(measure, rate))
}

/// `shock.force`, `shock.length`; `clutch.torque`, `clutch.angle`.
pub(in crate::model) fn spring_output(
    scope: &mut Scope<'_>,
    docs: &[Attribute],
    owner: &Ident,
    member: &Ident,
) {
    let Some((id, part)) = part_of_spring(scope, owner, member) else { return };
    if part == 0 {
        return dynamics_outputs::ask(scope, docs, owner, member, Effort::Spring(id));
    }
    let spring = &scope.mechanism.dynamics.springs[id.index()];
    let (ends, own) = (spring.ends, spring.docs.clone());
    let field = format_ident!("{owner}_{member}", span = owner.span());
    let (value, dimension) = match ends {
        Ends::Points(points) => (mechanism::Scalar::Distance(points), Dimension::LENGTH),
        Ends::Bodies(_) => (mechanism::Scalar::Twist(id), Dimension::ANGLE),
    };
    let kind = OutputKind::Value { value, dimension };
    given::give(scope, member.span(), field, &[docs, &own].concat(), kind);
}

/// The effort of a spring in an expression.
pub(in crate::model) fn effort_of_spring(
    scope: &mut Scope<'_>,
    owner: &Ident,
    member: &Ident,
) -> Option<Effort> {
    let (id, part) = part_of_spring(scope, owner, member)?;
    if part == 0 {
        return Some(Effort::Spring(id));
    }
    let message = format!("`{owner}.{member}` is an output of its own");
    let reason = "an expression reads the `distance` of its points, or its links' angles";
    scope.diagnostics.error_because(member.span(), message, reason);
    None
}

fn part_of_spring(
    scope: &mut Scope<'_>,
    owner: &Ident,
    member: &Ident,
) -> Option<(SpringId, usize)> {
    let Entity::Spring(id) = uses::usable(scope, owner, &[Kind::Spring])? else { return None };
    let parts = parts(scope.mechanism.dynamics.springs[id.index()].ends);
    let found = parts.iter().position(|part| member == part);
    if found.is_none() {
        let message = format!("the spring `{owner}` has no `{member}`");
        let reason = format!("it has `{}` and `{}`", parts[0], parts[1]);
        scope.diagnostics.error_because(member.span(), message, reason);
    }
    Some((id, found?))
}

/// The members of a spring: its force and length, or its torque and angle.
pub(in crate::model) fn parts(ends: Ends) -> [&'static str; 2] {
    match ends {
        Ends::Points(_) => ["force", "length"],
        Ends::Bodies(_) => ["torque", "angle"],
    }
}

/// True if the expression is a rate.
pub(in crate::model) fn is_rate(expr: &Expr) -> bool {
    matches!(&expr.kind, ExprKind::Call(function, _) if function == RATE)
}
