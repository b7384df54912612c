//! Addresses of PMKS+: everything behind the `?`.
//!
//! | there | here |
//! |---|---|
//! | a revolute joint | a pin |
//! | a link, welded ones as the one that they are together | a link |
//! | a piston and its prismatic joint | a link on a guide: on the ground at the joint's angle, or a slot through two joints of a link |
//! | a prismatic joint of another link | a pin, and such a block on it |
//! | a welded joint | one link of those that meet there |
//! | the input at a joint | the first link there against the ground or against the second; the slide of a piston |
//! | the mass of a link | its mass, at its centre; grams and kg·cm² in a drawing in centimetres. None where all are as PMKS+ sets them |
//! | numbers behind the records that thousandths do not hold | in their place |
//! | a force | a force on a point of its link, which turns with the link where it is local |
//!
//! Both forms of an address, [`today`]'s and the [`older`] one, are read into the same [`records`].

mod address;
mod extensions;
mod loads;
mod older;
mod records;
mod today;
mod welds;

use super::Mistake;
use super::drawing::{Angle, Drawing, Drive, Guide, Line, Link, Pin};
use records::{Joint, Member, Records, block};

pub(crate) fn read(address: &str) -> Result<Drawing, Mistake> {
    let query = address::query(address);
    let records = match older::is_older(&query) {
        true => older::records(&query)?,
        false => today::records(&query)?,
    };
    let mut drawing = Drawing::new("Machine", records.unit);
    leave_out(&mut drawing, &records);
    draw(&mut drawing, &records)?;
    loads::draw_masses(&mut drawing, &records);
    loads::draw_forces(&mut drawing, &records)?;
    welds::weld(&mut drawing, &records);
    for joint in records.joints.iter().filter(|joint| joint.is_input && !joint.is_prismatic) {
        let drive = turned(&drawing, joint)?;
        drawing.drives.push(drive);
    }
    Ok(drawing)
}

/// Notes what a declaration has no place for.
fn leave_out(drawing: &mut Drawing, records: &Records<'_>) {
    for joint in records.joints.iter().filter(|joint| joint.is_input) {
        let speed = joint.speed.unwrap_or(records.speed);
        let unit = if joint.is_prismatic { "" } else { " rpm" };
        let what = format!("the speed of the input at `{}`, {speed}{unit}", joint.id);
        drawing.left_out.push(what);
    }
    if records.has_gravity {
        drawing.left_out.push("gravity".to_string());
    }
    let rubbing = records.joints.iter().filter(|joint| joint.rubs);
    drawing.left_out.extend(rubbing.map(|joint| format!("the friction at `{}`", joint.id)));
    drawing.left_out.extend(records.left_out.iter().cloned());
    let joints = records.joints.iter().map(|joint| (joint.id, joint.title));
    let links = records.members.iter().map(|member| (member.id, member.title));
    for (id, title) in joints.chain(links).filter(|(id, title)| !title.is_empty() && id != title) {
        drawing.left_out.push(format!("the title of `{id}`, {title}"));
    }
    if records.members.iter().any(|member| !member.colour.is_empty()) {
        drawing.left_out.push("colours".to_string());
    }
}

fn draw(drawing: &mut Drawing, records: &Records<'_>) -> Result<(), Mistake> {
    for joint in &records.joints {
        if !joint.is_prismatic || records.is_slider(joint) {
            let is_ground = joint.is_ground && !joint.is_prismatic;
            drawing.pins.push(Pin { id: joint.id.to_string(), at: joint.at, is_ground });
        }
    }
    records.members.iter().try_for_each(|member| draw_link(drawing, member, &records.joints))?;
    let sliders = records.joints.iter().filter(|joint| records.is_slider(joint));
    for joint in sliders {
        let mut link = Link { id: block(joint), pins: vec![joint.id.to_string()], on: Vec::new() };
        slide(drawing, &mut link, joint)?;
        drawing.links.push(link);
    }
    Ok(())
}

/// Lets a link slide on the guide of a prismatic joint.
fn slide(drawing: &mut Drawing, link: &mut Link, joint: &Joint<'_>) -> Result<(), Mistake> {
    let guide = guide(drawing, joint)?;
    link.on.push(guide.id.clone());
    drawing.guides.push(guide);
    if joint.is_input {
        drawing.drives.push(Drive::Slide { link: link.id.clone() });
    }
    Ok(())
}

fn draw_link(
    drawing: &mut Drawing,
    member: &Member<'_>,
    joints: &[Joint<'_>],
) -> Result<(), Mistake> {
    let mut own = Vec::new();
    for &id in &member.joints {
        let joint = joints.iter().find(|joint| joint.id == id);
        own.push(
            joint.ok_or_else(|| {
                format!("`{}` names a joint `{id}`, and there is none", member.id)
            })?,
        );
    }
    let (prismatic, pins): (Vec<&Joint<'_>>, Vec<_>) =
        own.into_iter().partition(|joint| joint.is_prismatic && member.is_piston);
    let pins = pins.iter().map(|pin| pin.id.to_string()).collect();
    let mut link = Link { id: member.id.to_string(), pins, on: Vec::new() };
    for joint in prismatic {
        slide(drawing, &mut link, joint)?;
    }
    if member.is_piston && link.on.is_empty() {
        return Err(format!("the piston `{}` has no prismatic joint", member.id));
    }
    drawing.links.push(link);
    Ok(())
}

fn guide(drawing: &mut Drawing, joint: &Joint<'_>) -> Result<Guide, Mistake> {
    let id = format!("guide_{}", joint.id);
    match joint.slot {
        Some([carrier, from, to]) => {
            let line = Line::Pins([from, to].map(String::from));
            Ok(Guide { id, on: Some(carrier.to_string()), line })
        }
        None if joint.is_ground => {
            let angle = direction(joint.angle);
            if let Angle::Degrees(degrees) = angle
                && (degrees.to_radians() - joint.angle).abs() > EXACT
            {
                let remark = format!(
                    "`{id}` is along {degrees}deg, which PMKS+ wrote as {} rad",
                    joint.angle
                );
                drawing.remarks.push(remark);
            }
            Ok(Guide { id, on: None, line: Line::Along { through: joint.at, angle } })
        }
        None => {
            Err(format!("`{}` slides neither on the ground nor in the slot of a link", joint.id))
        }
    }
}

/// The rounding of an angle that was computed in double precision.
const EXACT: f64 = 1e-9;

/// The direction that an angle in radians stands for: a whole number of degrees where it is one to the three decimals
/// that an address has, as 1.571 rad is 90°.
fn direction(angle: f64) -> Angle {
    let degrees = angle.to_degrees().round();
    let off = (degrees.to_radians() - angle).abs();
    let is_rounded = (1000.0 * angle - (1000.0 * angle).round()).abs() < EXACT;
    let nearest = if is_rounded { 0.0005 + EXACT } else { EXACT };
    if off <= nearest { Angle::Degrees(degrees + 0.0) } else { Angle::Radians(angle) }
}

/// The drive of a revolute joint that is an input.
fn turned(drawing: &Drawing, joint: &Joint<'_>) -> Result<Drive, Mistake> {
    let mut links = drawing.at(joint.id).map(|link| link.id.clone());
    let against_another =
        format!("`{}` is an input of one link that is not on the ground", joint.id);
    match (links.next(), links.next(), joint.is_ground) {
        (Some(link), _, true) => Ok(Drive::Angle { link, against: None }),
        (Some(link), Some(other), false) => Ok(Drive::Angle { link, against: Some(other) }),
        (Some(_), None, false) => Err(against_another),
        (None, ..) => Err(format!("`{}` is an input, and no link goes through it", joint.id)),
    }
}
