//! The stub of a declaration with mistakes: what was understood of it, and a place for every name that
//! was not. Code that uses the mechanism still finds the struct, its methods and its fields, so that one
//! mistake gives one message.
//!
//! A stub never runs. No step places anything, and the program behind it returns zeros.

mod result_fields;

use proc_macro2::{Ident, Span};
use quote::format_ident;

use crate::syntax::anatomy::{GroupSpec, Pin};
use crate::syntax::openings::OPENINGS;
use crate::syntax::tree::{
    self, Declaration, LinkStatement, OutputStatement, Statement, StatementKind,
};

use crate::model::acting::{Dynamics, Effort, Magnitude, Mass, MassPlace, RequestedEffort};
use crate::model::mechanism::{
    DeclaredOutput, Dimension, Input, Mechanism, Numerics, OutputKind, PartOf, PointId, References,
    Scalar,
};
use crate::model::names::{Entity, Kind};
use crate::model::scope::Scope;
use crate::model::statements::{declared_by, output, rules};
use crate::model::{dynamics_outputs, given};

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
        touchings: Vec::new(),
        known: Vec::new(),
        references: References::default(),
        numerics: Numerics::Plain,
        dynamics,
        ..scope.mechanism
    }
}

/// Makes what the names of a statement stand for, where the statement was not understood.
fn every_name_has_a_place(scope: &mut Scope<'_>, statement: &Statement) {
    let rules = rules(statement);
    for (name, kind) in rules.declares() {
        if scope.names.made(name).is_some() || scope.names.kind(name) != Some(kind) {
            continue;
        }
        if let Some(entity) = rules.stand_in(scope, &statement.docs, name) {
            scope.names.bind(name, entity);
        }
    }
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
        let StatementKind::Output(OutputStatement { items, .. }) = &statement.kind else {
            continue;
        };
        for item in items {
            is_asked = true;
            output::output(scope, &statement.docs, item);
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
                given::whole(scope, it)
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
    let is_unread = OPENINGS.iter().any(|of| of.acts && tree.unread.may_hold(of.word));
    let acts = |statement: &Statement| matches!(&statement.kind, StatementKind::Action(action) if action.acts());
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
            StatementKind::Link(LinkStatement { links, .. }) => {
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
