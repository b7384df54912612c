//! Poses next to dead points, at which a traced unknown bends sharply, and the terms of a fit for them.
//!
//! Where two ways to assemble a group come close to each other and part again, the unknown of either goes as
//! φ₀ ± c √(x² + e²) over the distance x from there, and so does the slope of the equation. The dead point lies off the
//! real axis by e, and a polynomial of degree n comes near such a bend to a part exp(−e n) only. Once the root is taken
//! off, what is left is as smooth as elsewhere.

use std::f64::consts::TAU;

use super::fit::NearDead;
use super::plane::root;
use super::trace::Sample;

/// The share of the median of its square below which the least slope of an equation is next to a dead point.
const DEEP: f64 = 0.15;
/// The least and the greatest distance from the real axis for which there are terms: what is farther off is smooth.
const WIDTHS: [f64; 2] = [1e-3, 1.0];
/// The count of places, the deepest first.
const MOST: usize = 3;

/// The places along the motion of an angle next to dead points, and their distances from these: where the square of the
/// slope is least, and the parabola through three poses has its complex zeros.
pub(super) fn places(poses: &[Sample<'_>], closes: bool) -> Vec<[f64; 2]> {
    let mut points: Vec<_> = poses.iter().map(|pose| [pose.drive, pose.slope.powi(2)]).collect();
    let mut squares: Vec<_> = points.iter().map(|[_, square]| *square).collect();
    squares.sort_by(f64::total_cmp);
    let deep = DEEP * squares[squares.len() / 2];
    if closes {
        // The last pose is the first one.
        let [at, square] = points[points.len() - 2];
        points.insert(0, [at - TAU, square]);
    }
    let mut found: Vec<_> = points.windows(3).filter_map(|near| place(near, deep)).collect();
    found.sort_by(|a, b| a[1].total_cmp(&b[1]));
    found.truncate(MOST);
    found
}

pub fn place(near: &[[f64; 2]], deep: f64) -> Option<[f64; 2]> {
    let &[[x0, a], [x1, b], [x2, c]] = near else { return None };
    if !(b < a && b <= c && b < deep) {
        return None;
    }
    let chords = [(b - a) / (x1 - x0), (c - b) / (x2 - x1)];
    let bend = (chords[1] - chords[0]) / (x2 - x0);
    // a + chord (x − x₀) + bend (x − x₀)(x − x₁)
    let at = (x0 + x1) / 2.0 - chords[0] / (2.0 * bend);
    let least = b + chords[0] * (at - x1) + bend * (at - x0) * (at - x1);
    let width = root((least / bend).max(0.0)).max(WIDTHS[0]);
    (width < WIDTHS[1]).then_some([at, width])
}

/// The terms at these places, by least squares of a curve together with smooth functions.
pub fn fitted(
    curve: &[[f64; 2]],
    places: &[[f64; 2]],
    smooth: impl Fn(f64) -> Vec<f64>,
) -> Vec<NearDead> {
    let unit = |at, width| NearDead { at, width, even: 1.0, odd: 0.0 };
    let row = |&[x, value]: &[f64; 2]| {
        let mut row = smooth(x);
        for &[at, width] in places {
            let bent = unit(at, width).at(x);
            row.extend([bent, bent * (x - at).sin()]);
        }
        row.push(value);
        row
    };
    let factors = least_squares(curve.iter().map(row).collect());
    let factors = &factors[factors.len() - 2 * places.len()..];
    let terms = places.iter().zip(factors.chunks_exact(2));
    terms.map(|(&[at, width], by)| NearDead { at, width, even: by[0], odd: by[1] }).collect()
}

/// The factors of the columns for which their sum is nearest to the last one, by Householder's reflections. A column that
/// depends on those before has none.
fn least_squares(mut rows: Vec<Vec<f64>>) -> Vec<f64> {
    /// The share of a column that is taken for rounding.
    const ROUNDING: f64 = 1e-11;
    let count = rows.first().map_or(0, |row| row.len().saturating_sub(1)).min(rows.len());
    let mut is_used = vec![true; count];
    for column in 0..count {
        let size = |from: usize| {
            let squares = rows[from..].iter().map(|row| row[column].powi(2));
            root(squares.sum())
        };
        let (whole, left) = (size(0), size(column));
        is_used[column] = left > ROUNDING * whole;
        if !is_used[column] {
            continue;
        }
        let mut normal: Vec<_> = rows[column..].iter().map(|row| row[column]).collect();
        normal[0] += left.copysign(normal[0]);
        let square: f64 = normal.iter().map(|part| part * part).sum();
        for other in column..=count {
            let along: f64 =
                rows[column..].iter().zip(&normal).map(|(row, n)| row[other] * n).sum();
            let by = 2.0 * along / square;
            rows[column..].iter_mut().zip(&normal).for_each(|(row, n)| row[other] -= by * n);
        }
    }
    let mut factors = vec![0.0; count];
    for column in (0..count).rev().filter(|&column| is_used[column]) {
        let known: f64 =
            (column + 1..count).map(|other| rows[column][other] * factors[other]).sum();
        factors[column] = (rows[column][count] - known) / rows[column][column];
    }
    factors
}
