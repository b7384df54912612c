//! The solution of a class III group by one unknown: one link is left out, the unknown drives another, and
//! the rest are drivers and dyads. The link that was left out is the equation.

use super::cutting::{Found, KNOWN, Pair, Placed, SearchedGroup, Unplaced};
use super::machine::{GROUND, Held, Machine};

impl SearchedGroup {
    fn of(
        left_out: usize,
        held: Option<(usize, Held)>,
        joints: [Pair; 2],
        steps: Vec<Found>,
    ) -> Self {
        let (between, stretches) = ([0.0; 2], Vec::new());
        Self {
            left_out,
            held,
            joints,
            steps,
            between,
            rises: true,
            stretches,
            following: None,
            assemblies: None,
        }
    }
}

impl SearchedGroup {
    /// The unit of the unknown: a radian, or the size of the machine.
    pub fn unit(&self, machine: &Machine) -> f64 {
        match self.steps[0] {
            Found::Slider { .. } => machine.size(),
            _ => 1.0,
        }
    }
}

/// All ways to solve a group by one unknown, angles against the ground first.
pub fn options(machine: &Machine, known: &Placed, group: &[usize]) -> Vec<SearchedGroup> {
    let parts: Vec<_> = group.iter().map(|&body| vec![body]).collect();
    let all = Unplaced { machine, known: known.clone(), parts };
    let set: Vec<_> = (0..group.len()).collect();
    let joints = all.joints(&set);
    let mut found = Vec::new();
    for (part, &body) in group.iter().enumerate() {
        let is_driven = machine.drives.iter().any(|drive| drive.bodies.contains(&body));
        let mut own: Vec<_> = joints
            .iter()
            .filter(|(_, between)| between.contains(&part))
            .map(|(pair, _)| *pair)
            .collect();
        own.sort_by_key(|pair| match pair {
            // In the order in which they are written.
            Pair::Pin(pin) => machine.bodies[body].pins.iter().position(|own| own == pin),
            Pair::Slide(_) => Some(usize::MAX),
        });
        let [first @ Pair::Pin(_), second] = own[..] else { continue };
        if is_driven {
            continue;
        }
        let rest: Vec<_> = group.iter().copied().filter(|&other| other != body).collect();
        for driven in driven(machine, known, &rest) {
            if let Some(steps) = by_dyads(machine, known, &rest, driven) {
                found.push(SearchedGroup::of(body, None, [first, second], steps));
            }
        }
    }
    found.extend(held_options(machine, known, group));
    let is_of_ground = |search: &SearchedGroup| match search.steps[0] {
        Found::Crank { reference, .. } => reference == GROUND,
        _ => true,
    };
    found.sort_by_key(|search| !is_of_ground(search));
    found
}

/// The ways that leave out two bodies which a drive holds together, pinned at both ends.
fn held_options(machine: &Machine, known: &Placed, group: &[usize]) -> Vec<SearchedGroup> {
    let mut found = Vec::new();
    for drive in &machine.drives {
        let Some(held) = machine.held(drive.bodies) else { continue };
        if !drive.bodies.iter().all(|body| group.contains(body)) {
            continue;
        }
        let rest: Vec<_> =
            group.iter().copied().filter(|body| !drive.bodies.contains(body)).collect();
        let mut parts: Vec<_> = rest.iter().map(|&body| vec![body]).collect();
        parts.push(drive.bodies.to_vec());
        let all = Unplaced { machine, known: known.clone(), parts };
        let set: Vec<_> = (0..all.parts.len()).collect();
        let own = all.joints(&set).into_iter().filter(|(_, between)| between.contains(&rest.len()));
        let own: Vec<_> = own.map(|(pair, _)| pair).collect();
        let [Pair::Pin(p), Pair::Pin(q)] = own[..] else { continue };
        let has = |body: usize, pin: usize| machine.bodies[body].pins.contains(&pin);
        let [a, b] = drive.bodies;
        let ends = match (has(a, p) && has(b, q), has(a, q) && has(b, p)) {
            (true, false) => [p, q],
            (false, true) => [q, p],
            _ => continue,
        };
        for driven in driven(machine, known, &rest) {
            if let Some(steps) = by_dyads(machine, known, &rest, driven) {
                found.push(SearchedGroup::of(a, Some((b, held)), ends.map(Pair::Pin), steps));
            }
        }
    }
    found
}

/// The steps that the unknown may drive: links at known pins, against each known body there, and links on
/// known slides.
fn driven(machine: &Machine, known: &Placed, rest: &[usize]) -> Vec<Found> {
    let parts = rest.iter().map(|&body| vec![body]).collect();
    let rest = Unplaced { machine, known: known.clone(), parts };
    let set: Vec<_> = (0..rest.parts.len()).collect();
    let mut found = Vec::new();
    for (pair, between) in rest.joints(&set) {
        if !between.contains(&KNOWN) {
            continue;
        }
        for &part in between.iter().filter(|&&part| part != KNOWN) {
            let body = rest.parts[part][0];
            match pair {
                Pair::Slide(slide) => found.push(Found::Slider { drive: None, body, slide }),
                Pair::Pin(pivot) => {
                    let others =
                        machine.at(pivot).filter(|&other| other != GROUND && known.body(other));
                    let references = [GROUND].into_iter().chain(others);
                    found.extend(references.map(|reference| Found::Crank {
                        drive: None,
                        body,
                        reference,
                        pivot,
                    }));
                }
            }
        }
    }
    found
}

/// The steps that place the rest once one of its links is driven.
fn by_dyads(
    machine: &Machine,
    known: &Placed,
    rest: &[usize],
    driven: Found,
) -> Option<Vec<Found>> {
    let (Found::Crank { body, .. } | Found::Slider { body, .. }) = driven else { return None };
    let mut known = known.clone();
    known.add(machine, &[body]);
    let parts = rest.iter().filter(|&&other| other != body).map(|&other| vec![other]).collect();
    let mut parts = Unplaced { machine, known, parts };
    let mut steps = vec![driven];
    steps.extend(parts.place());
    parts.parts.is_empty().then_some(steps)
}
