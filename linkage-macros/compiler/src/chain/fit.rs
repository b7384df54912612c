//! Fits of a traced unknown over the first drive.
//!
//! Over an angle the fit is f(x) = P(cos x) + sin x Q(cos x), with x from the middle of the
//! stretch. It has the same value a turn on, and its polynomials have half the degree that one in x
//! would need, so that their coefficients stay small beside what `f32` resolves.

use super::plane::root;

/// The traced value of an unknown over the first drive, both from the drawing.
#[derive(Clone, Debug)]
pub struct Following {
    /// The middle of the stretch.
    pub middle: f64,
    pub terms: Terms,
    pub ends: Option<DeadEnds>,
    /// The poses next to dead points, of an angle alone.
    pub near: Vec<NearDead>,
}

/// The square roots towards dead points at the ends of the stretch, where the unknown turns back:
/// √z (mean + skew y), where z falls to zero at both ends and y is odd. Over an angle z = 1 + u and
/// y = sin x; along a slide z = 1 − y² and y = x/reach.
#[derive(Clone, Copy, Debug)]
pub struct DeadEnds {
    pub mean: f64,
    pub skew: f64,
}

/// The bend of an angle next to a dead point: √(2 − 2 cos x + width²) (even + odd sin x), with x from there.
#[derive(Clone, Copy, Debug)]
pub struct NearDead {
    /// The place, from the middle of the stretch.
    pub at: f64,
    pub width: f64,
    pub even: f64,
    pub odd: f64,
}

#[derive(Clone, Debug)]
pub enum Terms {
    /// P(u) + sin x Q(u) + turns x, where u = (cos x − center)/reach.
    Turning { center: f64, reach: f64, even: Vec<f64>, odd: Vec<f64>, turns: i32 },
    /// P(x/reach).
    Sliding { reach: f64, powers: Vec<f64> },
}

/// The unknowns on a stretch of the first drive, from the drawing: polynomials of the place between the ends, from −1 to 1.
#[derive(Clone, Debug)]
pub struct Piece {
    pub ends: [f64; 2],
    /// By unknown, in radians and metres.
    pub powers: Vec<Vec<f64>>,
}

impl Following {
    pub fn at(&self, drive: f64) -> f64 {
        let x = drive - self.middle;
        let smooth = match &self.terms {
            Terms::Turning { center, reach, even, odd, turns } => {
                let u = (x.cos() - center) / reach;
                polynomial(even, u) + x.sin() * polynomial(odd, u) + f64::from(*turns) * x
            }
            Terms::Sliding { reach, powers } => polynomial(powers, x / reach),
        };
        let near: f64 = self.near.iter().map(|near| near.at(x)).sum();
        smooth + self.ends.map_or(0.0, |ends| ends.at(self.terms.end(x))) + near
    }

    /// The coefficients as multiples of a unit.
    pub(super) fn rounded(mut self, unit: f64) -> Self {
        let lists = match &mut self.terms {
            Terms::Turning { even, odd, .. } => vec![even, odd],
            Terms::Sliding { powers, .. } => vec![powers],
        };
        for term in lists.into_iter().flatten() {
            // The decimal that is printed.
            let digits = (-unit.log10().floor()).max(0.0) as usize;
            *term = format!("{term:.digits$}").parse().unwrap_or(*term);
        }
        self
    }
}

impl Piece {
    pub(super) fn at(&self, drive: f64) -> impl Iterator<Item = f64> + '_ {
        let [from, to] = self.ends;
        let place = (2.0 * drive - from - to) / (to - from);
        let value = move |powers: &Vec<f64>| {
            powers.iter().rev().fold(0.0, |sum, power| sum * place + power)
        };
        self.powers.iter().map(value)
    }
}

impl DeadEnds {
    pub(super) fn at(&self, [z, y]: [f64; 2]) -> f64 {
        root(z.max(0.0)) * (self.mean + self.skew * y)
    }
}

impl NearDead {
    pub fn at(&self, x: f64) -> f64 {
        let (sin, cos) = (x - self.at).sin_cos();
        root(2.0 - 2.0 * cos + self.width * self.width) * (self.even + self.odd * sin)
    }
}

impl Terms {
    /// The number z that falls to zero at both ends, and the odd number y.
    pub(super) fn end(&self, x: f64) -> [f64; 2] {
        match self {
            Self::Turning { center, reach, .. } => [1.0 + (x.cos() - center) / reach, x.sin()],
            Self::Sliding { reach, .. } => [1.0 - (x / reach).powi(2), x / reach],
        }
    }
}

fn polynomial(powers: &[f64], at: f64) -> f64 {
    powers.iter().rev().fold(0.0, |sum, power| sum * at + power)
}
