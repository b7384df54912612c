//! A machine as it is drawn: what its statements say, in numbers.

use std::f64::consts::TAU;

/// A generalised coordinate.
#[derive(Clone, Debug)]
pub(super) struct Input {
    pub name: String,
    pub is_angle: bool,
}

/// A point by name.
#[derive(Clone, Debug)]
pub(super) struct Pin {
    pub name: String,
    pub place: Place,
}

/// A place, by what states it.
#[derive(Clone, Copy, Debug)]
pub(super) enum Place {
    Ground([f64; 2]),
    /// Where it is drawn, and the parameter that moves it along x.
    Drawn([f64; 2], Option<usize>),
    /// Its coordinates in a link's frame.
    OnLink(usize, [f64; 2]),
}

#[derive(Clone, Debug)]
pub(super) struct Link {
    pub name: String,
    pub pins: Vec<usize>,
    pub on: Vec<usize>,
    /// The length of a bar that is given.
    pub length: Option<Value>,
}

#[derive(Clone, Copy, Debug)]
pub(super) enum Through {
    At([f64; 2]),
    Pin(usize),
}

#[derive(Clone, Copy, Debug)]
pub(super) enum Along {
    /// From the x of its body.
    Degrees(f64),
    Towards(usize),
}

#[derive(Clone, Debug)]
pub(super) struct Guide {
    pub name: String,
    /// The link that carries it, or the ground.
    pub of: Option<usize>,
    pub through: Through,
    pub along: Along,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Read {
    Input(usize),
    Angle(usize),
    Slide(usize),
}

/// A number times what it reads, and a constant beside it; of a length that nothing moves the number is zero.
#[derive(Clone, Copy, Debug)]
pub(super) struct Value {
    pub factor: f64,
    pub of: Read,
    pub constant: f64,
}

#[derive(Clone, Debug)]
pub(super) struct Drive {
    pub driven: Read,
    /// The link against whose angle it is.
    pub against: Option<usize>,
    pub value: Value,
}

/// A length that the declaration names.
#[derive(Clone, Debug)]
pub(super) struct Param {
    pub name: String,
    pub default: f64,
}

#[derive(Clone, Debug, Default)]
pub(super) struct Drawing {
    pub inputs: Vec<Input>,
    pub params: Vec<Param>,
    pub pins: Vec<Pin>,
    pub links: Vec<Link>,
    pub guides: Vec<Guide>,
    pub drives: Vec<Drive>,
}

/// A place and a direction.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Frame {
    pub at: [f64; 2],
    pub angle: f64,
}

impl Frame {
    /// The place of coordinates in this frame.
    pub(super) fn out(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let (sin, cos) = self.angle.sin_cos();
        [self.at[0] + x * cos - y * sin, self.at[1] + x * sin + y * cos]
    }

    /// The coordinates of a place in this frame.
    pub(super) fn within(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let (sin, cos) = self.angle.sin_cos();
        let [x, y] = [x - self.at[0], y - self.at[1]];
        [x * cos + y * sin, y * cos - x * sin]
    }
}

fn direction(from: [f64; 2], to: [f64; 2]) -> f64 {
    (to[1] - from[1]).atan2(to[0] - from[0])
}

pub(super) fn within_half_a_turn(angle: f64) -> f64 {
    angle - TAU * (angle / TAU).round()
}

impl Drawing {
    /// Where a pin is drawn.
    pub(super) fn place(&self, pin: usize) -> [f64; 2] {
        match self.pins[pin].place {
            Place::Ground(at) | Place::Drawn(at, None) => at,
            Place::Drawn([x, y], Some(param)) => [x + self.params[param].default, y],
            Place::OnLink(link, at) => self.frame(link).out(at),
        }
    }

    /// A link's frame in the drawing: at its first pin towards its second, or along its guide where it has one pin or none.
    pub(super) fn frame(&self, link: usize) -> Frame {
        let Link { pins, on, .. } = &self.links[link];
        match pins[..] {
            [first, second, ..] => {
                let [at, to] = [first, second].map(|pin| self.place(pin));
                Frame { at, angle: direction(at, to) }
            }
            [first] => Frame { at: self.place(first), ..self.guide(on[0]) },
            [] => self.guide(on[0]),
        }
    }

    /// A guide's point and direction in the drawing.
    pub(super) fn guide(&self, guide: usize) -> Frame {
        let Guide { of, through, along, .. } = &self.guides[guide];
        let body = of.map_or_else(Frame::default, |link| self.frame(link));
        let at = match *through {
            Through::At(at) => body.out(at),
            Through::Pin(pin) => self.place(pin),
        };
        let angle = match *along {
            Along::Degrees(degrees) => body.angle + degrees.to_radians(),
            Along::Towards(pin) => direction(at, self.place(pin)),
        };
        Frame { at, angle }
    }

    /// The value that is driven or read, in the drawing.
    pub(super) fn drawn(&self, read: Read) -> f64 {
        match read {
            Read::Input(input) => self.drawn_input(input),
            Read::Angle(link) => self.frame(link).angle,
            Read::Slide(link) => self.guide(self.links[link].on[0]).within(self.frame(link).at)[0],
        }
    }

    /// The value of a drive in the drawing: an angle within half a turn.
    pub(super) fn driven(&self, drive: &Drive) -> f64 {
        let drawn = self.drawn(drive.driven);
        drive
            .against
            .map_or(drawn, |link| within_half_a_turn(drawn - self.drawn(Read::Angle(link))))
    }

    fn drawn_input(&self, input: usize) -> f64 {
        let reads = |value: &Value| value.of == Read::Input(input) && value.factor != 0.0;
        let of_drives = self.drives.iter().filter(|drive| reads(&drive.value));
        let mut found = of_drives.map(|drive| (drive.value, self.driven(drive)));
        let mut of_lengths = self.links.iter().filter_map(|link| {
            let length = link.length.filter(reads)?;
            let [from, to] = [0, 1].map(|end| self.place(link.pins[end]));
            Some((length, (to[0] - from[0]).hypot(to[1] - from[1])))
        });
        let (value, drawn) = found.next().or_else(|| of_lengths.next()).expect("it drives");
        (drawn - value.constant) / value.factor
    }

    pub(super) fn drawn_inputs(&self) -> Vec<f64> {
        (0..self.inputs.len()).map(|input| self.drawn_input(input)).collect()
    }

    /// The links through a pin, but for the one that a declared point lies on.
    pub(super) fn links_at(&self, pin: usize) -> Vec<usize> {
        (0..self.links.len()).filter(|&link| self.links[link].pins.contains(&pin)).collect()
    }

    /// The links that move with a pin: those through it, and the one that it is declared on.
    pub(super) fn bodies_at(&self, pin: usize) -> Vec<usize> {
        let mut bodies = self.links_at(pin);
        if let Place::OnLink(link, _) = self.pins[pin].place {
            bodies.push(link);
        }
        bodies
    }

    pub(super) fn is_ground(&self, pin: usize) -> bool {
        matches!(self.pins[pin].place, Place::Ground(_))
    }
}
