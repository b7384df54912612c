//! The pose of a machine whose bars are longer or shorter than they are drawn: Newton's method on all
//! bodies at once, from the drawing on, while the lengths change step by step.
//!
//! Each body's motion from the drawing is z ↦ c + e^{iθ} z. The equations are those of the joints, and of
//! the drives at their drawn values. Where the determinant of their derivatives changes its sign, the
//! machine has passed a limit, behind which the drawing no longer says how it assembles.

use super::machine::{Driven, Driving, Machine, Slide};
use super::plane::Complex;

/// The longest and the shortest step in which lengths change, as shares of the change: powers of a half, whose sums have no
/// error.
const LONGEST: f64 = 1.0 / 16.0;
const SHORTEST: f64 = 1.0 / 1024.0;
/// The most iterations a step: Newton's method doubles the digits from the second on.
const ITERATIONS: usize = 12;
/// The part of the machine's size to which joints close.
const CLOSED: f64 = 1e-13;

/// The motion of a body from the drawing.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Displacement {
    shift: Complex,
    pub turn: f64,
}

impl Displacement {
    const NONE: Self = Self { shift: Complex { x: 0.0, y: 0.0 }, turn: 0.0 };

    pub(crate) fn of(self, place: Complex) -> Complex {
        self.shift + self.direction(place)
    }

    fn direction(self, vector: Complex) -> Complex {
        Complex::turned(self.turn) * vector
    }
}

/// The machine in another pose.
pub(crate) struct Redrawn {
    pub machine: Machine,
    pub displacements: Vec<Displacement>,
}

/// A bar between two pins with the length that it is to have.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Resized {
    pub body: usize,
    pub pins: [usize; 2],
    pub length: f64,
}

/// The machine in the pose next to the drawing in which these bars have their lengths; `None` if
/// there is none on this side of a limit.
pub(crate) fn redrawn(machine: &Machine, bars: &[Resized]) -> Option<Redrawn> {
    let mut relaxation = Relaxation {
        machine,
        bars,
        share: 0.0,
        displacements: vec![Displacement::NONE; machine.bodies.len()],
    };
    let side = relaxation.step()?.1;
    let (mut done, mut step) = (0.0, LONGEST);
    while done < 1.0 {
        let before = relaxation.displacements.clone();
        relaxation.share = f64::min(done + step, 1.0);
        // Newton's method may go past a limit where the pose itself comes to none.
        if relaxation.closed() == Some(side) {
            done = relaxation.share;
            step = f64::min(2.0 * step, LONGEST);
        } else {
            relaxation.displacements = before;
            step /= 2.0;
            if step < SHORTEST {
                return None;
            }
        }
    }
    Some(relaxation.redrawn())
}

struct Relaxation<'m> {
    machine: &'m Machine,
    bars: &'m [Resized],
    /// The share of the change of lengths.
    share: f64,
    displacements: Vec<Displacement>,
}

/// An equation: what it is off by, and its derivatives by the bodies that it names.
struct LinearEquation {
    off: f64,
    slopes: Vec<(usize, [f64; 3])>,
}

impl Relaxation<'_> {
    fn moves(&self) -> Vec<usize> {
        (0..self.machine.bodies.len()).filter(|&body| !self.machine.is_given(body)).collect()
    }

    /// The place of a pin on a body.
    fn place(&self, body: usize, pin: usize) -> Complex {
        let place = self.machine.pins[pin];
        let bar = self.bars.iter().find(|bar| bar.body == body && bar.pins[1] == pin);
        let Some(bar) = bar else { return place };
        let first = self.machine.pins[bar.pins[0]];
        let drawn = (place - first).length();
        let length = drawn + self.share * (bar.length - drawn);
        first + (place - first).times(length / drawn)
    }

    /// Closes all joints; the sign of the determinant there.
    fn closed(&mut self) -> Option<bool> {
        for _ in 0..ITERATIONS {
            let (change, side) = self.step()?;
            if change < CLOSED {
                return Some(side);
            }
        }
        None
    }

    /// One iteration: the largest change, lengths as parts of the machine's size, and the sign of
    /// the determinant.
    fn step(&mut self) -> Option<(f64, bool)> {
        let (moves, size) = (self.moves(), self.machine.size());
        let rows = self.rows(size);
        let index = |body: usize| moves.iter().position(|&other| other == body);
        let mut matrix: Vec<Vec<f64>> = rows
            .iter()
            .map(|row| {
                let mut line = vec![0.0; 3 * moves.len() + 1];
                for (body, slopes) in &row.slopes {
                    let Some(index) = index(*body) else { continue };
                    (0..3).for_each(|i| line[3 * index + i] += slopes[i]);
                }
                line[3 * moves.len()] = -row.off;
                line
            })
            .collect();
        let (change, side) = eliminated(&mut matrix)?;
        for (body, change) in moves.iter().zip(change.chunks_exact(3)) {
            let Displacement { shift, turn } = &mut self.displacements[*body];
            *shift = *shift + Complex::new(change[0], change[1]).times(size);
            *turn += change[2];
        }
        // An iteration that leaps does not lead to the pose beside the drawing.
        let largest = change.iter().fold(0.0_f64, |largest, change| largest.max(change.abs()));
        (largest < 0.5).then_some((largest, side))
    }

    /// The equations, lengths as parts of the machine's size.
    fn rows(&self, size: f64) -> Vec<LinearEquation> {
        let machine = self.machine;
        let mut rows = Vec::new();
        for pin in 0..machine.pins.len() {
            // Where a body is given, the others go where it is.
            let (given, others): (Vec<_>, Vec<_>) =
                machine.at(pin).partition(|&body| machine.is_given(body));
            let through: Vec<_> = given.into_iter().take(1).chain(others).collect();
            let [first, rest @ ..] = &through[..] else { continue };
            for other in rest {
                let ends = [*first, *other].map(|body| (body, self.place(body, pin)));
                for axis in [Complex::new(1.0, 0.0), Complex::new(0.0, 1.0)] {
                    rows.push(self.between(ends, axis, size));
                }
            }
        }
        for (index, slide) in machine.slides.iter().enumerate() {
            rows.push(self.turning([slide.body, slide.carrier]));
            let [along, across] = self.along(slide, size);
            let is_driven = machine.drives.iter().any(|drive| drive.kind == Driven::Slide(index));
            rows.push(across);
            rows.extend(is_driven.then_some(along));
        }
        let turned = machine.drives.iter().filter(|drive| drive.kind == Driven::Angle);
        rows.extend(turned.map(|Driving { bodies, .. }| self.turning(*bodies)));
        rows
    }

    /// The part along an axis from a point of one body to one of another.
    fn between(&self, ends: [(usize, Complex); 2], axis: Complex, size: f64) -> LinearEquation {
        let [(a, p), (b, q)] = ends;
        let [from, to] = ends.map(|(body, place)| self.displacements[body].of(place));
        let slopes = |body: usize, place: Complex, sign: f64| {
            let swept = self.displacements[body].direction(Complex::new(-place.y, place.x));
            let turned = axis.dot(swept) / size;
            (body, [axis.x, axis.y, turned].map(|slope| sign * slope))
        };
        let slopes = vec![slopes(a, p, -1.0), slopes(b, q, 1.0)];
        LinearEquation { off: axis.dot(to - from) / size, slopes }
    }

    /// The angle between two bodies.
    fn turning(&self, [a, b]: [usize; 2]) -> LinearEquation {
        let off = self.displacements[a].turn - self.displacements[b].turn;
        LinearEquation { off, slopes: vec![(a, [0.0, 0.0, 1.0]), (b, [0.0, 0.0, -1.0])] }
    }

    /// The distances along and across a slide. Where both bodies turn alike, the carrier's axes
    /// count as at rest.
    fn along(&self, slide: &Slide, size: f64) -> [LinearEquation; 2] {
        let carrier = self.displacements[slide.carrier];
        let along = carrier.direction(slide.along);
        let across = along * Complex::new(0.0, 1.0);
        let ends = [(slide.carrier, slide.through), (slide.body, slide.through)];
        [along, across].map(|axis| {
            let mut row = self.between(ends, axis, size);
            let [from, to] = ends.map(|(body, place)| self.displacements[body].of(place));
            // The axis turns with the carrier.
            let turning = (axis * Complex::new(0.0, 1.0)).dot(to - from) / size;
            row.slopes[0].1[2] += turning;
            row
        })
    }

    fn redrawn(self) -> Redrawn {
        let mut machine = self.machine.clone();
        for pin in 0..machine.pins.len() {
            let Some(body) = self.machine.at(pin).next() else { continue };
            machine.pins[pin] = self.displacements[body].of(self.place(body, pin));
        }
        for slide in &mut machine.slides {
            let carrier = self.displacements[slide.carrier];
            slide.through = carrier.of(slide.through);
            slide.along = carrier.direction(slide.along);
        }
        Redrawn { machine, displacements: self.displacements }
    }
}

/// The solution of linear equations, each with its right side last, and the sign of the determinant.
fn eliminated(rows: &mut [Vec<f64>]) -> Option<(Vec<f64>, bool)> {
    let count = rows.len();
    let mut is_positive = true;
    if rows.first()?.len() != count + 1 {
        return None;
    }
    for column in 0..count {
        let size = |row: usize| rows[row][column].abs();
        let pivot = (column..count).max_by(|&a, &b| size(a).total_cmp(&size(b)))?;
        // Coefficients are of the order of one.
        if size(pivot) < 1e-12 {
            return None;
        }
        is_positive ^= pivot != column;
        rows.swap(column, pivot);
        let (above, below) = rows.split_at_mut(column + 1);
        let pivot = &above[column];
        is_positive ^= pivot[column] < 0.0;
        for row in below {
            let factor = row[column] / pivot[column];
            row.iter_mut().zip(pivot).for_each(|(value, pivot)| *value -= factor * pivot);
        }
    }
    let mut solution = vec![0.0; count];
    for row in (0..count).rev() {
        let known: f64 = (row + 1..count).map(|column| rows[row][column] * solution[column]).sum();
        solution[row] = (rows[row][count] - known) / rows[row][row];
    }
    solution.iter().all(|value| value.is_finite()).then_some((solution, is_positive))
}

#[cfg(test)]
mod tests {
    use super::super::machine::RigidBody;
    use super::*;

    /// A crank, a coupler with a rod, a block that is driven along it, and a rocker.
    fn machine() -> Machine {
        let body = |pins: &[usize]| RigidBody { pins: pins.to_vec(), ..RigidBody::default() };
        let pins = [[0.0, 0.0], [4.0, 0.2], [0.5, 0.9], [3.2, 2.6], [1.9, 2.4]];
        Machine {
            pins: pins.map(|[x, y]| Complex::new(x, y)).into(),
            bodies: vec![body(&[0, 1]), body(&[0, 2]), body(&[2, 3]), body(&[1, 3]), body(&[4])],
            slides: vec![Slide {
                body: 4,
                carrier: 2,
                through: Complex::new(1.5, 2.0),
                along: Complex::new(0.6, 0.8),
            }],
            drives: vec![
                Driving { kind: Driven::Angle, bodies: [1, 0], reads: Vec::new() },
                Driving { kind: Driven::Slide(0), bodies: [4, 2], reads: Vec::new() },
            ],
            ..Machine::default()
        }
    }

    /// The slopes of every equation are its central differences, in a pose in which nothing is closed.
    #[test]
    fn slopes_are_those_of_the_equations() {
        const STEP: f64 = 1e-5;
        let machine = machine();
        let bars = [Resized { body: 2, pins: [2, 3], length: 3.0 }];
        let displacements = (0..5).map(|body| {
            let body = f64::from(body);
            let shift = Complex::new(0.3 * body, 0.5 - 0.2 * body);
            Displacement { shift, turn: 0.4 - 0.3 * body }
        });
        let displacements = displacements.collect();
        let mut relaxation =
            Relaxation { machine: &machine, bars: &bars, share: 0.7, displacements };
        let size = machine.size();
        let rows = relaxation.rows(size);
        assert_eq!(rows.len(), 8 + 2 + 2);
        for body in 0..5 {
            for axis in 0..3 {
                let mut moved = |step: f64| -> Vec<f64> {
                    let before = relaxation.displacements[body];
                    let now = &mut relaxation.displacements[body];
                    match axis {
                        0 => now.shift.x += step * size,
                        1 => now.shift.y += step * size,
                        _ => now.turn += step,
                    }
                    let off = relaxation.rows(size).iter().map(|row| row.off).collect();
                    relaxation.displacements[body] = before;
                    off
                };
                let (more, less) = (moved(STEP), moved(-STEP));
                for (index, row) in rows.iter().enumerate() {
                    let own = row.slopes.iter().filter(|(other, _)| *other == body);
                    let slope: f64 = own.map(|(_, slopes)| slopes[axis]).sum();
                    let wanted = (more[index] - less[index]) / (2.0 * STEP);
                    // h² of sines of order one, and roundings over h: both below 1e-9.
                    let off = (slope - wanted).abs();
                    assert!(
                        off < 1e-9,
                        "row {index}, body {body}, axis {axis}: {slope} for {wanted}"
                    );
                }
            }
        }
    }

    /// The determinant by minors.
    fn determinant(rows: &[Vec<f64>]) -> f64 {
        let [first, rest @ ..] = rows else { return 1.0 };
        let minor = |column: usize| -> Vec<Vec<f64>> {
            let without = |row: &Vec<f64>| {
                let others = row.iter().enumerate().filter(|(other, _)| *other != column);
                others.map(|(_, value)| *value).collect()
            };
            rest.iter().map(without).collect()
        };
        let sign = |column: usize| if column.is_multiple_of(2) { 1.0 } else { -1.0 };
        let parts = (0..first.len()).map(|i| sign(i) * first[i] * determinant(&minor(i)));
        parts.sum()
    }

    #[test]
    fn the_sign_is_that_of_the_determinant() {
        let mut seed = 0x9e37_79b9_u64;
        let mut number = || {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            (seed >> 40) as f64 / (1_u64 << 23) as f64 - 1.0
        };
        let mut signs = [0, 0];
        for _ in 0..200 {
            let matrix: Vec<Vec<f64>> =
                (0..4).map(|_| (0..4).map(|_| number()).collect()).collect();
            let wanted: Vec<f64> = (0..4).map(|_| number()).collect();
            let mut rows = matrix.clone();
            for row in &mut rows {
                let right = row.iter().zip(&wanted).map(|(a, x)| a * x).sum();
                row.push(right);
            }
            let determinant = determinant(&matrix);
            let (solution, is_positive) = eliminated(&mut rows).expect("it is regular");
            assert_eq!(is_positive, determinant > 0.0, "{matrix:?}");
            for (found, wanted) in solution.iter().zip(&wanted) {
                // Roundings over the determinant of numbers of order one.
                assert!((found - wanted).abs() < 1e-13 / determinant.abs(), "{matrix:?}");
            }
            signs[usize::from(is_positive)] += 1;
        }
        assert!(signs[0] > 50 && signs[1] > 50, "{signs:?}");
    }
}
