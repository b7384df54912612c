//! The proofs about a mechanism's solver, in numbers: errors of every result in both widths, what a dimension
//! changes, where the fast path answers, and what a call costs.
//!
//! | module | |
//! |---|---|
//! | `asked` | ranges, rates and numbers that the report is for |
//! | `comparisons` | the comparisons of an entry point's fast path |
//! | `proved_entry` | the bounds of an entry point's results |
//! | `stretches` | where of a range the fast path answers |
//! | `near_limits` | bounds against the distance from a limit |
//! | `transmission` | sines of transmission angles |
//! | `sensitivity` | what a dimension changes |
//! | `costs` | operations, and what is not straight-line |
//!
//! The numbers are those of [`prove`](crate::prove); nothing is printed here.

mod asked;
mod comparisons;
mod costs;
mod near_limits;
mod proved_entry;
mod sensitivity;
mod stretches;
mod transmission;

use proc_macro2::TokenStream;
use syn::ext::IdentExt;

use crate::diagnostics::Diagnostics;
use crate::ir::program::Program;
use crate::lower::routine::Lowered;
use crate::model::mechanism::Mechanism;

pub(crate) use asked::Asked;

/// The questions of a report. The default is all that is straight-line, over a full turn of every angle, at the
/// defaults of parameters.
#[derive(Clone, Debug, Default)]
#[non_exhaustive]
pub struct ReportOptions {
    /// The range of an input or a parameter, as in the language: `("s", "0mm..120mm")`.
    pub between: Vec<(String, String)>,
    /// The number of a parameter, a load, a drive or an input: `("rod", "420mm")`.
    pub set: Vec<(String, String)>,
    /// The rate of an input. Without one, bounds of rates are multiples of the inputs' rates, and forces are at rest.
    pub rate: Vec<(String, String)>,
    /// The entry points; without these `motion`, and forces and dynamics where there are any.
    pub only: Vec<String>,
    /// The largest error that is wished for, `1um`.
    pub within: Option<String>,
    /// The error of the target's own sine and cosine, `2^-20`, where printed C calls these.
    pub sine_error: Option<String>,
    /// The error of its own square root in last places, `1`.
    pub root_error: Option<String>,
}

/// See the module's documentation.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Report {
    /// The mechanism's name.
    pub mechanism: String,
    /// The entry points.
    pub entries: Vec<EntryReport>,
    /// The largest error that is wished for, and its unit.
    pub within: Option<(f64, String)>,
}

/// The proof of an entry point.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct EntryReport {
    /// Its name, `motion`.
    pub name: String,
    /// The ranges.
    pub ranges: Vec<RangeReport>,
    /// Values given beside: rates, loads, parameters that are not at their default.
    pub given: Vec<String>,
    /// Its numbers, in the order of the result.
    pub results: Vec<ResultReport>,
    /// The comparisons that the fast path makes.
    pub comparisons: usize,
    /// True if all of them are shown to hold over the whole range: no call takes the slow path.
    pub is_straight: bool,
    /// The stretches of one range over which the errors are proved; all of it where it is straight.
    pub stretches: Vec<[f64; 2]>,
    /// The stretches of one range in which the slow path may decide.
    pub open: Vec<[f64; 2]>,
    /// The share of several ranges over which the errors are proved.
    pub share: f64,
    /// The limits at which stretches end.
    pub limits: Vec<LimitReport>,
    /// The least sine of a transmission angle of each group with two pins or with a pin and a guide.
    pub transmissions: Vec<TransmissionReport>,
    /// The largest rate at which no call takes the slow path for its size, in double and in single precision; none
    /// where no rate is asked.
    pub largest_rate: Option<[f64; 2]>,
    /// The operations of a call.
    pub operations: OperationsReport,
    /// Parts of a call that are not straight-line, each with its bound.
    pub beside: Vec<String>,
}

/// A range.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct RangeReport {
    /// The input or the parameter.
    pub name: String,
    /// The unit of the ends, `rad`.
    pub unit: String,
    /// The ends.
    pub ends: [f64; 2],
}

/// A number of a result.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct ResultReport {
    /// The way to it, `position.C.x`.
    pub name: String,
    /// The unit, `m/s`.
    pub unit: String,
    /// The power of the inputs' rates that its numbers are multiples of.
    pub rates: u32,
    /// The bounds in double and in single precision; a reason where there is none.
    pub bounds: Result<[BoundReport; 2], String>,
    /// The most that a change of each dimension by one changes.
    pub sensitivities: Vec<(String, f64)>,
}

/// A bound in one width.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct BoundReport {
    /// The largest magnitude of the number at the places that were looked at.
    pub largest: f64,
    /// No error is larger.
    pub within: f64,
    /// No bound can be smaller by this method: what it is at a point.
    pub attained: f64,
    /// The bound of the part of an acceleration that is a multiple of the inputs' accelerations.
    pub with_acceleration: f64,
    /// Where it is worst, an entry a range.
    pub at: Vec<f64>,
}

/// A limit of a range within which the machine has poses.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct LimitReport {
    /// Where it is.
    pub at: f64,
    /// True if the poses lie above it.
    pub is_lower: bool,
    /// The group that is at its limit.
    pub group: String,
    /// Distances from it.
    pub distances: Vec<f64>,
    /// By result, the bound at each distance in double and in single precision; none where the slow path may decide.
    pub bounds: Vec<Vec<[Option<f64>; 2]>>,
}

/// The transmission angle of a group over the ranges.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct TransmissionReport {
    /// The group, `BC, DC`.
    pub group: String,
    /// The transmission angle in radians, from 0 to π, is nowhere less where errors are proved.
    pub least: f64,
    /// Where it is least, an entry a range.
    pub least_at: Vec<f64>,
    /// The angle is nowhere larger.
    pub largest: f64,
    /// Where it is largest.
    pub largest_at: Vec<f64>,
}

/// The operations of a call on the fast path.
#[derive(Clone, Copy, Debug, Default)]
#[non_exhaustive]
pub struct OperationsReport {
    /// Additions and subtractions.
    pub additions: u32,
    /// Multiplications.
    pub multiplications: u32,
    /// The pairs of both that are one fused operation where the target has it.
    pub fused: u32,
    /// Divisions.
    pub divisions: u32,
    /// Square roots.
    pub roots: u32,
    /// Pairs of sine and cosine, and other functions.
    pub functions: u32,
}

/// The report on a mechanism; none where what is asked is a mistake, which is reported.
pub(crate) fn of(
    mechanism: &Mechanism,
    (program, lowered): (&Program, &Lowered<'_>),
    source: &TokenStream,
    options: &ReportOptions,
    diagnostics: &mut Diagnostics,
) -> Option<Report> {
    let asked = Asked::of(mechanism, lowered, options, diagnostics)?;
    let sensitive = sensitivity::Sensitive::of(source);
    let entries = asked.entries.iter().map(|&id| {
        let entry = proved_entry::Proved { mechanism, program, lowered, asked: &asked, id };
        entry.report(sensitive.as_ref())
    });
    let entries = entries.collect();
    Some(Report { mechanism: mechanism.name.unraw().to_string(), entries, within: asked.within })
}
