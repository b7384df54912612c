//! Masses and forces of an address.

use super::super::drawing::{Drawing, Force, Mass};
use super::Mistake;
use super::records::{Arrow, MASS_AND_INERTIA, Member, Records, block};

pub(super) fn draw_masses(drawing: &mut Drawing, records: &Records<'_>) {
    let [mass, inertia] = MASS_AND_INERTIA;
    let is_untouched = |member: &Member<'_>| {
        member.mass == mass && (member.is_piston || member.inertia == inertia)
    };
    let blocks = records.joints.iter().filter(|joint| joint.mass != 0.0);
    if records.members.iter().all(is_untouched) && blocks.clone().count() == 0 {
        drawing.left_out.push("masses of links, which are as PMKS+ sets them".to_string());
        return;
    }
    let (unit, unit_of_inertia) = match &drawing.unit[..] {
        "cm" => ("g", "kg*cm^2"),
        "m" => ("kg", "kg*m^2"),
        unit => {
            let why =
                format!("masses of links, whose unit beside `{unit}` the address does not say");
            drawing.left_out.push(why);
            return;
        }
    };
    for joint in blocks.filter(|joint| records.is_slider(joint)) {
        let (value, at, inertia) = (joint.mass, joint.at, 0.0);
        drawing.masses.push(Mass { link: block(joint), value, unit, at, inertia, unit_of_inertia });
    }
    let has_mass = |member: &&Member<'_>| member.mass != 0.0 || member.inertia != 0.0;
    for member in records.members.iter().filter(has_mass) {
        // The mass of a piston is at its pin.
        let pin = member.joints.iter().find_map(|joint| drawing.pin(joint));
        let centre = pin.filter(|_| member.is_piston).map_or(member.centre, |pin| pin.at);
        drawing.masses.push(Mass {
            link: member.id.to_string(),
            value: member.mass,
            unit,
            at: centre,
            inertia: member.inertia,
            unit_of_inertia,
        });
    }
}

pub(super) fn draw_forces(drawing: &mut Drawing, records: &Records<'_>) -> Result<(), Mistake> {
    for arrow in &records.forces {
        match records.newtons {
            Some(newtons) => drawing.forces.push(force(arrow, newtons, &records.members)?),
            None => {
                let why = format!("the force `{}`, whose unit is not known here", arrow.id);
                drawing.left_out.push(why);
            }
        }
    }
    Ok(())
}

fn force(arrow: &Arrow<'_>, newtons: f64, members: &[Member<'_>]) -> Result<Force, Mistake> {
    let Arrow { id, link, ends: [at, end], .. } = *arrow;
    let is_of = |member: &&Member<'_>| member.id == link || member.parts.contains(&link);
    let Some(member) = members.iter().find(is_of) else {
        return Err(format!("the force `{id}` acts on `{link}`, which is no link"));
    };
    let along = [end[0] - at[0], end[1] - at[1]];
    let length = along[0].hypot(along[1]);
    if length == 0.0 {
        return Err(format!("the force `{id}` has no direction: its arrow ends where it begins"));
    }
    // The arrow points at the place that it acts on where it does not go outward.
    let sign = if arrow.is_outward { 1.0 } else { -1.0 };
    let factor = sign * newtons * arrow.magnitude / length;
    Ok(Force {
        id: id.to_string(),
        link: member.id.to_string(),
        at,
        vector: along.map(|part| factor * part),
        turns: arrow.turns,
    })
}
