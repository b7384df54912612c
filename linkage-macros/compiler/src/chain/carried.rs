//! Dyads whose bars are pinned to links of given angle and not to each other.
//!
//! A link whose angle is given is moved by its bars without being turned. The vector d from the pin of one bar over such
//! links to the pin of the other is known before they are placed: with the outer pin of the second bar shifted by −d, both
//! bars are a dyad.

use super::cutting::{Carried, Dyad, DyadLeg, KNOWN, Pair, Unplaced};
use super::machine::Driven;

impl Dyad {
    /// The pins at which the bars of a dyad end.
    pub(crate) fn tips(&self, inner: usize) -> [usize; 2] {
        [inner, self.carried.last().map_or(inner, |last| last.pins[1])]
    }

    /// The links between its bars.
    pub(crate) fn carried_bodies(&self) -> impl Iterator<Item = usize> {
        self.carried.iter().map(|carried| carried.body)
    }
}

impl Unplaced<'_> {
    /// The first dyad with links of given angle between its bars, and all parts that it places.
    pub(super) fn carried_dyad(&self) -> Option<(Vec<usize>, Dyad)> {
        if self.machine.drives.is_empty() || self.machine.is_loaded {
            return None;
        }
        let turned: Vec<_> = (0..self.parts.len()).map(|part| self.turned(part)).collect();
        let is_bar = |part: usize| self.parts[part].len() == 1 && turned[part].is_none();
        let bars: Vec<_> = (0..self.parts.len()).filter(|&part| is_bar(part)).collect();
        let begun =
            |&bar: &usize| self.open_pins(bar).map(move |pin| vec![PathPart { part: bar, pin }]);
        let mut paths: Vec<Vec<PathPart>> = bars.iter().flat_map(begun).collect();
        while let Some(path) = paths.pop() {
            let (first, Some(last)) = (path[0].part, path.last()) else { continue };
            for part in (0..self.parts.len()).filter(|&part| self.has(part, last.pin)) {
                if path.iter().any(|step| step.part == part) {
                    continue;
                }
                let is_end = path.len() > 1 && part > first && bars.contains(&part);
                if is_end && let Some(dyad) = self.carried_between(&path, part, &turned) {
                    let parts = path.iter().map(|step| step.part).chain([part]).collect();
                    return Some((parts, dyad));
                }
                if turned[part].is_some() {
                    let on = self.open_pins(part).filter(|&pin| pin != last.pin);
                    let longer = |pin| [&path[..], &[PathPart { part, pin }]].concat();
                    paths.extend(on.map(longer));
                }
            }
        }
        None
    }

    /// The pins of a part's only body that are not placed.
    fn open_pins(&self, part: usize) -> impl Iterator<Item = usize> {
        let body = self.parts[part].first().filter(|_| self.parts[part].len() == 1);
        let pins = body.map_or(&[][..], |&body| &self.machine.bodies[body].pins);
        pins.iter().copied().filter(|&pin| !self.known.pin(pin))
    }

    fn has(&self, part: usize, pin: usize) -> bool {
        self.open_pins(part).any(|own| own == pin)
    }

    /// The drives through which the angle of a part's only body is given, and against which body.
    fn turned(&self, part: usize) -> Option<GivenAngle> {
        let &[body] = &self.parts[part][..] else { return None };
        let mut open = vec![(body, Vec::new())];
        let mut seen = vec![body];
        while let Some((body, path)) = open.pop() {
            for (index, drive) in self.machine.drives.iter().enumerate() {
                let [a, b] = drive.bodies;
                let is_given = drive.reads.iter().all(|&read| self.known.body(read));
                if drive.kind != Driven::Angle || !is_given || (a != body && b != body) {
                    continue;
                }
                let other = if a == body { b } else { a };
                let path = [&path[..], &[[index, body]]].concat();
                if self.known.body(other) {
                    return Some(GivenAngle { drives: path, reference: other });
                }
                if !seen.contains(&other) {
                    seen.push(other);
                    open.push((other, path));
                }
            }
        }
        None
    }

    /// The dyad of the bars at both ends of a path, where nothing else holds what is on it.
    fn carried_between(
        &self,
        path: &[PathPart],
        last: usize,
        turned: &[Option<GivenAngle>],
    ) -> Option<Dyad> {
        let set: Vec<_> = path.iter().map(|step| step.part).chain([last]).collect();
        let joints = self.joints(&set);
        let are_single = joints.iter().all(|(pair, between)| pair.is_pin() && between.len() == 2);
        if joints.len() != set.len() + 1 || !are_single {
            return None;
        }
        let leg = |part: usize| {
            let mut outer = joints
                .iter()
                .filter(|(_, between)| between.contains(&KNOWN) && between.contains(&part));
            let only = outer.next()?.0;
            let leg = DyadLeg { bodies: self.parts[part].clone(), outer: only, held: None };
            outer.next().is_none().then_some(leg)
        };
        let legs = [leg(set[0])?, leg(last)?];
        let carried = path.windows(2).map(|steps| {
            let GivenAngle { drives, reference } = turned[steps[1].part].clone()?;
            let pins = [steps[0].pin, steps[1].pin];
            Some(Carried { body: self.parts[steps[1].part][0], pins, drives, reference })
        });
        let carried = carried.collect::<Option<Vec<_>>>()?;
        Some(Dyad { legs, inner: Pair::Pin(path[0].pin), carried })
    }
}

/// The angle of a body by drives, its own first, each with the body on its side, and against which body.
#[derive(Clone)]
struct GivenAngle {
    drives: Vec<[usize; 2]>,
    reference: usize,
}

/// A part on the way, and the pin by which it is left.
#[derive(Clone, Copy)]
struct PathPart {
    part: usize,
    pin: usize,
}
