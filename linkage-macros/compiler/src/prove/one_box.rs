//! The bounds of all results over one box and at its corners.

use super::adjoint::Adjoints;
use super::demand::Verdict;
use super::goal::Goal;
use super::outward::{OutwardInterval, above};
use super::own_error::{beside_twin, own_error};
use super::sloped::{COLUMNS, InputBox, SlopedValue};
use super::value::value;
use crate::ir::graph::Id;

/// Values over a box, each with its own error, and their errors.
pub struct OneBox<'a, 'g> {
    pub subject: &'a Goal<'g>,
    pub frame: InputBox,
    pub values: Vec<SlopedValue>,
    /// By node, the error in each column.
    pub errors: Vec<[f64; COLUMNS]>,
}

impl<'a, 'g> OneBox<'a, 'g> {
    pub fn new(subject: &'a Goal<'g>, frame: InputBox) -> Self {
        let (mut values, mut errors) = (Vec::new(), Vec::new());
        for place in 0..subject.nodes.len() {
            let exact = value(subject, &frame, &values, place);
            let mut own = [0.0; COLUMNS];
            for (column, own) in own.iter_mut().enumerate().take(frame.columns()) {
                *own = own_error(subject, &values, place, column, exact.columns[column]);
            }
            values.push(frame.widened(&exact, own[0]));
            errors.push(own);
        }
        Self { subject, frame, values, errors }
    }

    /// A value over the box, computed or exact.
    pub fn range(&self, id: Id) -> OutwardInterval {
        self.values[self.subject.place(id)].range()
    }

    /// The same with its slopes.
    pub(crate) fn sloped(&self, id: Id) -> &SlopedValue {
        &self.values[self.subject.place(id)]
    }

    /// The same in a column: 0 is the box, the others its corners.
    pub(crate) fn column(&self, id: Id, column: usize) -> OutwardInterval {
        self.values[self.subject.place(id)].columns[column]
    }

    /// The box's answer to all comparisons of the fast path, and of overflow.
    pub(crate) fn verdict(&self) -> Verdict {
        let values = |id| self.range(id);
        let width = self.subject.width;
        let mut all = Verdict::Holds;
        for demand in self.subject.demands {
            match demand.verdict(width, &values) {
                Verdict::Fails => return Verdict::Fails,
                Verdict::Open => all = Verdict::Open,
                Verdict::Holds => {}
            }
        }
        // Values that only unproved results need are not looked at.
        let is_in_range = |(place, jet): (usize, &SlopedValue)| {
            let (id, _) = self.subject.nodes[place];
            self.subject.unproved(id).is_some() || jet.range().magnitude() < width.largest()
        };
        if self.values.iter().enumerate().all(is_in_range) { all } else { Verdict::Open }
    }

    /// The bound of a result over the box and at each corner: an infinite one where there is none.
    pub fn bounds(&self, sink: Id) -> Vec<f64> {
        let subject = self.subject;
        let backwards = Adjoints { subject, frame: &self.frame, values: &self.values };
        let adjoints = backwards.adjoints(sink);
        let shared = self.shared(&adjoints);
        let mut sums = [0.0; COLUMNS];
        let mut known = [OutwardInterval::ZERO; COLUMNS];
        for (place, adjoint) in adjoints.iter().enumerate() {
            let adjoint = match (adjoint, &shared[place]) {
                (Some(own), Some(twin)) => self.frame.met(&self.frame.sub(own, twin)),
                (None, Some(twin)) => self.frame.neg(twin),
                (Some(own), None) => *own,
                (None, None) => continue,
            };
            for column in 0..self.frame.columns() {
                let by = adjoint.columns[column];
                match subject.known(place) {
                    Some(number) if number.error.is_zero() => {}
                    Some(_) if subject.twin_of(place).is_some() => {
                        // The rest of a constant, which its own rounding leaves of it.
                        known[column] = known[column].add(by.mul(self.rest_error(place)));
                    }
                    Some(number) => known[column] = known[column].add(by.mul(number.error)),
                    None => {
                        let own = match subject.twin_of(place) {
                            Some(_) => beside_twin(subject, place),
                            None => self.errors[place][column],
                        };
                        sums[column] = added(sums[column], by.magnitude(), own);
                    }
                }
            }
        }
        let columns = sums.iter().zip(known).take(self.frame.columns());
        columns.map(|(sum, known)| total(*sum, known.magnitude())).collect()
    }

    /// By operation, the sum of the adjoints of what is minus its error.
    fn shared(&self, adjoints: &[Option<SlopedValue>]) -> Vec<Option<SlopedValue>> {
        let mut shared: Vec<Option<SlopedValue>> = vec![None; adjoints.len()];
        for (place, adjoint) in adjoints.iter().enumerate() {
            if let (Some(adjoint), Some(twin)) = (adjoint, self.subject.twin_of(place)) {
                let sum = &mut shared[twin];
                *sum = Some(sum.map_or(*adjoint, |sum| self.frame.add(&sum, adjoint)));
            }
        }
        shared
    }

    /// The rounded rest of a constant, less the true rest.
    fn rest_error(&self, place: usize) -> OutwardInterval {
        let twin = self.subject.twin_of(place).and_then(|twin| self.subject.known(twin));
        let [rest, lost] = [self.subject.known(place), twin]
            .map(|known| known.expect("constants are known").error);
        rest.add(lost)
    }
}

/// A sum and a product of numbers that are not negative, rounded up; what is not needed is not asked whether it is
/// known.
fn added(sum: f64, size: f64, error: f64) -> f64 {
    if error == 0.0 { sum } else { above(sum + above(size * error)) }
}

/// Nothing stays nothing; what is not a number has no bound.
fn total(sum: f64, known: f64) -> f64 {
    let bound = sum + known;
    match () {
        () if bound.is_nan() => f64::INFINITY,
        () if bound == 0.0 => 0.0,
        () => above(bound),
    }
}
