//! The four-bar and its coupler curves.

use std::f64::consts::TAU;

use linkage_core::{LengthMismatch, Point, Side, Status, mechanism, unwanted};

mechanism! {
    /// A four-bar whose crank is the unit of length. Coupler, follower and ground are the atlas's A, B, C.
    pub struct FourBar {
        input theta: angle;

        param coupler = 3m;
        param follower = 3.5m;
        param base = 2m;
        param p_x = 1.5m;
        param p_y = 0.5m;
        param branch: mode = left;

        ground A(0, 0), D(base, 0);

        crank AB(A) -> B        { length: 1m, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (coupler, follower), mode: branch }

        point P on BC at (p_x, p_y);
        output P, B, C;
    }
}

/// One curve: the lengths of the links by that of the crank, and the place of the coupler point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dimensions {
    /// A, between the coupler's pins.
    pub coupler: f64,
    /// B, between the follower's.
    pub follower: f64,
    /// C, between the pivots.
    pub base: f64,
    /// The coupler point from the crank's pin towards the follower's.
    pub along: f64,
    /// The coupler point to the left of that line.
    pub across: f64,
    /// On which side of the line from the crank's pin to the follower's pivot the follower's pin is.
    pub branch: Side,
}

impl Dimensions {
    /// The solver for these dimensions.
    #[must_use]
    pub fn four_bar(&self) -> FourBar {
        let Self { coupler, follower, base, along: p_x, across: p_y, branch } = *self;
        FourBar { coupler, follower, base, p_x, p_y, branch }
    }

    /// The four-bar seen in a mirror on its line of pivots: the other branch, and the coupler point on the
    /// coupler's other side.
    #[must_use]
    pub fn mirrored(self) -> Self {
        Self { across: -self.across, branch: self.branch.flipped(), ..self }
    }
}

/// Coupler curves of so many poses, one after the other in the same slices.
#[derive(Clone, Debug)]
pub struct Tracer {
    angles: Vec<f64>,
    /// The coordinates of the coupler point at each pose of the curve that was traced last.
    pub x: Vec<f64>,
    /// See [`x`](Self::x).
    pub y: Vec<f64>,
    status: Vec<Status>,
}

impl Tracer {
    /// For curves of so many poses in equal steps of the crank over one turn.
    #[must_use]
    pub fn new(poses: u32) -> Self {
        let angles: Vec<f64> = (0..poses).map(|k| TAU * f64::from(k) / f64::from(poses)).collect();
        let count = angles.len();
        let numbers = vec![0.0; count];
        Self { angles, x: numbers.clone(), y: numbers, status: vec![Status::Solved; count] }
    }

    /// The number of poses of a curve.
    #[must_use]
    pub fn poses(&self) -> usize {
        self.angles.len()
    }

    /// Traces the coupler point through a turn of the crank, by one sweep. Tells whether every pose could
    /// be assembled.
    ///
    /// # Errors
    /// Never: all slices are of one length.
    pub fn trace(&mut self, dimensions: &Dimensions) -> Result<bool, LengthMismatch> {
        let Self { angles, x, y, status } = self;
        let out = FourBarPosition { P: Point { x: &mut x[..], y: &mut y[..] }, ..unwanted() };
        dimensions.four_bar().sweep_position(&angles[..], out, status, ())?;
        Ok(status.iter().all(|&pose| pose == Status::Solved))
    }
}
