//! Polynomials as sums of Chebyshev's, from values in his nodes that are known to within a radius.

use core::f64::consts::PI;

use libm::cos;

use crate::MOST_DEGREE;

const EPSILON: f64 = f64::EPSILON;
/// The most coefficients of a polynomial.
const MOST: usize = 2 * MOST_DEGREE + 1;

/// The nodes for polynomials of so many coefficients.
pub struct Nodes {
    /// The count of coefficients.
    pub count: usize,
    /// The cosines of the multiples of π/2 by the count.
    cosines: [f64; 4 * MOST],
}

/// A polynomial over −1 … 1, as far as it is known.
pub struct Polynomial {
    count: usize,
    terms: [f64; MOST],
    /// A bound on what the sum of these terms is off by.
    off: f64,
    /// The sum of the coefficients' magnitudes, which bounds all values.
    size: f64,
}

/// The zeros of a polynomial over −1 … 1 as far as its coefficients tell.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ZerosFound {
    /// None at all.
    None,
    /// A single one, between these.
    One([f64; 2]),
    /// The coefficients do not tell.
    Unknown,
}

impl Nodes {
    /// The nodes for polynomials of so many coefficients, 61 at most.
    #[must_use]
    pub fn of(count: usize) -> Self {
        let mut cosines = [0.0; 4 * MOST];
        for (index, cosine) in cosines.iter_mut().enumerate().take(4 * count) {
            *cosine = cos(PI * index as f64 / (2 * count) as f64);
        }
        Self { count, cosines }
    }

    /// The place of a node.
    #[must_use]
    pub fn node(&self, index: usize) -> f64 {
        self.cosines[2 * index + 1]
    }

    /// The polynomial with these values in the nodes, each off by a radius at most.
    ///
    /// The interpolation of errors in the nodes grows them by Lebesgue's constant at most, 1 + (2/π) ln n: under 4 for 61 nodes. A
    /// cosine is off by ten units, as its argument of up to 2π is, and a sum of n products by n half units.
    #[must_use]
    pub fn polynomial(&self, values: &[f64; MOST], radius: f64) -> Polynomial {
        let count = self.count;
        let mut terms = [0.0; MOST];
        for (row, term) in terms.iter_mut().enumerate().take(count) {
            let cosine = |node: usize| self.cosines[row * (2 * node + 1) % (4 * count)];
            let sum: f64 = (0..count).map(|node| values[node] * cosine(node)).sum();
            *term = sum * if row == 0 { 1.0 } else { 2.0 } / count as f64;
        }
        let all: f64 = values[..count].iter().map(|value| value.abs()).sum();
        let size = terms[..count].iter().map(|one| one.abs()).sum();
        let off = 4.0 * radius + (count + 24) as f64 * EPSILON * all;
        Polynomial { count, terms, off, size }
    }

    /// Room for the values in all nodes.
    #[must_use]
    pub fn no_values() -> [f64; MOST] {
        [0.0; MOST]
    }
}

impl Polynomial {
    /// The zeros, by two rules: a constant term that is greater than all others leaves none, and one of the slope leaves one at
    /// most, which the signs at the ends tell.
    #[must_use]
    pub fn zeros(&self) -> ZerosFound {
        let constant = self.terms[0].abs();
        if !(self.size + self.off).is_finite() {
            return ZerosFound::Unknown;
        }
        let rounding = self.count as f64 * EPSILON * self.size;
        if constant > self.size - constant + self.off + rounding {
            return ZerosFound::None;
        }
        let least_slope = self.least_slope();
        if least_slope <= 0.0 || least_slope.is_nan() {
            return ZerosFound::Unknown;
        }
        let ends = [-1.0, 1.0].map(|end| self.at(end));
        if ends.iter().any(|end| end.abs() <= self.off + self.rounding_of_values()) {
            return ZerosFound::Unknown;
        }
        match (ends[0] > 0.0) == (ends[1] > 0.0) {
            true => ZerosFound::None,
            false => ZerosFound::One(self.bracket(ends[1] > 0.0, least_slope)),
        }
    }

    /// A lower bound of the slope's magnitude; zero or less where it may change its sign.
    ///
    /// By Markov's inequality the slope of what is left out is n² times that at most, of degree n.
    fn least_slope(&self) -> f64 {
        let degree = self.count - 1;
        let mut slope = [0.0; MOST + 1];
        let mut terms = 0.0;
        for index in (1..=degree).rev() {
            let term = 2.0 * index as f64 * self.terms[index];
            terms += term.abs();
            slope[index - 1] = slope[index + 1] + term;
        }
        slope[0] /= 2.0;
        let others: f64 = slope[1..=degree].iter().map(|one| one.abs()).sum();
        let square = (self.count * self.count) as f64;
        slope[0].abs() - others - square * (self.off + EPSILON * terms)
    }

    /// Clenshaw's sum. It is off by `rounding_of_values` at most: each of n steps by two units of a sum that grows n-fold at most, and
    /// passes this on up to n-fold.
    fn at(&self, x: f64) -> f64 {
        let mut later = [0.0; 2];
        for &one in self.terms[1..self.count].iter().rev() {
            later = [one + 2.0 * x * later[0] - later[1], later[0]];
        }
        self.terms[0] + x * later[0] - later[1]
    }

    fn rounding_of_values(&self) -> f64 {
        (2 * self.count * self.count) as f64 * EPSILON * self.size
    }

    /// The single zero by halving, as far as the polynomial is known.
    fn bracket(&self, rises: bool, least_slope: f64) -> [f64; 2] {
        let mut ends = [-1.0, 1.0];
        for _ in 0..60 {
            let middle = (ends[0] + ends[1]) / 2.0;
            let is_low = (self.at(middle) > 0.0) == rises;
            ends[usize::from(is_low)] = middle;
        }
        let around = (self.off + self.rounding_of_values()) / least_slope + EPSILON;
        [f64::max(ends[0] - around, -1.0), f64::min(ends[1] + around, 1.0)]
    }
}
