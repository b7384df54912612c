//! Forces that are asked for: `theta.drive`, `AB.drive`, `BC.push`, `BC.B`, `block.rail`, and what is
//! the whole mechanism's: `energy`, `shaking`, `centre_of_mass`.

use proc_macro2::Ident;
use syn::Attribute;

use crate::model::acting::{Effort, RequestedEffort};
use crate::model::link_efforts::{self, Efforts, MEMBERS};
use crate::model::mechanism::{InputId, LinkId, OutputKind, SpringId};
use crate::model::named_efforts::{self, parts};
use crate::model::names::{Entity, Kind};
use crate::model::scope::Scope;
use crate::model::{given, uses};

/// Outputs of the whole mechanism.
const WHOLE: [&str; 4] = ["energy", "shaking", "centre_of_mass", "losses"];

/// The members that name the effort driving a link.
const EFFORTS: [&str; 2] = ["drive", "push"];

/// Words behind a link that mean something, whatever points are called.
fn is_meant(word: &str) -> bool {
    EFFORTS.contains(&word) || MEMBERS.contains(&word)
}

/// Returns true if the output is about a force; it is then resolved or reported.
pub(super) fn effort_output(
    scope: &mut Scope<'_>,
    docs: &[Attribute],
    owner: &Ident,
    member: &Ident,
) -> bool {
    if scope.names.kind(owner) == Some(Kind::Spring) {
        named_efforts::spring_output(scope, docs, owner, member);
        return true;
    }
    let Some(found) = effort_named(scope, owner, member) else { return false };
    if let Some(effort) = found {
        named_efforts::ask(scope, docs, owner, member, effort);
    }
    true
}

/// The effort that a member is, none inside where that was reported; `None` if it is about no force.
pub(super) fn effort_named(
    scope: &mut Scope<'_>,
    owner: &Ident,
    member: &Ident,
) -> Option<Option<Effort>> {
    let word = member.to_string();
    if WHOLE.iter().any(|whole| owner == whole) {
        let message = format!("write `{owner}`");
        let reason = format!("`{word}` is a field of its result");
        scope.diagnostics.error_because(member.span(), message, reason);
        return Some(None);
    }
    let is_of_a_drive = ["drive", "push", "force", "torque"].contains(&&word[..]);
    match scope.names.kind(owner) {
        Some(Kind::Input) if is_of_a_drive => Some(input_effort(scope, owner, member)),
        Some(Kind::Unknown) if is_of_a_drive => {
            Some(named_efforts::unknown_effort(scope, owner, member))
        }
        Some(Kind::Stop) => Some(named_efforts::effort_of_stop(scope, owner, member)),
        Some(Kind::Link) if scope.names.kind(member) == Some(Kind::Point) && is_meant(&word) => {
            match uses::link(scope, owner) {
                Some(link) if touches(scope, link, member) => {
                    point_is_renamed(scope, owner, member);
                    Some(None)
                }
                Some(link) if EFFORTS.contains(&&word[..]) => {
                    Some(driven_effort(scope, owner, link, member))
                }
                Some(_) => None,
                None => Some(None),
            }
        }
        Some(Kind::Link) if EFFORTS.contains(&&word[..]) => {
            let link = uses::link(scope, owner);
            Some(link.and_then(|link| driven_effort(scope, owner, link, member)))
        }
        Some(Kind::Link) => {
            let is_named =
                matches!(scope.names.kind(member), Some(Kind::Point | Kind::Guide | Kind::Link));
            if !is_named || is_meant(&word) {
                return None;
            }
            let link = uses::link(scope, owner);
            Some(link.and_then(|link| joint_effort(scope, owner, link, member)))
        }
        _ => None,
    }
}

/// Returns true if the output is one of the whole mechanism; it is then resolved or reported.
pub(super) fn output_of_the_whole(scope: &mut Scope<'_>, docs: &[Attribute], name: &Ident) -> bool {
    let dynamics = &scope.mechanism.dynamics;
    let has_mass = !dynamics.masses.is_empty();
    let has_spring = dynamics.is_elastic();
    match name.to_string().as_str() {
        "energy" if has_mass || has_spring || named_efforts::a_force_may_be_unread(scope) => {
            if std::mem::replace(&mut scope.mechanism.dynamics.energy, true) {
                scope
                    .diagnostics
                    .error(name.span(), "the output `energy` is given twice; remove one");
            }
        }
        "shaking" if has_mass || named_efforts::a_force_may_be_unread(scope) => {
            named_efforts::ask(scope, docs, name, name, Effort::Shaking);
        }
        "centre_of_mass" if has_mass || named_efforts::a_force_may_be_unread(scope) => {
            given::give(scope, name.span(), name.clone(), docs, OutputKind::CentreOfMass);
        }
        "losses" => {
            if named_efforts::something_rubs(scope, name).is_some() {
                named_efforts::ask(scope, docs, name, name, Effort::Losses);
            }
        }
        word @ ("energy" | "shaking" | "centre_of_mass") => {
            let message = match word {
                "energy" => "nothing has mass and nothing is sprung, so there is no energy",
                _ => "nothing has mass; declare what has",
            };
            let reason = "as in `mass 2kg on BC uniform`";
            scope.diagnostics.error_because(name.span(), message, reason);
        }
        _ => return false,
    }
    true
}

fn input_effort(scope: &mut Scope<'_>, owner: &Ident, member: &Ident) -> Option<Effort> {
    if member != "drive" {
        let message = format!("write `{owner}.drive`");
        let reason = "an input's effort is a torque or a force, as the input is";
        scope.diagnostics.error_because(member.span(), message, reason);
        return None;
    }
    match uses::usable(scope, owner, &[Kind::Input])? {
        Entity::Input(id) => {
            named_efforts::has_a_drive(scope, owner, id).map(|()| Effort::Input(id))
        }
        _ => None,
    }
}

/// `AB.drive`, `BC.push`
fn driven_effort(
    scope: &mut Scope<'_>,
    owner: &Ident,
    link: LinkId,
    member: &Ident,
) -> Option<Effort> {
    let efforts = link_efforts::efforts_of(scope, link);
    let found = efforts.iter().find(|(field, effort)| {
        field == member && matches!(effort, Effort::Drive(_) | Effort::Push(_))
    });
    if let Some(&(_, effort)) = found {
        if let Effort::Drive(by) = effort {
            named_efforts::link_has_a_drive(scope, owner, by)?;
        }
        return Some(effort);
    }
    if !scope.facts.links[link.index()].is_placed {
        return None;
    }
    let group = &scope.mechanism.groups[scope.mechanism.links[link.index()].made_by.index()];
    let (message, reason) = match (member == "drive", &group.keyword.to_string()[..]) {
        (true, "crank" | "slider") | (false, _) => (
            format!("no length of `{owner}` is driven, and nothing pushes its ends apart"),
            "`push` is the force of a bar whose length depends on an input".to_string(),
        ),
        (true, keyword) => (
            format!("`{owner}` is a link of `{keyword}` and has no drive"),
            format!("cranks and sliders are driven; {}", known_efforts(&efforts, owner)),
        ),
    };
    scope.diagnostics.error_because(member.span(), message, reason);
    None
}

/// `BC.B`, `block.rail`
pub(super) fn joint_effort(
    scope: &mut Scope<'_>,
    owner: &Ident,
    link: LinkId,
    member: &Ident,
) -> Option<Effort> {
    let efforts = link_efforts::efforts_of(scope, link);
    if let Some(&(_, effort)) = efforts.iter().find(|(field, _)| field == member) {
        return Some(effort);
    }
    let mut slides = scope.mechanism.slides_of(link);
    if let Some(slide) = slides.find(|slide| slide.carrier.as_ref() == Some(member)) {
        return Some(Effort::Guide(slide.by));
    }
    if !scope.facts.links[link.index()].is_placed {
        return None;
    }
    let message = format!("`{owner}` does not touch `{member}`");
    let reason = known_efforts(&efforts, owner);
    scope.diagnostics.error_because(member.span(), message, reason);
    None
}

/// The first link that has the point as a joint.
pub(super) fn link_that_touches<'s>(scope: &'s Scope<'_>, point: &Ident) -> Option<&'s Ident> {
    let links = scope.mechanism.links.iter().enumerate();
    let mut touching = links.filter(|&(id, _)| touches(scope, LinkId(id as u32), point));
    touching.next().map(|(_, link)| &link.name)
}

/// True if the point is a joint of the link.
fn touches(scope: &Scope<'_>, link: LinkId, point: &Ident) -> bool {
    let is_joint = |effort: &Effort| matches!(effort, Effort::Pin(..) | Effort::Bearing(..));
    link_efforts::efforts_of(scope, link)
        .iter()
        .any(|(field, effort)| field == point && is_joint(effort))
}

/// `AB.drive`, where a joint of `AB` is called `drive`, would be two things.
fn point_is_renamed(scope: &mut Scope<'_>, owner: &Ident, point: &Ident) {
    let message = format!("rename the point `{point}`");
    let reason = format!(
        "`{owner}.{point}` is something else of every link: the force at that joint needs another \
         name"
    );
    scope.diagnostics.error_because(point.span(), message, reason);
}

fn known_efforts(efforts: &Efforts, owner: &Ident) -> String {
    let known: Vec<_> = efforts.iter().map(|(field, _)| format!("`{owner}.{field}`")).collect();
    match known.is_empty() {
        true => format!("no force of `{owner}` is known"),
        false => format!("there is {}", super::names::listed(&known, "and")),
    }
}

/// The end of a list of a link's members: its forces, where something has mass or acts.
pub(super) fn forces_too(scope: &Scope<'_>, owner: &Ident) -> String {
    forces_of(scope, owner).map_or(String::new(), |known| format!("; of its forces {known}"))
}

/// The forces of a link in words, where something has mass or acts.
pub(super) fn forces_of(scope: &Scope<'_>, owner: &Ident) -> Option<String> {
    let Entity::Link(link) = scope.names.entity(owner)? else { return None };
    let efforts = link_efforts::efforts_of(scope, link);
    let has_any = !scope.mechanism.dynamics.is_empty() && !efforts.is_empty();
    has_any.then(|| known_efforts(&efforts, owner))
}

/// Every drive and reaction, where anything has mass or acts.
pub(super) fn every_effort_is_given(scope: &mut Scope<'_>) {
    let dynamics = &mut scope.mechanism.dynamics;
    dynamics.energy = !dynamics.masses.is_empty() || dynamics.is_elastic();
    if dynamics.is_empty() {
        return;
    }
    let drive = |name: &Ident| Ident::new("drive", name.span());
    let inputs = scope.mechanism.inputs.iter().enumerate();
    let inputs: Vec<_> = inputs
        .map(|(index, input)| {
            let id = InputId(index as u32);
            if let Some((_, load)) = dynamics.driven().filter(|(driven, _)| *driven == id) {
                let [owner, field] = [(); 2].map(|()| load.name.clone());
                let docs = load.docs.clone();
                return RequestedEffort { owner, field, docs, effort: Effort::Pull };
            }
            let (owner, field) = (input.name.clone(), drive(&input.name));
            RequestedEffort { owner, field, docs: Vec::new(), effort: Effort::Input(id) }
        })
        .collect();
    let links = (0..scope.mechanism.links.len()).map(|index| LinkId(index as u32));
    let links = links.flat_map(|link| {
        let declared = &scope.mechanism.links[link.index()];
        link_efforts::exerted(scope, link).map(|(field, effort)| RequestedEffort {
            owner: declared.name.clone(),
            field,
            docs: declared.docs.clone(),
            effort,
        })
    });
    let links: Vec<_> = links.collect();
    let springs = scope.mechanism.dynamics.springs.iter().enumerate();
    let springs = springs.filter_map(|(index, spring)| {
        let owner = spring.name.clone()?;
        let field = Ident::new(parts(spring.ends)[0], owner.span());
        let effort = Effort::Spring(SpringId(index as u32));
        Some(RequestedEffort { owner, field, docs: spring.docs.clone(), effort })
    });
    let springs: Vec<_> = springs.chain(named_efforts::efforts_of_stops(scope)).collect();
    let losses = losses_of_all(scope);
    let mut asked: Vec<RequestedEffort> =
        inputs.into_iter().chain(links).chain(springs).chain(losses).collect();
    if !scope.mechanism.equations_are_held() {
        asked = scope.mechanism.dynamics.what_is_of_power(asked);
    }
    for (nth, known) in asked.iter().enumerate() {
        let is_same =
            |other: &&RequestedEffort| other.owner == known.owner && other.field == known.field;
        // The effort of a drive comes first, and has the span of its link.
        if asked[..nth].iter().any(|other| is_same(&other)) {
            point_is_renamed(scope, &known.owner, &known.field);
        }
    }
    scope.mechanism.dynamics.asked = asked;
}

/// The output `losses`, where anything rubs.
fn losses_of_all(scope: &Scope<'_>) -> Option<RequestedEffort> {
    let owner = Ident::new("losses", scope.mechanism.name.span());
    let (field, effort) = (owner.clone(), Effort::Losses);
    let rubs = !scope.mechanism.dynamics.frictions.is_empty();
    rubs.then(|| RequestedEffort { owner, field, docs: Vec::new(), effort })
}
