//! The records of addresses since the spring of 2023. Sections end with a point: four of settings, then joints, links and
//! forces, each list behind an empty section, what is selected, [`extensions`], and a character that counts the length.
//! Numbers are thousandths to the base of 64, with a zero in front where they are negative.

use super::Mistake;
use super::address::counted;
use super::extensions;
use super::records::{Arrow, Joint, Member, POUND, Records};

pub(super) const DIGITS: &str = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz_-";
/// The count of settings in front of the joints.
const SETTINGS: usize = 4;

pub(super) fn records(query: &str) -> Result<Records<'_>, Mistake> {
    let sections = counted(query)?;
    let mut sections = sections.split('.');
    let settings: Vec<_> = sections.by_ref().take(SETTINGS).collect();
    let &[_, numbers, integers, words] = &settings[..] else {
        return Err("the address ends within its settings".into());
    };
    let joints = list(&mut sections, joint)?;
    let links = list(&mut sections, member)?;
    let forces = list(&mut sections, force)?;
    let (mut members, mut parts) = (Vec::new(), Vec::new());
    for (member, is_root) in links {
        if is_root { members.push(member) } else { parts.push(member) }
    }
    let speed = integer(integers.split(',').next().unwrap_or_default())?;
    let mut records = Records {
        unit: unit(words)?,
        speed,
        newtons: newtons(words),
        has_gravity: false,
        // Versions that know a welded block write a second number, the speed of slides.
        welds_blocks: numbers.contains(','),
        joints,
        members,
        parts,
        forces,
        left_out: Vec::new(),
    };
    // Behind what is selected.
    let more: Vec<_> = sections.skip(1).collect();
    extensions::read(&mut records, &more.join("."))?;
    Ok(records)
}

/// The records up to the next empty section.
fn list<'a, T>(
    sections: &mut impl Iterator<Item = &'a str>,
    read: impl Fn(&'a str) -> Result<T, Mistake>,
) -> Result<Vec<T>, Mistake> {
    sections.take_while(|section| !section.is_empty()).map(read).collect()
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

/// Newtons of the unit of forces: the third word of the settings. Inches have pounds.
fn newtons(words: &str) -> Option<f64> {
    match (words.chars().next(), words.chars().nth(2)) {
        (Some('0'), _) => Some(POUND),
        (_, Some('1') | None) => Some(1.0),
        _ => None,
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

/// The flags of a record, and its name.
fn flags<'a>(first: &'a str, kind: &str, section: &str) -> Result<(u32, &'a str), Mistake> {
    let Some((flags, id)) = first.char_indices().nth(1).map(|(at, _)| first.split_at(at)) else {
        return Err(format!("`{section}` is a {kind} without a name"));
    };
    Ok((integer(flags)? as u32, id))
}

fn joint(section: &str) -> Result<Joint<'_>, Mistake> {
    let fields: Vec<_> = section.split(',').collect();
    let &[first, title, x, y, angle, ref slots @ ..] = &fields[..] else {
        return Err(format!("`{section}` is no joint: its fields are name, title, x, y, angle"));
    };
    let (flags, id) = flags(first, "joint", section)?;
    let slot = match *slots {
        [] | ["", ..] => None,
        // A speed of its own and the mass of a block may stand behind.
        [carrier, from, to, ..] => Some([carrier, from, to]),
        _ => return Err(format!("the slot of `{id}` is no link and two joints")),
    };
    let behind = |at: usize| {
        let text = slots.get(at).filter(|text| !text.is_empty());
        text.map(|text| number(text))
    };
    Ok(Joint {
        id,
        title,
        at: [number(x)?, number(y)?],
        angle: number(angle)?,
        is_prismatic: flags & 1 != 0,
        is_input: flags & 2 != 0,
        is_ground: flags & 4 != 0,
        is_welded: flags & 8 != 0,
        slot,
        speed: behind(3).transpose()?,
        mass: behind(4).transpose()?.unwrap_or(0.0),
        // A mark stands between: several links are one at a slider.
        rubs: slots.get(6).is_some_and(|coefficient| !matches!(*coefficient, "" | "0")),
    })
}

/// A link, and whether it is one by itself: others are parts of links that are welded together.
fn member(section: &str) -> Result<(Member<'_>, bool), Mistake> {
    let fields: Vec<_> = section.split(',').collect();
    let mut letters = fields[0].chars();
    // The letter says, too, which of inertia and centre PMKS+ computes, and whether the link is drawn as a disc.
    let is_root = match letters.next() {
        Some('Y' | 'A' | 'M' | 'G' | '0'..='3') => true,
        Some('N' | 'a' | 'm' | 'g' | '4'..='7') => false,
        _ => {
            return Err(format!(
                "`{section}` is no link: its first letter is not Y, N or their like"
            ));
        }
    };
    let is_piston = match letters.next() {
        Some('R') => false,
        Some('P') => true,
        _ => return Err(format!("`{section}` is neither a link R nor a piston P")),
    };
    let id = letters.as_str();
    let &[_, title, mass, inertia, x, y, colour, ref names @ ..] = &fields[..] else {
        return Err(format!("`{section}` is no link: it ends in front of its joints"));
    };
    let mut names = names.iter().copied();
    let joints = names.by_ref().take_while(|joint| !joint.is_empty()).collect();
    let member = Member {
        id,
        title,
        is_piston,
        mass: number(mass)?,
        inertia: number(inertia)?,
        centre: [number(x)?, number(y)?],
        colour,
        joints,
        parts: names.filter(|part| !part.is_empty()).collect(),
    };
    Ok((member, is_root))
}

/// A force: two flags and its name, the link, a title, where the arrow begins and ends, and how large it is.
fn force(section: &str) -> Result<Arrow<'_>, Mistake> {
    let fields: Vec<_> = section.split(',').collect();
    let &[first, link, _, x, y, u, v, size] = &fields[..] else {
        return Err(format!(
            "`{section}` is no force: its fields are name, link, title, two places of two numbers, and the magnitude"
        ));
    };
    let (flags, id) = flags(first, "force", section)?;
    let ends = [[number(x)?, number(y)?], [number(u)?, number(v)?]];
    let (turns, is_outward) = (flags & 1 != 0, flags & 2 != 0);
    Ok(Arrow { id, link, ends, magnitude: number(size)?, turns, is_outward })
}
