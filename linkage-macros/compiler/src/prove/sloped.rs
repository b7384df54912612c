//! Values over a box of inputs: an interval for the whole box and one for each of its corners, and the slope of the
//! value by each input over the box.

use super::outward::OutwardInterval;

/// The most inputs, parameters over a range included, that are followed at once.
pub(crate) const INPUTS: usize = 3;

/// The columns of a jet: the box, then its corners.
pub(crate) const COLUMNS: usize = 1 + (1 << INPUTS);

/// See the module's documentation.
#[derive(Clone, Copy, Debug)]
pub struct SlopedValue {
    pub columns: [OutwardInterval; COLUMNS],
    pub slopes: [OutwardInterval; INPUTS],
}

/// A box of inputs.
#[derive(Clone, Copy, Debug)]
pub struct InputBox {
    pub inputs: usize,
    low: [f64; INPUTS],
    high: [f64; INPUTS],
}

impl SlopedValue {
    /// A value that no input changes.
    pub(crate) fn constant(value: OutwardInterval) -> Self {
        Self { columns: [value; COLUMNS], slopes: [OutwardInterval::ZERO; INPUTS] }
    }

    pub(crate) const ZERO: Self =
        Self { columns: [OutwardInterval::ZERO; COLUMNS], slopes: [OutwardInterval::ZERO; INPUTS] };

    /// The values over the box.
    pub fn range(&self) -> OutwardInterval {
        self.columns[0]
    }
}

impl InputBox {
    pub fn new(sides: &[[f64; 2]]) -> Self {
        let (mut low, mut high) = ([0.0; INPUTS], [0.0; INPUTS]);
        for (input, &[from, to]) in sides.iter().enumerate() {
            (low[input], high[input]) = (from, to);
        }
        Self { inputs: sides.len(), low, high }
    }

    /// The columns that are used.
    pub(crate) fn columns(&self) -> usize {
        1 + (1 << self.inputs)
    }

    /// A corner as a pose: bit `input` of its number says which end.
    pub(crate) fn corner(&self, corner: usize) -> Vec<f64> {
        (0..self.inputs).map(|input| self.end(input, corner)).collect()
    }

    fn end(&self, input: usize, corner: usize) -> f64 {
        if corner >> input & 1 == 1 { self.high[input] } else { self.low[input] }
    }

    /// An input itself.
    pub(crate) fn input(&self, input: usize) -> SlopedValue {
        let mut jet = SlopedValue::ZERO;
        jet.columns[0] = OutwardInterval::between(self.low[input], self.high[input]);
        for column in 1..self.columns() {
            jet.columns[column] = OutwardInterval::point(self.end(input, column - 1));
        }
        jet.slopes[input] = OutwardInterval::point(1.0);
        jet
    }

    /// A jet of which the columns are made one by one.
    #[inline]
    pub(crate) fn map(
        &self,
        column: impl Fn(usize) -> OutwardInterval,
        slope: impl Fn(usize) -> OutwardInterval,
    ) -> SlopedValue {
        let mut jet = SlopedValue::ZERO;
        (0..self.columns()).for_each(|at| jet.columns[at] = column(at));
        (0..self.inputs).for_each(|input| jet.slopes[input] = slope(input));
        jet
    }

    pub(crate) fn neg(&self, a: &SlopedValue) -> SlopedValue {
        self.map(|at| a.columns[at].neg(), |input| a.slopes[input].neg())
    }

    pub(crate) fn add(&self, a: &SlopedValue, b: &SlopedValue) -> SlopedValue {
        self.map(
            |at| a.columns[at].add(b.columns[at]),
            |input| a.slopes[input].add(b.slopes[input]),
        )
    }

    pub(crate) fn sub(&self, a: &SlopedValue, b: &SlopedValue) -> SlopedValue {
        self.map(
            |at| a.columns[at].sub(b.columns[at]),
            |input| a.slopes[input].sub(b.slopes[input]),
        )
    }

    pub(crate) fn mul(&self, a: &SlopedValue, b: &SlopedValue) -> SlopedValue {
        let (x, y) = (a.range(), b.range());
        self.map(
            |at| a.columns[at].mul(b.columns[at]),
            |input| a.slopes[input].mul(y).add(b.slopes[input].mul(x)),
        )
    }

    pub(crate) fn square(&self, a: &SlopedValue) -> SlopedValue {
        let double = a.range().add(a.range());
        self.map(|at| a.columns[at].square(), |input| a.slopes[input].mul(double))
    }

    pub(crate) fn div(&self, a: &SlopedValue, b: &SlopedValue) -> SlopedValue {
        let quotient = a.range().div(b.range());
        let by = b.range().reciprocal();
        self.map(
            |at| a.columns[at].div(b.columns[at]),
            |input| a.slopes[input].sub(quotient.mul(b.slopes[input])).mul(by),
        )
    }

    /// A function of which values and slope are known.
    pub(crate) fn chain(
        &self,
        a: &SlopedValue,
        values: impl Fn(OutwardInterval) -> OutwardInterval,
        slope: OutwardInterval,
    ) -> SlopedValue {
        self.map(|at| values(a.columns[at]), |input| a.slopes[input].mul(slope))
    }

    /// Each column widened by an error that holds over the whole box: what is known of the box holds for whatever
    /// errors its poses have.
    pub(crate) fn widened(&self, a: &SlopedValue, by: f64) -> SlopedValue {
        self.map(|at| a.columns[at].widened(by), |input| a.slopes[input])
    }

    /// The same jet, where the values over the box are met with what the slopes allow from each corner.
    pub(crate) fn met(&self, a: &SlopedValue) -> SlopedValue {
        let mut met = *a;
        let used = &a.slopes[..self.inputs];
        if !used.iter().all(|slope| slope.is_finite()) || used.iter().all(|slope| slope.is_zero()) {
            return met;
        }
        for corner in 0..1 << self.inputs {
            let mut reached = a.columns[1 + corner];
            for (input, slope) in used.iter().enumerate() {
                let (low, high) = (self.low[input], self.high[input]);
                let width = OutwardInterval::between(
                    0.0,
                    OutwardInterval::point(high).sub(OutwardInterval::point(low)).high,
                );
                let way = if corner >> input & 1 == 1 { width.neg() } else { width };
                reached = reached.add(slope.mul(way));
            }
            met.columns[0] = met.columns[0].meet(reached);
        }
        met
    }
}
