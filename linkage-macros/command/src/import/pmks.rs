//! Addresses of PMKS+: everything behind the `?`.
//!
//! Sections end with a point: four of settings, then joints, links and forces, each list behind an empty section,
//! and a character that counts the length. Numbers are thousandths to the base of 64, with a zero in front where they are
//! negative.
//!
//! | there | here |
//! |---|---|
//! | a revolute joint | a pin |
//! | a link, welded ones as the one that they are together | a link |
//! | a piston and its prismatic joint | a link on a guide: on the ground at the joint's angle, or a slot through two joints of a link |
//! | the input at a joint | the first link there against the ground or against the second; the slide of a piston |
//! | the mass of a link | its mass, at its centre; grams and kg·cm² in a drawing in centimetres. None where all are as PMKS+ sets them |
//! | a force | a force on a point of its link, which turns with the link where it is local |
//!
//! An address carries no gravity.

use super::Mistake;
use super::drawing::{Angle, Drawing, Drive, Force, Guide, Line, Link, Mass, Pin};

const DIGITS: &str = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz_-";
/// The count of settings in front of the joints.
const SETTINGS: usize = 4;
/// The characters that count an address: the digits of letters and numbers.
const COUNTED: usize = 62;

struct Joint<'a> {
    id: &'a str,
    at: [f64; 2],
    angle: f64,
    is_prismatic: bool,
    is_input: bool,
    is_ground: bool,
    /// The link that carries a slot, and the joints through which it goes.
    slot: Option<[&'a str; 3]>,
}

struct Member<'a> {
    id: &'a str,
    is_piston: bool,
    mass: f64,
    inertia: f64,
    centre: [f64; 2],
    joints: Vec<&'a str>,
    /// The links that are welded together to it.
    parts: Vec<&'a str>,
}

/// The mass and the inertia that a link has unless a user changes them; a piston has no inertia.
const MASS_AND_INERTIA: [f64; 2] = [1.0, 1.0];
/// Newtons of a pound's weight.
const POUND: f64 = 4.448_221_615_260_5;

pub(crate) fn read(address: &str) -> Result<Drawing, Mistake> {
    let query = address.split_once('?').map_or("", |(_, query)| query);
    let sections = counted(query)?;
    let mut sections = sections.split('.');
    let settings: Vec<_> = sections.by_ref().take(SETTINGS).collect();
    let &[_, _, _, words] = &settings[..] else {
        return Err("the address ends within its settings".into());
    };
    let mut joints = Vec::new();
    for section in sections.by_ref().take_while(|section| !section.is_empty()) {
        joints.push(joint(section)?);
    }
    let mut members = Vec::new();
    for section in sections.by_ref().take_while(|section| !section.is_empty()) {
        members.extend(member(section)?);
    }
    let mut drawing = Drawing::new("Machine", unit(words)?);
    draw(&mut drawing, &joints, &members)?;
    draw_masses(&mut drawing, &members);
    for section in sections.take_while(|section| !section.is_empty()) {
        let force = force(section, &drawing.unit, &members)?;
        drawing.forces.push(force);
    }
    Ok(drawing)
}

fn draw_masses(drawing: &mut Drawing, members: &[Member<'_>]) {
    let [mass, inertia] = MASS_AND_INERTIA;
    let is_untouched = |member: &Member<'_>| {
        member.mass == mass && (member.is_piston || member.inertia == inertia)
    };
    if members.iter().all(is_untouched) {
        drawing.left_out.push("masses of links, which are as PMKS+ sets them".to_string());
        return;
    }
    let (unit, unit_of_inertia) = match &drawing.unit[..] {
        "cm" => ("g", "kg*cm^2"),
        "m" => ("kg", "kg*m^2"),
        _ => {
            let why = "masses of links, whose unit beside inches the address does not say";
            drawing.left_out.push(why.to_string());
            return;
        }
    };
    for member in members.iter().filter(|member| member.mass != 0.0 || member.inertia != 0.0) {
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

/// A force: two flags and its name, the link, a title, where the arrow begins and ends, and how large it is.
fn force(section: &str, unit: &str, members: &[Member<'_>]) -> Result<Force, Mistake> {
    let fields: Vec<_> = section.split(',').collect();
    let &[first, link, _, x, y, u, v, size] = &fields[..] else {
        return Err(format!(
            "`{section}` is no force: its fields are name, link, title, two places of two numbers, and the magnitude"
        ));
    };
    let Some((flags, id)) = first.char_indices().nth(1).map(|(at, _)| first.split_at(at)) else {
        return Err(format!("`{section}` is a force without a name"));
    };
    let flags = integer(flags)? as u32;
    let is_of = |member: &&Member<'_>| member.id == link || member.parts.contains(&link);
    let Some(member) = members.iter().find(is_of) else {
        return Err(format!("the force `{id}` acts on `{link}`, which is no link"));
    };
    let [at, end] = [[number(x)?, number(y)?], [number(u)?, number(v)?]];
    let along = [end[0] - at[0], end[1] - at[1]];
    let length = along[0].hypot(along[1]);
    if length == 0.0 {
        return Err(format!("the force `{id}` has no direction: its arrow ends where it begins"));
    }
    // The arrow points at the place that it acts on where it does not go outward.
    let sign = if flags & 2 != 0 { 1.0 } else { -1.0 };
    let newtons = if unit == "in" { POUND } else { 1.0 };
    let factor = sign * newtons * number(size)? / length;
    Ok(Force {
        id: id.to_string(),
        link: member.id.to_string(),
        at,
        vector: along.map(|part| factor * part),
        turns: flags & 1 != 0,
    })
}

/// The address without the character at its end, which counts the others.
fn counted(query: &str) -> Result<&str, Mistake> {
    let cut = "the address is cut off or changed: its last character does not count its length";
    let (at, last) = query.char_indices().last().ok_or("there is nothing behind `?`")?;
    match DIGITS.find(last) == Some(at % COUNTED) {
        true => Ok(&query[..at]),
        false => Err(cut.into()),
    }
}

/// The unit of length: the first word of the settings.
fn unit(words: &str) -> Result<&'static str, Mistake> {
    match words.chars().next() {
        Some('0') => Ok("in"),
        Some('1') => Ok("cm"),
        Some('2') => Ok("m"),
        _ => Err(format!("the address has no unit of length that is known: `{words}`")),
    }
}

fn integer(digits: &str) -> Result<f64, Mistake> {
    digits.chars().try_fold(0.0, |number, digit| {
        let digit = DIGITS.find(digit).ok_or_else(|| format!("`{digits}` is no number"))?;
        Ok(64.0 * number + digit as f64)
    })
}

/// A number of thousandths. A zero in front of others is the sign.
fn number(text: &str) -> Result<f64, Mistake> {
    let thousandths = match text.strip_prefix('0') {
        Some(digits) if !digits.is_empty() => -integer(digits)?,
        _ if text.is_empty() => return Err("the address lacks a number".into()),
        _ => integer(text)?,
    };
    Ok(thousandths / 1000.0)
}

fn joint(section: &str) -> Result<Joint<'_>, Mistake> {
    let fields: Vec<_> = section.split(',').collect();
    let &[first, _, x, y, angle, ref slot @ ..] = &fields[..] else {
        return Err(format!("`{section}` is no joint: its fields are name, title, x, y, angle"));
    };
    let Some((flags, id)) = first.char_indices().nth(1).map(|(at, _)| first.split_at(at)) else {
        return Err(format!("`{section}` is a joint without a name"));
    };
    let flags = integer(flags)? as u32;
    let slot = match *slot {
        [] | ["", ..] => None,
        [carrier, from, to] => Some([carrier, from, to]),
        _ => return Err(format!("the slot of `{id}` is no link and two joints")),
    };
    Ok(Joint {
        id,
        at: [number(x)?, number(y)?],
        angle: number(angle)?,
        is_prismatic: flags & 1 != 0,
        is_input: flags & 2 != 0,
        is_ground: flags & 4 != 0,
        slot,
    })
}

/// A link, `None` where it is a part of links that are welded together.
fn member(section: &str) -> Result<Option<Member<'_>>, Mistake> {
    let fields: Vec<_> = section.split(',').collect();
    let mut letters = fields[0].chars();
    let is_root = match letters.next() {
        Some('Y') => true,
        Some('N') => false,
        _ => return Err(format!("`{section}` is no link: it begins with neither Y nor N")),
    };
    let is_piston = match letters.next() {
        Some('R') => false,
        Some('P') => true,
        _ => return Err(format!("`{section}` is neither a link R nor a piston P")),
    };
    let id = letters.as_str();
    if !is_root {
        return Ok(None);
    }
    // Behind the name are title, mass, inertia, two coordinates of the centre and the colour.
    let &[_, _, mass, inertia, x, y, _, ref names @ ..] = &fields[..] else {
        return Err(format!("`{section}` is no link: it ends in front of its joints"));
    };
    let mut names = names.iter().copied();
    let joints = names.by_ref().take_while(|joint| !joint.is_empty()).collect();
    Ok(Some(Member {
        id,
        is_piston,
        mass: number(mass)?,
        inertia: number(inertia)?,
        centre: [number(x)?, number(y)?],
        joints,
        parts: names.filter(|part| !part.is_empty()).collect(),
    }))
}

fn draw(
    drawing: &mut Drawing,
    joints: &[Joint<'_>],
    members: &[Member<'_>],
) -> Result<(), Mistake> {
    for joint in joints.iter().filter(|joint| !joint.is_prismatic) {
        let pin = Pin { id: joint.id.to_string(), at: joint.at, is_ground: joint.is_ground };
        drawing.pins.push(pin);
    }
    for member in members {
        let mut own = Vec::new();
        for &id in &member.joints {
            let joint = joints.iter().find(|joint| joint.id == id);
            own.push(joint.ok_or_else(|| {
                format!("`{}` names a joint `{id}`, and there is none", member.id)
            })?);
        }
        let (prismatic, pins): (Vec<_>, Vec<_>) =
            own.into_iter().partition(|joint| joint.is_prismatic);
        let pins = pins.iter().map(|pin| pin.id.to_string()).collect();
        let mut link = Link { id: member.id.to_string(), pins, on: Vec::new() };
        for joint in prismatic {
            if !member.is_piston {
                return Err(format!(
                    "`{}` is no piston, and `{}` is prismatic",
                    member.id, joint.id
                ));
            }
            let guide = guide(joint)?;
            link.on.push(guide.id.clone());
            drawing.guides.push(guide);
            if joint.is_input {
                drawing.drives.push(Drive::Slide { link: link.id.clone() });
            }
        }
        if member.is_piston && link.on.is_empty() {
            return Err(format!("the piston `{}` has no prismatic joint", member.id));
        }
        drawing.links.push(link);
    }
    for joint in joints.iter().filter(|joint| joint.is_input && !joint.is_prismatic) {
        let drive = turned(drawing, joint)?;
        drawing.drives.push(drive);
    }
    Ok(())
}

fn guide(joint: &Joint<'_>) -> Result<Guide, Mistake> {
    let id = format!("guide_{}", joint.id);
    match joint.slot {
        Some([carrier, from, to]) => {
            let line = Line::Pins([from, to].map(String::from));
            Ok(Guide { id, on: Some(carrier.to_string()), line })
        }
        None if joint.is_ground => {
            let line = Line::Along { through: joint.at, angle: Angle::Radians(joint.angle) };
            Ok(Guide { id, on: None, line })
        }
        None => {
            Err(format!("`{}` slides neither on the ground nor in the slot of a link", joint.id))
        }
    }
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
