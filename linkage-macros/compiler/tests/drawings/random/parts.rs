//! The parts that machines grow by.

use super::super::variants::Random;
use super::drawing::{Along, Drawing, Drive, Read, Through, Value};
use super::growing::{Part, between, rounded};
use super::text::shuffled;

impl Drawing {
    pub(super) fn add(&mut self, random: &mut Random, part: Part) -> Option<()> {
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
        let bars = [from, to].map(|foot| self.bar(random, foot, pin));
        // One of six bars is given a length beside that of the drawing.
        for bar in bars {
            if random.below(6) > 0 {
                continue;
            }
            let [from, to, ..] = self.links[bar].pins[..] else { continue };
            let [from_at, to_at] = [from, to].map(|pin| self.place(pin));
            let drawn = (to_at[0] - from_at[0]).hypot(to_at[1] - from_at[1]);
            let [length, _] = rounded([drawn * between(random, [0.97, 1.03]); 2]);
            if self.links[bar].pins.len() == 2 {
                let of = Read::Input(0);
                self.links[bar].length = Some(Value { factor: 0.0, of, constant: length });
            }
        }
        Some(bars)
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
