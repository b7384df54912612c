//! Entries that newer versions of PMKS+ write behind the records. A comma ends each, and its first letter says what it is.
//! Numbers that thousandths do not hold are taken; gears, and what is for the screen, are not.

use super::Mistake;
use super::records::Records;

/// The entries that mean nothing here, by their first letters.
const LEFT_OUT: [(char, &str); 8] = [
    ('J', "locks"),
    ('L', "locks"),
    ('F', "locks"),
    ('H', "held lengths and angles"),
    ('C', "what centres of mass are held against"),
    ('S', "the design of a synthesis"),
    ('T', "materials and cross-sections"),
    ('G', "gears"),
];

pub(super) fn read(records: &mut Records<'_>, entries: &str) -> Result<(), Mistake> {
    for entry in entries.split(',').filter(|entry| !entry.is_empty()) {
        let what = match entry.strip_prefix('P') {
            Some(number) => {
                correct(records, number)
                    .ok_or_else(|| format!("`{entry}` corrects no number of the address"))?;
                continue;
            }
            None => LEFT_OUT.iter().find(|(letter, _)| entry.starts_with(*letter)),
        };
        let what = what.map_or_else(|| format!("`{entry}`"), |(_, what)| what.to_string());
        if !records.left_out.contains(&what) {
            records.left_out.push(what);
        }
    }
    Ok(())
}

/// Sets a number that the records have rounded: `JB~0~1.23456` is the first number of joint B. Settings have numbers, too.
fn correct(records: &mut Records<'_>, entry: &str) -> Option<()> {
    let (place, value) = entry.rsplit_once('~')?;
    let (object, index) = place.rsplit_once('~')?;
    let index: usize = index.parse().ok()?;
    let value: f64 = value.parse().ok().filter(|value: &f64| value.is_finite())?;
    let kind = object.chars().next()?;
    let id = &object[kind.len_utf8()..];
    let number = match kind {
        'D' | 'I' if id.is_empty() => return Some(()),
        'J' => {
            let joint = records.joints.iter_mut().find(|joint| joint.id == id)?;
            match index {
                0 | 1 => &mut joint.at[index],
                2 => &mut joint.angle,
                3 => joint.speed.insert(value),
                4 => &mut joint.mass,
                _ => return None,
            }
        }
        'L' => {
            let mut all = records.members.iter_mut().chain(&mut records.parts);
            let member = all.find(|member| member.id == id)?;
            match index {
                0 => &mut member.mass,
                1 => &mut member.inertia,
                2 | 3 => &mut member.centre[index - 2],
                _ => return None,
            }
        }
        'F' => {
            let arrow = records.forces.iter_mut().find(|arrow| arrow.id == id)?;
            match index {
                0..4 => &mut arrow.ends[index / 2][index % 2],
                4 => &mut arrow.magnitude,
                _ => return None,
            }
        }
        _ => return None,
    };
    *number = value;
    Some(())
}
