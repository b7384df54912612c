//! The documentation of forces: the body that acts, the body acted on, the sign and the unit of each.

use proc_macro2::TokenStream;

use super::doc_comments::{after, lines};
use crate::codegen::identifiers::text;
use crate::interface::Interface;
use crate::interface::force_records::path;
use crate::interface::quantity::Order;
use crate::interface::units_in_words::unit;
use crate::model::acting::{Effort, Ends, Load, RequestedEffort};
use crate::model::effort_dimensions::{effort_along, of_effort};
use crate::model::mechanism::{
    Body, Carrier, Dimension, Drive, LinkId, Mechanism, PointId, SpringId, StopId,
};

pub(super) fn load(load: &Load) -> TokenStream {
    let unit = unit(load.dimension, Order::Position);
    after(&load.docs, &format!("Load `{}` in {unit}.", text(&load.name)))
}

/// Describes the form of the loads: a number, or an array or record of several.
pub(super) fn loads(mechanism: &Mechanism, interface: &Interface) -> String {
    match (&mechanism.dynamics.loads[..], interface.load_record()) {
        ([only], _) => {
            let unit = unit(only.dimension, Order::Position);
            format!("\nThe load `{}` is in {unit}.", text(&only.name))
        }
        (_, Some(record)) => {
            format!("\nThe loads are an array in the order of `LOADS` or a [`{record}`].")
        }
        _ => String::new(),
    }
}

/// A field of the record of one owner.
pub(super) fn effort(mechanism: &Mechanism, index: usize) -> TokenStream {
    let asked = &mechanism.dynamics.asked[index];
    after(&asked.docs, &format!("{}.", sentence(mechanism, asked)))
}

/// The field of an owner.
pub(super) fn owner(mechanism: &Mechanism, first: usize) -> TokenStream {
    let owner = text(&mechanism.dynamics.asked[first].owner);
    lines(&format!("Forces of `{owner}`."))
}

/// One effort in a list.
pub(in crate::codegen) fn describe(mechanism: &Mechanism, index: usize) -> String {
    let asked = &mechanism.dynamics.asked[index];
    format!("`{}`: {}", path(asked), sentence(mechanism, asked))
}

fn sentence(mechanism: &Mechanism, asked: &RequestedEffort) -> String {
    let link = |id: LinkId| text(&mechanism.links[id.index()].name);
    match asked.effort {
        Effort::Input(id) => {
            let input = &mechanism.inputs[id.index()];
            let (name, unit) = (text(&input.name), effort_unit(input.dimension));
            format!("effort of `{name}` in {unit}: the power that drives put in, over its rate")
        }
        Effort::Pull => pull(mechanism),
        Effort::Unknown(id) => {
            let unknown = &mechanism.unknowns[id.index()];
            let (name, unit) = (text(&unknown.name), effort_unit(unknown.dimension));
            format!("effort of a drive at `{name}` in {unit}, in place of the input's")
        }
        Effort::Drive(id) => driven(mechanism, id),
        Effort::Push(id) => {
            format!(
                "force in N that drives the length of `{}`; positive pushes its ends apart",
                link(id)
            )
        }
        // A block that stands in for a link is not named.
        Effort::Pin(_, joint) => reaction(mechanism, &text(&asked.owner), joint),
        Effort::Bearing(id, joint) => bearing(mechanism, &link(id), joint),
        Effort::Spring(id) => spring(mechanism, id),
        Effort::Stop(id) => stop(mechanism, id)[0].to_string(),
        Effort::Gap(id) => stop(mechanism, id)[1].to_string(),
        Effort::Shaking => {
            "what inertia puts on the ground, as if all links were one body, without \
                            weight and applied forces: force in N and, about the ground's origin, \
                            couple in N·m"
                .to_string()
        }
        Effort::PinFriction(id, _) => friction(&link(id), asked.effort),
        Effort::GuideFriction(by) => friction(&link(mechanism.sliding(by)), asked.effort),
        Effort::Losses => "power in W that friction takes at all joints".to_string(),
        Effort::Formula(_) => {
            format!("formula of efforts, rates and loads, in {}", unit_of(mechanism, asked.effort))
        }
        Effort::Guide(by) => format!(
            "normal force in N on `{0}` at the origin of its frame, along the normal of `{1}`, and \
             couple in N·m on `{0}`, both exerted by `{1}`",
            link(mechanism.sliding(by)),
            text(&asked.field)
        ),
    }
}

/// A joint on which several stand.
fn bearing(mechanism: &Mechanism, link: &str, joint: PointId) -> String {
    let standing = mechanism.standing();
    let others = standing.iter().filter(|(at, _)| *at == joint);
    let name = |by: LinkId| text(mechanism.links[by.index()].known_as());
    let others: Vec<_> = others.map(|&(_, by)| format!("`{}`", name(by))).collect();
    let point = text(&mechanism.points[joint.index()].name);
    let others = others.join(", ");
    let others = match mechanism.is_loaded_joint(joint) {
        true => format!("{others}, and by what is put on it"),
        false => others,
    };
    format!("force in N on `{link}` at `{point}`, exerted by all that stand on it: {others}")
}

/// The load that drives an input.
fn pull(mechanism: &Mechanism) -> String {
    let dynamics = &mechanism.dynamics;
    let unit = unit_of(mechanism, Effort::Pull);
    let input = dynamics.pulled.map(|input| text(&mechanism.inputs[input.index()].name));
    format!("load in {unit} that drives `{}`", input.unwrap_or_default())
}

/// The force on a link at a pin, and the body that exerts it.
fn reaction(mechanism: &Mechanism, on: &str, joint: PointId) -> String {
    let link = |id: LinkId| text(&mechanism.links[id.index()].name);
    let point = text(&mechanism.points[joint.index()].name);
    let by = match mechanism.owner(joint) {
        Some(Body::Ground) => "the ground".to_string(),
        Some(Body::Link(by)) => format!("`{}`", link(by)),
        _ => format!("the pin `{point}`"),
    };
    format!("force in N on `{on}` at `{point}`, exerted by {by}")
}

/// The couple or force of friction on a link.
fn friction(link: &str, effort: Effort) -> String {
    match effort {
        Effort::GuideFriction(_) => format!("force in N of friction on `{link}` along its slide"),
        _ => format!("couple in N·m of friction on `{link}` at this pin, counter-clockwise"),
    }
}

/// The force or couple of a stop, and its gap.
fn stop(mechanism: &Mechanism, id: StopId) -> [&'static str; 2] {
    match mechanism.dynamics.stops[id.index()].of.dimension() {
        Dimension::ANGLE => [
            "couple in N·m of the stop: positive turns its angle forwards",
            "angle in rad to the nearer end of the stop, negative beyond it",
        ],
        _ => [
            "force in N of the stop: positive makes its slide or distance larger",
            "length in m to the nearer end of the stop, negative beyond it",
        ],
    }
}

/// The force or torque of a spring, and the end on which it acts.
fn spring(mechanism: &Mechanism, id: SpringId) -> String {
    let spring = &mechanism.dynamics.springs[id.index()];
    match spring.ends {
        Ends::Points(points) => {
            let [p, q] = points.map(|id| text(&mechanism.points[id.index()].name));
            format!(
                "force in N on `{q}`, away from `{p}`, and its opposite on `{p}`: positive pushes them apart"
            )
        }
        Ends::Bodies(bodies) => {
            let [first, second] = bodies.map(|body| mechanism.body_name(body));
            format!("couple in N·m on `{second}`, counter-clockwise, and its opposite on `{first}`")
        }
    }
}

/// The unit of an effort that is one number.
pub(in crate::codegen) fn unit_of(mechanism: &Mechanism, effort: Effort) -> String {
    match effort {
        Effort::Losses => "W".to_string(),
        _ => unit(of_effort(mechanism, effort), Order::Position),
    }
}

/// The unit of the effort whose product with a rate is a power.
fn effort_unit(dimension: Dimension) -> String {
    unit(effort_along(dimension), Order::Position)
}

/// The drive of a crank or a slider: its couple or force, and the body that it reacts against.
fn driven(mechanism: &Mechanism, id: LinkId) -> String {
    let of = |id: LinkId| text(&mechanism.links[id.index()].name);
    let driven = mechanism.driven_as_drawn(id);
    let (name, group) = (of(driven), mechanism.group_with(id));
    // Where a group has the drive the other way round, its link is what the drawn one is driven against.
    let against = |reference: LinkId| of(if driven == id { reference } else { id });
    let found = group.and_then(|group| match group.outer[0].drive.as_ref()? {
        Drive::Angle { relative_to: Carrier::Ground, .. } => {
            Some(format!("couple in N·m on `{name}`, exerted by its drive against the ground"))
        }
        Drive::Angle { relative_to: Carrier::Link(reference), .. } => Some(format!(
            "couple in N·m on `{name}`, exerted by its drive against `{}`",
            against(*reference)
        )),
        Drive::Slide(_) => Some(format!(
            "force in N on `{name}` along `{}`, exerted by its drive against what carries that",
            text(match mechanism.slide_as_drawn(id) {
                Some(slide) => &slide.guide,
                None => &mechanism.guides[group.slides_on(0).index()].name,
            })
        )),
    });
    found.unwrap_or_else(|| format!("effort of the drive of `{name}`"))
}
