//! Random machines: from the ground outwards, by drivers, dyads and groups of class III.

use super::super::variants::Random;
use super::drawing::{
    Along, Drawing, Drive, Guide, Input, Link, Param, Pin, Place, Read, Through, Value,
};
use super::text::shuffled;
use super::truth::Truth;

/// What is added to a machine at once.
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
fn rounded(at: [f64; 2]) -> [f64; 2] {
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
    fn add(&mut self, random: &mut Random, part: Part) -> Option<()> {
        match part {
            Part::Crank => self.add_crank(random),
            Part::CrankOnLink => self.add_crank_on_link(random),
            Part::SlideDrive => self.add_slide_drive(random),
            Part::Bars => self.add_bars(random).map(|_| ()),
            Part::BarAndBlock => self.add_bar_and_block(random),
            Part::BlockOnBar => self.add_block_on_bar(random),
            Part::TwoBlocks => self.add_two_blocks(random),
            Part::Yoke => self.add_yoke(random),
            Part::Hub => self.add_hub(random),
            Part::Cylinder => self.add_cylinder(random),
            Part::Gear => self.add_gear(random),
            Part::Held => self.add_held(random),
            Part::Triad => self.add_triad(random),
        }
    }

    fn named_pin(&mut self, place: Place) -> usize {
        let letter = match place {
            Place::Ground(_) => 'G',
            Place::Drawn(..) => 'P',
            Place::OnLink(..) => 'E',
        };
        self.pins.push(Pin { name: format!("{letter}{}", self.pins.len()), place });
        self.pins.len() - 1
    }

    /// A pin somewhere about a place; one of six by a parameter.
    fn pin_about(&mut self, random: &mut Random, [x, y]: [f64; 2]) -> usize {
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

    fn ground_pin(&mut self, random: &mut Random) -> usize {
        let at = rounded([(); 2].map(|()| between(random, [-0.7, 0.7])));
        self.named_pin(Place::Ground(at))
    }

    fn link(&mut self, random: &mut Random, pins: &[usize], on: &[usize]) -> usize {
        let mut pins = pins.to_vec();
        shuffled(random, &mut pins);
        let name = format!("L{}", self.links.len());
        self.links.push(Link { name, pins, on: on.to_vec(), length: None });
        self.links.len() - 1
    }

    /// A bar between two pins, with a point of its own now and then.
    fn bar(&mut self, random: &mut Random, from: usize, to: usize) -> usize {
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
    fn moving_pin(&mut self, random: &mut Random) -> Option<usize> {
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

    fn foot(&mut self, random: &mut Random) -> Option<usize> {
        match random.below(5) {
            0 | 1 => Some(self.ground_pin(random)),
            _ => self.moving_pin(random),
        }
    }

    /// Two joints on different bodies, at least one of which moves.
    fn feet(&mut self, random: &mut Random) -> Option<[usize; 2]> {
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

    fn rail(&mut self, random: &mut Random, may_move: bool) -> Option<usize> {
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

    fn guide_of(&mut self, of: Option<usize>, through: Through, along: Along) -> usize {
        let name = format!("g{}", self.guides.len());
        self.guides.push(Guide { name, of, through, along });
        self.guides.len() - 1
    }

    /// A block with a joint on a guide.
    fn block(&mut self, random: &mut Random, pin: usize, guide: usize) -> usize {
        let mut pins = vec![pin];
        if random.below(3) == 0 {
            pins.push(self.pin_about(random, self.place(pin)));
        }
        self.link(random, &pins, &[guide])
    }

    fn input(&mut self, is_angle: bool) -> usize {
        self.inputs.push(Input { name: format!("q{}", self.inputs.len()), is_angle });
        self.inputs.len() - 1
    }

    fn add_drive(&mut self, random: &mut Random, driven: Read, against: Option<usize>) {
        let input = self.input(matches!(driven, Read::Angle(_)));
        let factor = [1.0, 1.0, 1.0, -1.0, 2.0, 0.5][random.below(6)];
        let constant = [0.0, 0.0, 0.125, -0.3][random.below(4)];
        let value = Value { factor, of: Read::Input(input), constant };
        self.drives.push(Drive { driven, against, value });
    }

    fn add_crank(&mut self, random: &mut Random) -> Option<()> {
        let pivot = self.ground_pin(random);
        let end = self.pin_about(random, self.place(pivot));
        let link = self.bar(random, pivot, end);
        self.add_drive(random, Read::Angle(link), None);
        Some(())
    }

    fn add_crank_on_link(&mut self, random: &mut Random) -> Option<()> {
        let pivot = self.moving_pin(random)?;
        let bodies = self.bodies_at(pivot);
        let against = (random.below(3) > 0).then(|| bodies[random.below(bodies.len())]);
        let end = self.pin_about(random, self.place(pivot));
        let link = self.bar(random, pivot, end);
        self.add_drive(random, Read::Angle(link), against);
        Some(())
    }

    fn add_slide_drive(&mut self, random: &mut Random) -> Option<()> {
        let guide = self.rail(random, true)?;
        let pin = self.pin_about(random, self.guide(guide).at);
        let link = self.block(random, pin, guide);
        self.add_drive(random, Read::Slide(link), None);
        Some(())
    }

    fn add_bars(&mut self, random: &mut Random) -> Option<[usize; 2]> {
        let [from, to] = self.feet(random)?;
        let middle = [0, 1].map(|axis| 0.5 * (self.place(from)[axis] + self.place(to)[axis]));
        let pin = self.pin_about(random, middle);
        Some([from, to].map(|foot| self.bar(random, foot, pin)))
    }

    fn add_bar_and_block(&mut self, random: &mut Random) -> Option<()> {
        let foot = self.moving_pin(random)?;
        let guide = self.rail(random, true)?;
        if self.guides[guide].of.is_some_and(|link| self.bodies_at(foot).contains(&link)) {
            return None;
        }
        let pin = self.pin_about(random, self.place(foot));
        self.bar(random, foot, pin);
        self.block(random, pin, guide);
        Some(())
    }

    fn add_block_on_bar(&mut self, random: &mut Random) -> Option<()> {
        let [foot, pin] = self.feet(random)?;
        let end = self.pin_about(random, self.place(foot));
        let bar = self.link(random, &[foot, end], &[]);
        let at = rounded([(); 2].map(|()| between(random, [-0.1, 0.1])));
        let degrees = between(random, [-30.0, 30.0]).round();
        let guide = match random.below(2) {
            0 => self.guide_of(Some(bar), Through::Pin(foot), Along::Towards(end)),
            _ => self.guide_of(Some(bar), Through::At(at), Along::Degrees(degrees)),
        };
        self.block(random, pin, guide);
        Some(())
    }

    fn add_two_blocks(&mut self, random: &mut Random) -> Option<()> {
        let guides = [self.rail(random, true)?, self.rail(random, true)?];
        let [one, other] = guides.map(|guide| self.guides[guide].of);
        if one == other {
            return None;
        }
        let pin = self.pin_about(random, self.guide(guides[0]).at);
        for guide in guides {
            self.block(random, pin, guide);
        }
        Some(())
    }

    fn add_yoke(&mut self, random: &mut Random) -> Option<()> {
        let pin = self.moving_pin(random)?;
        let rail = self.rail(random, true)?;
        if self.guides[rail].of.is_some_and(|link| self.bodies_at(pin).contains(&link)) {
            return None;
        }
        let yoke = match random.below(3) {
            0 => self.link(random, &[], &[rail]),
            _ => {
                let end = self.pin_about(random, self.guide(rail).at);
                self.block(random, end, rail)
            }
        };
        let at = rounded([(); 2].map(|()| between(random, [-0.2, 0.2])));
        let degrees = between(random, [-180.0, 180.0]).round();
        let slot = self.guide_of(Some(yoke), Through::At(at), Along::Degrees(degrees));
        self.block(random, pin, slot);
        Some(())
    }

    /// A link that slides on two others, of which one turns about a joint.
    fn add_hub(&mut self, random: &mut Random) -> Option<()> {
        let foot = self.foot(random)?;
        let rail = self.rail(random, true)?;
        let carrier = self.guides[rail].of;
        if carrier.map_or(self.is_ground(foot), |link| self.bodies_at(foot).contains(&link)) {
            return None;
        }
        let end = self.pin_about(random, self.place(foot));
        let hub = self.link(random, &[foot, end], &[]);
        let degrees = between(random, [-180.0, 180.0]).round();
        let guide = self.guide_of(Some(hub), Through::Pin(foot), Along::Degrees(degrees));
        let at = self.pin_about(random, self.place(foot));
        self.link(random, &[at], &[rail, guide]);
        Some(())
    }

    fn add_cylinder(&mut self, random: &mut Random) -> Option<()> {
        let feet = match self.links.is_empty() {
            true => [self.ground_pin(random), self.ground_pin(random)],
            false => self.feet(random)?,
        };
        let pin = self.pin_about(random, self.place(feet[1]));
        let cylinder = self.link(random, &[feet[0], pin], &[]);
        self.bar(random, feet[1], pin);
        let of = Read::Input(self.input(false));
        self.links[cylinder].length = Some(Value { factor: 1.0, of, constant: 0.0 });
        Some(())
    }

    /// A link on a ground pin that turns as a multiple of another one.
    fn add_gear(&mut self, random: &mut Random) -> Option<()> {
        let of = random.below(self.links.len());
        let pivot = self.ground_pin(random);
        let end = self.pin_about(random, self.place(pivot));
        let gear = self.bar(random, pivot, end);
        let factor = [-1.0, -2.0, 1.0, 2.0, -3.0][random.below(5)];
        let constant = self.drawn(Read::Angle(gear)) - factor * self.drawn(Read::Angle(of));
        let value = Value { factor, of: Read::Angle(of), constant };
        self.drives.push(Drive { driven: Read::Angle(gear), against: None, value });
        Some(())
    }

    /// Three bars in a row, two of them driven against each other.
    fn add_held(&mut self, random: &mut Random) -> Option<()> {
        let [from, to] = self.feet(random)?;
        let first = self.pin_about(random, self.place(from));
        let second = self.pin_about(random, self.place(to));
        let bars = [(from, first), (first, second), (second, to)]
            .map(|(from, to)| self.bar(random, from, to));
        let at = random.below(2);
        let mut pair = [bars[at], bars[at + 1]];
        shuffled(random, &mut pair);
        self.add_drive(random, Read::Angle(pair[0]), Some(pair[1]));
        Some(())
    }

    /// A plate on three bars.
    fn add_triad(&mut self, random: &mut Random) -> Option<()> {
        let feet = [self.moving_pin(random)?, self.foot(random)?, self.foot(random)?];
        let holds =
            |link: usize| feet.iter().filter(|&&pin| self.bodies_at(pin).contains(&link)).count();
        let grounds = feet.iter().filter(|&&pin| self.is_ground(pin)).count();
        if grounds > 2
            || (0..self.links.len()).any(|link| holds(link) > 2)
            || feet[0] == feet[1]
            || feet[1] == feet[2]
            || feet[0] == feet[2]
        {
            return None;
        }
        let pins = feet.map(|foot| self.pin_about(random, self.place(foot)));
        for (foot, pin) in feet.into_iter().zip(pins) {
            self.link(random, &[foot, pin], &[]);
        }
        self.link(random, &pins, &[]);
        Some(())
    }
}
