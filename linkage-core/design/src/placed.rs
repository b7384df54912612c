//! Place, turn and size of a curve, which are linear in its least squares and need no search.

use linkage_core::Real;

/// The best place, turn and size of a curve among given points: a point (x, y) of the curve goes to
/// (`x` + `cos`·x − `sin`·y, `y` + `sin`·x + `cos`·y).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placement<T = f64> {
    /// Place of the curve's origin.
    pub x: T,
    /// Its other coordinate.
    pub y: T,
    /// Cosine of the turn, times the size.
    pub cos: T,
    /// Sine of the turn, times the size.
    pub sin: T,
}

impl<T: Real> Placement<T> {
    /// The place of a point of the curve.
    #[must_use]
    pub fn of(&self, [x, y]: [T; 2]) -> [T; 2] {
        [self.x + self.cos * x - self.sin * y, self.y + self.sin * x + self.cos * y]
    }
}

/// The placement by which the points of a curve come nearest to others, in the sum of squares. In complex
/// numbers about both centres it is Σ w̄ t / Σ w̄ w (Umeyama, IEEE PAMI 13, 1991, without reflections).
#[must_use]
pub fn placement<T: Real>(curve: &[[T; 2]], targets: &[[f64; 2]]) -> Placement<T> {
    let zero = T::num(0.0);
    let share = 1.0 / curve.len() as f64;
    let (mut from, mut to) = ([zero; 2], [0.0; 2]);
    for (w, t) in curve.iter().zip(targets) {
        for i in 0..2 {
            from[i] = from[i] + w[i] * T::num(share);
            to[i] += t[i] * share;
        }
    }
    let (mut re, mut im, mut size) = (zero, zero, zero);
    for (w, t) in curve.iter().zip(targets) {
        let [wx, wy] = [w[0] - from[0], w[1] - from[1]];
        let [tx, ty] = [T::num(t[0] - to[0]), T::num(t[1] - to[1])];
        re = re + wx * tx + wy * ty;
        im = im + wx * ty - wy * tx;
        size = size + wx * wx + wy * wy;
    }
    let (cos, sin) = (re / size, im / size);
    let x = T::num(to[0]) - (cos * from[0] - sin * from[1]);
    let y = T::num(to[1]) - (sin * from[0] + cos * from[1]);
    Placement { x, y, cos, sin }
}

/// Placed points less their targets.
pub(crate) fn remainders<T: Real>(curve: &[[T; 2]], targets: &[[f64; 2]]) -> Vec<[T; 2]> {
    let placement = placement(curve, targets);
    let one = |(w, t): (&[T; 2], &[f64; 2])| {
        let [x, y] = placement.of(*w);
        [x - T::num(t[0]), y - T::num(t[1])]
    };
    curve.iter().zip(targets).map(one).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_placed_curve_is_recovered() {
        let curve = [[0.0, 0.0], [1.0, 0.2], [1.5, 1.0], [0.3, 2.0]];
        let placed = Placement { x: 3.0, y: -1.0, cos: 1.2, sin: -0.7 };
        let targets = curve.map(|point| placed.of(point));
        let found = placement(&curve, &targets);
        let [a, b] = [found, placed].map(|p| [p.x, p.y, p.cos, p.sin]);
        assert!(a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-14), "{found:?}");
        assert!(remainders(&curve, &targets).as_flattened().iter().all(|r| r.abs() < 1e-14));
    }
}
