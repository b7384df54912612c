//! The difference in shape of two closed curves, whatever their place, size, turn and mirroring, and whatever
//! the point and the direction in which they are run through.
//!
//! # Descriptors
//! A curve is a closed polygon z(t), a complex number over the share t of its length, from 0 to 1. Its Fourier
//! coefficients cₖ, for k = ±1 … ±[`HARMONICS`], are known exactly: each side contributes in closed form (F. P.
//! Kuhl and C. R. Giardina, "Elliptic Fourier Features of a Closed Contour", 1982). Leaving c₀ out makes them
//! the same wherever the curve lies, and dividing them by √Σ|cₖ|² however large it is. A turn by ψ
//! multiplies all of them by e^{iψ}, another starting point multiplies cₖ by e^{ikτ}, the other direction
//! exchanges cₖ and c₋ₖ, and a mirror makes c₋ₖ's conjugate of cₖ.
//!
//! # Distance
//! √Σ|tₖ − e^{i(ψ+kτ)} cₖ|², at the ψ and τ and in the direction and the mirror where it is least. By Parseval's
//! theorem this is the root mean square of the distances between points at equal shares of the two
//! curves, laid onto each other, in units of the curve's own root mean square distance from its centre: 0
//! for curves of one shape, 0.05 for curves that are apart by a twentieth of their size, √2 at most.
//!
//! With hₖ = t̄ₖcₖ the distance is √(2 − 2|Σ hₖe^{ikτ}|) at the best ψ. Turn and start aside, it cannot be
//! less than √Σ(|tₖ| − |cₖ|)², which costs nothing beside it: see [`Descriptor::bound`].

use std::f64::consts::TAU;
use std::ops::{Add, Mul, Sub};

use linkage_core::{Lanes, Scalar};

/// So many harmonics on each side of 0: a coupler curve is of order six, and a corner still shows.
pub const HARMONICS: usize = 12;

/// The number of lanes: two vectors of 256 bits.
const WIDTH: usize = 8;
type Vector = Lanes<f64, WIDTH>;

/// A complex number: a point or a coefficient.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Complex {
    /// Real part, x.
    pub re: f64,
    /// Imaginary part, y.
    pub im: f64,
}

impl Complex {
    /// e^{iφ}.
    #[must_use]
    pub fn turn(angle: f64) -> Self {
        let (im, re) = angle.sin_cos();
        Self { re, im }
    }

    /// Mirrored on the real axis.
    #[must_use]
    pub fn conjugate(self) -> Self {
        Self { im: -self.im, ..self }
    }

    /// The square of the distance from 0.
    #[must_use]
    pub fn square(self) -> f64 {
        self.re * self.re + self.im * self.im
    }

    fn scaled(self, by: f64) -> Self {
        Self { re: self.re * by, im: self.im * by }
    }
}

impl Add for Complex {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self { re: self.re + other.re, im: self.im + other.im }
    }
}

impl Sub for Complex {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self { re: self.re - other.re, im: self.im - other.im }
    }
}

impl Mul for Complex {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let re = self.re * other.re - self.im * other.im;
        Self { re, im: self.re * other.im + self.im * other.re }
    }
}

/// The coefficients of a curve, of square sum 1, and what was taken out of them.
#[derive(Clone, Copy, Debug)]
pub struct Descriptor {
    /// c₁, c₂, …
    ahead: [Complex; HARMONICS],
    /// c₋₁, c₋₂, …
    back: [Complex; HARMONICS],
    /// |c₁|, … and |c₋₁|, …
    sizes: [[f64; HARMONICS]; 2],
    /// √Σ|cₖ|² before it was divided out.
    size: f64,
    /// c₀, the centre of the curve as of a wire.
    centre: Complex,
}

/// The placement of one curve onto another: mirrored on the real axis or not, then turned, scaled and moved.
#[derive(Clone, Copy, Debug)]
pub struct Placement {
    mirrored: bool,
    factor: Complex,
    offset: Complex,
}

impl Placement {
    /// True if the curve is mirrored.
    #[must_use]
    pub fn is_mirrored(&self) -> bool {
        self.mirrored
    }

    /// By how much lengths grow.
    #[must_use]
    pub fn scale(&self) -> f64 {
        self.factor.square().sqrt()
    }

    /// Where a point goes.
    #[must_use]
    pub fn place(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let point = Complex { re: x, im: if self.mirrored { -y } else { y } };
        let placed = self.factor * point + self.offset;
        [placed.re, placed.im]
    }
}

/// The alignment of one curve's coefficients with another's: exchanged or not, conjugated or not, then
/// multiplied by e^{i(ψ+kτ)}.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Alignment {
    /// cₖ and c₋ₖ change places.
    pub(crate) swapped: bool,
    /// Each becomes its conjugate.
    pub(crate) mirrored: bool,
    /// e^{iψ}.
    pub(crate) turn: Complex,
    /// τ.
    pub(crate) shift: f64,
}

/// Describes curves, one after the other with the same memory.
#[derive(Clone, Debug, Default)]
pub struct Describer {
    /// For each corner, by the lane: e^{iφ} for its share φ of a turn, the power of it that is summed, and
    /// the change of direction there.
    unit: Vec<[Vector; 2]>,
    power: Vec<[Vector; 2]>,
    bend: Vec<[Vector; 2]>,
    lengths: Vec<f64>,
    directions: Vec<[f64; 2]>,
}

impl Describer {
    /// The descriptor of the closed polygon through these points; none where it has no length or is not finite.
    pub fn describe(&mut self, x: &[f64], y: &[f64]) -> Option<Descriptor> {
        let (perimeter, centre) = self.sides(x, y)?;
        self.corners(perimeter);
        let (mut ahead, mut back) =
            ([Complex::default(); HARMONICS], [Complex::default(); HARMONICS]);
        let mut square = 0.0;
        for (k, (ahead, back)) in (1_u32..).zip(ahead.iter_mut().zip(&mut back)) {
            let [cx, sy, cy, sx] = self.sums();
            // −T/(4π²k²) times the sums of bends by e^{∓ikφ}.
            let factor = -perimeter / (TAU * f64::from(k)).powi(2);
            *ahead = Complex { re: cx + sy, im: cy - sx }.scaled(factor);
            *back = Complex { re: cx - sy, im: cy + sx }.scaled(factor);
            square += ahead.square() + back.square();
        }
        let size = square.sqrt();
        if !(size > 0.0 && size.is_finite()) {
            return None;
        }
        let [ahead, back] = [ahead, back].map(|side| side.map(|c| c.scaled(1.0 / size)));
        let sizes = [ahead, back].map(|side| side.map(|c| c.square().sqrt()));
        Some(Descriptor { ahead, back, sizes, size, centre })
    }

    /// Lengths and directions of the sides. Their sum, and the centre.
    fn sides(&mut self, x: &[f64], y: &[f64]) -> Option<(f64, Complex)> {
        self.lengths.clear();
        self.directions.clear();
        let next = |values: &[f64], k: usize| values.get(k + 1).or(values.first()).copied();
        let mut moment = Complex::default();
        for (k, (&x0, &y0)) in x.iter().zip(y).enumerate() {
            let (x1, y1) = (next(x, k)?, next(y, k)?);
            let (dx, dy) = (x1 - x0, y1 - y0);
            let length = (dx * dx + dy * dy).sqrt();
            // A side of no length has no direction, and what it is taken for does not matter.
            let inverse = if length > 0.0 { 1.0 / length } else { 0.0 };
            self.lengths.push(length);
            self.directions.push([dx * inverse, dy * inverse]);
            moment = moment + Complex { re: x0 + x1, im: y0 + y1 }.scaled(length / 2.0);
        }
        let perimeter: f64 = self.lengths.iter().sum();
        (perimeter > 0.0 && perimeter.is_finite())
            .then(|| (perimeter, moment.scaled(1.0 / perimeter)))
    }

    /// Where the corners are on the way round, and how the direction changes there.
    fn corners(&mut self, perimeter: f64) {
        let count = self.lengths.len();
        let (mut run, mut last) = (0.0, self.directions[count - 1]);
        self.unit.clear();
        self.power.clear();
        self.bend.clear();
        for first in (0..count).step_by(WIDTH) {
            // Lanes that are left over bend by nothing.
            let (mut angle, mut bend) = ([0.0; WIDTH], [[0.0; WIDTH]; 2]);
            for (lane, corner) in (first..count.min(first + WIDTH)).enumerate() {
                angle[lane] = run * (TAU / perimeter);
                let [x, y] = self.directions[corner];
                (bend[0][lane], bend[1][lane]) = (x - last[0], y - last[1]);
                run += self.lengths[corner];
                last = [x, y];
            }
            let (sin, cos) = Vector::new(angle).sin_cos_near();
            self.unit.push([cos, sin]);
            self.power.push([Vector::splat(1.0), Vector::splat(0.0)]);
            self.bend.push(bend.map(Vector::new));
        }
    }

    /// Σ cos·x, Σ sin·y, Σ cos·y and Σ sin·x over the corners, for the next harmonic and the bends (x, y).
    fn sums(&mut self) -> [f64; 4] {
        let mut sums = [Vector::splat(0.0); 4];
        for ((unit, power), bend) in self.unit.iter().zip(&mut self.power).zip(&self.bend) {
            let ([c, s], [pc, ps], [x, y]) = (*unit, *power, *bend);
            let (cos, sin) = (pc * c - ps * s, pc * s + ps * c);
            *power = [cos, sin];
            let [cx, sy, cy, sx] = sums;
            sums = [cx + cos * x, sy + sin * y, cy + cos * y, sx + sin * x];
        }
        sums.map(|sum| sum.to_array().iter().sum())
    }
}

impl Descriptor {
    /// The coefficient of a harmonic, in the curve's own unit; none of 0 and of those beyond [`HARMONICS`].
    #[must_use]
    pub fn coefficient(&self, k: i32) -> Option<Complex> {
        let side = if k > 0 { &self.ahead } else { &self.back };
        let nth = usize::try_from(k.unsigned_abs()).ok()?.checked_sub(1)?;
        side.get(nth).map(|c| c.scaled(self.size))
    }

    /// A number that the distance is not below, to within rounding.
    #[must_use]
    pub fn bound(&self, other: &Self) -> f64 {
        let [t, c] = [&self.sizes, &other.sizes];
        let apart = |side: usize, other: usize| -> f64 {
            t[side].iter().zip(&c[other]).map(|(t, c)| (t - c) * (t - c)).sum()
        };
        let straight = apart(0, 0) + apart(1, 1);
        straight.min(apart(0, 1) + apart(1, 0)).sqrt()
    }

    /// c₁, c₂, … and c₋₁, c₋₂, …, of square sum 1.
    pub(crate) fn sides(&self) -> [[Complex; HARMONICS]; 2] {
        [self.ahead, self.back]
    }

    /// The distance to the other curve, and how that one is laid onto this one.
    #[must_use]
    pub fn distance(&self, other: &Self) -> (f64, Placement) {
        let (square, Alignment { mirrored, turn, .. }) = self.aligned(other);
        let factor = turn.scaled(self.size / other.size);
        let centre = if mirrored { other.centre.conjugate() } else { other.centre };
        let offset = self.centre - factor * centre;
        (square.sqrt(), Placement { mirrored, factor, offset })
    }

    /// The square of the distance, and the alignment that makes it least.
    pub(crate) fn aligned(&self, other: &Self) -> (f64, Alignment) {
        let conjugate = |side: [Complex; HARMONICS]| side.map(Complex::conjugate);
        let Self { ahead, back, .. } = *other;
        let ways = [
            (false, false, [ahead, back]),
            // Run through the other way.
            (true, false, [back, ahead]),
            (true, true, [conjugate(back), conjugate(ahead)]),
            (false, true, [conjugate(ahead), conjugate(back)]),
        ];
        let laid = ways.map(|(swapped, mirrored, sides)| {
            let (square, turn, shift) = self.laid_onto(&sides);
            (square, Alignment { swapped, mirrored, turn, shift })
        });
        let [first, rest @ ..] = laid;
        rest.into_iter().fold(first, |one, two| if two.0 < one.0 { two } else { one })
    }

    /// The square of the distance over all turns and starting points, the turn and the start.
    fn laid_onto(&self, other: &[[Complex; HARMONICS]; 2]) -> (f64, Complex, f64) {
        let product = |t: &[Complex; HARMONICS], c: &[Complex; HARMONICS]| {
            let mut h = *c;
            h.iter_mut().zip(t).for_each(|(h, t)| *h = t.conjugate() * *h);
            h
        };
        let h = [product(&self.ahead, &other[0]), product(&self.back, &other[1])];
        let shift = best_shift(&h);
        let sum = correlation(&h, shift);
        let size = sum.square().sqrt();
        let turn = if size > 0.0 {
            sum.conjugate().scaled(1.0 / size)
        } else {
            Complex { re: 1.0, im: 0.0 }
        };
        // Summed rather than taken from 2 − 2|Σh|, which cancels where the curves are the same.
        let step = Complex::turn(shift);
        let (mut square, mut by) = (0.0, Complex { re: 1.0, im: 0.0 });
        let ahead = self.ahead.iter().zip(&other[0]);
        for ((&t1, &c1), (&t2, &c2)) in ahead.zip(self.back.iter().zip(&other[1])) {
            by = by * step;
            square += (t1 - turn * by * c1).square();
            square += (t2 - turn * by.conjugate() * c2).square();
        }
        (square, turn, shift)
    }
}

/// Σ hₖe^{ikτ}.
fn correlation([ahead, back]: &[[Complex; HARMONICS]; 2], shift: f64) -> Complex {
    let step = Complex::turn(shift);
    let (mut sum, mut by) = (Complex::default(), Complex { re: 1.0, im: 0.0 });
    for (ahead, back) in ahead.iter().zip(back) {
        by = by * step;
        sum = sum + *ahead * by + *back * by.conjugate();
    }
    sum
}

/// Where |Σ hₖe^{ikτ}| is largest.
///
/// Its square is a trigonometric polynomial of degree 2·[`HARMONICS`], with as many maxima at most; eight
/// samples for each of them find the highest, and [`top`] its place.
fn best_shift(h: &[[Complex; HARMONICS]; 2]) -> f64 {
    const SAMPLES: u32 = 16 * HARMONICS as u32;
    let step = TAU / f64::from(SAMPLES);
    let at = |shift: f64| correlation(h, shift).square();
    let mut best = (f64::NEG_INFINITY, 0.0);
    for k in 0..SAMPLES {
        let shift = step * f64::from(k);
        let value = at(shift);
        if value > best.0 {
            best = (value, shift);
        }
    }
    top(h, best.1, step)
}

/// The top of |Σ hₖe^{ikτ}|² within a step of `start`: Newton's method on its slope, which is quadratic next to
/// a top; a step that leads out of the stretch is not taken.
fn top([ahead, back]: &[[Complex; HARMONICS]; 2], start: f64, stretch: f64) -> f64 {
    let mut shift = start;
    for _ in 0..8 {
        let step = Complex::turn(shift);
        let mut by = Complex { re: 1.0, im: 0.0 };
        // G, G′/i and −G″.
        let mut g = [Complex::default(); 3];
        for (k, (ahead, back)) in (1_u32..).zip(ahead.iter().zip(back)) {
            by = by * step;
            let (k, one, other) = (f64::from(k), *ahead * by, *back * by.conjugate());
            g[0] = g[0] + one + other;
            g[1] = g[1] + (one - other).scaled(k);
            g[2] = g[2] + (one + other).scaled(k * k);
        }
        // (|G|²)′/2 = Re(Ḡ·iG₁) and (|G|²)″/2 = |G₁|² − Re(Ḡ·G₂).
        let slope = -(g[0].conjugate() * g[1]).im;
        let curvature = g[1].square() - (g[0].conjugate() * g[2]).re;
        let next = shift - slope / curvature;
        if !(curvature < 0.0 && (next - start).abs() <= stretch) {
            break;
        }
        shift = next;
    }
    shift
}
