//! The stub of a declaration with mistakes: what was understood of it, and a place for every name that
//! was not. Code that uses the mechanism still finds the struct, its methods and its fields, so that one
//! mistake gives one message.
//!
//! A stub never runs. No step places anything, and the program behind it returns zeros.

mod result_fields;
#[cfg(test)]
mod tests;

use proc_macro2::{Ident, Span};
use quote::format_ident;

use crate::exact::Exact;
use crate::syntax::action::ACTING;
use crate::syntax::anatomy::{GroupSpec, Modes, Pin};
use crate::syntax::tree::{self, Action, Declaration, Statement, StatementKind};

use super::acting::{
    Dynamics, Effort, Ends, Load, Magnitude, Mass, MassPlace, RequestedEffort, Spring, Stop,
    Stopped,
};
use super::dimension::Measure;
use super::expressions::bare_name;
use super::facts::{GuideFacts, ParamFacts};
use super::mechanism::{
    AngleSum, Carrier, DeclaredOutput, Dimension, GroupId, GroupName, Guide, GuideId, Input,
    InputId, Mechanism, Numerics, OutputKind, Param, ParamId, ParamKind, PartOf, PointId,
    References, Scalar, Sign, SpringId, StopId,
};
use super::modes::mode_word;
use super::names::{Entity, Kind, declared_by};
use super::scope::Scope;
use super::{actions, dyads, dynamics_outputs, outputs, spring_damper};

const NUMBER: Dimension = Dimension::NUMBER;

/// The mechanism as far as it was understood. Nothing is reported twice.
pub(super) fn stub(mut scope: Scope<'_>, tree: &Declaration) -> Mechanism {
    let reported = scope.diagnostics.count();
    scope.names.are_unique();
    for statement in &tree.statements {
        every_name_has_a_place(&mut scope, statement);
    }
    if scope.mechanism.inputs.is_empty() {
        let name = Ident::new("input", Span::call_site());
        scope.mechanism.inputs.push(Input { name, docs: Vec::new(), dimension: NUMBER });
    }
    outputs_of_stub(&mut scope, tree);
    scope.diagnostics.forget_since(reported);
    let dynamics = Dynamics { forces: Vec::new(), torques: Vec::new(), ..scope.mechanism.dynamics };
    Mechanism {
        is_stub: true,
        unknowns: Vec::new(),
        steps: Vec::new(),
        rotatabilities: Vec::new(),
        known: Vec::new(),
        references: References::default(),
        numerics: Numerics::Plain,
        dynamics,
        ..scope.mechanism
    }
}

/// Makes what the names of a statement stand for, where the statement was not understood.
fn every_name_has_a_place(scope: &mut Scope<'_>, statement: &Statement) {
    let mut group = None;
    for (name, kind) in declared_by(statement) {
        if scope.names.made(name).is_some() || scope.names.kind(name) != Some(kind) {
            continue;
        }
        let entity = match kind {
            Kind::Point | Kind::Link => {
                let known = group.filter(|_| matches!(statement.kind, StatementKind::Group(_)));
                let group =
                    *group.insert(known.unwrap_or_else(|| group_of_stub(scope, statement, name)));
                body_of_stub(scope, statement, name, kind, group)
            }
            _ => number_of_stub(scope, statement, name),
        };
        if let Some(entity) = entity {
            scope.names.bind(name, entity);
        }
    }
}

/// The group that a statement would have made, or a point by itself.
fn group_of_stub(scope: &mut Scope<'_>, statement: &Statement, name: &Ident) -> GroupId {
    let id = dyads::next_group(scope);
    let keyword = |word| Ident::new(word, name.span());
    let (keyword, title) = match &statement.kind {
        StatementKind::Group(group) => (group.keyword.clone(), group.title()),
        StatementKind::Link { .. } => (keyword("link"), name.to_string()),
        StatementKind::Pin { .. } => (keyword("pin"), name.to_string()),
        _ => (keyword("point"), name.to_string()),
    };
    scope.mechanism.groups.push(GroupName { keyword, title });
    id
}

fn body_of_stub(
    scope: &mut Scope<'_>,
    statement: &Statement,
    name: &Ident,
    kind: Kind,
    made_by: GroupId,
) -> Option<Entity> {
    let part_of = match &statement.kind {
        StatementKind::Group(group) if kind == Kind::Link => {
            let place = group.legs.iter().position(|leg| leg.link == *name)?;
            // Where the group is not known, its links have every field.
            let anatomy = GroupSpec::of(&group.keyword.to_string());
            let slides = anatomy.is_none_or(|anatomy| anatomy.slides().get(place) == Some(&true));
            return Some(Entity::Link(dyads::new_link(
                scope,
                &statement.docs,
                name,
                made_by,
                slides,
            )));
        }
        StatementKind::Link { links, .. } => {
            let link = links.iter().find(|link| link.name == *name)?;
            let slides = !link.on.is_empty();
            return Some(Entity::Link(dyads::new_link(
                scope,
                &statement.docs,
                name,
                made_by,
                slides,
            )));
        }
        StatementKind::Ground { .. } => PartOf::Ground,
        _ => PartOf::Pin(made_by),
    };
    Some(Entity::Point(dyads::new_point(scope, &statement.docs, name, part_of)))
}

fn number_of_stub(scope: &mut Scope<'_>, statement: &Statement, name: &Ident) -> Option<Entity> {
    let (name, docs) = (name.clone(), statement.docs.clone());
    let Mechanism { inputs, params, guides, .. } = &mut scope.mechanism;
    Some(match &statement.kind {
        StatementKind::Input { .. } => {
            inputs.push(Input { name, docs, dimension: NUMBER });
            Entity::Input(InputId(inputs.len() as u32 - 1))
        }
        StatementKind::Load { .. } => {
            actions::new_load(scope, Load { name, docs, dimension: NUMBER })
        }
        StatementKind::Param { kind, default, .. } => {
            let is_mode = kind.as_ref().is_some_and(|kind| kind == "mode");
            let kind = match bare_name(default).and_then(mode_word) {
                Some(mode) => mode,
                None if is_mode => ParamKind::Mode { of: Modes::ALL[0], default: Sign::Plus },
                None => ParamKind::Number {
                    dimension: NUMBER,
                    default: Exact::integer(0),
                    written_in: None,
                },
            };
            params.push(Param { name, docs, kind });
            let (measure, span) = (Measure::NUMBER, default.span);
            scope.facts.params.push(ParamFacts { measure, span, blamed: true });
            Entity::Param(ParamId(params.len() as u32 - 1))
        }
        StatementKind::Guide { .. } => {
            guides.push(Guide { name });
            let carrier = Carrier::Ground;
            let facts = GuideFacts { moves: false, carrier, line: None, angle: None };
            scope.facts.guides.push(facts);
            Entity::Guide(GuideId(guides.len() as u32 - 1))
        }
        StatementKind::Action(Action::Spring { ends, .. }) => {
            let ends = match spring_damper::is_between_bodies(scope, ends)
                || scope.mechanism.points.is_empty()
            {
                true => Ends::Bodies([Carrier::Ground; 2]),
                false => Ends::Points([PointId(0); 2]),
            };
            let [stiffness, damping, free] = [(); 3].map(|()| Magnitude::zero());
            let name = Some(name);
            let springs = &mut scope.mechanism.dynamics.springs;
            springs.push(Spring { name, docs, ends, stiffness, damping, free });
            Entity::Spring(SpringId(springs.len() as u32 - 1))
        }
        StatementKind::Action(Action::Stop(_)) => {
            let of = Stopped::Angle(AngleSum { links: Vec::new(), rest: Scalar::zero() });
            let ends = [(); 2].map(|()| Scalar::zero());
            let [stiffness, damping] = [(); 2].map(|()| Magnitude::zero());
            let name = Some(name);
            let stops = &mut scope.mechanism.dynamics.stops;
            stops.push(Stop { name, docs, of, ends, stiffness, damping });
            Entity::Stop(StopId(stops.len() as u32 - 1))
        }
        _ => return None,
    })
}

/// Resolves the requested outputs. If one of them is not understood, it may be any of the names:
/// all names then become fields.
fn outputs_of_stub(scope: &mut Scope<'_>, tree: &Declaration) {
    scope.mechanism.outputs.clear();
    scope.mechanism.dynamics.asked.clear();
    scope.mechanism.dynamics.formulas.clear();
    scope.mechanism.dynamics.energy = false;
    let (mut is_asked, mut is_understood) = (false, true);
    for statement in &tree.statements {
        let StatementKind::Output { items } = &statement.kind else { continue };
        for item in items {
            is_asked = true;
            outputs::output(scope, &statement.docs, item);
            result_fields::named_output_of_stub(scope, tree, item);
            is_understood &= result_fields::is_given(scope, item);
        }
    }
    if !is_asked || !is_understood {
        every_force_of_stub(scope, tree);
    }
    if !is_asked || !is_understood || scope.mechanism.outputs.is_empty() {
        every_name_is_given(scope, tree, is_asked && !is_understood);
    }
    if scope.mechanism.outputs.is_empty() {
        // A record without a field could not have a type parameter.
        let name = Ident::new("nothing_", Span::call_site());
        scope.mechanism.outputs.push(DeclaredOutput {
            field: name,
            docs: Vec::new(),
            kind: number(),
        });
    }
}

/// Adds points, links and unknowns that were not asked for, in the order they were declared.
fn every_name_is_given(scope: &mut Scope<'_>, tree: &Declaration, with_ground: bool) {
    for (name, kind) in tree.statements.iter().flat_map(declared_by) {
        let points = &scope.mechanism.points;
        let is_in_ground = |id: PointId| points[id.index()].part_of == PartOf::Ground;
        let output = match scope.names.made(name) {
            Some(Entity::Point(id)) if is_in_ground(id) && !with_ground => None,
            Some(it @ (Entity::Point(_) | Entity::Link(_) | Entity::Unknown(_))) => {
                outputs::whole(scope, it)
            }
            None if kind == Kind::Unknown => {
                Some(DeclaredOutput { field: name.clone(), docs: Vec::new(), kind: number() })
            }
            _ => None,
        };
        let is_new = |output: &DeclaredOutput| !result_fields::has_field(scope, &output.field);
        let output = output.filter(is_new);
        scope.mechanism.outputs.extend(output);
    }
}

/// Every effort and reaction, where something may have mass or act.
fn every_force_of_stub(scope: &mut Scope<'_>, tree: &Declaration) {
    let acts = |statement: &Statement| {
        matches!(&statement.kind,
        StatementKind::Action(action) if !matches!(action, Action::Gravity { .. }))
    };
    let is_unread = ACTING.iter().any(|word| tree.unread.may_hold(word));
    if !is_unread && !tree.statements.iter().any(acts) {
        return;
    }
    if scope.mechanism.dynamics.masses.is_empty() {
        // Where it is says nothing: it is there for what is offered where something has mass.
        let place = MassPlace::Pin(PointId(0));
        let [mass, inertia] = [(); 2].map(|()| Magnitude::zero());
        scope.mechanism.dynamics.masses.push(Mass { place, mass, inertia });
    }
    dynamics_outputs::every_effort_is_given(scope);
    for statement in &tree.statements {
        match &statement.kind {
            StatementKind::Group(group) => forces_of_group(scope, group),
            StatementKind::Link { links, .. } => {
                links.iter().for_each(|link| forces_of_drawn(scope, link));
            }
            _ => {}
        }
    }
    let shaking = Ident::new("shaking", tree.name.span());
    ask_once(scope, &shaking, shaking.clone(), Effort::Shaking);
}

/// The efforts and reactions of links as they are written.
fn forces_of_group(scope: &mut Scope<'_>, group: &tree::GroupStatement) {
    let Some(anatomy) = GroupSpec::of(&group.keyword.to_string()) else { return };
    for (leg, slides) in group.legs.iter().zip(anatomy.slides()) {
        let Some(Entity::Link(link)) = scope.names.made(&leg.link) else { continue };
        let is_placed = scope.facts.links[link.index()].is_placed;
        let mut efforts = Vec::new();
        if !is_placed && !anatomy.is_dyad() {
            efforts.push((format_ident!("drive"), Effort::Drive(link)));
        }
        if !is_placed && anatomy.has_length() {
            efforts.push((format_ident!("push"), Effort::Push(link)));
        }
        let joints = leg.joint.iter().chain(&group.pin);
        efforts.extend(joints.filter_map(|joint| match scope.names.made(joint) {
            Some(Entity::Point(point)) => Some((joint.clone(), Effort::Pin(link, point))),
            Some(Entity::Guide(_)) => Some((joint.clone(), Effort::Guide(link))),
            // A name that nothing declares is that of a guide where the joint is prismatic.
            None if slides => Some((joint.clone(), Effort::Guide(link))),
            _ => None,
        }));
        let other = group.legs.iter().find(|other| other.link != leg.link);
        if let (Pin::None(_), Some(other)) = (anatomy.pin, other) {
            efforts.push((other.link.clone(), Effort::Guide(link)));
        }
        for (field, effort) in efforts {
            ask_once(scope, &leg.link, field, effort);
        }
    }
}

/// The reactions of a drawn link at its pins and guides.
fn forces_of_drawn(scope: &mut Scope<'_>, drawn: &tree::DrawnLink) {
    let Some(Entity::Link(link)) = scope.names.made(&drawn.name) else { return };
    for pin in &drawn.pins {
        if let Some(Entity::Point(point)) = scope.names.made(pin) {
            ask_once(scope, &drawn.name, pin.clone(), Effort::Pin(link, point));
        }
    }
    for guide in &drawn.on {
        ask_once(scope, &drawn.name, guide.clone(), Effort::Guide(link));
    }
}

/// Asks once for every field.
fn ask_once(scope: &mut Scope<'_>, owner: &Ident, field: Ident, effort: Effort) {
    let asked = &mut scope.mechanism.dynamics.asked;
    if asked.iter().any(|known| known.owner == *owner && known.field == field) {
        return;
    }
    let behind = asked.iter().rposition(|known| known.owner == *owner);
    let new = RequestedEffort { owner: owner.clone(), field, docs: Vec::new(), effort };
    asked.insert(behind.map_or(asked.len(), |last| last + 1), new);
}

fn number() -> OutputKind {
    OutputKind::Value { value: Scalar::zero(), dimension: NUMBER }
}
