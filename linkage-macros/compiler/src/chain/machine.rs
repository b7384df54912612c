//! Bodies, joints and drives of a machine in the pose in which it is drawn.

use super::plane::Complex;

/// The body that does not move.
pub const GROUND: usize = 0;

#[derive(Clone, Debug, Default)]
pub struct Machine {
    /// The places of the pins in the drawing.
    pub pins: Vec<Complex>,
    /// The ground first.
    pub bodies: Vec<RigidBody>,
    pub slides: Vec<Slide>,
    pub drives: Vec<Driving>,
    /// The motions that are followed, one an input; none where the first drive is the only one.
    pub motions: Vec<InputRates>,
    /// True if a dimension depends on a parameter or an input.
    pub varies: bool,
    /// True if anything has mass or acts, so that what pushes in the joints is asked for.
    pub is_loaded: bool,
}

/// A rigid body. A pin of several bodies is a revolute joint between them.
#[derive(Clone, Debug, Default)]
pub struct RigidBody {
    pub pins: Vec<usize>,
    /// The bodies and pins from which the body follows by other means, where it is no body of the
    /// chain.
    pub given: Option<Footing>,
    /// The bodies on which its length depends.
    pub reads: Vec<usize>,
}

impl RigidBody {
    /// The pins that are there by the body, where it is given or the ground: all but those that it depends
    /// on.
    pub(crate) fn made(&self) -> impl Iterator<Item = usize> {
        let needs = self.given.as_ref();
        let is_own = move |pin: &usize| needs.is_none_or(|needs| !needs.pins.contains(pin));
        self.pins.iter().copied().filter(is_own)
    }
}

/// The bodies and pins that a given body depends on.
#[derive(Clone, Debug, Default)]
pub struct Footing {
    pub bodies: Vec<usize>,
    pub pins: Vec<usize>,
}

/// A prismatic joint: the body slides along a line of the carrier and does not turn against it.
#[derive(Clone, Copy, Debug)]
pub struct Slide {
    pub body: usize,
    pub carrier: usize,
    /// A point of the line.
    pub through: Complex,
    /// Its direction, of length one.
    pub along: Complex,
}

/// A driven joint: the angle or the slide of a body against another is given.
#[derive(Clone, Debug)]
pub struct Driving {
    pub kind: Driven,
    /// The body that is driven, and what it is driven against.
    pub bodies: [usize; 2],
    /// The bodies on which the given value depends.
    pub reads: Vec<usize>,
}

/// A motion from the drawing: what changes while an input changes by one.
#[derive(Clone, Debug, Default)]
pub struct InputRates {
    /// By drive.
    pub drives: Vec<f64>,
    /// The lengths of bars, by body.
    pub lengths: Vec<f64>,
    /// The angles of bodies that are given, about the first pin that they depend on.
    pub turns: Vec<f64>,
    /// The places of those that do not turn.
    pub shifts: Vec<Complex>,
}

impl InputRates {
    /// True if the input moves anything.
    pub(crate) fn moves(&self) -> bool {
        let rates = self.drives.iter().chain(&self.lengths).chain(&self.turns);
        rates.copied().any(|rate| rate != 0.0)
            || self.shifts.iter().any(|rate| rate.length() != 0.0)
    }
}

/// The drive that holds two bodies together, and the pin that it turns them about.
#[derive(Clone, Copy, Debug)]
pub struct Held {
    pub drive: usize,
    pub pivot: usize,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Driven {
    Angle,
    /// Along this slide.
    Slide(usize),
}

impl Machine {
    /// The bodies through a pin.
    pub fn at(&self, pin: usize) -> impl Iterator<Item = usize> {
        (0..self.bodies.len()).filter(move |&body| self.bodies[body].pins.contains(&pin))
    }

    pub(crate) fn is_given(&self, body: usize) -> bool {
        body == GROUND || self.bodies[body].given.is_some()
    }

    /// True if a body is given by means that depend on the pin.
    pub(crate) fn stands_on(&self, body: usize, pin: usize) -> bool {
        self.bodies[body].given.as_ref().is_some_and(|given| given.pins.contains(&pin))
    }

    /// The drive between two bodies that turns them about a pin of both.
    pub(crate) fn held(&self, [a, b]: [usize; 2]) -> Option<Held> {
        let is_between = |drive: &Driving| {
            drive.kind == Driven::Angle && (drive.bodies == [a, b] || drive.bodies == [b, a])
        };
        let drive = self.drives.iter().position(is_between)?;
        let pins = &self.bodies[a].pins;
        let pivot = pins.iter().copied().find(|pin| self.bodies[b].pins.contains(pin))?;
        Some(Held { drive, pivot })
    }

    /// True if all poses follow from the first drive.
    pub(crate) fn has_one_motion(&self) -> bool {
        !self.varies
            && self.motions.is_empty()
            && matches!(&self.drives[..], [drive] if drive.reads.is_empty())
    }

    /// The greatest distance between two pins along an axis: the size by which lengths are judged.
    pub fn size(&self) -> f64 {
        let extent = |of: fn(&Complex) -> f64| {
            let values = || self.pins.iter().map(of);
            values().fold(f64::NEG_INFINITY, f64::max) - values().fold(f64::INFINITY, f64::min)
        };
        extent(|pin| pin.x).max(extent(|pin| pin.y)).max(f64::MIN_POSITIVE)
    }
}
