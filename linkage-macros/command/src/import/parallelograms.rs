//! Sides that were parallel and equal before their coordinates were rounded.
//!
//! A parallelogram of which one side is a thousandth longer is a four-bar that jams or crosses over where its bars come
//! into one line. Drawings are saved with three decimals, or as they were computed, so what was a parallelogram seldom is
//! one to the last digit: one of its pins is moved by the missing part.

use std::collections::BTreeSet;

use super::drawing::{Drawing, Pin};

/// The most by which a side is off after rounding to three decimals: half a thousandth at each of four pins.
const ROUNDED: f64 = 0.002;
/// The least length of a side, in parts by which it is off.
const LONG: f64 = 500.0;
/// The decimals to which coordinates are rounded that were computed.
const DECIMALS: usize = 9;

/// Two sides between the same two bodies: the links, and the indices of their pins, each from one body to the other.
struct Sides {
    links: [String; 2],
    pins: [[usize; 2]; 2],
}

/// Makes sides exactly parallel and equal that nearly are.
pub(crate) fn make_exact(drawing: &mut Drawing) {
    let all = sides(drawing);
    // Pins that stay where they are: on the ground, on a guide, or at a corner of a parallelogram.
    let is_sliding = |pin: &Pin| drawing.at(&pin.id).any(|link| !link.on.is_empty());
    let held = drawing.pins.iter().enumerate().filter(|(_, pin)| pin.is_ground || is_sliding(pin));
    let mut held: BTreeSet<usize> = held.map(|(at, _)| at).collect();
    let (exact, others): (Vec<_>, Vec<_>) =
        all.into_iter().partition(|sides| is_exact(&drawing.pins, sides));
    held.extend(exact.iter().flat_map(|sides| sides.pins.as_flattened()));
    for sides in others {
        if is_near(&drawing.pins, &sides) && !is_exact(&drawing.pins, &sides) {
            move_one(drawing, &sides, &held);
        }
        if is_exact(&drawing.pins, &sides) {
            held.extend(sides.pins.as_flattened());
        }
    }
}

/// The pairs of links that join the same two bodies, at four pins.
fn sides(drawing: &Drawing) -> Vec<Sides> {
    let index = |id: &String| drawing.pins.iter().position(|pin| pin.id == *id);
    let ground = drawing.pins.iter().enumerate().filter(|(_, pin)| pin.is_ground);
    let mut bodies = vec![ground.map(|(at, _)| at).collect::<Vec<_>>()];
    bodies.extend(drawing.links.iter().map(|link| link.pins.iter().filter_map(index).collect()));
    let bodies = &bodies;
    // A body that has a pin of each of two others, and the pins.
    let joining = move |from: usize, to: usize| {
        let others = (1..bodies.len()).filter(move |&body| body != from && body != to);
        others.flat_map(move |body| {
            let own = move |other: usize, not: usize| {
                let pins = bodies[body].iter().copied();
                pins.filter(move |pin| bodies[other].contains(pin) && !bodies[not].contains(pin))
            };
            own(from, to).flat_map(move |p| own(to, from).map(move |q| (body, [p, q])))
        })
    };
    let mut found = Vec::new();
    for from in 0..bodies.len() {
        for to in from + 1..bodies.len() {
            let joining: Vec<_> = joining(from, to).collect();
            for (at, &(one, pins)) in joining.iter().enumerate() {
                let differs = |&&(other, [p, q]): &&(usize, [usize; 2])| {
                    other != one && p != pins[0] && q != pins[1]
                };
                found.extend(joining[at + 1..].iter().filter(differs).map(|&(other, own)| Sides {
                    links: [one, other].map(|body| drawing.links[body - 1].id.clone()),
                    pins: [pins, own],
                }));
            }
        }
    }
    found
}

fn between(from: [f64; 2], to: [f64; 2]) -> [f64; 2] {
    [to[0] - from[0], to[1] - from[1]]
}

fn length([x, y]: [f64; 2]) -> f64 {
    x.hypot(y)
}

/// True if two sides are parallel and equal but for the last digits of their pins.
fn is_near(pins: &[Pin], sides: &Sides) -> bool {
    let [[p, q], [r, s]] = sides.pins.map(|side| side.map(|pin| pins[pin].at));
    let [one, other] = [between(p, q), between(r, s)];
    let off = between(one, other).map(f64::abs);
    let shortest = length(one).min(length(between(p, r)));
    off.iter().all(|off| *off <= ROUNDED) && LONG * length(off) <= shortest && shortest > 0.0
}

/// True if two sides are parallel and equal in the decimals that are printed.
fn is_exact(pins: &[Pin], sides: &Sides) -> bool {
    let places = sides.pins.map(|side| side.map(|pin| pins[pin].at.map(decimal)));
    let [[p, q], [r, s]] = places;
    (0..2).all(|axis| match [p, q, r, s].map(|place| place[axis]) {
        [Some(p), Some(q), Some(r), Some(s)] => q - p == s - r,
        _ => false,
    })
}

/// A coordinate in units of the last decimal; `None` where it has more of them or is too large.
fn decimal(number: f64) -> Option<i64> {
    let text = format!("{number:.DECIMALS$}");
    let is_whole = text.parse::<f64>() == Ok(number);
    text.replace('.', "").parse().ok().filter(|_| is_whole)
}

/// Moves one pin that is not held so that the sides are equal, and rounds the others where they were computed.
fn move_one(drawing: &mut Drawing, sides: &Sides, held: &BTreeSet<usize>) {
    let [[p, q], [r, s]] = sides.pins;
    let rounded =
        |at: [f64; 2]| at.map(|x| format!("{x:.DECIMALS$}").parse::<f64>().unwrap_or(x) + 0.0);
    let is_held = |pin: usize| held.contains(&pin);
    let is_computed = |pin: usize| drawing.pins[pin].at.map(decimal).contains(&None);
    // The pin that moves, and those from which its place follows: the first plus the second less the third.
    let ways = [(s, [r, q, p]), (q, [p, s, r]), (r, [s, p, q]), (p, [q, r, s])];
    let Some((moved, others)) = ways.into_iter().find(|&(pin, _)| !is_held(pin)) else { return };
    if others
        .into_iter()
        .any(|pin| is_computed(pin) && is_held(pin) && !drawing.pins[pin].is_ground)
    {
        return;
    }
    let [a, b, c] = others.map(|pin| rounded(drawing.pins[pin].at));
    let place = rounded([a[0] + b[0] - c[0], a[1] + b[1] - c[1]]);
    let mut was = Vec::new();
    for (pin, place) in others.into_iter().zip([a, b, c]).chain([(moved, place)]) {
        let pin = &mut drawing.pins[pin];
        if pin.at != place {
            was.push(format!("`{}` was at ({}, {})", pin.id, pin.at[0], pin.at[1]));
            pin.at = place;
        }
    }
    let [one, other] = &sides.links;
    let remark = format!("{}: `{one}` and `{other}` are made parallel and equal", was.join(", "));
    drawing.remarks.push(remark);
}
