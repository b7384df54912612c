//! Random machines: from the ground outwards, by drivers, dyads and groups of class III.

use super::super::variants::Random;
use super::drawing::{
    Along, Drawing, Drive, Guide, Input, Link, Param, Pin, Place, Read, Through, Value,
};
use super::text::shuffled;
use super::truth::Truth;

/// A part that is added to a machine at once.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum Part {
    Crank,
    CrankOnLink,
    SlideDrive,
    Bars,
    BarAndBlock,
    BlockOnBar,
    TwoBlocks,
    Yoke,
    Hub,
    Cylinder,
    Gear,
    Held,
    Triad,
}

pub(super) const PARTS: [Part; 13] = [
    Part::Bars,
    Part::BarAndBlock,
    Part::BlockOnBar,
    Part::TwoBlocks,
    Part::Yoke,
    Part::Hub,
    Part::Cylinder,
    Part::Gear,
    Part::Crank,
    Part::CrankOnLink,
    Part::SlideDrive,
    Part::Held,
    Part::Triad,
];

/// The largest condition of the equations in a drawing.
pub(super) const DRAWN_CONDITION: f64 = 300.0;

pub(super) struct Growth {
    pub drawing: Drawing,
    pub parts: Vec<Part>,
}

/// A machine of a seed, of about so many links.
pub(super) fn grown(random: &mut Random, links: usize) -> Growth {
    let mut growth = Growth { drawing: Drawing::default(), parts: Vec::new() };
    let firsts = [Part::Crank, Part::Crank, Part::Crank, Part::SlideDrive, Part::Cylinder];
    while growth.drawing.links.is_empty() {
        let first = firsts[random.below(firsts.len())];
        growth.attempt(random, first);
    }
    let mut attempts = 0;
    while growth.drawing.links.len() < links && attempts < 200 {
        attempts += 1;
        // Bars are what most machines are made of.
        let part = PARTS[random.below(PARTS.len() + 3).saturating_sub(3)];
        let is_driven = !matches!(
            part,
            Part::Crank | Part::CrankOnLink | Part::SlideDrive | Part::Cylinder | Part::Held
        );
        if is_driven || growth.drawing.inputs.len() < 3 {
            growth.attempt(random, part);
        }
    }
    growth
}

pub(super) fn between(random: &mut Random, [from, to]: [f64; 2]) -> f64 {
    from + (to - from) * random.below(1 << 20) as f64 / f64::from(1 << 20)
}

/// Tenths of millimetres.
pub(super) fn rounded(at: [f64; 2]) -> [f64; 2] {
    at.map(|part| (part * 1e4).round() / 1e4)
}

impl Growth {
    /// Adds a part, unless the drawing is next to a limit then.
    fn attempt(&mut self, random: &mut Random, part: Part) {
        let before = self.drawing.clone();
        let is_added = self.drawing.add(random, part).is_some() && {
            let truth = Truth::of(&self.drawing);
            assert!(truth.is_square(), "{part:?} {:?}", self.drawing);
            truth.drawn().is_some_and(|pose| pose.condition() < DRAWN_CONDITION)
        };
        match is_added {
            true => self.parts.push(part),
            false => self.drawing = before,
        }
    }
}

impl Drawing {
    pub(super) fn named_pin(&mut self, place: Place) -> usize {
        let letter = match place {
            Place::Ground(_) => 'G',
            Place::Drawn(..) => 'P',
            Place::OnLink(..) => 'E',
        };
        self.pins.push(Pin { name: format!("{letter}{}", self.pins.len()), place });
        self.pins.len() - 1
    }

    /// A pin somewhere about a place; one of six by a parameter.
    pub(super) fn pin_about(&mut self, random: &mut Random, [x, y]: [f64; 2]) -> usize {
        let (size, angle) = (between(random, [0.12, 0.5]), between(random, [-3.2, 3.2]));
        let [x, y] = rounded([x + size * angle.cos(), y + size * angle.sin()]);
        if random.below(8) > 0 || self.params.len() > 1 {
            return self.named_pin(Place::Drawn([x, y], None));
        }
        let default = rounded([between(random, [0.02, 0.1]); 2])[0];
        self.params.push(Param { name: format!("p{}", self.params.len()), default });
        let [x, y] = rounded([x - default, y]);
        self.named_pin(Place::Drawn([x, y], Some(self.params.len() - 1)))
    }

    pub(super) fn ground_pin(&mut self, random: &mut Random) -> usize {
        let at = rounded([(); 2].map(|()| between(random, [-0.7, 0.7])));
        self.named_pin(Place::Ground(at))
    }

    pub(super) fn link(&mut self, random: &mut Random, pins: &[usize], on: &[usize]) -> usize {
        let mut pins = pins.to_vec();
        shuffled(random, &mut pins);
        let name = format!("L{}", self.links.len());
        self.links.push(Link { name, pins, on: on.to_vec(), length: None });
        self.links.len() - 1
    }

    /// A bar between two pins, with a point of its own now and then.
    pub(super) fn bar(&mut self, random: &mut Random, from: usize, to: usize) -> usize {
        let mut pins = vec![from, to];
        if random.below(4) == 0 {
            pins.push(self.pin_about(random, self.place(to)));
        }
        self.link(random, &pins, &[])
    }

    fn moving_link(&self, random: &mut Random) -> Option<usize> {
        let all: Vec<_> =
            (0..self.links.len()).filter(|&link| self.links[link].length.is_none()).collect();
        (!all.is_empty()).then(|| all[random.below(all.len())])
    }

    /// A joint on something that moves: a pin that is there, another one on a link, or a declared point.
    pub(super) fn moving_pin(&mut self, random: &mut Random) -> Option<usize> {
        let link = self.moving_link(random)?;
        if random.below(3) > 0 {
            let there = |pin: &usize| !self.is_ground(*pin);
            let pins: Vec<_> = self.links[link].pins.iter().copied().filter(there).collect();
            return (!pins.is_empty()).then(|| pins[random.below(pins.len())]);
        }
        if random.below(2) == 0
            || self.links[link].pins.is_empty()
            || self.links[link].pins.len() < 2
        {
            let at = rounded([(); 2].map(|()| between(random, [-0.3, 0.3])));
            return Some(self.named_pin(Place::OnLink(link, at)));
        }
        let pin = self.pin_about(random, self.frame(link).at);
        self.links[link].pins.push(pin);
        Some(pin)
    }

    pub(super) fn foot(&mut self, random: &mut Random) -> Option<usize> {
        match random.below(5) {
            0 | 1 => Some(self.ground_pin(random)),
            _ => self.moving_pin(random),
        }
    }

    /// Two joints on different bodies, at least one of which moves.
    pub(super) fn feet(&mut self, random: &mut Random) -> Option<[usize; 2]> {
        let mut feet = [self.moving_pin(random)?, self.foot(random)?];
        shuffled(random, &mut feet);
        self.are_apart(&feet).then_some(feet)
    }

    /// True if no body holds two of the pins.
    fn are_apart(&self, pins: &[usize]) -> bool {
        let holds =
            |link: usize| pins.iter().filter(|&&pin| self.bodies_at(pin).contains(&link)).count();
        pins.iter().filter(|&&pin| self.is_ground(pin)).count() < 2
            && (0..self.links.len()).all(|link| holds(link) < 2)
    }

    pub(super) fn rail(&mut self, random: &mut Random, may_move: bool) -> Option<usize> {
        if !self.guides.is_empty() && random.below(4) == 0 {
            let guide = random.below(self.guides.len());
            return (may_move || self.guides[guide].of.is_none()).then_some(guide);
        }
        let of = if may_move && random.below(2) == 0 { self.moving_link(random) } else { None };
        let at = rounded([(); 2].map(|()| between(random, [-0.4, 0.4])));
        let degrees = between(random, [-180.0, 180.0]).round();
        let (mut through, mut along) = (Through::At(at), Along::Degrees(degrees));
        if let Some(link) = of.filter(|_| random.below(2) == 0) {
            let pins = &self.links[link].pins;
            match pins[..] {
                [first, second, ..] if random.below(2) == 0 => {
                    (through, along) = (Through::Pin(second), Along::Towards(first));
                }
                [.., last] => through = Through::Pin(last),
                [] => {}
            }
        }
        Some(self.guide_of(of, through, along))
    }

    pub(super) fn guide_of(&mut self, of: Option<usize>, through: Through, along: Along) -> usize {
        let name = format!("g{}", self.guides.len());
        self.guides.push(Guide { name, of, through, along });
        self.guides.len() - 1
    }

    /// A block with a joint on a guide.
    pub(super) fn block(&mut self, random: &mut Random, pin: usize, guide: usize) -> usize {
        let mut pins = vec![pin];
        if random.below(3) == 0 {
            pins.push(self.pin_about(random, self.place(pin)));
        }
        self.link(random, &pins, &[guide])
    }

    pub(super) fn input(&mut self, is_angle: bool) -> usize {
        self.inputs.push(Input { name: format!("q{}", self.inputs.len()), is_angle });
        self.inputs.len() - 1
    }

    pub(super) fn add_drive(&mut self, random: &mut Random, driven: Read, against: Option<usize>) {
        let input = self.input(matches!(driven, Read::Angle(_)));
        let factor = [1.0, 1.0, 1.0, -1.0, 2.0, 0.5][random.below(6)];
        let constant = [0.0, 0.0, 0.125, -0.3][random.below(4)];
        let value = Value { factor, of: Read::Input(input), constant };
        self.drives.push(Drive { driven, against, value });
    }
}
