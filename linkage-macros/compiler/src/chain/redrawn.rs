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
pub struct Displacement {
    pub shift: Complex,
    pub turn: f64,
}

impl Displacement {
    const NONE: Self = Self { shift: Complex { x: 0.0, y: 0.0 }, turn: 0.0 };

    pub fn of(self, place: Complex) -> Complex {
        self.shift + self.direction(place)
    }

    fn direction(self, vector: Complex) -> Complex {
        Complex::turned(self.turn) * vector
    }
}

/// The machine in another pose.
pub struct Redrawn {
    pub machine: Machine,
    pub displacements: Vec<Displacement>,
}

/// A bar between two pins with the length that it is to have.
#[derive(Clone, Copy, Debug)]
pub struct Resized {
    pub body: usize,
    pub pins: [usize; 2],
    pub length: f64,
}

/// The machine in the pose next to the drawing in which these bars have their lengths; `None` if
/// there is none on this side of a limit.
pub fn redrawn(machine: &Machine, bars: &[Resized]) -> Option<Redrawn> {
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

pub struct Relaxation<'m> {
    pub machine: &'m Machine,
    pub bars: &'m [Resized],
    /// The share of the change of lengths.
    pub share: f64,
    pub displacements: Vec<Displacement>,
}

/// An equation: what it is off by, and its derivatives by the bodies that it names.
pub struct LinearEquation {
    pub off: f64,
    pub slopes: Vec<(usize, [f64; 3])>,
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
    pub fn rows(&self, size: f64) -> Vec<LinearEquation> {
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
pub fn eliminated(rows: &mut [Vec<f64>]) -> Option<(Vec<f64>, bool)> {
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
