//! Lines on a body.

use crate::exact::Exact;

/// A directed line through a place.
#[derive(Clone)]
pub struct BodyLine {
    pub through: [Exact; 2],
    pub angle: Exact,
}

impl BodyLine {
    /// The distance of the place from the line, along its normal.
    pub(crate) fn distance(&self, [x, y]: &[Exact; 2]) -> Exact {
        let (dx, dy) = (x.sub(&self.through[0]), y.sub(&self.through[1]));
        dy.mul(&self.angle.cos()).sub(&dx.mul(&self.angle.sin()))
    }

    /// The place at `slide` along the line and `offset` along its normal.
    pub(crate) fn at(&self, slide: &Exact, offset: &Exact) -> [Exact; 2] {
        let (cos, sin) = (self.angle.cos(), self.angle.sin());
        [
            self.through[0].add(&slide.mul(&cos)).sub(&offset.mul(&sin)),
            self.through[1].add(&slide.mul(&sin)).add(&offset.mul(&cos)),
        ]
    }
}
