//! The bodies of a group hung on what is placed, and the pins that close loops.

use crate::chain::cutting::{Closing, Found, Placed, is_unknown};
use crate::chain::machine::{Driven, GROUND, Machine};

/// Steps, and the pins that close loops.
pub(super) struct Hung {
    pub steps: Vec<Found>,
    pub closings: Vec<Closing>,
}

/// A group as far as it hangs on what is placed.
struct Hanging<'m> {
    machine: &'m Machine,
    known: Placed,
    open: Vec<usize>,
    used: Vec<usize>,
}

/// Every body of the group by a driver of its own; `None` where slides close loops.
pub(super) fn hung(machine: &Machine, known: &Placed, group: &[usize]) -> Option<Hung> {
    let mut hanging =
        Hanging { machine, known: known.clone(), open: group.to_vec(), used: Vec::new() };
    let (mut steps, mut closings) = (Vec::new(), Vec::new());
    while !hanging.open.is_empty() {
        let step = hanging.next()?;
        let body = step.bodies()[0];
        let own = &machine.bodies[body].pins;
        let hangs = |pin: usize| matches!(step, Found::Crank { pivot, .. } if pivot == pin);
        let closing = own.iter().filter(|&&pin| hanging.known.pin(pin) && !hangs(pin));
        closings.extend(closing.map(|&pin| Closing { pin, body, bend: 0.0 }));
        if let Found::Slider { slide, .. } = step {
            hanging.used.push(slide);
        }
        hanging.known.add(machine, &[body]);
        hanging.open.retain(|&other| other != body);
        steps.push(step);
    }
    // A slide between bodies that hang elsewhere closes a loop as well.
    let is_of_group = |slide: usize| {
        let slide = machine.slides[slide];
        group.contains(&slide.body) || group.contains(&slide.carrier)
    };
    let all_used = (0..machine.slides.len())
        .filter(|&slide| is_of_group(slide))
        .all(|slide| hanging.used.contains(&slide));
    let unknowns = steps.iter().filter(|step| is_unknown(step)).count();
    (all_used && unknowns == 2 * closings.len()).then_some(Hung { steps, closings })
}

impl Hanging<'_> {
    /// A driven body first, since a drive is no equation; then one that slides, since no slide is; then one on a pin.
    fn next(&self) -> Option<Found> {
        self.driven().or_else(|| self.sliding()).or_else(|| self.turning())
    }

    fn driven(&self) -> Option<Found> {
        let drives = self.machine.drives.iter().enumerate();
        drives
            .flat_map(|(drive, driving)| {
                let [a, b] = driving.bodies;
                [(a, b), (b, a)].map(|(body, reference)| (drive, driving.kind, body, reference))
            })
            .find_map(|(drive, kind, body, reference)| {
                if !self.open.contains(&body) || !self.known.body(reference) {
                    return None;
                }
                let drive = Some(drive);
                Some(match kind {
                    Driven::Slide(slide) => Found::Slider { drive, body, slide },
                    Driven::Angle => {
                        Found::Crank { drive, body, reference, pivot: self.pivot(body)? }
                    }
                })
            })
    }

    /// The first pin of a body that is placed.
    fn pivot(&self, body: usize) -> Option<usize> {
        self.machine.bodies[body].pins.iter().copied().find(|&pin| self.known.pin(pin))
    }

    fn sliding(&self) -> Option<Found> {
        let slides = self.machine.slides.iter().enumerate();
        slides.filter(|(slide, _)| !self.is_driven(*slide)).find_map(|(slide, joint)| {
            let is_free = self.open.contains(&joint.body) && self.known.body(joint.carrier);
            is_free.then_some(Found::Slider { drive: None, body: joint.body, slide })
        })
    }

    fn is_driven(&self, slide: usize) -> bool {
        self.machine.drives.iter().any(|drive| drive.kind == Driven::Slide(slide))
    }

    /// A body that a drive or a slide will place is left to these.
    fn turning(&self) -> Option<Found> {
        let waits = |body: usize| {
            let slides = &self.machine.slides;
            slides.iter().any(|slide| slide.body == body && self.open.contains(&slide.carrier))
        };
        let turns = |&body: &usize| {
            let pivot = self.pivot(body).filter(|_| !waits(body))?;
            Some(Found::Crank { drive: None, body, reference: GROUND, pivot })
        };
        self.open.iter().find_map(turns)
    }
}
