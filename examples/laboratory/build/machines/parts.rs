//! The common parts of the machines: rails, rods, and words of their declarations.

use crate::random::Random;

use crate::{is, length};

/// A line of the ground, along x for every other.
pub(super) struct Rail {
    pub(super) origin: [f64; 2],
    pub(super) degrees: f64,
}

impl Rail {
    pub(super) fn draw(random: &mut Random) -> Self {
        let [x, y] = [length(random, -0.2, 0.3), length(random, -0.1, 0.1)];
        let degrees = if is(random) { 0.0 } else { random.between(-170.0, 170.0).round() };
        Self { origin: [x, y], degrees }
    }

    /// The signed distance of a point from it.
    pub(super) fn across(&self, [x, y]: [f64; 2]) -> f64 {
        let (sin, cos) = self.degrees.to_radians().sin_cos();
        (y - self.origin[1]) * cos - (x - self.origin[0]) * sin
    }

    pub(super) fn declared(&self) -> String {
        let ([x, y], degrees) = (self.origin, self.degrees);
        format!("guide rail through ({x:?}, {y:?}) along {degrees}deg;")
    }

    pub(super) fn form(&self) -> String {
        format!("Rail {{ origin: {:?}, direction: {} }}", self.origin, direction(self.degrees))
    }
}

/// Cosine and sine, exact for no angle.
pub(super) fn direction(degrees: f64) -> String {
    let (sin, cos) = degrees.to_radians().sin_cos();
    if degrees == 0.0 { "[1.0, 0.0]".to_owned() } else { format!("[{cos:?}, {sin:?}]") }
}

/// A bar to a block.
pub(super) struct Rod {
    pub(super) length: f64,
    pub(super) offset: f64,
    pub(super) is_ahead: bool,
}

impl Rod {
    pub(super) fn draw(random: &mut Random) -> Self {
        let offset = if is(random) { 0.0 } else { length(random, -0.1, 0.1) };
        Self { length: length(random, 0.15, 0.7), offset, is_ahead: is(random) }
    }

    /// True if the bar is not nearly across the line.
    pub(super) fn stands(&self, across: f64) -> bool {
        (self.offset - across).abs() <= self.length * 25_f64.to_radians().cos()
    }

    pub(super) fn declared(&self) -> String {
        let Self { length, offset, is_ahead } = self;
        format!("length: {length:?}, offset: {offset:?}, mode: {}", sense(*is_ahead))
    }

    pub(super) fn form(&self) -> String {
        let Self { length, offset, is_ahead } = self;
        format!("Rod {{ length: {length:?}, offset: {offset:?}, sense: {} }}", sign(*is_ahead))
    }
}

pub(super) fn sense(is_ahead: bool) -> &'static str {
    if is_ahead { "ahead" } else { "behind" }
}

pub(super) fn sign(is_plus: bool) -> &'static str {
    if is_plus { "1.0" } else { "-1.0" }
}
