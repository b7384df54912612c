//! Masses, couples, wheels and the drives that are asked for, which a page draws beside bodies: the formulas of where
//! they are, and what the numbers are.

use super::in_script::quoted;
use super::{function, given, searches};
use crate::codegen::text::Text;
use crate::interface::force_records;
use crate::lower::routine::Lowered;
use crate::model::acting::{Effort, RequestedEffort};
use crate::model::mechanism::{
    Carrier, Drive, Group, InputId, LinkId, Mechanism, Operator, Scalar,
};
use crate::model::wheels::wheels;

/// Nothing where there are none.
pub(super) fn put(mechanism: &Mechanism, marks: Option<&Lowered<'_>>, to: &mut Text) {
    let asked = mechanism.dynamics.asked.iter();
    let mut drives: Vec<(String, String)> =
        asked.filter_map(|asked| drive(mechanism, asked)).collect();
    // A crank's own drive and that of the input that turns it are one.
    let mut places: Vec<String> = Vec::new();
    drives.retain(|(_, place)| {
        let is_new = !places.contains(place);
        places.push(place.clone());
        is_new
    });
    if let Some(lowered) = marks {
        let routine = &lowered.routines[0];
        let read = given(mechanism, routine.reads.iter().copied());
        to.put("marked: (p, q, v, a, l, e) => ");
        function(mechanism, lowered, routine, 1, &read, false, to);
        to.put(", () => PLAN.name),\n");
        searches(mechanism, lowered, to);
    } else if drives.is_empty() {
        return;
    }
    let dynamics = &mechanism.dynamics;
    let couples = dynamics.torques.iter().flat_map(|torque| [Some(torque.on), torque.against]);
    let couples = couples.flatten().filter_map(|on| match on {
        Carrier::Link(link) => Some(link.0.to_string()),
        Carrier::Ground => None,
    });
    let wheels = wheels(mechanism).into_iter().map(|wheels| {
        let of = |nth: usize| {
            let link = match wheels.bodies[nth] {
                Carrier::Link(link) => link.0.to_string(),
                Carrier::Ground => "null".to_string(),
            };
            format!("{link}, {}", wheels.centres[nth].0)
        };
        format!("[{}, {}]", of(0), of(1))
    });
    let drives = drives.into_iter().map(|(name, place)| format!("[{}, {place}]", quoted(&name)));
    let [couples, wheels, drives] = [couples.collect(), wheels.collect(), drives.collect()]
        .map(|list: Vec<String>| format!("[{}]", list.join(", ")));
    let masses = dynamics.masses.len();
    let weigh = masses > 0 && dynamics.gravity.is_some();
    to.put(&format!(
        "marks: {{masses: {masses}, weigh: {weigh}, couples: {couples}, wheels: {wheels}, drives: {drives}}},\n"
    ));
}

/// The name of a drive's effort and where it is drawn: a point at which it turns, a link along whose guide it pushes, or
/// the two ends that it pushes apart.
fn drive(mechanism: &Mechanism, asked: &RequestedEffort) -> Option<(String, String)> {
    let place = match asked.effort {
        Effort::Drive(link) | Effort::Push(link) => at_link(mechanism, link, asked.effort)?,
        Effort::Input(input) => {
            let mut driven =
                mechanism.group_steps().flat_map(|group| driven_by(mechanism, group, input));
            let (link, effort) = driven.next()?;
            if driven.next().is_some() {
                return None;
            }
            at_link(mechanism, link, effort)?
        }
        _ => return None,
    };
    Some((force_records::path(asked), place))
}

fn at_link(mechanism: &Mechanism, link: LinkId, effort: Effort) -> Option<String> {
    let group = mechanism.group_with(link)?;
    let joint = group.outer.iter().find(|joint| joint.link() == link)?;
    match (effort, joint.point(), group.pin) {
        (Effort::Push(_), Some(pivot), Some(pin)) => {
            Some(format!("{{push: [{}, {}]}}", pivot.0, pin.0))
        }
        (Effort::Push(_), ..) => None,
        (_, Some(pivot), _) => Some(format!("{{turn: {}}}", pivot.0)),
        (_, None, _) => Some(format!("{{slide: {}}}", link.0)),
    }
}

/// The links of a group whose angle, slide or length is the input itself, but for what does not move.
fn driven_by<'m>(
    mechanism: &'m Mechanism,
    group: &'m Group,
    input: InputId,
) -> impl Iterator<Item = (LinkId, Effort)> + 'm {
    group.outer.iter().enumerate().filter_map(move |(nth, joint)| {
        let link = joint.link();
        let (value, effort) = match (&joint.drive, &group.lengths[nth]) {
            (Some(Drive::Angle { angle, .. }), _) if angle.links.is_empty() => {
                (&angle.rest, Effort::Drive(link))
            }
            (Some(Drive::Slide(slide)), _) => (slide, Effort::Drive(link)),
            (None, Some(length)) => (&length.value, Effort::Push(link)),
            _ => return None,
        };
        is_input(mechanism, value, input).then_some((link, effort))
    })
}

fn is_input(mechanism: &Mechanism, value: &Scalar, input: InputId) -> bool {
    match value {
        Scalar::Input(own) => *own == input,
        Scalar::Let(id) => {
            let named = &mechanism.lets[id.index()];
            named.links.is_empty() && is_input(mechanism, &named.rest, input)
        }
        Scalar::Chain(first, rest) => {
            let is_offset = |(operator, part): &(Operator, Scalar)| {
                matches!(operator, Operator::Add | Operator::Sub) && !mechanism.moves(part)
            };
            is_input(mechanism, first, input) && rest.iter().all(is_offset)
        }
        _ => false,
    }
}
