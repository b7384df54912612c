//! The sum of what acts along the coordinates of a machine.

use super::acting::{Amount, Ends, Friction, Load, Mass, Spring, Stop, Stopped};
use super::drawing::{Read, within_half_a_turn};
use super::jet::{Jet, Vector, dot, minus};
use super::truth::{Moment, Truth};

/// A place where something acts: a point of a link, or a pin.
#[derive(Clone, Copy, Debug)]
enum Site {
    OnLink(usize, [f64; 2]),
    Pin(usize),
}

/// The sum of what acts along the coordinates, and the moment in which it does.
pub(super) struct Sum<'a> {
    pub truth: &'a Truth<'a>,
    pub moment: Moment<'a>,
    pub along: Vec<f64>,
}

fn values(vector: Vector, order: usize) -> [f64; 2] {
    vector.map(|part| part.0[order])
}

impl Sum<'_> {
    fn place(&self, site: Site) -> Vector {
        match site {
            Site::OnLink(link, at) => self.moment.on_link(link, at.map(Jet::still)),
            Site::Pin(pin) => self.moment.pin(pin),
        }
    }

    fn couple(&mut self, link: Option<usize>, couple: f64) {
        if let Some(link) = link {
            self.along[3 * link + 2] += couple;
        }
    }

    /// A force at a place of a link, wherever the place moves.
    fn force_at(&mut self, link: usize, place: [f64; 2], [x, y]: [f64; 2]) {
        let origin = values(self.moment.on_link(link, [Jet::still(0.0); 2]), 0);
        let arm = [place[0] - origin[0], place[1] - origin[1]];
        self.along[3 * link] += x;
        self.along[3 * link + 1] += y;
        self.couple(Some(link), arm[0] * y - arm[1] * x);
    }

    fn force(&mut self, site: Site, force: [f64; 2]) {
        let place = values(self.place(site), 0);
        let link = match site {
            Site::OnLink(link, _) => link,
            Site::Pin(pin) => {
                if let Some(first) = self.truth.joint(pin) {
                    self.along[first] += force[0];
                    self.along[first + 1] += force[1];
                    return;
                }
                // The ground takes what acts on it.
                if self.truth.drawing.is_ground(pin) {
                    return;
                }
                self.truth.drawing.bodies_at(pin)[0]
            }
        };
        self.force_at(link, place, force);
    }

    /// Two points apart.
    fn apart(&mut self, pins: [usize; 2], force: f64) {
        let [from, to] = pins.map(|pin| values(self.moment.pin(pin), 0));
        let way = [to[0] - from[0], to[1] - from[1]];
        let size = way[0].hypot(way[1]);
        let force = way.map(|part| force * part / size);
        self.force(Site::Pin(pins[1]), force);
        self.force(Site::Pin(pins[0]), force.map(|part| -part));
    }

    /// A block along its first guide, and the guide's body the other way.
    fn along_slide(&mut self, link: usize, force: f64) {
        let guide = self.truth.drawing.links[link].on[0];
        let angle = self.moment.guide(guide).1.0[0];
        let force = [force * angle.cos(), force * angle.sin()];
        let at = values(self.moment.on_link(link, [Jet::still(0.0); 2]), 0);
        self.force_at(link, at, force);
        if let Some(carrier) = self.truth.drawing.guides[guide].of {
            self.force_at(carrier, at, force.map(|part| -part));
        }
    }

    fn amount(&self, amount: &Amount, loads: &[f64]) -> f64 {
        let of_load = amount.of_load.map_or(0.0, |(factor, load)| factor * loads[load]);
        let of_rate =
            amount.of_rate.map_or(0.0, |(factor, read)| factor * self.moment.read(read).0[1]);
        amount.constant + of_load + of_rate
    }

    pub(super) fn load(&mut self, load: &Load, loads: &[f64]) {
        match load {
            Load::Force { pin, parts, axes } => {
                let [x, y] = parts.each_ref().map(|part| self.amount(part, loads));
                let (sin, cos) = axes.map_or(0.0, |link| self.moment.angle(link).0[0]).sin_cos();
                self.force(Site::Pin(*pin), [x * cos - y * sin, x * sin + y * cos]);
            }
            Load::Between { pins, amount } => self.apart(*pins, self.amount(amount, loads)),
            Load::Torque { link, amount } => self.couple(Some(*link), self.amount(amount, loads)),
            Load::TorqueBetween { links: [from, to], amount } => {
                let couple = self.amount(amount, loads);
                self.couple(Some(*to), couple);
                self.couple(Some(*from), -couple);
            }
        }
    }

    fn distance(&self, pins: [usize; 2]) -> [f64; 2] {
        let [from, to] = pins.map(|pin| self.moment.pin(pin));
        let way = minus(to, from);
        let square = dot(way, way).0;
        let distance = square[0].sqrt();
        [distance, 0.5 * square[1] / distance]
    }

    /// The effort of a spring and its energy.
    pub(super) fn spring(
        &mut self,
        Spring { ends, stiffness, free, damping }: &Spring,
    ) -> [f64; 2] {
        let [off, rate] = match ends {
            Ends::Pins(pins) => {
                let [distance, rate] = self.distance(*pins);
                [distance - free, rate]
            }
            Ends::Links(links) => {
                let angle = |link: &Option<usize>| {
                    link.map_or(Jet::still(0.0), |link| self.moment.angle(link))
                };
                let turned = angle(&links[1]) - angle(&links[0]);
                [within_half_a_turn(turned.0[0] - free), turned.0[1]]
            }
        };
        let effort = -stiffness * off - damping * rate;
        match ends {
            Ends::Pins(pins) => self.apart(*pins, effort),
            Ends::Links([from, to]) => {
                self.couple(*to, effort);
                self.couple(*from, -effort);
            }
        }
        [effort, 0.5 * stiffness * off * off]
    }

    /// The effort of a stop, the way to its nearer end, and its energy.
    pub(super) fn stop(
        &mut self,
        Stop { of, between: [from, to], stiffness, damping }: &Stop,
    ) -> [f64; 3] {
        let [at, rate] = match of {
            Stopped::Angle(link) => {
                let Jet([angle, rate, _]) = self.moment.angle(*link);
                let middle = 0.5 * (from + to);
                [middle + within_half_a_turn(angle - middle), rate]
            }
            Stopped::Slide(link) => {
                let Jet([slide, rate, _]) = self.moment.read(Read::Slide(*link));
                [slide, rate]
            }
            Stopped::Distance(pins) => self.distance(*pins),
        };
        let beyond = [from - at, at - to].map(|beyond| beyond.max(0.0));
        let pushed = match beyond {
            [low, _] if low > 0.0 => (stiffness * low - damping * rate).max(0.0),
            [_, high] if high > 0.0 => -(stiffness * high + damping * rate).max(0.0),
            _ => 0.0,
        };
        match of {
            Stopped::Angle(link) => self.couple(Some(*link), pushed),
            Stopped::Slide(link) => self.along_slide(*link, pushed),
            Stopped::Distance(pins) => self.apart(*pins, pushed),
        }
        let energy = beyond.map(|beyond| 0.5 * stiffness * beyond * beyond).iter().sum();
        [pushed, (at - from).min(to - at), energy]
    }

    /// The inertia and the weight of a mass; its mass, its kinetic and its potential energy.
    pub(super) fn mass(&mut self, mass: &Mass, gravity: [f64; 2]) -> [f64; 3] {
        let drawing = self.truth.drawing;
        let (site, mass, inertia, link) = match *mass {
            Mass::OnLink { link, mass, at, inertia } => {
                (Site::OnLink(link, at), mass, inertia, Some(link))
            }
            Mass::AtPin { link, mass, pin, inertia } => {
                (Site::OnLink(link, self.truth.local(link, pin)), mass, inertia, Some(link))
            }
            Mass::Uniform { link, mass } => {
                let [from, to] =
                    [0, 1].map(|end| self.truth.local(link, drawing.links[link].pins[end]));
                let way = [to[0] - from[0], to[1] - from[1]];
                let middle = [0, 1].map(|axis| 0.5 * (from[axis] + to[axis]));
                let inertia = mass * (way[0] * way[0] + way[1] * way[1]) / 12.0;
                (Site::OnLink(link, middle), mass, inertia, Some(link))
            }
            Mass::Inertia { link, inertia } => {
                (Site::OnLink(link, [0.0; 2]), 0.0, inertia, Some(link))
            }
            Mass::OnPin { pin, mass } => (Site::Pin(pin), mass, 0.0, None),
        };
        let place = self.place(site);
        let [at, rate, second] = [0, 1, 2].map(|order| values(place, order));
        self.force(site, [0, 1].map(|axis| mass * (gravity[axis] - second[axis])));
        let Jet([_, omega, alpha]) = link.map_or(Jet::still(0.0), |link| self.moment.angle(link));
        self.couple(link, -inertia * alpha);
        let kinetic = mass * (rate[0] * rate[0] + rate[1] * rate[1]) + inertia * omega * omega;
        [mass, 0.5 * kinetic, -mass * (gravity[0] * at[0] + gravity[1] * at[1])]
    }

    /// The effort of a friction of this size against the slip, by its slip.
    pub(super) fn rubbing(&mut self, friction: &Friction, size: f64) {
        match *friction {
            Friction::Pin { pin, .. } => {
                let links = self.truth.rubbing_links(pin);
                self.couple(links[0], size);
                self.couple(links[1], -size);
            }
            Friction::Guide { link, .. } => self.along_slide(link, size),
        }
    }

    pub(super) fn slip(&self, friction: &Friction) -> f64 {
        match *friction {
            Friction::Pin { pin, .. } => {
                let [a, b] = self
                    .truth
                    .rubbing_links(pin)
                    .map(|link| link.map_or(0.0, |link| self.moment.angle(link).0[1]));
                a - b
            }
            Friction::Guide { link, .. } => self.moment.read(Read::Slide(link)).0[1],
        }
    }
}
