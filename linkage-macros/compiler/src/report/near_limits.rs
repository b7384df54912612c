//! Bounds against the distance from a limit: next to one they grow without bound, and a bound over the whole range
//! would say nothing.

use super::LimitReport;
use super::stretches::{Stretches, failing, limit};
use crate::ir::graph::Id;
use crate::prove::demand::{Demand, Verdict};
use crate::prove::goal::Goal;
use crate::prove::one_box::OneBox;
use crate::prove::premises::Premises;
use crate::prove::sloped::InputBox;
use crate::prove::width::Precision;

/// In units of the input.
const DISTANCES: [f64; 6] = [1.0, 0.1, 1e-2, 1e-3, 1e-4, 1e-5];

/// The part of a distance over which its bound is proved.
const PART: f64 = 1e-4;

/// The proof next to a limit.
pub(super) struct Near<'a, 'g> {
    /// In double and in single precision.
    pub subjects: [&'a Goal<'g>; 2],
    pub sinks: &'a [Id],
    pub groups: &'a [String],
}

impl Near<'_, '_> {
    /// The limits at the ends of stretches inside the range.
    pub(super) fn limits(&self, stretches: &Stretches, [from, to]: [f64; 2]) -> Vec<LimitReport> {
        let mut limits = Vec::new();
        for (at, &[low, high]) in stretches.shown.iter().enumerate() {
            let before = at.checked_sub(1).map_or(from, |before| stretches.shown[before][1]);
            let after = stretches.shown.get(at + 1).map_or(to, |after| after[0]);
            if low > from {
                limits.push(self.limit([low, before], high));
            }
            if high < to {
                limits.push(self.limit([high, after], low));
            }
        }
        limits
    }

    /// The limit between a shown place and one that is not, and the bounds on the way to the stretch's other end.
    fn limit(&self, [inside, outside]: [f64; 2], other: f64) -> LimitReport {
        let [double, single] = self.subjects;
        let at = limit(double, [inside, outside]);
        let is_lower = inside > outside;
        let group = failing(double, at + (outside - inside) * 1e-9);
        let group = group.map_or_else(String::new, |group| self.groups[group as usize].clone());
        let sign = if is_lower { 1.0 } else { -1.0 };
        let room = (other - at).abs();
        let distances: Vec<f64> =
            DISTANCES.into_iter().filter(|distance| distance * (1.0 + PART) < room).collect();
        let box_at = |distance: f64| {
            let ends = [at + sign * distance, at + sign * distance * (1.0 + PART)];
            [ends[0].min(ends[1]), ends[0].max(ends[1])]
        };
        let found: Vec<[Option<OneBox<'_, '_>>; 2]> = distances
            .iter()
            .map(|&distance| {
                [double, single].map(|subject| {
                    let values = OneBox::new(subject, InputBox::new(&[box_at(distance)]));
                    (values.verdict() == Verdict::Holds).then_some(values)
                })
            })
            .collect();
        let bounds = self.sinks.iter().map(|&sink| {
            let of = |one: &Option<OneBox<'_, '_>>| {
                let one = one.as_ref().filter(|one| one.subject.unproved(sink).is_none())?;
                Some(one.bounds(sink)[0]).filter(|bound| bound.is_finite())
            };
            found.iter().map(|widths| widths.each_ref().map(of)).collect()
        });
        LimitReport { at, is_lower, group, bounds: bounds.collect(), distances }
    }
}

/// A subject over what is given, in both widths.
pub(super) fn subjects<'g>(
    graph: &'g crate::ir::graph::Graph,
    of: (&'g [Id], &'g [Demand]),
    given: &'g Premises,
) -> [Goal<'g>; 2] {
    [Precision::DOUBLE, Precision::SINGLE].map(|width| Goal::new(graph, of, given, width))
}
