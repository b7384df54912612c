//! Random poses of a mechanism: anywhere, after thousands of turns, next to quarter turns, and next to
//! a limit.

use core::f64::consts::{FRAC_PI_2, PI, TAU};

use linkage_tests::measured::Width;
use linkage_tests::measured::poses::Source;

use crate::twins::{Twin, answers};

/// Where a pose was looked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Place {
    Anywhere,
    ManyTurns,
    QuarterTurn,
    Limit,
}

#[derive(Clone, Debug)]
pub(crate) struct Pose {
    pub(crate) place: Place,
    pub(crate) q: Vec<f64>,
    pub(crate) rate: Vec<f64>,
    pub(crate) second: Vec<f64>,
}

pub(crate) fn draw(twin: &Twin, source: &mut Source, width: Width) -> Pose {
    let share = source.unit();
    let (mut place, mut q) = (Place::Anywhere, anywhere(twin, source));
    if share < 0.4 {
        if let Some(near) = near_limit(twin, source, width) {
            (place, q) = (Place::Limit, near);
        }
    } else if share < 0.5 {
        place = Place::ManyTurns;
        // Within the range of the fast path as a rule, and sometimes beyond.
        let most = if width == Width::Double { 5.5 } else { 4.2 };
        let turns = source.magnitude(0.0, most).round() * if source.coin() { 1.0 } else { -1.0 };
        change_angles(twin, &mut q, |angle| angle + TAU * turns);
    } else if share < 0.6 {
        place = Place::QuarterTurn;
        let digits = if width == Width::Double { -16.0 } else { -8.0 };
        change_angles(twin, &mut q, |angle| {
            (angle / FRAC_PI_2).round() * FRAC_PI_2
                + source.between(-1.0, 1.0) * source.magnitude(digits, -2.0)
        });
    }
    let list = |source: &mut Source| {
        let signed = |_: &_| source.magnitude(-1.0, 1.0) * if source.coin() { 1.0 } else { -1.0 };
        twin.inputs.iter().map(signed).collect()
    };
    let (rate, second) = (list(source), list(source));
    let rounded = |list: Vec<f64>| list.into_iter().map(|x| width.round(x)).collect();
    Pose { place, q: rounded(q), rate: rounded(rate), second: rounded(second) }
}

fn anywhere(twin: &Twin, source: &mut Source) -> Vec<f64> {
    let drawn = twin.inputs.iter().map(|range| {
        let [low, high] = range.unwrap_or([-PI, PI]);
        source.between(low, high)
    });
    drawn.collect()
}

fn change_angles(twin: &Twin, q: &mut [f64], mut change: impl FnMut(f64) -> f64) {
    for (q, _) in q.iter_mut().zip(twin.inputs).filter(|(_, range)| range.is_none()) {
        *q = change(*q);
    }
}

fn is_solved(twin: &Twin, q: &[f64], width: Width) -> bool {
    let ones = vec![1.0; q.len()];
    let lists = [q, &ones[..], &ones];
    match width {
        Width::Double => answers(&twin.double, lists).0[0].is_ok(),
        Width::Single => answers(&twin.single, lists).0[0].is_ok(),
    }
}

/// Next to a limit between two random poses that differ in one input, at a distance that is as likely
/// to be a last place as a tenth of the way.
fn near_limit(twin: &Twin, source: &mut Source, width: Width) -> Option<Vec<f64>> {
    for _ in 0..12 {
        let mut inside: Vec<f64> =
            anywhere(twin, source).into_iter().map(|x| width.round(x)).collect();
        if !is_solved(twin, &inside, width) {
            continue;
        }
        let varied = (source.unit() * inside.len() as f64) as usize;
        let range = twin.inputs[varied];
        let mut outside = inside.clone();
        outside[varied] = width.round(match range {
            Some([low, high]) => source.between(low, high),
            None => inside[varied] + source.between(-PI, PI),
        });
        if is_solved(twin, &outside, width) {
            continue;
        }
        let way = inside[varied] - outside[varied];
        loop {
            let middle = width.round(f64::midpoint(inside[varied], outside[varied]));
            if middle == inside[varied] || middle == outside[varied] {
                break;
            }
            let mut between = inside.clone();
            between[varied] = middle;
            if is_solved(twin, &between, width) { inside = between } else { outside = between }
        }
        let digits = if width == Width::Double { -16.0 } else { -8.0 };
        let away = if source.unit() < 0.3 {
            // Last places to both sides.
            let places = (source.between(-8.0, 8.0)).round();
            2.0 * width.half_unit() * inside[varied].abs() * places
        } else {
            way * source.magnitude(digits, -1.0)
        };
        inside[varied] += away;
        return Some(inside);
    }
    None
}
