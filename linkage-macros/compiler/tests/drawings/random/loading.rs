//! Random masses and forces on a machine.

use super::super::variants::Random;
use super::acting::{Acting, Amount, Ends, Friction, Load, Mass, Spring, Stop, Stopped};
use super::drawing::{Drawing, Read};
use super::growing::between;
use super::text::shuffled;

/// A number of three digits.
fn number(random: &mut Random, ends: [f64; 2]) -> f64 {
    let value = between(random, ends);
    let unit = 10_f64.powf(value.abs().log10().floor() - 2.0);
    let digits = (value / unit).round();
    // As a literal reads.
    format!("{digits}e{}", unit.log10().round()).parse().expect("a number")
}

impl Drawing {
    fn amount(&self, random: &mut Random, loads: &[bool], is_force: bool, size: f64) -> Amount {
        let constant = number(random, [-size, size]);
        let fitting: Vec<_> = (0..loads.len()).filter(|&load| loads[load] == is_force).collect();
        let of_load = (!fitting.is_empty() && random.below(3) == 0)
            .then(|| (number(random, [0.5, 2.0]), fitting[random.below(fitting.len())]));
        let of_rate = (random.below(3) == 0).then(|| {
            let read = match random.below(3) {
                0 => Read::Input(random.below(self.inputs.len())),
                1 => Read::Angle(random.below(self.links.len())),
                _ => self.sliding(random).map_or(Read::Angle(0), Read::Slide),
            };
            (number(random, [-0.3 * size, -0.02 * size]), read)
        });
        Amount { constant, of_load, of_rate, is_named: random.below(3) == 0 }
    }

    /// True if drives and slides alone say how a link turns: its angle may count whole turns.
    fn turns_as_driven(&self, link: usize) -> bool {
        let mut turning = vec![false; self.links.len()];
        for drive in &self.drives {
            let links = match drive.driven {
                Read::Angle(link) => [Some(link), drive.against],
                _ => [None; 2],
            };
            links.into_iter().flatten().for_each(|link| turning[link] = true);
        }
        for _ in 0..self.links.len() {
            for (link, of) in self.links.iter().enumerate() {
                for &guide in &of.on {
                    let carrier = self.guides[guide].of;
                    let turns = turning[link] || carrier.is_none_or(|carrier| turning[carrier]);
                    turning[link] = turns;
                    carrier.into_iter().for_each(|carrier| turning[carrier] = turns);
                }
            }
        }
        turning[link]
    }

    /// All that acts but for springs and stops of angles that count whole turns.
    pub(super) fn without_turns(&self, acting: &Acting) -> Acting {
        let mut acting = acting.clone();
        let is_driven = |link: usize| self.turns_as_driven(link);
        acting.springs.retain(|spring| match spring.ends {
            Ends::Links([from, to]) => !(from.is_none_or(is_driven) && to.is_none_or(is_driven)),
            Ends::Pins(_) => true,
        });
        acting.stops.retain(|stop| match stop.of {
            Stopped::Angle(link) => !is_driven(link),
            _ => true,
        });
        acting
    }

    fn sliding(&self, random: &mut Random) -> Option<usize> {
        let all: Vec<_> =
            (0..self.links.len()).filter(|&link| !self.links[link].on.is_empty()).collect();
        (!all.is_empty()).then(|| all[random.below(all.len())])
    }

    fn any_pin(&self, random: &mut Random) -> usize {
        random.below(self.pins.len())
    }

    /// Two pins of different bodies that are apart.
    fn two_pins(&self, random: &mut Random) -> Option<[usize; 2]> {
        let pins = [self.any_pin(random), self.any_pin(random)];
        let [from, to] = pins.map(|pin| self.place(pin));
        let holds = |link: usize| pins.iter().all(|&pin| self.bodies_at(pin).contains(&link));
        let is_rigid =
            pins.iter().all(|&pin| self.is_ground(pin)) || (0..self.links.len()).any(holds);
        ((from[0] - to[0]).hypot(from[1] - to[1]) > 0.2 && !is_rigid).then_some(pins)
    }

    fn mass_on(&self, random: &mut Random, link: usize) -> Option<Mass> {
        let of = &self.links[link];
        let mass = number(random, [0.2, 4.0]);
        let inertia = number(random, [0.001, 0.08]);
        if of.length.is_some() {
            return None;
        }
        match random.below(6) {
            0 if of.pins.len() == 2 && of.on.is_empty() => Some(Mass::Uniform { link, mass }),
            1 => Some(Mass::Inertia { link, inertia }),
            2 if !of.pins.is_empty() => {
                Some(Mass::AtPin { link, mass, pin: of.pins[random.below(of.pins.len())], inertia })
            }
            5 => None,
            _ => {
                let at = [(); 2].map(|()| (between(random, [-0.2, 0.2]) * 1e3).round() / 1e3);
                Some(Mass::OnLink { link, mass, at, inertia })
            }
        }
    }

    fn some_spring(&self, random: &mut Random) -> Option<Spring> {
        let damping = if random.below(2) == 0 { 0.0 } else { number(random, [0.1, 5.0]) };
        if random.below(2) == 0 {
            let pins = self.two_pins(random)?;
            let free = (between(random, [0.05, 0.5]) * 1e3).round() / 1e3;
            let stiffness = number(random, [20.0, 200.0]);
            return Some(Spring { ends: Ends::Pins(pins), stiffness, free, damping });
        }
        let to = random.below(self.links.len());
        let from =
            Some(random.below(self.links.len())).filter(|&from| from != to && random.below(4) > 0);
        // Angles of drivers count whole turns.
        let is_driven = |link: usize| self.turns_as_driven(link);
        if is_driven(to) && from.is_none_or(is_driven) {
            return None;
        }
        let angle = |link: usize| self.frame(link).angle;
        let drawn = angle(to) - from.map_or(0.0, angle);
        let free = super::drawing::within_half_a_turn(drawn + between(random, [-1.0, 1.0]));
        let free = (free * 1e3).round() / 1e3;
        let stiffness = number(random, [0.5, 20.0]);
        Some(Spring { ends: Ends::Links([from, Some(to)]), stiffness, free, damping })
    }

    /// A stop with one of its ends about the drawing.
    fn some_stop(&self, random: &mut Random) -> Option<Stop> {
        let (of, drawn, widths) = match random.below(3) {
            0 => {
                let link = random.below(self.links.len());
                if self.turns_as_driven(link) {
                    return None;
                }
                (Stopped::Angle(link), self.frame(link).angle, [0.3, 2.0])
            }
            1 => {
                let link = self.sliding(random)?;
                (Stopped::Slide(link), self.drawn(Read::Slide(link)), [0.02, 0.3])
            }
            _ => {
                let pins = self.two_pins(random)?;
                let [from, to] = pins.map(|pin| self.place(pin));
                let drawn = (to[0] - from[0]).hypot(to[1] - from[1]);
                (Stopped::Distance(pins), drawn, [0.02, 0.3])
            }
        };
        let [near, far] = [between(random, [-0.05, 0.05]), between(random, widths)];
        let between = if random.below(2) == 0 {
            [drawn + near, drawn + near + far]
        } else {
            [drawn + near - far, drawn + near]
        };
        let between = between.map(|end| (end * 1e4).round() / 1e4);
        let damping = if random.below(2) == 0 { 0.0 } else { number(random, [0.1, 5.0]) };
        Some(Stop { of, between, stiffness: number(random, [20.0, 500.0]), damping })
    }

    fn some_force(&self, random: &mut Random, loads: &[bool]) -> Option<Load> {
        match random.below(5) {
            0 | 1 => {
                let pin = self.any_pin(random);
                let parts = [(); 2].map(|()| self.amount(random, loads, true, 20.0));
                let axes = (random.below(2) == 0).then(|| random.below(self.links.len()));
                (!self.is_ground(pin)).then_some(Load::Force { pin, parts, axes })
            }
            2 => {
                let pins = self.two_pins(random)?;
                Some(Load::Between { pins, amount: self.amount(random, loads, true, 20.0) })
            }
            3 => {
                let link = random.below(self.links.len());
                Some(Load::Torque { link, amount: self.amount(random, loads, false, 5.0) })
            }
            _ => {
                let links = [(); 2].map(|()| random.below(self.links.len()));
                let amount = self.amount(random, loads, false, 5.0);
                (links[0] != links[1]).then_some(Load::TorqueBetween { links, amount })
            }
        }
    }

    fn some_friction(&self, random: &mut Random, acting: &Acting) -> Option<Friction> {
        let coefficient = number(random, [0.02, 0.12]);
        let pin = self.any_pin(random);
        let is_free = |load: &Load| match *load {
            Load::Force { pin: on, .. } => on != pin,
            Load::Between { pins, .. } => !pins.contains(&pin),
            _ => true,
        };
        let is_between = |ends: &Ends| matches!(ends, Ends::Pins(pins) if pins.contains(&pin));
        let is_stopped =
            |stop: &Stop| matches!(stop.of, Stopped::Distance(pins) if pins.contains(&pin));
        let is_laden = acting
            .masses
            .iter()
            .any(|mass| matches!(*mass, Mass::OnPin { pin: on, .. } if on == pin))
            || !acting.forces.iter().all(is_free)
            || acting.springs.iter().any(|spring| is_between(&spring.ends))
            || acting.stops.iter().any(is_stopped);
        let bodies = self.bodies_at(pin);
        let is_joint = bodies.len() + usize::from(self.is_ground(pin)) == 2;
        if is_joint && !is_laden && random.below(2) == 0 {
            let radius = (between(random, [0.004, 0.02]) * 1e4).round() / 1e4;
            return Some(Friction::Pin { pin, coefficient, radius });
        }
        let link = self.sliding(random)?;
        if self.links[link].on.len() > 1 {
            return None;
        }
        let length =
            (random.below(2) == 0).then(|| (between(random, [0.1, 0.3]) * 1e3).round() / 1e3);
        Some(Friction::Guide { link, coefficient, length })
    }

    /// Masses, forces, springs, stops and friction.
    pub(super) fn acting(&self, random: &mut Random) -> Acting {
        let gravity = [number(random, [-2.0, 2.0]), -9.81];
        let loads = (0..random.below(3)).map(|_| random.below(3) > 0).collect();
        let mut acting = Acting { gravity, loads, ..Acting::default() };
        for link in 0..self.links.len() {
            acting.masses.extend(self.mass_on(random, link));
        }
        // Gravity without a mass is a mistake.
        acting.masses.push(Mass::Inertia { link: 0, inertia: number(random, [0.001, 0.08]) });
        let at = [0.05, -0.02];
        acting.masses.push(Mass::OnLink {
            link: self.links.len() - 1,
            mass: 0.5,
            at,
            inertia: 0.01,
        });
        for _ in 0..random.below(3) {
            let pin = self.any_pin(random);
            if !self.is_ground(pin) {
                acting.masses.push(Mass::OnPin { pin, mass: number(random, [0.1, 2.0]) });
            }
        }
        for _ in 0..random.below(4) {
            let force = self.some_force(random, &acting.loads.clone());
            acting.forces.extend(force);
        }
        acting.springs = (0..random.below(4)).filter_map(|_| self.some_spring(random)).collect();
        acting.stops = (0..random.below(4)).filter_map(|_| self.some_stop(random)).collect();
        for _ in 0..random.below(5) {
            let Some(friction) = self.some_friction(random, &acting) else { continue };
            let is_known = acting.frictions.iter().any(|known| match (*known, friction) {
                (Friction::Pin { pin: a, .. }, Friction::Pin { pin: b, .. }) => a == b,
                (Friction::Guide { link: a, .. }, Friction::Guide { link: b, .. }) => a == b,
                _ => false,
            });
            if !is_known {
                acting.frictions.push(friction);
            }
        }
        self.use_every_load(&mut acting, random);
        shuffled(random, &mut acting.masses);
        acting
    }

    /// A load that nothing reads is a mistake.
    fn use_every_load(&self, acting: &mut Acting, random: &mut Random) {
        for load in 0..acting.loads.len() {
            let amount = Amount {
                constant: 0.5,
                of_load: Some((1.0, load)),
                of_rate: None,
                is_named: false,
            };
            acting.forces.push(match acting.loads[load] {
                true => {
                    let still = Amount { constant: 0.0, of_load: None, of_rate: None, is_named: false };
                    let moving: Vec<_> = (0..self.pins.len()).filter(|&pin| !self.is_ground(pin)).collect();
                    let pin = moving[random.below(moving.len())];
                    let rubs = |friction: &Friction| matches!(*friction, Friction::Pin { pin: at, .. } if at == pin);
                    acting.frictions.retain(|friction| !rubs(friction));
                    Load::Force { pin, parts: [still, amount], axes: None }
                }
                false => Load::Torque { link: random.below(self.links.len()), amount },
            });
        }
    }
}
