//! Loads, gravity, forces and torques, and the check that they have an effect.

use proc_macro2::{Ident, Span};
use syn::Attribute;

use crate::diagnostics::nearest;
use crate::syntax::tree::{self, Action, Declaration, ExprKind, StatementKind};

use super::acting::{Axes, Dynamics, Force, Load, Torque};
use super::expressions::Allowed;
use super::inputs::{add_names, follow_lets};
use super::mechanism::{Body, Carrier, Dimension, LoadId, PointId, Scalar};
use super::names::{Entity, Kind};
use super::references::{expressions, names_in};
use super::scope::Scope;
use super::spring_damper::{self, is_rate};
use super::units::unit;
use super::{driving_load, end_stops, laws, masses, numbers, uses};

const INSIDE: &str = "what acts inside a body moves nothing";
const LOAD_KINDS: [&str; 3] = ["force", "torque", "number"];

pub(super) fn load(
    scope: &mut Scope<'_>,
    docs: &[Attribute],
    names: &[Ident],
    kind: Option<&Ident>,
) {
    let dimension = kind.and_then(|kind| load_kind(scope, kind));
    for name in names {
        let is_new = uses::name_is_new(scope, name).is_some();
        let (true, Some(dimension)) = (is_new, dimension) else { continue };
        let load = Load { name: name.clone(), docs: docs.to_vec(), dimension };
        let entity = new_load(scope, load);
        scope.names.bind(name, entity);
    }
}

/// A load that each call is given, or the one that drives an input.
pub(super) fn new_load(scope: &mut Scope<'_>, load: Load) -> Entity {
    let dynamics = &mut scope.mechanism.dynamics;
    if scope.facts.driving.as_deref() == Some(&load.name.to_string()) && dynamics.pull.is_none() {
        dynamics.pull = Some(load);
        return Entity::Pull;
    }
    dynamics.loads.push(load);
    Entity::Load(LoadId(dynamics.loads.len() as u32 - 1))
}

fn load_kind(scope: &mut Scope<'_>, kind: &Ident) -> Option<Dimension> {
    let text = kind.to_string();
    match text.as_str() {
        "force" => return Some(Dimension::FORCE),
        "torque" => return Some(Dimension::TORQUE),
        "number" => return Some(Dimension::NUMBER),
        _ => {}
    }
    if let Some((dimension, _)) = unit(&text)
        && dimension == Dimension::FORCE
    {
        let message = format!("`{text}` is a unit; write `force`");
        let reason = "a load is in newtons or newton metres; units stand behind numbers: `2kN`";
        scope.diagnostics.error_because(kind.span(), message, reason);
        return None;
    }
    let mut message = format!("no load kind named `{text}`");
    if let Some(near) = nearest(&text, LOAD_KINDS.into_iter()) {
        message += &format!("; one with a similar name exists: `{near}`");
    }
    let reason = "it is `force`, `torque` or `number`";
    scope.diagnostics.error_because(kind.span(), message, reason);
    None
}

pub(super) fn action(scope: &mut Scope<'_>, docs: &[Attribute], action: &Action) {
    match action {
        Action::Gravity { at, value } => gravity(scope, *at, value),
        Action::Mass { value, on, place, inertia } => {
            let mass = masses::mass(scope, value, on, place, inertia.as_ref());
            scope.mechanism.dynamics.masses.extend(mass);
        }
        Action::Inertia { value, on } => {
            let mass = masses::inertia(scope, value, on);
            scope.mechanism.dynamics.masses.extend(mass);
        }
        Action::Force { value, axes, on } => {
            let force = force(scope, value, axes.as_ref(), on);
            scope.mechanism.dynamics.forces.extend(force);
        }
        Action::ForceBetween { value, points } => {
            let force = force_between(scope, value, points);
            scope.mechanism.dynamics.forces.extend(force);
        }
        Action::Torque { value, on } => {
            let on = uses::link(scope, on).map(Carrier::Link);
            let value = acting(scope, value, Dimension::TORQUE);
            scope.mechanism.dynamics.torques.extend(torque(on, None, value));
        }
        Action::TorqueBetween { value, bodies } => {
            let torque = torque_between(scope, value, bodies);
            scope.mechanism.dynamics.torques.extend(torque);
        }
        Action::Spring { name, ends, fields } => {
            spring_damper::spring(scope, docs, name, ends, fields)
        }
        Action::Stop(written) => end_stops::stop(scope, docs, written),
        // Which links meet at a pin is known when all are.
        Action::Friction(_) => {}
    }
}

/// Gravity is given once, and no input changes it.
fn gravity(scope: &mut Scope<'_>, at: Span, value: &[tree::Expr; 2]) {
    let acceleration = Dimension::LENGTH.times(Dimension::TIME, -2);
    let value = [0, 1].map(|k| {
        changes_with_no_input(scope, &value[k], "gravity")?;
        numbers::scalar(scope, &value[k], acceleration)
    });
    if scope.facts.gravity_at.replace(at).is_some() {
        let message = "gravity is given twice; remove one";
        scope.diagnostics.error(at, message);
    }
    if let [Some(x), Some(y)] = value {
        scope.mechanism.dynamics.gravity = Some([x, y]);
    }
}

/// A number of the machine itself: constants and parameters.
pub(super) fn changes_with_no_input(
    scope: &mut Scope<'_>,
    expr: &tree::Expr,
    what: &str,
) -> Option<()> {
    // Rates have a message of their own.
    let of_a_rate = numbers::first(scope, expr, &|scope, part| {
        is_rate(part) || laws::is_law(scope, part, |_| true)
    })
    .is_some();
    let Some(span) = numbers::moving_part(scope, expr).filter(|_| !of_a_rate) else {
        return Some(());
    };
    let message = format!("{what} cannot depend on an input");
    let reason = "it is made of constants and parameters";
    scope.diagnostics.error_because(span, message, reason);
    None
}

pub(super) fn ground_moves_nothing<T>(
    scope: &mut Scope<'_>,
    point: &Ident,
    what: &str,
) -> Option<T> {
    let message = format!("`{point}` is a point of the ground, and a {what} there does nothing");
    let reason = "name a point of a link, a pin or a driven point";
    scope.diagnostics.error_because(point.span(), message, reason);
    None
}

/// The value of a force or a torque: loads may stand in it.
pub(super) fn acting(
    scope: &mut Scope<'_>,
    expr: &tree::Expr,
    dimension: Dimension,
) -> Option<Scalar> {
    let value = numbers::scalar_where(scope, expr, dimension, Allowed::IN_FORCES)?;
    driving_load::is_linear_in_pull(scope, expr, &value)?;
    Some(value)
}

/// A load stands in the value of a force or a torque, and nowhere else.
pub(super) fn load_stands_in_a_force(
    scope: &mut Scope<'_>,
    name: &Ident,
    allowed: Allowed,
) -> Option<()> {
    if allowed.forces {
        return Some(());
    }
    let message = format!("`{name}` is a load, and stands in forces, torques and outputs alone");
    let reason = "what the mechanism is made of and how it moves depends on no load";
    scope.diagnostics.error_because(name.span(), message, reason);
    None
}

fn force(
    scope: &mut Scope<'_>,
    value: &[tree::Expr; 2],
    axes: Option<&Ident>,
    on: &Ident,
) -> Option<Force> {
    let value = [0, 1].map(|k| acting(scope, &value[k], Dimension::FORCE));
    let axes = match axes {
        None => Some(Axes::Body(Carrier::Ground)),
        Some(name) => match uses::usable(scope, name, &[Kind::Link, Kind::Guide]) {
            Some(Entity::Link(link)) => Some(Axes::Body(Carrier::Link(link))),
            Some(Entity::Guide(guide)) => Some(Axes::Guide(guide)),
            _ => None,
        },
    };
    let point = moved_point(scope, on);
    let [x, y] = value;
    Some(Force::At { point: point?, value: [x?, y?], axes: axes? })
}

/// A point that a force moves, or tries to.
fn moved_point(scope: &mut Scope<'_>, name: &Ident) -> Option<PointId> {
    let point = uses::point(scope, name)?;
    match scope.mechanism.owner(point)? {
        Body::Ground => ground_moves_nothing(scope, name, "force"),
        _ => Some(point),
    }
}

fn force_between(scope: &mut Scope<'_>, value: &tree::Expr, names: &[Ident; 2]) -> Option<Force> {
    let value = acting(scope, value, Dimension::FORCE);
    let points = two_points(scope, names, "a force acts")?;
    Some(Force::Between { points, value: value? })
}

/// Points that can move against each other: of two bodies, or of one where an input drives a coordinate.
pub(super) fn two_points(
    scope: &mut Scope<'_>,
    names: &[Ident; 2],
    what: &str,
) -> Option<[PointId; 2]> {
    let points = [0, 1].map(|k| uses::point(scope, &names[k]));
    let [p, q] = [points[0]?, points[1]?];
    if p == q {
        let message = format!("{what} between two points");
        scope.diagnostics.error_because(names[1].span(), message, INSIDE);
        return None;
    }
    let owners = [p, q].map(|point| scope.mechanism.owner(point));
    if owners[0]? == owners[1]? && !is_driven_in(scope, owners[0]?, [p, q]) {
        let message = format!("`{}` and `{}` are fixed to one body", names[0], names[1]);
        let reason = "what acts between them moves nothing; it does where an input drives a \
                      coordinate of one, as in `at (0.2m + s, 0)`";
        scope.diagnostics.error_because(names[1].span(), message, reason);
        return None;
    }
    Some([p, q])
}

/// True if one of the points moves in the body that both belong to.
fn is_driven_in(scope: &Scope<'_>, owner: Body, points: [PointId; 2]) -> bool {
    let Body::Link(link) = owner else { return false };
    let moves = |point| scope.mechanism.coordinates_move(Carrier::Link(link), point);
    points.into_iter().any(|point| moves(point) != [false; 2])
}

fn torque_between(scope: &mut Scope<'_>, value: &tree::Expr, names: &[Ident; 2]) -> Option<Torque> {
    let value = acting(scope, value, Dimension::TORQUE);
    let [against, on] = two_bodies(scope, names, "a torque acts")?;
    torque(Some(on), Some(against), value)
}

/// Links, or the ground and a link.
pub(super) fn two_bodies(
    scope: &mut Scope<'_>,
    names: &[Ident; 2],
    what: &str,
) -> Option<[Carrier; 2]> {
    let bodies = [0, 1].map(|k| match names[k] == "ground" {
        true => Some(Carrier::Ground),
        false => uses::link(scope, &names[k]).map(Carrier::Link),
    });
    let [first, second] = [bodies[0]?, bodies[1]?];
    if first == second {
        let message = format!("{what} between two bodies");
        scope.diagnostics.error_because(names[1].span(), message, INSIDE);
        return None;
    }
    Some([first, second])
}

/// Every load is used, and gravity has a mass to pull.
pub(super) fn actions_have_an_effect(scope: &mut Scope<'_>, tree: &Declaration) {
    let (mut acting, mut named) = (Vec::new(), Vec::new());
    let mut masses = tree.unread.may_hold("mass");
    for statement in &tree.statements {
        match &statement.kind {
            StatementKind::Action(action) => {
                masses |= matches!(action, Action::Mass { .. });
                let expressions = action.expressions();
                expressions.into_iter().for_each(|expr| add_names(expr, &mut acting));
            }
            StatementKind::Output { items } => {
                items.iter().for_each(|item| add_names(&item.value, &mut named));
            }
            _ => {}
        }
    }
    follow_lets(tree, &mut acting);
    follow_lets(tree, &mut named);
    let Dynamics { loads, pull, .. } = &scope.mechanism.dynamics;
    for load in loads.iter().chain(pull) {
        let name = load.name.to_string();
        // A load that drives has to act.
        let is_given = scope.facts.driving.as_deref() != Some(&name);
        let is_used = acting.contains(&name) || is_given && named.contains(&name);
        // Where it stands in error, that was said.
        let is_mentioned = || scope.diagnostics.count() > 0 && is_mentioned(tree, &name);
        if is_used || tree.unread.may_hold(&name) || is_mentioned() {
            continue;
        }
        let message = format!("nothing uses the load `{name}`; use it or remove it");
        let reason = match load.dimension {
            Dimension::TORQUE => format!("as in `torque {name} on BC`"),
            _ => format!("as in `force (0, -{name}) on P`"),
        };
        scope.diagnostics.error_because(load.name.span(), message, reason);
    }
    if let Some(at) = scope.facts.gravity_at.filter(|_| !masses) {
        let message = "gravity without a mass does nothing; declare one or remove it";
        scope.diagnostics.error_because(at, message, "as in `mass 2kg on BC uniform`");
    }
}

/// True if any expression of the declaration holds the name, be it that of a function.
fn is_mentioned(tree: &Declaration, name: &str) -> bool {
    let mut is_mentioned = false;
    for statement in &tree.statements {
        expressions(statement, &mut |expr| {
            expr.each_part(&mut |part| {
                let called = matches!(&part.kind, ExprKind::Call(function, _) if function == name);
                is_mentioned |= called;
            });
            names_in(expr, &mut |used| is_mentioned |= used == name);
        });
    }
    is_mentioned
}

fn torque(on: Option<Carrier>, against: Option<Carrier>, value: Option<Scalar>) -> Option<Torque> {
    Some(Torque { on: on?, against, value: value? })
}
