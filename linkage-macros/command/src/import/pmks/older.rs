//! The records of addresses that PMKS+ wrote until the spring of 2023: parameters `j`, `l`, `f` and `s`, a line a record.
//!
//! | parameter | fields |
//! |---|---|
//! | `j` | name, x, y, links, `R` or `P`, on the ground, angle in radians, input |
//! | `l` | name, `R` or `P`, mass, inertia, two coordinates of the centre, joints, forces; what else is there is the outline |
//! | `f` | name, link, two places of two numbers, keeps its direction, outward, magnitude |
//! | `s` | speed, clockwise, gravity, unit |
//!
//! A mark is `t` or `f`; lists within a field are divided by `|`.

use super::Mistake;
use super::records::{Arrow, Joint, MASS_AND_INERTIA, Member, POUND, Records};

/// The parameter of this letter; empty where there is none.
fn parameter<'a>(query: &'a str, letter: &str) -> &'a str {
    let value = |part: &'a str| part.strip_prefix(letter)?.strip_prefix('=');
    query.split('&').find_map(value).unwrap_or_default()
}

/// True if the query is one of these.
pub(super) fn is_older(query: &str) -> bool {
    !parameter(query, "j").is_empty()
}

pub(super) fn records(query: &str) -> Result<Records<'_>, Mistake> {
    let lines = |letter| {
        parameter(query, letter).lines().map(str::trim).filter(|line: &&str| !line.is_empty())
    };
    let settings: Vec<_> = parameter(query, "s").split(',').collect();
    let &[speed, _, gravity, unit] = &settings[..] else {
        return Err(
            "the address is cut off: behind `&s=` stand speed, direction, gravity and unit".into(),
        );
    };
    let unit = ["cm", "mm", "m", "in", "ft"].into_iter().find(|known| *known == unit.trim());
    Ok(Records {
        unit: unit.ok_or("the address has no unit of length that is known")?,
        speed: number(speed)?,
        newtons: Some(if unit == Some("in") { POUND } else { 1.0 }),
        has_gravity: mark(gravity)?,
        welds_blocks: false,
        joints: lines("j").map(joint).collect::<Result<_, _>>()?,
        members: lines("l").map(member).collect::<Result<_, _>>()?,
        parts: Vec::new(),
        forces: lines("f").map(force).collect::<Result<_, _>>()?,
        left_out: Vec::new(),
    })
}

fn number(text: &str) -> Result<f64, Mistake> {
    let number = text.parse().ok().filter(|number: &f64| number.is_finite());
    number.ok_or_else(|| format!("`{text}` is no number"))
}

/// A number that means nothing for its record where it is `Null`.
fn number_or_null(text: &str) -> Result<Option<f64>, Mistake> {
    if text == "Null" { Ok(None) } else { number(text).map(Some) }
}

fn mark(text: &str) -> Result<bool, Mistake> {
    match text {
        "t" | "true" => Ok(true),
        "f" | "false" => Ok(false),
        _ => Err(format!("`{text}` is neither `t` nor `f`")),
    }
}

/// True if a record is prismatic or a piston.
fn is_prismatic(kind: &str, id: &str) -> Result<bool, Mistake> {
    match kind {
        "R" => Ok(false),
        "P" => Ok(true),
        _ => Err(format!("`{id}` is neither `R` nor `P`")),
    }
}

fn joint(line: &str) -> Result<Joint<'_>, Mistake> {
    let fields: Vec<_> = line.split(',').collect();
    let &[id, x, y, _, kind, ground, angle, input] = &fields[..] else {
        return Err(format!(
            "`{line}` is no joint: its fields are name, x, y, links, type, ground, angle and input"
        ));
    };
    Ok(Joint {
        id,
        title: id,
        at: [number(x)?, number(y)?],
        angle: number_or_null(angle)?.unwrap_or(0.0),
        is_prismatic: is_prismatic(kind, id)?,
        is_input: mark(input)?,
        is_ground: mark(ground)?,
        is_welded: false,
        slot: None,
        speed: None,
        mass: 0.0,
        rubs: false,
    })
}

fn member(line: &str) -> Result<Member<'_>, Mistake> {
    let fields: Vec<_> = line.split(',').collect();
    let &[id, kind, mass, inertia, x, y, joints, ..] = &fields[..] else {
        return Err(format!("`{line}` is no link: it ends in front of its joints"));
    };
    let [inertia, x, y] = [inertia, x, y].map(number_or_null);
    Ok(Member {
        id,
        title: id,
        is_piston: is_prismatic(kind, id)?,
        // A piston that says nothing of its mass has the one that PMKS+ sets.
        mass: number_or_null(mass)?.unwrap_or(MASS_AND_INERTIA[0]),
        inertia: inertia?.unwrap_or(0.0),
        centre: [x?.unwrap_or(0.0), y?.unwrap_or(0.0)],
        colour: "",
        joints: joints.split('|').filter(|joint| !joint.is_empty()).collect(),
        parts: Vec::new(),
    })
}

fn force(line: &str) -> Result<Arrow<'_>, Mistake> {
    let fields: Vec<_> = line.split(',').collect();
    let &[id, link, x, y, u, v, keeps, outward, size] = &fields[..] else {
        return Err(format!(
            "`{line}` is no force: its fields are name, link, two places of two numbers, two marks and the magnitude"
        ));
    };
    let ends = [[number(x)?, number(y)?], [number(u)?, number(v)?]];
    let (turns, is_outward) = (!mark(keeps)?, mark(outward)?);
    Ok(Arrow { id, link, ends, magnitude: number(size)?, turns, is_outward })
}
