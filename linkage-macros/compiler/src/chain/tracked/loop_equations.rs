//! The equations of a group: at the pins that close loops two bodies meet.
//!
//! Every body has an angle of its own, so that the vector between the two pins is a sum of vectors of constant length, one
//! a body: its second derivative by an angle is as long as its first. A slide along a body that turns adds the unit
//! vector along it, turned as the body is.

use super::hung_bodies::Hung;
use crate::chain::cutting::{Closing, Found, Placed, TrackedGroup, is_unknown};
use crate::chain::machine::Machine;
use crate::chain::plane::{Complex, Displaced};
use crate::chain::pose::Posed;
use crate::chain::trace::Way;

pub(super) struct System<'m> {
    pub machine: &'m Machine,
    pub way: Way,
    before: Vec<Found>,
    pub steps: Vec<Found>,
    pub closings: Vec<Closing>,
    /// By pin, the body that makes it.
    makers: Vec<Option<usize>>,
    pub size: f64,
}

/// The equations at some values of the unknowns: the numbers that are zero at a root, and by unknown their derivatives.
/// Slides are in units of the size.
pub(super) struct LoopEquations {
    pub missed: Vec<f64>,
    pub columns: Vec<Vec<f64>>,
}

/// The rates of a body that one unknown moves: at a place p it is `shift` + i `turn` p.
#[derive(Clone, Copy)]
struct Rate {
    shift: Complex,
    turn: f64,
}

impl Rate {
    fn of(self, place: Complex) -> Complex {
        self.shift + Complex::new(0.0, self.turn) * place
    }
}

/// A body of the group where it is tried.
#[derive(Clone)]
struct Tried {
    at: Displaced,
    rates: Vec<Rate>,
    /// The unknown that its angle is; none where that is known.
    turned_by: Option<usize>,
}

impl<'m> System<'m> {
    pub(super) fn of(machine: &'m Machine, before: &[Found], known: &Placed, hung: Hung) -> Self {
        let Hung { steps, closings } = hung;
        let bodies = 0..machine.bodies.len();
        let known: Vec<_> = bodies.filter(|&body| known.body(body)).collect();
        let order = known.into_iter().chain(steps.iter().flat_map(Found::bodies));
        let mut makers = vec![None; machine.pins.len()];
        for body in order {
            for &pin in &machine.bodies[body].pins {
                makers[pin].get_or_insert(body);
            }
        }
        let way = Way::all(machine).remove(0);
        let (before, size) = (before.to_vec(), machine.size());
        Self { machine, way, before, steps, closings, makers, size }
    }

    /// The count of unknowns, which is that of equations.
    pub(super) fn count(&self) -> usize {
        2 * self.closings.len()
    }

    /// True of unknowns that are angles, by unknown.
    pub(super) fn angles(&self) -> Vec<bool> {
        let unknowns = self.steps.iter().filter(|step| is_unknown(step));
        unknowns.map(|step| matches!(step, Found::Crank { .. })).collect()
    }

    /// By unknown, the unit in which it counts: a radian or the size.
    pub(super) fn units(&self) -> Vec<f64> {
        let angles = self.angles().into_iter();
        angles.map(|is_angle| if is_angle { 1.0 } else { self.size }).collect()
    }

    /// The bodies before the group, at a drive from the drawing.
    pub(super) fn posed(&self, drive: f64) -> Option<Posed<'m>> {
        let mut posed = Posed::new(self.machine);
        posed.run(&self.before, &mut self.way.given(self.machine, drive), 0.0)?;
        Some(posed)
    }

    /// The equations at a drive, with what stands before the group there.
    pub(super) fn at(
        &self,
        posed: &Posed<'m>,
        drive: f64,
        unknowns: &[f64],
    ) -> Option<LoopEquations> {
        let tried = self.tried(posed, drive, unknowns)?;
        let mut equations =
            LoopEquations { missed: Vec::new(), columns: vec![Vec::new(); self.count()] };
        for Closing { pin, body, .. } in &self.closings {
            let at = self.machine.pins[*pin];
            let ends = [self.makers[*pin]?, *body].map(|body| tried[body].as_ref());
            let [Some(made), Some(met)] = ends else { return None };
            let missed = met.at.of(at) - made.at.of(at);
            equations.missed.extend([missed.x, missed.y]);
            for (unknown, column) in equations.columns.iter_mut().enumerate() {
                let [met, made] = [met, made].map(|tried| tried.rates[unknown].of(tried.at.of(at)));
                let rate = met - made;
                column.extend([rate.x, rate.y]);
            }
        }
        equations.missed.iter().all(|missed| missed.is_finite()).then_some(equations)
    }

    fn tried(&self, posed: &Posed<'m>, drive: f64, unknowns: &[f64]) -> Option<Vec<Option<Tried>>> {
        let resting = Rate { shift: Complex::new(0.0, 0.0), turn: 0.0 };
        let known = |body| {
            let at = posed.displaced(body)?;
            Some(Tried { at, rates: vec![resting; self.count()], turned_by: None })
        };
        let mut tried: Vec<_> = (0..self.machine.bodies.len()).map(known).collect();
        let given = self.way.given(self.machine, drive);
        let mut next = 0;
        for step in &self.steps {
            let mut own = None;
            if is_unknown(step) {
                own = Some((next, unknowns[next]));
                next += 1;
            }
            let driven = |drive: usize, body: usize| match self.machine.drives[drive].bodies[0] {
                first if first == body => given.drives[drive],
                _ => -given.drives[drive],
            };
            match *step {
                Found::Crank { drive, body, reference, pivot } => {
                    let change = drive.map(|drive| driven(drive, body));
                    let placed = self.turned(&tried, (reference, pivot), own, change)?;
                    tried[body] = Some(placed);
                }
                Found::Slider { drive, body, slide } => {
                    let change = drive.map(|drive| driven(drive, body));
                    let placed = self.slid(&tried, (body, slide), own, change)?;
                    tried[body] = Some(placed);
                }
                Found::Dyad(_) | Found::Search(_) | Found::Tracked(_) => return None,
            }
        }
        Some(tried)
    }

    fn turned(
        &self,
        tried: &[Option<Tried>],
        (reference, pivot): (usize, usize),
        own: Option<(usize, f64)>,
        change: Option<f64>,
    ) -> Option<Tried> {
        let against = tried[reference].as_ref()?;
        let carrying = tried[self.makers[pivot]?].as_ref()?;
        let drawn = self.machine.pins[pivot];
        let at = carrying.at.of(drawn);
        let angle = change.or(own.map(|(_, angle)| angle))?;
        let turn = against.at.turn * Complex::turned(angle);
        let rate = |unknown: usize| {
            let is_own = own.is_some_and(|(own, _)| own == unknown);
            let turn = against.rates[unknown].turn + if is_own { 1.0 } else { 0.0 };
            let shift = carrying.rates[unknown].of(at) - Complex::new(0.0, turn) * at;
            Rate { shift, turn }
        };
        Some(Tried {
            at: Displaced::taking(drawn, at, turn),
            rates: (0..self.count()).map(rate).collect(),
            turned_by: own.map(|(own, _)| own).or(against.turned_by),
        })
    }

    fn slid(
        &self,
        tried: &[Option<Tried>],
        (body, slide): (usize, usize),
        own: Option<(usize, f64)>,
        change: Option<f64>,
    ) -> Option<Tried> {
        let slide = self.machine.slides[slide];
        let other = if slide.body == body { slide.carrier } else { slide.body };
        let against = tried[other].as_ref()?;
        let along = against.at.turn * slide.along;
        let way = change.or(own.map(|(_, way)| way * self.size))?;
        let moved = along.times(way);
        let rate = |unknown: usize| {
            let Rate { shift, turn } = against.rates[unknown];
            let is_own = own.is_some_and(|(own, _)| own == unknown);
            let along = along.times(if is_own { self.size } else { 0.0 });
            Rate { shift: shift + along, turn }
        };
        Some(Tried {
            at: Displaced { shift: against.at.shift + moved, turn: against.at.turn },
            rates: (0..self.count()).map(rate).collect(),
            turned_by: against.turned_by,
        })
    }

    /// By closing pin, a bound on the sum of the second derivatives near these unknowns: a vector's length by angle, and for
    /// a slide along a body that an unknown turns its unit, twice with that angle and once more for what it adds to the
    /// vector while it changes by less than a unit.
    pub(super) fn bends(
        &self,
        posed: &Posed<'m>,
        drive: f64,
        unknowns: &[f64],
    ) -> Option<Vec<f64>> {
        let (tried, found) =
            (self.tried(posed, drive, unknowns)?, self.at(posed, drive, unknowns)?);
        let carriers = self.steps.iter().filter(|step| is_unknown(step)).map(|step| match *step {
            Found::Slider { body, .. } => tried[body].as_ref().and_then(|body| body.turned_by),
            _ => None,
        });
        let carriers: Vec<_> = carriers.collect();
        let lengths = |closing: usize| {
            let columns = found.columns.iter().zip(self.angles()).zip(&carriers);
            columns.map(move |((column, is_angle), carrier)| {
                let length = column[2 * closing].hypot(column[2 * closing + 1]);
                match (is_angle, carrier) {
                    (true, _) => length,
                    (false, Some(_)) => 3.0 * length,
                    (false, None) => 0.0,
                }
            })
        };
        Some((0..self.closings.len()).map(|closing| lengths(closing).sum()).collect())
    }

    /// The group with what was found of it.
    pub(super) fn group(self, bends: Vec<f64>) -> TrackedGroup {
        let closings = self.closings.into_iter().zip(bends);
        TrackedGroup {
            steps: self.steps,
            closings: closings.map(|(closing, bend)| Closing { bend, ..closing }).collect(),
            pieces: Vec::new(),
            size: self.size,
            closes: false,
        }
    }
}

/// The inverse of the derivatives, a row an unknown; `None` where there is none. The determinant beside it.
pub(super) fn inverse(columns: &[Vec<f64>]) -> Option<(Vec<Vec<f64>>, f64)> {
    let count = columns.len();
    let unit = |row: usize| (0..count).map(move |column| f64::from(u8::from(row == column)));
    let mut rows: Vec<Vec<f64>> = (0..count)
        .map(|row| columns.iter().map(|column| column[row]).chain(unit(row)).collect())
        .collect();
    let mut determinant = 1.0;
    for column in 0..count {
        let size = |row: &usize| rows[*row][column].abs();
        let pivot = (column..count).max_by(|a, b| size(a).total_cmp(&size(b)))?;
        if pivot != column {
            rows.swap(pivot, column);
            determinant = -determinant;
        }
        let value = rows[column][column];
        determinant *= value;
        if value == 0.0 || !value.is_finite() {
            return None;
        }
        rows[column].iter_mut().for_each(|entry| *entry /= value);
        let own = rows[column].clone();
        for (_, entries) in rows.iter_mut().enumerate().filter(|(row, _)| *row != column) {
            let factor = entries[column];
            entries.iter_mut().zip(&own).for_each(|(entry, own)| *entry -= factor * own);
        }
    }
    Some((rows.into_iter().map(|row| row[count..].to_vec()).collect(), determinant))
}

/// The product of a matrix in rows with a vector.
pub(super) fn times(rows: &[Vec<f64>], vector: &[f64]) -> Vec<f64> {
    let product = |row: &Vec<f64>| row.iter().zip(vector).map(|(a, b)| a * b).sum();
    rows.iter().map(product).collect()
}

/// The greatest size of a number among these.
pub(super) fn greatest(numbers: &[f64]) -> f64 {
    numbers.iter().fold(0.0, |most, number| most.max(number.abs()))
}

/// The product h of Newton and Kantorovich where the equations are so, by the bends of the closing pins.
pub(super) fn certificate(equations: &LoopEquations, bends: &[f64]) -> Option<f64> {
    let (rows, _) = inverse(&equations.columns)?;
    let step = greatest(&times(&rows, &equations.missed));
    let bent = rows.iter().map(|row| {
        let pairs = row.chunks(2).zip(bends);
        pairs.map(|(pair, bend)| (pair[0].abs() + pair[1].abs()) * bend).sum::<f64>()
    });
    let product = step * bent.fold(0.0, f64::max);
    product.is_finite().then_some(product)
}
