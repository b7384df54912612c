//! The range over which a wish is shown, where limits stand in the range that was asked about.

use linkage_compiler::{EntryReport, LimitReport};

/// The parts of a turn, or of a range, that ends are rounded to.
const PARTS: f64 = 36_000.0;

/// The widest stretch of the only range, narrowed to where all bounds next to its limits are no larger than is wished;
/// none where the told distances do not show one.
pub(super) fn narrowed(
    entry: &EntryReport,
    (wished, unit): (f64, &str),
    widths: &[usize],
) -> Option<String> {
    let [range] = &entry.ranges[..] else { return None };
    let length = |[from, to]: &[f64; 2]| to - from;
    let widest = entry.stretches.iter().max_by(|a, b| length(a).total_cmp(&length(b)))?;
    let is_asked = |at: &usize| entry.results[*at].unit == unit && entry.results[*at].rates == 0;
    let asked: Vec<usize> = (0..entry.results.len()).filter(is_asked).collect();
    // The least distance that is told of at which everything is within.
    let distance = |limit: &LimitReport| {
        let is_within = |&at: &usize| {
            let bound = |&result: &usize, width: &usize| limit.bounds[result][at][*width];
            let mut all = asked
                .iter()
                .flat_map(|result| widths.iter().map(move |width| bound(result, width)));
            all.all(|bound| bound.is_some_and(|bound| bound <= wished))
        };
        (0..limit.distances.len()).rev().find(is_within).map(|at| limit.distances[at])
    };
    let [low, high] = *widest;
    let limit_at = |is_lower: bool, is_beside: &dyn Fn(f64) -> bool| {
        let beside = |limit: &&LimitReport| limit.is_lower == is_lower && is_beside(limit.at);
        let off = |limit: &&LimitReport| (limit.at - if is_lower { low } else { high }).abs();
        entry.limits.iter().filter(beside).min_by(|a, b| off(a).total_cmp(&off(b)))
    };
    let from = match limit_at(true, &|at| at <= low) {
        Some(limit) => limit.at + distance(limit)?,
        None => low,
    };
    let to = match limit_at(false, &|at| at >= high) {
        Some(limit) => limit.at - distance(limit)?,
        None => high,
    };
    let (factor, word) =
        if range.unit == "rad" { (1_f64.to_degrees(), "deg") } else { (1e3, "mm") };
    let step = match word {
        "deg" => 360.0 / PARTS,
        _ => 10_f64.powf((length(&range.ends) * factor / PARTS).log10().ceil()),
    };
    let inwards = |end: f64, round: fn(f64) -> f64| round(end * factor / step) * step;
    // The ends of the range itself stay what they are.
    let text = |end: f64, is_own: bool, round: fn(f64) -> f64| {
        let end = if is_own { end * factor } else { inwards(end, round) };
        format!("{}{word}", (end * 1e9).round() / 1e9)
    };
    let [first, last] = range.ends;
    let [from, to] = [text(from, from == first, f64::ceil), text(to, to == last, f64::floor)];
    Some(format!("--between {}={from}..{to}", range.name))
}
