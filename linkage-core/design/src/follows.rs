//! Outputs that can follow a function, and poses to pass.

use linkage_core::{Direction, SlidingDirection};

use crate::rows::Dual;

/// An output that can follow a function: a number, or a direction by its angle.
pub trait Follows<const N: usize> {
    /// The output less the wanted number; of an angle the difference in (−π, π].
    fn ahead_of(self, wanted: f64) -> Dual<N>;
}

impl<const N: usize> Follows<N> for Dual<N> {
    fn ahead_of(self, wanted: f64) -> Dual<N> {
        self - wanted
    }
}

impl<const N: usize> Follows<N> for Direction<Dual<N>> {
    fn ahead_of(self, wanted: f64) -> Dual<N> {
        self.angle_from(Direction::from_angle(Dual::from_re(wanted)))
    }
}

impl<const N: usize> Follows<N> for SlidingDirection<Dual<N>> {
    fn ahead_of(self, wanted: f64) -> Dual<N> {
        Direction::from(self).ahead_of(wanted)
    }
}

/// A pose that a link shall pass.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose {
    /// A point of the link, in metres.
    pub x: f64,
    /// Its other coordinate.
    pub y: f64,
    /// The angle of the link in radians.
    pub angle: f64,
}
