//! The plane of a drawing in space.

use clap::ValueEnum;

/// The axes of space along which the drawing's x and y lie.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(crate) enum Plane {
    /// x to the right, z up; an angle is about −y.
    #[default]
    Xz,
    /// x and y; an angle is about z.
    Xy,
    /// y to the right, z up; an angle is about x.
    Yz,
}

impl Plane {
    /// A vector of the drawing in space.
    pub(super) fn space(self, [x, y]: [f64; 2]) -> [f64; 3] {
        match self {
            Self::Xz => [x, 0.0, y],
            Self::Xy => [x, y, 0.0],
            Self::Yz => [0.0, x, y],
        }
    }

    /// The axis about which angles are counter-clockwise.
    pub(super) fn axis(self) -> [f64; 3] {
        match self {
            Self::Xz => [0.0, -1.0, 0.0],
            Self::Xy => [0.0, 0.0, 1.0],
            Self::Yz => [1.0, 0.0, 0.0],
        }
    }

    /// A turn as a quaternion.
    pub(super) fn turn(self, angle: f64) -> [f64; 4] {
        let [x, y, z] = self.axis().map(|part| part * (angle / 2.0).sin());
        [(angle / 2.0).cos(), x, y, z]
    }
}
