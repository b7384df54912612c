//! Efforts by the names of springs, stops, unknowns and inputs.

use proc_macro2::Ident;
use quote::format_ident;
use syn::Attribute;

use crate::syntax::openings::OPENINGS;

use crate::model::acting::{Ends, RequestedEffort};
use crate::model::dimension::Dimension;
use crate::model::driven_through::driven_through;
use crate::model::effort::Effort;
use crate::model::mechanism::{self, InputId, LinkId, OutputKind, SpringId, StopId};
use crate::model::names::{Entity, Kind};
use crate::model::scope::Scope;
use crate::model::{given, uses};

/// The members of a stop.
const PARTS: [&str; 2] = ["force", "gap"];

/// `shock.force`, `shock.length`; `clutch.torque`, `clutch.angle`.
pub(in crate::model) fn spring_output(
    scope: &mut Scope<'_>,
    docs: &[Attribute],
    owner: &Ident,
    member: &Ident,
) {
    let Some((id, part)) = part_of_spring(scope, owner, member) else { return };
    if part == 0 {
        return ask(scope, docs, owner, member, Effort::Spring(id));
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

/// `bumper.force`, `bumper.gap`
pub(in crate::model) fn effort_of_stop(
    scope: &mut Scope<'_>,
    owner: &Ident,
    member: &Ident,
) -> Option<Effort> {
    let Entity::Stop(id) = uses::usable(scope, owner, &[Kind::Stop])? else { return None };
    match PARTS.iter().position(|part| member == part) {
        Some(0) => Some(Effort::Stop(id)),
        Some(_) => Some(Effort::Gap(id)),
        None => {
            let message = format!("the stop `{owner}` has no `{member}`");
            let reason = format!("it has `{}` and `{}`", PARTS[0], PARTS[1]);
            scope.diagnostics.error_because(member.span(), message, reason);
            None
        }
    }
}

/// Both members of every named stop.
pub(in crate::model) fn efforts_of_stops(
    scope: &Scope<'_>,
) -> impl Iterator<Item = RequestedEffort> {
    let stops = scope.mechanism.dynamics.stops.iter().enumerate();
    stops.flat_map(|(index, stop)| {
        let id = StopId(index as u32);
        let efforts = PARTS.into_iter().zip([Effort::Stop(id), Effort::Gap(id)]);
        let of = |(part, effort)| {
            let owner = stop.name.clone()?;
            let field = Ident::new(part, owner.span());
            Some(RequestedEffort { owner, field, docs: stop.docs.clone(), effort })
        };
        efforts.filter_map(of).collect::<Vec<_>>()
    })
}

/// Beside an equation that a drive may hold, efforts are known that follow from power alone.
pub(in crate::model) fn effort_is_known(
    scope: &mut Scope<'_>,
    at: &Ident,
    effort: Effort,
) -> Option<()> {
    if scope.mechanism.dynamics.is_of_power(effort) || scope.mechanism.equations_are_held() {
        return Some(());
    }
    let name = &scope.mechanism.unknowns.first()?.name;
    let input = scope.mechanism.inputs.first().map(|input| &input.name);
    let instead = input.map_or(String::new(), |input| format!("; ask for `{input}.drive`"));
    let message = format!("no reactions beside `unknown {name}`{instead}");
    let reason = "what holds the equation of `solve` exerts a force as well: of `distance(P, Q) = l` a bar does, \
                  of `offset(P, guide) = h` a block, of any other equation nobody says what";
    scope.diagnostics.error_because(at.span(), message, reason);
    None
}

/// `theta.drive`, in place of the only input's.
pub(in crate::model) fn unknown_effort(
    scope: &mut Scope<'_>,
    owner: &Ident,
    member: &Ident,
) -> Option<Effort> {
    let Entity::Unknown(id) = uses::usable(scope, owner, &[Kind::Unknown])? else { return None };
    if member != "drive" {
        let message = format!("write `{owner}.drive`");
        let reason = "its effort is a torque or a force, as the unknown is an angle or a length";
        scope.diagnostics.error_because(member.span(), message, reason);
        return None;
    }
    if let [first, _, ..] = &scope.mechanism.inputs[..] {
        let message = format!("`{owner}.drive` stands for one input's, and there are several");
        let reason = format!("ask for `{}.drive` and its like", first.name);
        scope.diagnostics.error_because(owner.span(), message, reason);
        return None;
    }
    has_a_drive(scope, owner, InputId(0))?;
    Some(Effort::Unknown(id))
}

/// The effort of an input is put in by no load.
pub(in crate::model) fn has_a_drive(
    scope: &mut Scope<'_>,
    owner: &Ident,
    id: InputId,
) -> Option<()> {
    let Some((driven, load)) = scope.mechanism.dynamics.driven() else { return Some(()) };
    if driven != id {
        return Some(());
    }
    let message = format!("`{owner}` is driven by `{0}`; ask for `{0}`", load.name);
    let reason = "a drive of its own would put in nothing";
    scope.diagnostics.error_because(owner.span(), message, reason);
    None
}

/// The drive of a link is put in by no load.
pub(in crate::model) fn link_has_a_drive(
    scope: &mut Scope<'_>,
    owner: &Ident,
    link: LinkId,
) -> Option<()> {
    let Some((input, load)) = driven_through(&scope.mechanism, link) else { return Some(()) };
    let input = &scope.mechanism.inputs[input.index()].name;
    let message =
        format!("`{load}` drives `{owner}` by `{input}`; ask for `{load}`", load = load.name);
    let reason = "a drive of its own would put in nothing";
    scope.diagnostics.error_because(owner.span(), message, reason);
    None
}

/// True if a mistake may have hidden a statement that acts.
pub(in crate::model) fn a_force_may_be_unread(scope: &Scope<'_>) -> bool {
    OPENINGS.iter().any(|of| of.acts && scope.unread.may_hold(of.word))
        || scope.diagnostics.count() > 0
}

pub(in crate::model) fn ask(
    scope: &mut Scope<'_>,
    docs: &[Attribute],
    owner: &Ident,
    member: &Ident,
    effort: Effort,
) {
    if scope.mechanism.dynamics.is_empty() && !a_force_may_be_unread(scope) {
        let message = format!("nothing has mass and nothing acts, so `{owner}.{member}` is zero");
        let reason = "declare what does: `mass 2kg on BC uniform`, `force (0, -10N) on P`";
        return scope.diagnostics.error_because(member.span(), message, reason);
    }
    if effort_is_known(scope, member, effort).is_none() {
        return;
    }
    let (own, field) = (owner.clone(), member.clone());
    let asked_for = RequestedEffort { owner: own, field, docs: docs.to_vec(), effort };
    let asked = &mut scope.mechanism.dynamics.asked;
    if asked.iter().any(|known| known.effort == effort) {
        return given::output_is_given_twice(scope, member.span(), &asked_for.path());
    }
    // Efforts of one owner form one field of the result.
    let behind = asked.iter().rposition(|known| known.owner == *owner);
    asked.insert(behind.map_or(asked.len(), |last| last + 1), asked_for);
}

pub(in crate::model) fn something_rubs(scope: &mut Scope<'_>, name: &Ident) -> Option<()> {
    if !scope.mechanism.dynamics.frictions.is_empty() || a_force_may_be_unread(scope) {
        return Some(());
    }
    let message = "nothing rubs, so there are no losses";
    let reason = "as in `friction 0.1 at C radius 8mm`";
    scope.diagnostics.error_because(name.span(), message, reason);
    None
}
