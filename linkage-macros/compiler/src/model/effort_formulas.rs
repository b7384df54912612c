//! Outputs that read efforts, reactions, rates and loads: they stand in the results of `forces`.

use proc_macro2::Ident;
use quote::format_ident;
use syn::Attribute;

use crate::syntax::tree;

use crate::model::acting::{Contact, Effort, Formula, RequestedEffort};
use crate::model::dimension::Measure;
use crate::model::effort_dimensions::of_effort;
use crate::model::ids::FormulaId;
use crate::model::mechanism::{Carrier, Dimension, LinkId, Mechanism, Scalar};
use crate::model::names::{Kind, listed};
use crate::model::ratios::depends_on_rates;
use crate::model::reads::Reads;
use crate::model::resolved_expr::ResolvedExpr;
use crate::model::scope::Scope;
use crate::model::{dynamics_outputs, fits, given, link_efforts, named_efforts, uses};

/// A number of efforts, rates and loads as an output.
pub(super) fn give_formula(
    scope: &mut Scope<'_>,
    (name, docs): (&Ident, &[Attribute]),
    value: &tree::Expr,
    quantity: ResolvedExpr,
) {
    if fits::no_link_angle(scope, value, &quantity).is_none() {
        return;
    }
    let dynamics = &scope.mechanism.dynamics;
    if dynamics.is_empty() && !named_efforts::a_force_may_be_unread(scope) {
        let message =
            format!("nothing has mass and nothing acts, so there are no forces beside `{name}`");
        let reason = depends_on_rates(&scope.mechanism, value, &quantity).unwrap_or(
            "an output of rates and loads stands in the result of `forces`; of rates alone, `velocity` gives those \
             of every output",
        );
        return scope.diagnostics.error_because(name.span(), message, reason);
    }
    let is_known = scope.mechanism.outputs.iter().any(|output| output.field == *name)
        || dynamics.asked.iter().any(|asked| asked.is_formula(name));
    if is_known {
        return given::output_is_given_twice(scope, name.span(), &name.to_string());
    }
    let dynamics = &mut scope.mechanism.dynamics;
    let effort = Effort::Formula(FormulaId(dynamics.formulas.len() as u32));
    let dimension = quantity.measure.dimension();
    let reads = quantity.reads.efforts.clone();
    dynamics.formulas.push(Formula { value: quantity.rest, dimension, reads });
    let (owner, field) = (name.clone(), name.clone());
    dynamics.asked.push(RequestedEffort { owner, field, docs: docs.to_vec(), effort });
}

/// `theta.drive`, `shock.force`, `low.gap` in an output; `None` if it is about no force.
pub(super) fn effort_read(
    scope: &mut Scope<'_>,
    owner: &Ident,
    member: &Ident,
) -> Option<Option<ResolvedExpr>> {
    if let Some(Kind::Spring) = scope.names.kind(owner) {
        let effort = named_efforts::effort_of_spring(scope, owner, member);
        return Some(effort.and_then(|effort| reading(scope, member, effort, 0)));
    }
    let whole = (owner == "shaking").then(|| ["x", "y", "couple"].iter().position(|p| member == p));
    if let Some(Some(part)) = whole {
        return Some(reading(scope, member, Effort::Shaking, part));
    }
    let effort = dynamics_outputs::effort_named(scope, owner, member)?;
    Some(effort.and_then(|effort| whole_effort(scope, owner, member, effort)))
}

/// `losses` in an output.
pub(super) fn losses_read(scope: &mut Scope<'_>, name: &Ident) -> Option<ResolvedExpr> {
    named_efforts::something_rubs(scope, name)?;
    reading(scope, name, Effort::Losses, 0)
}

/// An effort of one number; of a reaction a part is read.
fn whole_effort(
    scope: &mut Scope<'_>,
    owner: &Ident,
    member: &Ident,
    effort: Effort,
) -> Option<ResolvedExpr> {
    let (what, parts) = match effort {
        Effort::Pin(..) | Effort::Bearing(..) => ("a force", ["x", "y"]),
        Effort::Guide(_) => ("a normal force and a couple", ["normal", "couple"]),
        effort => return reading(scope, member, effort, 0),
    };
    let path = format!("{owner}.{member}");
    let message =
        format!("`{path}` is {what}; write `{path}.{}` or `{path}.{}`", parts[0], parts[1]);
    let reason = match effort {
        Effort::Guide(_) => "an expression is made of single numbers".to_string(),
        _ => format!(
            "an expression is made of single numbers; its size is `hypot({path}.x, {path}.y)`"
        ),
    };
    scope.diagnostics.error_because(member.span(), message, reason);
    None
}

/// Reports `ram.friction`: friction is that of a joint.
pub(super) fn friction_is_at_a_joint(scope: &mut Scope<'_>, owner: &Ident, member: &Ident) {
    let Some(link) = uses::link(scope, owner) else { return };
    let frictions = &scope.mechanism.dynamics.frictions;
    let joints = link_efforts::efforts_of(scope, link).into_iter().filter(|(_, effort)| {
        frictions.iter().any(|friction| match *effort {
            Effort::Guide(link) => friction.contact == Contact::Guide(link),
            Effort::Pin(_, pin) | Effort::Bearing(_, pin) => {
                rubs_at(friction.contact, link, Effort::PinFriction(link, pin))
            }
            _ => false,
        })
    });
    let known: Vec<_> = joints.map(|(joint, _)| format!("`{owner}.{joint}.friction`")).collect();
    let (message, reason) = match &known[..] {
        [] if named_efforts::a_force_may_be_unread(scope) => return,
        [] => (
            format!("nothing rubs at a joint of `{owner}`"),
            format!(
                "as in `friction 0.1 on {owner}` of what slides, `friction 0.1 on {owner} at C radius 8mm` of a pin"
            ),
        ),
        [only] => (format!("write {only}"), "friction is that of a joint".to_string()),
        _ => (
            format!("name the joint: {}", listed(&known, "or")),
            "friction is that of a joint".to_string(),
        ),
    };
    scope.diagnostics.error_because(member.span(), message, reason);
}

/// `BC.C.x`, `ram.bed.normal`, `ram.bed.friction`
pub(super) fn part_read(
    scope: &mut Scope<'_>,
    [owner, member, part]: &[Ident; 3],
) -> Option<ResolvedExpr> {
    if part == "friction" {
        let effort = friction_named(scope, owner, member, part)?;
        return reading(scope, part, effort, 0);
    }
    let link = uses::link(scope, owner)?;
    let effort = dynamics_outputs::joint_effort(scope, owner, link, member)?;
    let parts = match effort {
        Effort::Guide(_) => ["normal", "couple"],
        _ => ["x", "y"],
    };
    if let Some(index) = parts.iter().position(|known| part == known) {
        return reading(scope, part, effort, index);
    }
    let path = format!("{owner}.{member}");
    let message = format!("`{path}` has no `{part}`");
    let reason = format!("it has `{}` and `{}`, and `friction` where it rubs", parts[0], parts[1]);
    scope.diagnostics.error_because(part.span(), message, reason);
    None
}

/// `output BC.C.friction`; any other part is a field of its reaction.
pub(super) fn part_output(
    scope: &mut Scope<'_>,
    docs: &[Attribute],
    [owner, member, part]: &[Ident; 3],
) {
    if part == "friction" {
        let Some(effort) = friction_named(scope, owner, member, part) else { return };
        let field = format_ident!("{member}_friction", span = member.span());
        return named_efforts::ask(scope, docs, owner, &field, effort);
    }
    let (message, reason) = match part.to_string().as_str() {
        "x" | "y" => (
            format!("write `{member}.{part}` for the point, `{owner}.{member}` for the reaction"),
            "a point is known by its own name, and the reaction's components are fields of the \
             result; under a name of your own a component is an output",
        ),
        _ => (
            format!("write `{owner}.{member}`"),
            "the reaction of a guide is one output; `normal` and `couple` are fields of the result",
        ),
    };
    scope.diagnostics.error_because(part.span(), message, reason);
}

/// The friction of a link at a joint.
fn friction_named(
    scope: &mut Scope<'_>,
    owner: &Ident,
    member: &Ident,
    at: &Ident,
) -> Option<Effort> {
    let link = uses::link(scope, owner)?;
    let effort = match dynamics_outputs::joint_effort(scope, owner, link, member)? {
        Effort::Guide(link) => Effort::GuideFriction(link),
        Effort::Pin(_, pin) | Effort::Bearing(_, pin) => Effort::PinFriction(link, pin),
        _ => return None,
    };
    let rubs = scope.mechanism.dynamics.frictions.iter().any(|friction| match effort {
        Effort::GuideFriction(link) => friction.contact == Contact::Guide(link),
        _ => rubs_at(friction.contact, link, effort),
    });
    if rubs || named_efforts::a_force_may_be_unread(scope) {
        return Some(effort);
    }
    let message = format!("nothing rubs at `{owner}.{member}`");
    let reason = match effort {
        Effort::GuideFriction(_) => format!("as in `friction 0.1 on {owner};`"),
        _ => format!("as in `friction 0.1 on {owner} at {member} radius 8mm;`"),
    };
    scope.diagnostics.error_because(at.span(), message, reason);
    None
}

/// A component of an effort, which an output reads.
fn reading(scope: &mut Scope<'_>, at: &Ident, effort: Effort, part: usize) -> Option<ResolvedExpr> {
    named_efforts::effort_is_known(scope, at, effort)?;
    let reads = Reads::an_effort(effort);
    let measure = Measure::Known(dimension_of(&scope.mechanism, effort, part));
    Some(ResolvedExpr { reads, ..ResolvedExpr::plain(measure, Scalar::Effort(effort, part)) })
}

/// The dimension of a component of an effort.
fn dimension_of(mechanism: &Mechanism, effort: Effort, part: usize) -> Dimension {
    match (effort, part) {
        (Effort::Guide(_), 1) | (Effort::Shaking, 2) => Dimension::TORQUE,
        _ => of_effort(mechanism, effort),
    }
}

/// True if the link rubs at the pin, as either of the two bodies.
fn rubs_at(contact: Contact, asked: LinkId, effort: Effort) -> bool {
    let Contact::Pin { link, pin, against } = contact else { return false };
    effort == Effort::PinFriction(asked, pin) && (link == asked || against == Carrier::Link(asked))
}
