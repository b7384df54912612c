//! Rows of numbers that a machine gives at each of some inputs: residuals of aims, and reserves of keeps.

use linkage_core::SolveError;
use linkage_core::num_dual::{Derivative, DualSVec};
use nalgebra::{DMatrix, DVector};

/// A number with its derivatives by N parameters.
pub type Dual<const N: usize> = DualSVec<f64, N>;

/// Why rows were not computed, and at which place of the list of inputs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Cause {
    Refused(SolveError),
    NotANumber,
}

/// Where a block failed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Failure {
    /// Index of the block among aims and then keeps.
    pub(crate) block: usize,
    /// Index of the input.
    pub(crate) place: usize,
    pub(crate) cause: Cause,
}

/// A machine with derivatives by its parameters, and the same without.
pub(crate) struct Machines<M> {
    pub(crate) sloped: M,
    /// For places that are sought along an input: they do not need the derivatives.
    pub(crate) plain: M,
}

/// The rows of machines, at samples that a search may add to.
type Compute<'a, M, const N: usize> = dyn Fn(&Machines<M>, &[f64], &mut Vec<Dual<N>>) -> Result<(), (usize, Cause)>
    + Send
    + Sync
    + 'a;

type Place<'a> = dyn Fn(&[f64], usize) -> String + Send + Sync + 'a;

/// An aim or a keep.
pub(crate) struct Block<'a, M, const N: usize> {
    pub(crate) name: String,
    compute: Box<Compute<'a, M, N>>,
    place: Box<Place<'a>>,
    /// Rows at a place.
    width: usize,
    /// Inputs that confirmation may add to.
    pub(crate) samples: Vec<f64>,
    /// Numbers beside the parameters that the rows were freed of.
    pub(crate) eliminated: usize,
}

impl<'a, M: 'a, const N: usize> Block<'a, M, N> {
    /// Rows by a function at each of some inputs.
    pub(crate) fn each<Q: Copy + core::fmt::Debug + Send + Sync + 'a, const R: usize>(
        name: &str,
        at: Vec<Q>,
        rows: impl Fn(&M, Q) -> Result<[Dual<N>; R], SolveError> + Send + Sync + 'a,
    ) -> Self {
        let places = at.clone();
        let compute = move |machines: &Machines<M>, _: &[f64], to: &mut Vec<Dual<N>>| {
            for (place, &q) in at.iter().enumerate() {
                to.extend(
                    rows(&machines.sloped, q).map_err(|error| (place, Cause::Refused(error)))?,
                );
                finite(&to[to.len() - R..]).map_err(|cause| (place, cause))?;
            }
            Ok(())
        };
        Self::of(name, R, 0, compute, move |_, place| format!("{:?}", places[place]))
    }

    /// Rows by a function of the whole machine.
    pub(crate) fn of(
        name: &str,
        width: usize,
        eliminated: usize,
        compute: impl Fn(&Machines<M>, &[f64], &mut Vec<Dual<N>>) -> Result<(), (usize, Cause)>
        + Send
        + Sync
        + 'a,
        place: impl Fn(&[f64], usize) -> String + Send + Sync + 'a,
    ) -> Self {
        let (compute, place) = (Box::new(compute), Box::new(place));
        Self { name: name.into(), compute, place, width, samples: Vec::new(), eliminated }
    }

    /// Rows by a function at samples.
    pub(crate) fn sampled(
        name: &str,
        samples: Vec<f64>,
        width: usize,
        rows: impl Fn(&M, f64, &mut Vec<Dual<N>>) -> Result<(), SolveError> + Send + Sync + 'a,
    ) -> Self {
        let compute = move |machines: &Machines<M>, samples: &[f64], to: &mut Vec<Dual<N>>| {
            for (place, &q) in samples.iter().enumerate() {
                let before = to.len();
                rows(&machines.sloped, q, to).map_err(|error| (place, Cause::Refused(error)))?;
                finite(&to[before..]).map_err(|cause| (place, cause))?;
            }
            Ok(())
        };
        let place = |samples: &[f64], place: usize| format!("{:?}", samples[place]);
        Self { samples, ..Self::of(name, width, 0, compute, place) }
    }

    /// Adds the rows of this block.
    pub(crate) fn add(
        &self,
        machines: &Machines<M>,
        to: &mut Vec<Dual<N>>,
    ) -> Result<(), (usize, Cause)> {
        (self.compute)(machines, &self.samples, to)
    }

    /// The input at a place of the list.
    pub(crate) fn place(&self, place: usize) -> String {
        (self.place)(&self.samples, place)
    }

    /// The input that a row belongs to.
    pub(crate) fn input_of(&self, row: usize) -> String {
        self.place(row / self.width.max(1))
    }
}

/// Checks that a function gave numbers. A derivative that does not exist, as at the limit of assembly, is a
/// refusal: the machine is sound, and a search goes elsewhere.
pub(crate) fn finite<const N: usize>(rows: &[Dual<N>]) -> Result<(), Cause> {
    let is_smooth = |row: &Dual<N>| match &row.eps {
        Derivative(Some(slopes)) => slopes.iter().all(|slope| slope.is_finite()),
        _ => true,
    };
    if !rows.iter().all(|row| row.re.is_finite()) {
        return Err(Cause::NotANumber);
    }
    let singular = Cause::Refused(SolveError::Singular { group: "the derivative" });
    rows.iter().all(is_smooth).then_some(()).ok_or(singular)
}

/// The rows of all blocks, with derivatives where the machine's parameters carry any.
pub(crate) fn computed<'a, M: 'a, const N: usize>(
    blocks: &[Block<'a, M, N>],
    first: usize,
    machines: &Machines<M>,
) -> Result<Vec<Dual<N>>, Failure> {
    let mut rows = Vec::new();
    for (index, block) in blocks.iter().enumerate() {
        block.add(machines, &mut rows).map_err(|(place, cause)| Failure {
            block: first + index,
            place,
            cause,
        })?;
    }
    Ok(rows)
}

/// The name and the input of each row of some blocks.
pub(crate) fn named<'a, M: 'a, const N: usize>(
    blocks: &[Block<'a, M, N>],
    machines: &Machines<M>,
) -> Vec<(String, String)> {
    let mut all = Vec::new();
    for block in blocks {
        let mut rows = Vec::new();
        // A block that fails has been told of already.
        let _ = block.add(machines, &mut rows);
        all.extend((0..rows.len()).map(|row| (block.name.clone(), block.input_of(row))));
    }
    all
}

/// Values, and a row of derivatives for each.
#[derive(Clone, Debug, PartialEq)]
pub struct Rows {
    /// The numbers.
    pub values: DVector<f64>,
    /// Their derivatives, a column a parameter.
    pub slopes: DMatrix<f64>,
}

impl Rows {
    pub(crate) fn of<const N: usize>(duals: &[Dual<N>], scale: &[f64; N]) -> Self {
        let values = DVector::from_iterator(duals.len(), duals.iter().map(|dual| dual.re));
        let slope = |row: usize, column: usize| match &duals[row].eps {
            Derivative(Some(slopes)) => slopes[column] * scale[column],
            _ => 0.0,
        };
        Self { values, slopes: DMatrix::from_fn(duals.len(), N, slope) }
    }
}
