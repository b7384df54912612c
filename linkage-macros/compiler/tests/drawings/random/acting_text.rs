//! The statements of masses and forces as text.

use super::super::variants::Random;
use super::acting::{Acting, Amount, Ends, Friction, Load, Mass, Spring, Stop, Stopped};
use super::drawing::{Drawing, Read};
use super::text::{length, pair, shuffled};

/// The units of a force or of a torque, and of what a rate of an angle or of a length is multiplied by.
const UNITS: [[&str; 3]; 2] = [["N", "(N*s/rad)", "(N*s/m)"], ["(N*m)", "(N*m*s/rad)", "(N*s)"]];

/// The statements of laws, and the statement that uses them.
struct Writer<'a> {
    drawing: &'a Drawing,
    laws: Vec<String>,
}

impl Writer<'_> {
    fn amount(&mut self, amount: &Amount, is_torque: bool) -> String {
        let [unit, of_angle, of_length] = UNITS[usize::from(is_torque)];
        let mut text = format!("{:?}{unit}", amount.constant);
        if let Some((factor, load)) = amount.of_load {
            text += &format!(" + {factor:?} * f{load}");
        }
        if let Some((factor, read)) = amount.of_rate {
            let is_angle = match read {
                Read::Input(input) => self.drawing.inputs[input].is_angle,
                Read::Angle(_) => true,
                Read::Slide(_) => false,
            };
            let unit = if is_angle { of_angle } else { of_length };
            text += &format!(" + {factor:?}{unit} * rate({})", self.drawing.read(read));
        }
        if !amount.is_named {
            return text;
        }
        let name = format!("law{}", self.laws.len());
        self.laws.push(format!("let {name} = {text};"));
        name
    }

    fn load(&mut self, load: &Load) -> String {
        let drawing = self.drawing;
        let pin = |pin: usize| &drawing.pins[pin].name;
        let link = |link: usize| &drawing.links[link].name;
        match load {
            Load::Force { pin: on, parts, axes } => {
                let axes = axes.map_or_else(String::new, |axes| format!(" in {}", link(axes)));
                let [x, y] = parts.each_ref().map(|part| self.amount(part, false));
                format!("force ({x}, {y}){axes} on {};", pin(*on))
            }
            Load::Between { pins: [from, to], amount } => {
                let amount = self.amount(amount, false);
                format!("force {amount} between {} and {};", pin(*from), pin(*to))
            }
            Load::Torque { link: on, amount } => {
                format!("torque {} on {};", self.amount(amount, true), link(*on))
            }
            Load::TorqueBetween { links: [from, to], amount } => {
                let amount = self.amount(amount, true);
                format!("torque {amount} between {} and {};", link(*from), link(*to))
            }
        }
    }
}

impl Drawing {
    fn mass_statement(&self, mass: &Mass) -> String {
        let link = |link: usize| &self.links[link].name;
        let pin = |pin: usize| &self.pins[pin].name;
        match *mass {
            Mass::OnLink { link: on, mass, at, inertia } => {
                format!(
                    "mass {mass:?}kg on {} at {} inertia {inertia:?}(kg*m^2);",
                    link(on),
                    pair(at)
                )
            }
            Mass::AtPin { link: on, mass, pin: at, inertia } => {
                format!(
                    "mass {mass:?}kg on {} at {} inertia {inertia:?}(kg*m^2);",
                    link(on),
                    pin(at)
                )
            }
            Mass::Uniform { link: on, mass } => format!("mass {mass:?}kg on {} uniform;", link(on)),
            Mass::Inertia { link: on, inertia } => {
                format!("inertia {inertia:?}(kg*m^2) on {};", link(on))
            }
            Mass::OnPin { pin: on, mass } => format!("mass {mass:?}kg on {};", pin(on)),
        }
    }

    fn spring_statement(&self, index: usize, spring: &Spring) -> String {
        let Spring { ends, stiffness, free, damping } = spring;
        match ends {
            Ends::Pins(pins) => {
                let [from, to] = pins.map(|pin| &self.pins[pin].name);
                format!(
                    "spring spring{index} between {from} and {to} {{ stiffness: {stiffness:?}(N/m), free_length: {}, damping: {damping:?}(N*s/m) }}",
                    length(*free)
                )
            }
            Ends::Links(links) => {
                let [from, to] =
                    links.map(|link| link.map_or("ground", |link| &self.links[link].name[..]));
                format!(
                    "spring spring{index} between {from} and {to} {{ stiffness: {stiffness:?}(N*m/rad), free_angle: {free:?}rad, damping: {damping:?}(N*m*s/rad) }}"
                )
            }
        }
    }

    fn stop_statement(&self, index: usize, stop: &Stop) -> String {
        let Stop { of, between: [from, to], stiffness, damping } = stop;
        let (read, is_angle) = match of {
            Stopped::Angle(link) => (self.read(Read::Angle(*link)), true),
            Stopped::Slide(link) => (self.read(Read::Slide(*link)), false),
            Stopped::Distance(pins) => {
                let [from, to] = pins.map(|pin| &self.pins[pin].name);
                (format!("distance({from}, {to})"), false)
            }
        };
        let [unit, of_stiffness, of_damping] = match is_angle {
            true => ["rad", "(N*m/rad)", "(N*m*s/rad)"],
            false => ["m", "(N/m)", "(N*s/m)"],
        };
        format!(
            "stop stop{index} {read} between ({from:?}{unit}, {to:?}{unit}) {{ stiffness: {stiffness:?}{of_stiffness}, damping: {damping:?}{of_damping} }}"
        )
    }

    fn friction_statement(&self, friction: &Friction) -> String {
        match *friction {
            Friction::Pin { pin, coefficient, radius } => {
                format!(
                    "friction {coefficient:?} at {} radius {};",
                    self.pins[pin].name,
                    length(radius)
                )
            }
            Friction::Guide { link, coefficient, length: None } => {
                format!("friction {coefficient:?} on {};", self.links[link].name)
            }
            Friction::Guide { link, coefficient, length: Some(along) } => {
                format!(
                    "friction {coefficient:?} on {} length {};",
                    self.links[link].name,
                    length(along)
                )
            }
        }
    }

    /// The statements of all that acts.
    pub(super) fn acting_statements(&self, acting: &Acting, random: &mut Random) -> String {
        let [x, y] = acting.gravity;
        let mut head: Vec<_> = (acting.loads.iter().enumerate())
            .map(|(load, is_force)| {
                format!("load f{load}: {};", if *is_force { "force" } else { "torque" })
            })
            .collect();
        let mut rest = vec![format!("gravity ({x:?}, {y:?});")];
        let mut writer = Writer { drawing: self, laws: Vec::new() };
        rest.extend(acting.forces.iter().map(|load| writer.load(load)));
        head.extend(writer.laws);
        rest.extend(acting.masses.iter().map(|mass| self.mass_statement(mass)));
        rest.extend(
            acting
                .springs
                .iter()
                .enumerate()
                .map(|(index, spring)| self.spring_statement(index, spring)),
        );
        rest.extend(
            acting.stops.iter().enumerate().map(|(index, stop)| self.stop_statement(index, stop)),
        );
        rest.extend(acting.frictions.iter().map(|friction| self.friction_statement(friction)));
        shuffled(random, &mut rest);
        head.extend(rest);
        head.join("\n")
    }
}
