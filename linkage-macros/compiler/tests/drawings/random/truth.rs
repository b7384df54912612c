//! The motion of a drawn machine by full matrices: three coordinates a link, two a joint, an equation for all that
//! joints and drives hold, and Newton's method on all of them at once.

use super::drawing::{Drawing, Frame, Place, Read, Value, within_half_a_turn};
use super::jet::{Jet, Vector, dot, minus, plus, turned};
use super::matrix::Matrix;

/// An equation that holds in every pose.
#[derive(Clone, Copy, Debug)]
pub(super) enum Equation {
    /// A link's pin is where its joint is, along x or y.
    Pin {
        link: usize,
        pin: usize,
        axis: usize,
    },
    /// The origin of a link keeps its distance from a guide.
    Beside {
        link: usize,
        guide: usize,
        drawn: f64,
    },
    /// A link does not turn against the guide on which it slides.
    Parallel {
        link: usize,
        guide: usize,
        drawn: f64,
    },
    Drive(usize),
}

pub(super) struct Truth<'a> {
    pub drawing: &'a Drawing,
    /// The links as drawn.
    frames: Vec<Frame>,
    /// The guides in the frames of what carries them.
    guides: Vec<Frame>,
    /// The first coordinate of each pin that is a joint.
    joints: Vec<Option<usize>>,
    pub equations: Vec<Equation>,
    count: usize,
}

/// A motion in a moment: inputs and coordinates with their rates.
#[derive(Clone, Debug)]
pub(super) struct Pose {
    pub inputs: Vec<Jet>,
    pub coordinates: Vec<Jet>,
    pub jacobian: Matrix,
    pub inverse: Matrix,
    pub is_positive: bool,
}

impl Pose {
    /// The number by which the equations' rounding errors are magnified.
    pub(super) fn condition(&self) -> f64 {
        self.jacobian.norm() * self.inverse.norm()
    }
}

/// The parts of a motion that are asked for.
pub(super) struct Moment<'a> {
    truth: &'a Truth<'a>,
    inputs: &'a [Jet],
    coordinates: &'a [Jet],
}

impl<'a> Truth<'a> {
    pub(super) fn of(drawing: &'a Drawing) -> Self {
        let frames: Vec<_> = (0..drawing.links.len()).map(|link| drawing.frame(link)).collect();
        let guides = (0..drawing.guides.len()).map(|guide| {
            let drawn = drawing.guide(guide);
            let Some(link) = drawing.guides[guide].of else { return drawn };
            Frame { at: frames[link].within(drawn.at), angle: drawn.angle - frames[link].angle }
        });
        let guides: Vec<_> = guides.collect();
        let (mut count, mut equations) = (3 * frames.len(), Vec::new());
        let mut joints = vec![None; drawing.pins.len()];
        for (pin, joint) in joints.iter_mut().enumerate() {
            let is_ground = drawing.is_ground(pin);
            let links = drawing.bodies_at(pin);
            if !is_ground && links.len() > 1 {
                *joint = Some(count);
                count += 2;
            }
            if is_ground || joint.is_some() {
                let pins = links.iter().flat_map(|&link| [0, 1].map(|axis| (link, axis)));
                equations.extend(pins.map(|(link, axis)| Equation::Pin { link, pin, axis }));
            }
        }
        for (link, frame) in frames.iter().enumerate() {
            for &guide in &drawing.links[link].on {
                let on = drawing.guide(guide);
                let [beside, parallel] = [on.within(frame.at)[1], frame.angle - on.angle];
                equations.push(Equation::Beside { link, guide, drawn: beside });
                equations.push(Equation::Parallel { link, guide, drawn: parallel });
            }
        }
        equations.extend((0..drawing.drives.len()).map(Equation::Drive));
        Self { drawing, frames, guides, joints, equations, count }
    }

    /// True if there are as many equations as coordinates.
    pub(super) fn is_square(&self) -> bool {
        self.equations.len() == self.count
    }

    /// The first coordinate of a joint.
    pub(super) fn joint(&self, pin: usize) -> Option<usize> {
        self.joints[pin]
    }

    pub(super) fn moment<'b>(&'b self, inputs: &'b [Jet], coordinates: &'b [Jet]) -> Moment<'b> {
        Moment { truth: self, inputs, coordinates }
    }

    /// The coordinates of a pin in the frame of a link through it.
    pub(super) fn local(&self, link: usize, pin: usize) -> [f64; 2] {
        match self.drawing.pins[pin].place {
            Place::OnLink(of, at) if of == link => at,
            _ => self.frames[link].within(self.drawing.place(pin)),
        }
    }

    fn drawn_coordinates(&self) -> Vec<f64> {
        let mut all = vec![0.0; self.count];
        for (link, frame) in self.frames.iter().enumerate() {
            all[3 * link..][..3].copy_from_slice(&[frame.at[0], frame.at[1], frame.angle]);
        }
        for (pin, first) in self.joints.iter().enumerate() {
            if let Some(first) = first {
                all[*first..][..2].copy_from_slice(&self.drawing.place(pin));
            }
        }
        all
    }

    /// The coordinates that an equation holds.
    fn held(&self, equation: Equation) -> Vec<usize> {
        let link = |link: usize| (0..3).map(move |part| 3 * link + part);
        let read = |read: Read| match read {
            Read::Input(_) => Vec::new(),
            Read::Angle(of) => vec![3 * of + 2],
            Read::Slide(of) => {
                let on = self.drawing.guides[self.drawing.links[of].on[0]].of;
                link(of).chain(on.into_iter().flat_map(link)).collect()
            }
        };
        match equation {
            Equation::Pin { link: of, pin, axis } => {
                link(of).chain(self.joints[pin].map(|first| first + axis)).collect()
            }
            Equation::Beside { link: of, guide, .. }
            | Equation::Parallel { link: of, guide, .. } => {
                let on = self.drawing.guides[guide].of;
                link(of).chain(on.into_iter().flat_map(link)).collect()
            }
            Equation::Drive(drive) => {
                let drive = &self.drawing.drives[drive];
                let against = drive.against.map(|link| 3 * link + 2);
                let mut held: Vec<_> = read(drive.driven).into_iter().chain(against).collect();
                held.extend(read(drive.value.of));
                held
            }
        }
    }

    /// The slopes of the equations over the coordinates.
    fn jacobian(&self, inputs: &[f64], coordinates: &[f64]) -> Matrix {
        let inputs: Vec<_> = inputs.iter().map(|&value| Jet::still(value)).collect();
        let mut moving: Vec<_> = coordinates.iter().map(|&value| Jet::still(value)).collect();
        let mut slopes = Matrix::zero(self.count);
        for (row, &equation) in self.equations.iter().enumerate() {
            for column in self.held(equation) {
                moving[column].0[1] = 1.0;
                let slope = self.moment(&inputs, &moving).opened(equation).0[1];
                slopes.parts[row * self.count + column] = slope;
                moving[column].0[1] = 0.0;
            }
        }
        slopes
    }

    /// By how much the equations do not hold, or the rates of that.
    pub(super) fn opened(&self, inputs: &[Jet], coordinates: &[Jet], order: usize) -> Vec<f64> {
        let moment = self.moment(inputs, coordinates);
        self.equations.iter().map(|&equation| moment.opened(equation).0[order]).collect()
    }

    /// The pose at these inputs that Newton's method reaches from these coordinates, and its rates.
    pub(super) fn pose(&self, inputs: &[Jet], near: &[f64]) -> Option<Pose> {
        let values: Vec<_> = inputs.iter().map(|input| input.0[0]).collect();
        let still: Vec<_> = values.iter().map(|&value| Jet::still(value)).collect();
        let mut found = near.to_vec();
        let mut is_closed = false;
        for _ in 0..12 {
            let moving: Vec<_> = found.iter().map(|&value| Jet::still(value)).collect();
            let jacobian = self.jacobian(&values, &found);
            let step = jacobian.solved(&self.opened(&still, &moving, 0))?;
            for (value, step) in found.iter_mut().zip(&step) {
                *value -= step;
            }
            let size = step.iter().fold(0.0_f64, |size, step| size.max(step.abs()));
            if is_closed {
                return self.moved(inputs, &found);
            }
            // Once more: what was quadratic is then at the rounding of the equations.
            is_closed = size < 1e-9;
        }
        None
    }

    fn moved(&self, inputs: &[Jet], at: &[f64]) -> Option<Pose> {
        let values: Vec<_> = inputs.iter().map(|input| input.0[0]).collect();
        let jacobian = self.jacobian(&values, at);
        let (inverse, is_positive) = jacobian.inverse()?;
        let mut coordinates: Vec<_> = at.iter().map(|&value| Jet::still(value)).collect();
        for order in [1, 2] {
            let rates = inverse.times(&self.opened(inputs, &coordinates, order));
            for (coordinate, rate) in coordinates.iter_mut().zip(rates) {
                coordinate.0[order] = -rate;
            }
        }
        Some(Pose { inputs: inputs.to_vec(), coordinates, jacobian, inverse, is_positive })
    }

    /// The pose that is drawn, moved to where all equations hold.
    pub(super) fn drawn(&self) -> Option<Pose> {
        let inputs: Vec<_> = self.drawing.drawn_inputs().into_iter().map(Jet::still).collect();
        self.pose(&inputs, &self.drawn_coordinates())
    }
}

impl Moment<'_> {
    pub(super) fn angle(&self, link: usize) -> Jet {
        self.coordinates[3 * link + 2]
    }

    fn origin(&self, link: usize) -> Vector {
        [self.coordinates[3 * link], self.coordinates[3 * link + 1]]
    }

    /// A place of a link by its coordinates in the link's frame.
    pub(super) fn on_link(&self, link: usize, at: Vector) -> Vector {
        plus(self.origin(link), turned(self.angle(link).cos_sin(), at))
    }

    /// A pin where a link has it.
    fn pin_of(&self, link: usize, pin: usize) -> Vector {
        let of = &self.truth.drawing.links[link];
        let mut at = self.truth.local(link, pin).map(Jet::still);
        if let Some(length) = of.length.filter(|_| of.pins[1] == pin) {
            at = [self.value(length), Jet::still(0.0)];
        }
        self.on_link(link, at)
    }

    pub(super) fn pin(&self, pin: usize) -> Vector {
        if let Some(first) = self.truth.joints[pin] {
            return [self.coordinates[first], self.coordinates[first + 1]];
        }
        match self.truth.drawing.bodies_at(pin)[..] {
            [link] if !self.truth.drawing.is_ground(pin) => self.pin_of(link, pin),
            _ => self.truth.drawing.place(pin).map(Jet::still),
        }
    }

    /// The point of a guide, and its angle.
    pub(super) fn guide(&self, guide: usize) -> (Vector, Jet) {
        let Frame { at, angle } = self.truth.guides[guide];
        let (at, angle) = (at.map(Jet::still), Jet::still(angle));
        match self.truth.drawing.guides[guide].of {
            Some(link) => (self.on_link(link, at), self.angle(link) + angle),
            None => (at, angle),
        }
    }

    /// The way of a link's origin along a guide and beside it.
    fn along(&self, link: usize, guide: usize) -> Vector {
        let (from, angle) = self.guide(guide);
        let [cos, sin] = angle.cos_sin();
        let way = minus(self.origin(link), from);
        [dot(way, [cos, sin]), dot(way, [sin * -1.0, cos])]
    }

    pub(super) fn read(&self, read: Read) -> Jet {
        match read {
            Read::Input(input) => self.inputs[input],
            Read::Angle(link) => self.angle(link),
            Read::Slide(link) => self.along(link, self.truth.drawing.links[link].on[0])[0],
        }
    }

    fn value(&self, Value { factor, of, constant }: Value) -> Jet {
        self.read(of) * factor + Jet::still(constant)
    }

    /// By how much an equation does not hold.
    fn opened(&self, equation: Equation) -> Jet {
        match equation {
            Equation::Pin { link, pin, axis } => self.pin_of(link, pin)[axis] - self.pin(pin)[axis],
            Equation::Beside { link, guide, drawn } => {
                self.along(link, guide)[1] - Jet::still(drawn)
            }
            Equation::Parallel { link, guide, drawn } => {
                self.angle(link) - self.guide(guide).1 - Jet::still(drawn)
            }
            Equation::Drive(drive) => {
                let drive = &self.truth.drawing.drives[drive];
                let against = drive.against.map_or(Jet::still(0.0), |link| self.angle(link));
                let opened = self.read(drive.driven) - against - self.value(drive.value);
                // Whole turns are none, and every pose is less than half a turn from where it is sought.
                let is_angle = matches!(drive.driven, Read::Angle(_));
                let turns =
                    if is_angle { opened.0[0] - within_half_a_turn(opened.0[0]) } else { 0.0 };
                opened - Jet::still(turns)
            }
        }
    }
}
