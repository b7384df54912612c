//! Verdicts about conditions that hold over a whole range.

use linkage_core::range::RangeError;

/// The verdict about a condition over a range.
#[derive(Clone, Debug, PartialEq)]
pub enum Verdict {
    /// It holds between the samples, too.
    Everywhere,
    /// It does not hold next to these inputs.
    Not {
        /// Inputs in rising order.
        at: Vec<f64>,
    },
    /// The range could not be looked at.
    Unknown(RangeError),
}

/// A condition over a range, and whether it holds between the samples.
#[derive(Clone, Debug, PartialEq)]
pub struct Confirmed {
    /// The name of the keep.
    pub keep: String,
    /// By [`limits`](linkage_core::range::limits()) or [`extrema`](linkage_core::range::extrema()).
    pub verdict: Verdict,
}

/// The inputs at which a condition is broken, none where it holds.
pub(crate) type Broken<'a, M, F> = Box<dyn Fn(&F, &M) -> Result<Vec<f64>, RangeError> + 'a>;

/// A keep at samples that is confirmed afterwards.
pub(crate) struct Guard<'a, M, F> {
    /// Index of the keep.
    pub(crate) keep: usize,
    pub(crate) broken: Broken<'a, M, F>,
}

impl<M, F> Guard<'_, M, F> {
    pub(crate) fn verdict(&self, found: &F, plain: &M) -> Verdict {
        match (self.broken)(found, plain) {
            Ok(at) if at.is_empty() => Verdict::Everywhere,
            Ok(at) => Verdict::Not { at },
            Err(error) => Verdict::Unknown(error),
        }
    }
}
