//! Loads, gravity, forces and torques, and the check that they have an effect.

use proc_macro2::{Ident, Span};
use syn::Attribute;

use crate::diagnostics::nearest;
use crate::syntax::tree::{self, Action, Declaration, ExprKind, StatementKind};

use super::Resolver;
use super::acting::{Axes, Dynamics, Force, Load, Torque};
use super::expressions::Allowed;
use super::inputs::{add_names, follow_lets};
use super::mechanism::{Body, Carrier, Dimension, LoadId, PointId, Scalar};
use super::names::{Entity, Kind};
use super::references::{expressions, names_in};
use super::spring_damper::is_rate;
use super::units::unit;

const INSIDE: &str = "what acts inside a body moves nothing";
const LOAD_KINDS: [&str; 3] = ["force", "torque", "number"];

impl Resolver<'_> {
    pub(super) fn load(&mut self, docs: &[Attribute], names: &[Ident], kind: Option<&Ident>) {
        let dimension = kind.and_then(|kind| self.load_kind(kind));
        for name in names {
            let is_new = self.name_is_new(name).is_some();
            let (true, Some(dimension)) = (is_new, dimension) else { continue };
            let load = Load { name: name.clone(), docs: docs.to_vec(), dimension };
            let entity = self.new_load(load);
            self.names.bind(name, entity);
        }
    }

    /// A load that each call is given, or the one that drives an input.
    pub(super) fn new_load(&mut self, load: Load) -> Entity {
        let dynamics = &mut self.mechanism.dynamics;
        if self.driving.as_deref() == Some(&load.name.to_string()) && dynamics.pull.is_none() {
            dynamics.pull = Some(load);
            return Entity::Pull;
        }
        dynamics.loads.push(load);
        Entity::Load(LoadId(dynamics.loads.len() as u32 - 1))
    }

    fn load_kind(&mut self, kind: &Ident) -> Option<Dimension> {
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
            self.diagnostics.error_because(kind.span(), message, reason);
            return None;
        }
        let mut message = format!("no load kind named `{text}`");
        if let Some(near) = nearest(&text, LOAD_KINDS.into_iter()) {
            message += &format!("; one with a similar name exists: `{near}`");
        }
        let reason = "it is `force`, `torque` or `number`";
        self.diagnostics.error_because(kind.span(), message, reason);
        None
    }

    pub(super) fn action(&mut self, docs: &[Attribute], action: &Action) {
        match action {
            Action::Gravity { at, value } => self.gravity(*at, value),
            Action::Mass { value, on, place, inertia } => {
                let mass = self.mass(value, on, place, inertia.as_ref());
                self.mechanism.dynamics.masses.extend(mass);
            }
            Action::Inertia { value, on } => {
                let mass = self.inertia(value, on);
                self.mechanism.dynamics.masses.extend(mass);
            }
            Action::Force { value, axes, on } => {
                let force = self.force(value, axes.as_ref(), on);
                self.mechanism.dynamics.forces.extend(force);
            }
            Action::ForceBetween { value, points } => {
                let force = self.force_between(value, points);
                self.mechanism.dynamics.forces.extend(force);
            }
            Action::Torque { value, on } => {
                let on = self.link(on).map(Carrier::Link);
                let value = self.acting(value, Dimension::TORQUE);
                self.mechanism.dynamics.torques.extend(torque(on, None, value));
            }
            Action::TorqueBetween { value, bodies } => {
                let torque = self.torque_between(value, bodies);
                self.mechanism.dynamics.torques.extend(torque);
            }
            Action::Spring { name, ends, fields } => self.spring(docs, name, ends, fields),
            Action::Stop(written) => self.stop(docs, written),
            // Which links meet at a pin is known when all are.
            Action::Friction(_) => {}
        }
    }

    /// Gravity is given once, and no input changes it.
    fn gravity(&mut self, at: Span, value: &[tree::Expr; 2]) {
        let acceleration = Dimension::LENGTH.times(Dimension::TIME, -2);
        let value = [0, 1].map(|k| {
            self.changes_with_no_input(&value[k], "gravity")?;
            self.scalar(&value[k], acceleration)
        });
        if self.gravity_at.replace(at).is_some() {
            let message = "gravity is given twice; remove one";
            self.diagnostics.error(at, message);
        }
        if let [Some(x), Some(y)] = value {
            self.mechanism.dynamics.gravity = Some([x, y]);
        }
    }

    /// A number of the machine itself: constants and parameters.
    pub(super) fn changes_with_no_input(&mut self, expr: &tree::Expr, what: &str) -> Option<()> {
        // Rates have a message of their own.
        let of_a_rate = self
            .first(expr, &|resolver, part| is_rate(part) || resolver.is_law(part, |_| true))
            .is_some();
        let Some(span) = self.moving_part(expr).filter(|_| !of_a_rate) else { return Some(()) };
        let message = format!("{what} cannot depend on an input");
        let reason = "it is made of constants and parameters";
        self.diagnostics.error_because(span, message, reason);
        None
    }

    pub(super) fn ground_moves_nothing<T>(&mut self, point: &Ident, what: &str) -> Option<T> {
        let message =
            format!("`{point}` is a point of the ground, and a {what} there does nothing");
        let reason = "name a point of a link, a pin or a driven point";
        self.diagnostics.error_because(point.span(), message, reason);
        None
    }

    /// The value of a force or a torque: loads may stand in it.
    pub(super) fn acting(&mut self, expr: &tree::Expr, dimension: Dimension) -> Option<Scalar> {
        let value = self.scalar_where(expr, dimension, Allowed::IN_FORCES)?;
        self.is_linear_in_pull(expr, &value)?;
        Some(value)
    }

    /// A load stands in the value of a force or a torque, and nowhere else.
    pub(super) fn load_stands_in_a_force(&mut self, name: &Ident, allowed: Allowed) -> Option<()> {
        if allowed.forces {
            return Some(());
        }
        let message =
            format!("`{name}` is a load, and stands in forces, torques and outputs alone");
        let reason = "what the mechanism is made of and how it moves depends on no load";
        self.diagnostics.error_because(name.span(), message, reason);
        None
    }

    fn force(
        &mut self,
        value: &[tree::Expr; 2],
        axes: Option<&Ident>,
        on: &Ident,
    ) -> Option<Force> {
        let value = [0, 1].map(|k| self.acting(&value[k], Dimension::FORCE));
        let axes = match axes {
            None => Some(Axes::Body(Carrier::Ground)),
            Some(name) => match self.usable(name, &[Kind::Link, Kind::Guide]) {
                Some(Entity::Link(link)) => Some(Axes::Body(Carrier::Link(link))),
                Some(Entity::Guide(guide)) => Some(Axes::Guide(guide)),
                _ => None,
            },
        };
        let point = self.moved_point(on);
        let [x, y] = value;
        Some(Force::At { point: point?, value: [x?, y?], axes: axes? })
    }

    /// A point that a force moves, or tries to.
    fn moved_point(&mut self, name: &Ident) -> Option<PointId> {
        let point = self.point(name)?;
        match self.mechanism.owner(point)? {
            Body::Ground => self.ground_moves_nothing(name, "force"),
            _ => Some(point),
        }
    }

    fn force_between(&mut self, value: &tree::Expr, names: &[Ident; 2]) -> Option<Force> {
        let value = self.acting(value, Dimension::FORCE);
        let points = self.two_points(names, "a force acts")?;
        Some(Force::Between { points, value: value? })
    }

    /// Points that can move against each other: of two bodies, or of one where an input drives a coordinate.
    pub(super) fn two_points(&mut self, names: &[Ident; 2], what: &str) -> Option<[PointId; 2]> {
        let points = [0, 1].map(|k| self.point(&names[k]));
        let [p, q] = [points[0]?, points[1]?];
        if p == q {
            let message = format!("{what} between two points");
            self.diagnostics.error_because(names[1].span(), message, INSIDE);
            return None;
        }
        let owners = [p, q].map(|point| self.mechanism.owner(point));
        if owners[0]? == owners[1]? && !self.is_driven_in(owners[0]?, [p, q]) {
            let message = format!("`{}` and `{}` are fixed to one body", names[0], names[1]);
            let reason = "what acts between them moves nothing; it does where an input drives a \
                          coordinate of one, as in `at (0.2m + s, 0)`";
            self.diagnostics.error_because(names[1].span(), message, reason);
            return None;
        }
        Some([p, q])
    }

    /// True if one of the points moves in the body that both belong to.
    fn is_driven_in(&self, owner: Body, points: [PointId; 2]) -> bool {
        let Body::Link(link) = owner else { return false };
        let moves = |point| self.mechanism.coordinates_move(Carrier::Link(link), point);
        points.into_iter().any(|point| moves(point) != [false; 2])
    }

    fn torque_between(&mut self, value: &tree::Expr, names: &[Ident; 2]) -> Option<Torque> {
        let value = self.acting(value, Dimension::TORQUE);
        let [against, on] = self.two_bodies(names, "a torque acts")?;
        torque(Some(on), Some(against), value)
    }

    /// Links, or the ground and a link.
    pub(super) fn two_bodies(&mut self, names: &[Ident; 2], what: &str) -> Option<[Carrier; 2]> {
        let bodies = [0, 1].map(|k| match names[k] == "ground" {
            true => Some(Carrier::Ground),
            false => self.link(&names[k]).map(Carrier::Link),
        });
        let [first, second] = [bodies[0]?, bodies[1]?];
        if first == second {
            let message = format!("{what} between two bodies");
            self.diagnostics.error_because(names[1].span(), message, INSIDE);
            return None;
        }
        Some([first, second])
    }

    /// Every load is used, and gravity has a mass to pull.
    pub(super) fn actions_have_an_effect(&mut self, tree: &Declaration) {
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
        let Dynamics { loads, pull, .. } = &self.mechanism.dynamics;
        for load in loads.iter().chain(pull) {
            let name = load.name.to_string();
            // A load that drives has to act.
            let is_given = self.driving.as_deref() != Some(&name);
            let is_used = acting.contains(&name) || is_given && named.contains(&name);
            // Where it stands in error, that was said.
            let is_mentioned = || self.diagnostics.count() > 0 && is_mentioned(tree, &name);
            if is_used || tree.unread.may_hold(&name) || is_mentioned() {
                continue;
            }
            let message = format!("nothing uses the load `{name}`; use it or remove it");
            let reason = match load.dimension {
                Dimension::TORQUE => format!("as in `torque {name} on BC`"),
                _ => format!("as in `force (0, -{name}) on P`"),
            };
            self.diagnostics.error_because(load.name.span(), message, reason);
        }
        if let Some(at) = self.gravity_at.filter(|_| !masses) {
            let message = "gravity without a mass does nothing; declare one or remove it";
            self.diagnostics.error_because(at, message, "as in `mass 2kg on BC uniform`");
        }
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
