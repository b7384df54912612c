//! Frames of links and lines of guides in the drawing.
//!
//! A link's frame is that of its statement, whatever group it ends in: its origin is its first pin,
//! and its x points towards its second, or along its guide where it has one pin.

use crate::model::figures::{self, Figure};

/// Where a frame begins.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Origin {
    Ground,
    Pin(usize),
    /// A point of the guide.
    Guide(usize),
}

/// Where its x points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Heading {
    X,
    Pins(usize, usize),
    Guide(usize),
}

/// The frame of a link in the drawing.
#[derive(Clone)]
pub struct DrawnFrame {
    pub begins: Origin,
    pub points: Heading,
    pub origin: [Figure; 2],
    /// Not of length one.
    pub axis: [Figure; 2],
}

/// The line of a guide in the drawing.
#[derive(Clone)]
pub struct DrawnLine {
    pub through: [Figure; 2],
    /// Not of length one.
    pub along: [Figure; 2],
    pub points: Heading,
    /// The angle that it is given by, from the frame of its body.
    pub angle: Option<f64>,
}

impl DrawnLine {
    pub(in crate::model::drawn) fn unknown(zero: Figure) -> Self {
        let zero = [zero.clone(), zero];
        Self { through: zero.clone(), along: zero, points: Heading::X, angle: None }
    }
}

impl DrawnFrame {
    pub(in crate::model::drawn) fn ground() -> Self {
        Self {
            begins: Origin::Ground,
            points: Heading::X,
            origin: [Figure::zero(), Figure::zero()],
            axis: figures::x_axis(),
        }
    }

    /// Whether the other is the same frame, whatever the parameters are.
    pub(in crate::model::drawn) fn is(&self, other: &Self) -> bool {
        self.begins == other.begins && self.points == other.points
    }

    /// The place in this frame.
    pub(in crate::model::drawn) fn local(&self, place: &[Figure; 2]) -> [Figure; 2] {
        let from_origin = figures::minus(place, &self.origin);
        match self.points {
            Heading::X => from_origin,
            _ => figures::seen_from(&self.axis, &from_origin),
        }
    }

    /// The vector in the axes of this frame, not of its own length.
    pub(in crate::model::drawn) fn local_direction(&self, vector: &[Figure; 2]) -> [Figure; 2] {
        match self.points {
            Heading::X => vector.clone(),
            _ => [figures::dot(&self.axis, vector), figures::cross(&self.axis, vector)],
        }
    }

    /// True if its origin or its direction is that of the pin.
    pub(in crate::model::drawn) fn stands_on(&self, pin: usize) -> bool {
        let heads = matches!(self.points, Heading::Pins(from, to) if from == pin || to == pin);
        heads || self.begins == Origin::Pin(pin)
    }

    /// The place in the drawing of coordinates in this frame.
    pub(in crate::model::drawn) fn placed(&self, local: &[Figure; 2]) -> [Figure; 2] {
        figures::plus(&self.origin, &self.direction(local))
    }

    /// The vector in the drawing of components in this frame.
    pub(in crate::model::drawn) fn direction(&self, local: &[Figure; 2]) -> [Figure; 2] {
        match self.points {
            Heading::X => local.clone(),
            _ => figures::seen_in_ground(&self.axis, local),
        }
    }
}
