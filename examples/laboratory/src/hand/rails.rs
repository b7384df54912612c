//! Blocks and yokes on rails of the ground.
//!
//! With a bar from B of length l, the offset e from the rail and y = (B − K)·n,
//!
//! ```text
//! t = e − y     X = ± √((l − t)(l + t))     r = X u + t n     slide = (B − K)·u + X
//! ω = −v·n/X    α = (ω² t − a·n)/X          ṡ = v·u − ω t     s̈ = a·u − α t − ω² X
//! ```
//!
//! and 1/X = X · (1/X²), so that the division runs beside the root. Behind a crank v and a are products
//! with two numbers, its arm along the rail and across.

use super::fused;
use super::plane::{Bar, Moving, Vector};

/// A line of the ground: its origin and its direction, constants both.
#[derive(Clone, Copy, Debug)]
pub struct Rail {
    /// In m.
    pub origin: [f64; 2],
    /// A unit vector.
    pub direction: [f64; 2],
}

/// A slide and its rates.
#[derive(Clone, Copy, Debug)]
pub struct Slide {
    /// In m.
    pub value: f64,
    /// In m/s.
    pub rate: f64,
    /// In m/s².
    pub second: f64,
}

/// A bar to a block on a line.
#[derive(Clone, Copy, Debug)]
pub struct Rod {
    /// In m.
    pub length: f64,
    /// The block's, from the line, in m.
    pub offset: f64,
    /// +1 where the block is ahead of the bar's joint, −1 behind it.
    pub sense: f64,
}

/// A point seen from a line: along it and across, its velocity and its acceleration.
#[derive(Clone, Copy, Debug)]
pub struct Seen {
    /// In m.
    pub place: [f64; 2],
    /// In m/s.
    pub velocity: [f64; 2],
    /// In m/s².
    pub acceleration: [f64; 2],
}

impl Rail {
    /// A vector along the rail and across it.
    #[inline(always)]
    fn parts(self, Vector { x, y }: Vector) -> [f64; 2] {
        match self.direction {
            [1.0, 0.0] => [x, y],
            [ux, uy] => [fused(ux, x, uy * y), fused(ux, y, -(uy * x))],
        }
    }

    /// The vector of these parts.
    #[inline(always)]
    pub(super) fn vector(self, [along, across]: [f64; 2]) -> Vector {
        match self.direction {
            [1.0, 0.0] => Vector { x: along, y: across },
            [ux, uy] => {
                Vector { x: fused(along, ux, -(across * uy)), y: fused(along, uy, across * ux) }
            }
        }
    }

    /// The pin of a block: with its slide, where the rail is.
    #[inline(always)]
    #[must_use]
    pub fn pin(self, offset: f64, slide: Slide) -> Moving {
        let at = self.vector([slide.value, offset]);
        let [x, y] = self.origin;
        Moving {
            position: Vector { x: x + at.x, y: y + at.y },
            velocity: self.vector([slide.rate, 0.0]),
            acceleration: self.vector([slide.second, 0.0]),
        }
    }

    #[inline(always)]
    fn start(self) -> [f64; 2] {
        let [x, y] = self.origin;
        self.parts(Vector { x, y })
    }

    /// A point that moves.
    #[inline(always)]
    #[must_use]
    pub fn sees(self, point: Moving) -> Seen {
        let ([x, y], [sx, sy]) = (self.parts(point.position), self.start());
        Seen {
            place: [x - sx, y - sy],
            velocity: self.parts(point.velocity),
            acceleration: self.parts(point.acceleration),
        }
    }

    /// The pin of a crank on the origin of the ground's axes, from its cosine and sine and its rates.
    #[inline(always)]
    #[must_use]
    pub fn sees_crank(self, crank: f64, [cos, sin]: [f64; 2], [omega, alpha]: [f64; 2]) -> Seen {
        let ([ux, uy], [sx, sy]) = (self.direction, self.start());
        // The products of the crank with the direction are constants.
        let [along, across] = match self.direction {
            [1.0, 0.0] => [crank * cos, crank * sin],
            _ => [
                fused(crank * ux, cos, crank * uy * sin),
                fused(crank * ux, sin, -(crank * uy * cos)),
            ],
        };
        let square = omega * omega;
        Seen {
            place: [along - sx, across - sy],
            velocity: [-(omega * across), omega * along],
            acceleration: [
                fused(-square, along, -(alpha * across)),
                fused(alpha, along, -(square * across)),
            ],
        }
    }
}

impl Rod {
    /// X, t, ω, α of the bar against the line and the block's slide; none out of reach.
    #[inline(always)]
    pub(super) fn solve(self, seen: Seen) -> Option<([f64; 2], [f64; 2], Slide)> {
        let Self { length, offset, sense } = self;
        let t = offset - seen.place[1];
        let square = (length - t) * (length + t);
        if !(square > 0.0) {
            return None;
        }
        let x = sense * square.sqrt();
        let inverse = x * (1.0 / square);
        let omega = -(seen.velocity[1] * inverse);
        let p = omega * omega;
        let alpha = fused(p, t, -seen.acceleration[1]) * inverse;
        let slide = Slide {
            value: seen.place[0] + x,
            rate: fused(-omega, t, seen.velocity[0]),
            second: fused(-p, x, fused(-alpha, t, seen.acceleration[0])),
        };
        Some(([x, t], [omega, alpha], slide))
    }

    /// The bar and the block on a rail; none out of reach.
    #[inline(always)]
    #[must_use]
    pub fn on_rail(self, rail: Rail, seen: Seen) -> Option<(Bar, Slide)> {
        let (parts, [omega, alpha], slide) = self.solve(seen)?;
        Some((Bar { r: rail.vector(parts), length: self.length, omega, alpha }, slide))
    }
}

/// The slides of a yoke on a rail and of the block in its slot, which stands at the angle with this cosine
/// and sine to the rail: all is linear in what the rail sees of the block's pin.
#[inline(always)]
#[must_use]
pub fn yoke(seen: Seen, [cos, sin]: [f64; 2], [e1, e2]: [f64; 2]) -> [Slide; 2] {
    let inverse = 1.0 / sin;
    let both = |[x, y]: [f64; 2], [x0, y0]: [f64; 2]| {
        let block = (y - y0) * inverse;
        [fused(-block, cos, x + x0), block]
    };
    let [value, block] = both(seen.place, [e2 * sin, fused(e2, cos, e1)]);
    let [rate, block_rate] = both(seen.velocity, [0.0; 2]);
    let [second, block_second] = both(seen.acceleration, [0.0; 2]);
    [Slide { value, rate, second }, Slide { value: block, rate: block_rate, second: block_second }]
}
