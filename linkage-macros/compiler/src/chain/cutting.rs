//! Drivers and dyads among bodies that depend on each other.

use super::assembly_list::{Assemblies, OtherAssembly};
use super::fit::{Following, Piece};
pub use super::known_parts::{Closing, Placed};
use super::machine::{Driven, Held, Machine};

/// The step that places bodies once all before it are placed.
#[derive(Clone, Debug)]
pub enum Found {
    /// A body is turned about a pin that is known, by a drive or by the unknown of a search.
    Crank {
        drive: Option<usize>,
        body: usize,
        reference: usize,
        pivot: usize,
    },
    /// A body is moved along a slide.
    Slider {
        drive: Option<usize>,
        body: usize,
        slide: usize,
    },
    Dyad(Dyad),
    Search(Box<SearchedGroup>),
    /// A group that is solved by all its angles and slides at once.
    Tracked(Box<TrackedGroup>),
}

/// A group that is solved by one unknown.
#[derive(Clone, Debug)]
pub struct SearchedGroup {
    pub left_out: usize,
    /// The body that a drive holds together with it, at the second joint.
    pub held: Option<(usize, Held)>,
    /// The joints that hold it: two pins, or a pin and a slide behind it.
    pub joints: [Pair; 2],
    /// First what the unknown drives.
    pub steps: Vec<Found>,
    /// The ends of the unknown, from its value in the drawing or from the value that it follows.
    pub between: [f64; 2],
    /// True if the equation's left side grows with the unknown.
    pub rises: bool,
    /// By motion of the machine, the interval of what drives it, measured from the drawing, in which the
    /// search was followed.
    pub stretches: Vec<[f64; 2]>,
    /// The value over the first drive from which the ends are measured.
    pub following: Option<Following>,
    /// All ways to assemble it where it is drawn; none where they are not listed.
    pub assemblies: Option<Assemblies>,
}

/// A group that is solved by all its unknowns at once.
#[derive(Clone, Debug)]
pub struct TrackedGroup {
    /// Drivers, one a body. Those without a drive have an unknown each, in this order.
    pub steps: Vec<Found>,
    pub closings: Vec<Closing>,
    /// The unknowns over the first drive, from the drawing, in the order of its values.
    pub pieces: Vec<Piece>,
    /// The size that slides are measured by.
    pub size: f64,
    /// True if the drive turns fully.
    pub closes: bool,
}

impl TrackedGroup {
    /// The bodies of the group.
    pub(crate) fn bodies(&self) -> Vec<usize> {
        self.steps.iter().flat_map(Found::bodies).collect()
    }

    /// The steps that have an unknown.
    pub(crate) fn unknowns(&self) -> impl Iterator<Item = &Found> {
        self.steps.iter().filter(|step| is_unknown(step))
    }
}

/// True if the step has an unknown.
pub(super) fn is_unknown(step: &Found) -> bool {
    matches!(step, Found::Crank { drive: None, .. } | Found::Slider { drive: None, .. })
}

impl Found {
    /// The bodies that it places.
    pub fn bodies(&self) -> Vec<usize> {
        match self {
            Self::Crank { body, .. } | Self::Slider { body, .. } => vec![*body],
            Self::Dyad(dyad) => {
                let legs = dyad.legs.iter().flat_map(|leg| leg.bodies.clone());
                legs.chain(dyad.carried_bodies()).collect()
            }
            Self::Search(search) => search.bodies(),
            Self::Tracked(tracked) => tracked.bodies(),
        }
    }
}

impl SearchedGroup {
    /// The nearest other assembly that a search in its interval may find where the group is drawn.
    pub fn other_in_its_interval(&self) -> Option<OtherAssembly> {
        let Found::Crank { body, .. } = self.steps[0] else { return None };
        let from = self.following.as_ref().map_or(0.0, |following| following.at(0.0));
        let ends = self.between.map(|end| from + end);
        let turned = self.assemblies.as_ref()?.other_between(ends)?;
        Some(OtherAssembly { body, turned })
    }

    /// True if the unknown drives the same body in the same way and the same link is left out.
    pub fn is_the_way_of(&self, other: &Self) -> bool {
        let driven = |search: &Self| match search.steps[0] {
            Found::Crank { body, reference, pivot, .. } => Some((body, reference, pivot)),
            _ => None,
        };
        self.left_out == other.left_out && driven(self) == driven(other)
    }

    /// All bodies of the group, the one that is left out behind the others.
    pub(crate) fn bodies(&self) -> Vec<usize> {
        let placed = self.steps.iter().flat_map(Found::bodies).chain([self.left_out]);
        placed.chain(self.held.map(|(body, _)| body)).collect()
    }
}

/// Two legs, each with a joint outside, and a joint between them.
#[derive(Clone, Debug)]
pub struct Dyad {
    pub legs: [DyadLeg; 2],
    pub inner: Pair,
    /// Links of given angle between the first leg, at `inner`, and the second.
    pub carried: Vec<Carried>,
}

/// A link of given angle between the bars of a dyad.
#[derive(Clone, Debug)]
pub struct Carried {
    pub body: usize,
    /// The pins through which it goes on the way from the first bar to the second.
    pub pins: [usize; 2],
    /// The drives that turn it against what is placed, its own first, each with the body on its side.
    pub drives: Vec<[usize; 2]>,
    /// The body against which they turn it.
    pub reference: usize,
}

/// A body, or two that a drive holds together: first the one at the joint outside.
#[derive(Clone, Debug)]
pub struct DyadLeg {
    pub bodies: Vec<usize>,
    pub outer: Pair,
    pub held: Option<Held>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pair {
    Pin(usize),
    Slide(usize),
}

impl Pair {
    /// The letter of the joint in the name of a dyad.
    pub(crate) fn letter(self) -> char {
        match self {
            Self::Pin(_) => 'r',
            Self::Slide(_) => 'p',
        }
    }

    pub(super) fn is_pin(self) -> bool {
        matches!(self, Self::Pin(_))
    }
}

impl Dyad {
    /// The letters of its joints, from one outside joint to the other.
    pub fn letters(&self) -> String {
        [self.legs[0].outer, self.inner, self.legs[1].outer].map(Pair::letter).iter().collect()
    }

    /// The legs in the order in which the language names them: the bar in front of the block, the
    /// block in front of what it slides on.
    fn ordered(mut self, machine: &Machine) -> Self {
        let swaps = match (self.legs[0].outer.is_pin(), self.legs[1].outer.is_pin()) {
            (false, true) => true,
            (true, true) => match self.inner {
                Pair::Slide(slide) => !self.legs[0].bodies.contains(&machine.slides[slide].body),
                Pair::Pin(_) => false,
            },
            _ => false,
        };
        if swaps {
            self.legs.reverse();
        }
        self
    }
}

/// Unknown bodies, in parts that drives hold together.
#[derive(Clone)]
pub(crate) struct Unplaced<'m> {
    pub machine: &'m Machine,
    pub known: Placed,
    pub parts: Vec<Vec<usize>>,
}

/// The index that stands for all placed bodies in the list of a joint's two parts.
pub(super) const KNOWN: usize = usize::MAX;

impl Unplaced<'_> {
    /// The part that holds a body, [`KNOWN`] where it is placed.
    fn part_of(&self, body: usize) -> Option<usize> {
        match self.known.body(body) {
            true => Some(KNOWN),
            false => self.parts.iter().position(|part| part.contains(&body)),
        }
    }

    /// The joints among these parts and with what is known, each with what it is between.
    pub(super) fn joints(&self, set: &[usize]) -> Vec<(Pair, Vec<usize>)> {
        let mut joints = Vec::new();
        for pin in 0..self.machine.pins.len() {
            let mut between: Vec<usize> = Vec::new();
            for body in self.machine.at(pin) {
                let part = self.part_of(body).filter(|part| set.contains(part));
                between.extend(part.filter(|part| !between.contains(part)));
            }
            if self.known.pin(pin) && !between.is_empty() {
                between.push(KNOWN);
            }
            if between.len() > 1 {
                joints.push((Pair::Pin(pin), between));
            }
        }
        for (index, slide) in self.machine.slides.iter().enumerate() {
            let (Some(a), Some(b)) = (self.part_of(slide.body), self.part_of(slide.carrier)) else {
                continue;
            };
            let is_among = |part: usize| part == KNOWN || set.contains(&part);
            if a != b && is_among(a) && is_among(b) && (set.contains(&a) || set.contains(&b)) {
                joints.push((Pair::Slide(index), vec![a, b]));
            }
        }
        joints
    }

    /// The dyad that two parts are.
    fn dyad(&self, set: [usize; 2]) -> Option<Dyad> {
        let joints = self.joints(&set);
        let [first, second, third] = &joints[..] else { return None };
        if [first, second, third].iter().any(|(_, between)| between.len() != 2) {
            return None;
        }
        let inner = joints.iter().find(|(_, between)| !between.contains(&KNOWN))?;
        let outer = |part: usize| {
            let mut outer = joints
                .iter()
                .filter(|(_, between)| between.contains(&KNOWN) && between.contains(&part));
            let only = outer.next()?.0;
            outer.next().is_none().then_some(only)
        };
        let leg = |part: usize| self.leg(part, outer(part)?, inner.0);
        let legs = [leg(set[0])?, leg(set[1])?];
        let sliding =
            legs.iter().filter(|leg| !leg.outer.is_pin()).count() + usize::from(!inner.0.is_pin());
        // Two links with prismatic joints alone cannot turn.
        (sliding < 3)
            .then(|| Dyad { legs, inner: inner.0, carried: Vec::new() }.ordered(self.machine))
    }

    /// The bodies of a part between a joint outside and the one between both legs.
    fn leg(&self, part: usize, outer: Pair, inner: Pair) -> Option<DyadLeg> {
        let bodies = &self.parts[part];
        let has = |body: usize, pair: Pair| match pair {
            Pair::Pin(pin) => self.machine.bodies[body].pins.contains(&pin),
            Pair::Slide(slide) => {
                let slide = self.machine.slides[slide];
                [slide.body, slide.carrier].contains(&body)
            }
        };
        if let Some(&body) = bodies.iter().find(|&&body| has(body, outer) && has(body, inner)) {
            return Some(DyadLeg { bodies: vec![body], outer, held: None });
        }
        let [first, second] = bodies[..] else { return None };
        let ordered = if has(first, outer) { [first, second] } else { [second, first] };
        let held = Some(self.machine.held(ordered)?);
        // The offset of a held block changes with the drive: no group has that.
        let is_bar = outer.is_pin() && inner.is_pin();
        is_bar.then(|| DyadLeg { bodies: ordered.to_vec(), outer, held })
    }

    /// Lets a drive hold two parts together, if there is one between two bodies.
    fn hold(&mut self) -> bool {
        let pairs = self.machine.drives.iter().filter_map(|drive| {
            self.machine.held(drive.bodies)?;
            let [a, b] = drive.bodies.map(|body| self.part_of(body));
            let (a, b) = (a?, b?);
            let is_single = |part: usize| part != KNOWN && self.parts[part].len() == 1;
            (a != b && is_single(a) && is_single(b)).then_some([a.min(b), a.max(b)])
        });
        let Some([first, second]) = pairs.into_iter().next() else { return false };
        let held = self.parts.remove(second);
        self.parts[first].extend(held);
        true
    }

    fn take(&mut self, mut set: Vec<usize>) {
        set.sort_unstable();
        for part in set.into_iter().rev() {
            let bodies = self.parts.remove(part);
            self.known.add(self.machine, &bodies);
        }
    }

    /// A driver whose other side is known.
    fn driver(&self) -> Option<(usize, Found)> {
        self.machine.drives.iter().enumerate().find_map(|(index, drive)| {
            let [a, b] = drive.bodies;
            [(a, b), (b, a)].into_iter().find_map(|(body, reference)| {
                let part = self.part_of(body).filter(|&part| part != KNOWN)?;
                if !self.known.body(reference) || self.parts[part].len() != 1 {
                    return None;
                }
                let step = match drive.kind {
                    Driven::Slide(slide) => Found::Slider { drive: Some(index), body, slide },
                    Driven::Angle => {
                        let mut pins = self.machine.bodies[body].pins.iter().copied();
                        let pivot = pins.find(|&pin| self.known.pin(pin))?;
                        Found::Crank { drive: Some(index), body, reference, pivot }
                    }
                };
                Some((part, step))
            })
        })
    }

    /// The bodies that a drive turns against a leg and that have no part in the dyad.
    fn beside(&self, pair: [usize; 2], dyad: &Dyad) -> Vec<Found> {
        let mut turned = Vec::new();
        for (part, leg) in
            pair.into_iter().flat_map(|part| dyad.legs.iter().map(move |leg| (part, leg)))
        {
            let bodies = &self.parts[part];
            let reference = leg.bodies[0];
            let others = bodies.iter().filter(|body| !leg.bodies.contains(body));
            for &body in others.filter(|_| bodies.contains(&reference)) {
                let Some(Held { drive, pivot }) = self.machine.held([reference, body]) else {
                    continue;
                };
                turned.push(Found::Crank { drive: Some(drive), body, reference, pivot });
            }
        }
        turned
    }

    /// Drivers and dyads as far as they go.
    pub(crate) fn place(&mut self) -> Vec<Found> {
        let mut steps = Vec::new();
        loop {
            if let Some((part, step)) = self.driver() {
                steps.push(step);
                self.take(vec![part]);
                continue;
            }
            let pairs = (0..self.parts.len()).flat_map(|b| (0..b).map(move |a| [a, b]));
            let found = pairs.filter_map(|pair| Some((pair, self.dyad(pair)?))).next();
            match found {
                Some((pair, dyad)) => {
                    let turned = self.beside(pair, &dyad);
                    steps.push(Found::Dyad(dyad));
                    steps.extend(turned);
                    self.take(pair.to_vec());
                }
                None => match self.carried_dyad() {
                    Some((parts, dyad)) => {
                        steps.push(Found::Dyad(dyad));
                        self.take(parts);
                    }
                    None if self.hold() => {}
                    None => return steps,
                },
            }
        }
    }
}

/// The drivers and dyads that a group is made of; `None` where it is of class III or higher.
pub fn steps(machine: &Machine, known: &Placed, group: &[usize]) -> Option<Vec<Found>> {
    let parts = group.iter().map(|&body| vec![body]).collect();
    let mut parts = Unplaced { machine, known: known.clone(), parts };
    let steps = parts.place();
    parts.parts.is_empty().then_some(steps)
}
