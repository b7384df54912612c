//! A report as text.

use std::fmt::Write as _;

use linkage_compiler::{
    BoundReport, EntryReport, LimitReport, OperationsReport, Report, ResultReport,
};

use super::WIDTHS;
use super::numbers::{digits, exact_place, place, scaled, short, with_unit};

/// The most dimensions that a line names.
const DIMENSIONS: usize = 6;

pub(super) fn written(report: &Report, widths: &[usize]) -> String {
    let mut text = String::new();
    for entry in &report.entries {
        heading(&report.mechanism, entry, &mut text);
        table(entry, widths, &mut text);
        straight(entry, &mut text);
        for limit in &entry.limits {
            distances(entry, limit, widths[0], &mut text);
        }
        for group in &entry.transmissions {
            let [from, to] = angle_ends([group.least, group.largest]);
            let [least_at, largest_at] =
                [&group.least_at, &group.largest_at].map(|at| places(entry, at));
            let from = format!("from {from:.1}°, at {least_at}, to {to:.1}°, at {largest_at}");
            line(&mut text, &format!("Transmission angle of {}: {from}.", group.group));
        }
        let call = operations(&entry.operations);
        line(&mut text, &format!("A call on the fast path: {call}."));
        entry.beside.iter().for_each(|beside| line(&mut text, &format!("Beside: {beside}.")));
        dimensions(entry, &mut text);
        text.push('\n');
    }
    text
}

/// The ends of angles in degrees with one decimal, rounded outwards, so that they stay bounds.
fn angle_ends([least, largest]: [f64; 2]) -> [f64; 2] {
    let tenths = [least, largest].map(|angle| angle.to_degrees() * 10.0);
    // A half turn is the largest angle, however it is rounded.
    [tenths[0].floor() / 10.0, (tenths[1].ceil() / 10.0).min(180.0)]
}

fn line(text: &mut String, line: &str) {
    let _ = writeln!(text, "  {line}");
}

fn heading(mechanism: &str, entry: &EntryReport, text: &mut String) {
    let ranges = entry.ranges.iter().map(|range| {
        let [from, to] = range.ends.map(|end| place(end, &range.unit));
        format!("{} from {from} to {to}", range.name)
    });
    let given = entry.given.iter().cloned();
    let what: Vec<String> = ranges.chain(given).collect();
    let _ = writeln!(
        text,
        "{mechanism}.{}: {}; proved, with fused operations and without",
        entry.name,
        what.join(", ")
    );
}

/// The rows of a table, each column as wide as its widest.
fn aligned(rows: &[Vec<String>], text: &mut String) {
    let columns = rows.iter().map(Vec::len).max().unwrap_or(0);
    let width = |at: usize| {
        let cells = rows.iter().filter_map(|row| row.get(at));
        cells.map(|cell| cell.chars().count()).max().unwrap_or(0)
    };
    let widths: Vec<usize> = (0..columns).map(width).collect();
    for row in rows {
        let cells = row.iter().enumerate().map(|(at, cell)| {
            let blank = " ".repeat(widths[at] - cell.chars().count());
            if at == 0 { format!("{cell}{blank}") } else { format!("{blank}{cell}") }
        });
        let cells: Vec<String> = cells.collect();
        let _ = writeln!(text, "  {}", cells.join("  ").trim_end());
    }
}

fn table(entry: &EntryReport, widths: &[usize], text: &mut String) {
    let mut rows = vec![vec![String::new(), "largest".to_string()]];
    for (nth, &width) in widths.iter().enumerate() {
        rows[0].extend([format!("{} within", WIDTHS[width]), "digits".to_string()]);
        rows[0].extend((nth == 0).then(|| "worst at".to_string()));
    }
    let mut unproved = Vec::new();
    for result in &entry.results {
        match &result.bounds {
            Ok(bounds) => rows.push(row(entry, result, bounds, widths)),
            Err(why) => unproved.push(format!("{} is not proved: {why}.", result.name)),
        }
    }
    if rows.len() > 1 {
        aligned(&rows, text);
    }
    unproved.iter().for_each(|one| line(text, one));
}

/// The power of the rates behind a number, and the unit without what the rates bring.
fn measure(entry: &EntryReport, result: &ResultReport) -> (String, String) {
    let rate = match &entry.ranges[..] {
        [only] if only.unit == "rad" => "ω",
        _ => "rate",
    };
    let unit = result.unit.trim_end_matches("/s²").trim_end_matches("/s").to_string();
    // The rate of an angle by another is a number.
    let unit = if unit == "rad" && rate == "ω" { "1".to_string() } else { unit };
    match result.rates {
        0 => (result.unit.clone(), String::new()),
        1 => (unit, format!(" · {rate}")),
        _ => (unit, format!(" · {rate}²")),
    }
}

fn row(
    entry: &EntryReport,
    result: &ResultReport,
    bounds: &[BoundReport; 2],
    widths: &[usize],
) -> Vec<String> {
    let (unit, rate) = measure(entry, result);
    let largest = scaled(bounds[0].largest, &unit, 4);
    let mut row = vec![result.name.clone(), format!("{largest}{rate}")];
    for (nth, &width) in widths.iter().enumerate() {
        let bound = &bounds[width];
        let second = match bound.with_acceleration > 0.0 {
            true => format!(" + {} · α", with_unit(bound.with_acceleration, &unit)),
            false => String::new(),
        };
        let is_exact = bound.within == 0.0 && second.is_empty();
        row.push(match is_exact {
            true => "exact".to_string(),
            false => format!("{}{rate}{second}", with_unit(bound.within, &unit)),
        });
        row.push(
            digits(bound.within, bound.largest).map_or(String::new(), |of| format!("{of:.1}")),
        );
        row.extend(
            (nth == 0).then(|| if is_exact { String::new() } else { places(entry, &bound.at) }),
        );
    }
    row
}

fn places(entry: &EntryReport, at: &[f64]) -> String {
    let places = at.iter().zip(&entry.ranges).map(|(&at, range)| place(at, &range.unit));
    places.collect::<Vec<_>>().join(", ")
}

/// The sentences about the slow path.
fn straight(entry: &EntryReport, text: &mut String) {
    let rate = entry.largest_rate.map_or_else(String::new, |[double, single]| {
        format!(", up to a rate of {} (f32: {})", short(double, 4), short(single, 5))
    });
    if entry.is_straight {
        let count = match entry.comparisons {
            0 => "The fast path makes no comparison of its own".to_string(),
            1 => "The only comparison of the fast path always holds".to_string(),
            count => format!("All {count} comparisons of the fast path always hold"),
        };
        return line(text, &format!("{count}: no call takes the slow path{rate}."));
    }
    let Some(range) = entry.ranges.first().filter(|_| entry.ranges.len() == 1) else {
        let share = format!("{:.1} %", entry.share * 100.0);
        return line(
            text,
            &format!("Proved over {share} of the ranges; in the rest the slow path may decide."),
        );
    };
    let stretch = |&[from, to]: &[f64; 2], place: fn(f64, &str) -> String| {
        format!("{} to {}", place(from, &range.unit), place(to, &range.unit))
    };
    let proved: Vec<String> = entry.stretches.iter().map(|ends| stretch(ends, place)).collect();
    if !proved.is_empty() {
        line(text, &format!("Proved from {}{rate}; next to limits see below.", proved.join(", ")));
    }
    for ends in &entry.open {
        let between = stretch(ends, exact_place);
        line(text, &format!("From {between} the slow path may decide: not proved."));
    }
}

/// The bounds that grow towards a limit, by their distance.
fn distances(entry: &EntryReport, limit: &LimitReport, width: usize, text: &mut String) {
    let Some(range) = entry.ranges.first() else { return };
    let side = if limit.is_lower { "above" } else { "below" };
    let at = exact_place(limit.at, &range.unit);
    let of = if limit.group.is_empty() { String::new() } else { format!(" of {}", limit.group) };
    let width_in_words = WIDTHS[width];
    line(
        text,
        &format!(
            "Limit{of} at {at}, poses {side} it; {width_in_words} within, by the distance from it:"
        ),
    );
    let heads = limit.distances.iter().map(|distance| format!("{distance:?} {}", range.unit));
    let heads = [String::new()].into_iter().chain(heads).chain(["growth".into()]);
    let mut rows = vec![heads.collect::<Vec<_>>()];
    for (result, bounds) in entry.results.iter().zip(&limit.bounds) {
        let bounds: Vec<Option<f64>> = bounds.iter().map(|widths| widths[width]).collect();
        let Some(power) = growth(&limit.distances, &bounds).filter(|power| *power < -0.1) else {
            continue;
        };
        let (unit, rate) = measure(entry, result);
        let told = bounds.iter().map(|bound| match bound {
            Some(bound) => format!("{}{rate}", with_unit(*bound, &unit)),
            None => "slow path".to_string(),
        });
        let growth = format!("d^{power:.1}");
        rows.push([result.name.clone()].into_iter().chain(told).chain([growth]).collect());
    }
    aligned(&rows, text);
}

/// The power of the distance that a bound grows by, from two distances next to each other, the nearest of which second
/// orders say nothing yet.
fn growth(distances: &[f64], bounds: &[Option<f64>]) -> Option<f64> {
    let known: Vec<(f64, f64)> = (distances.iter().zip(bounds))
        .filter_map(|(&distance, &bound)| Some((distance, bound.filter(|bound| *bound > 0.0)?)))
        .collect();
    let [.., (far, less), (near, more)] = known[..known.len().min(4)] else { return None };
    Some((more / less).ln() / (near / far).ln())
}

fn operations(of: &OperationsReport) -> String {
    let counts = [
        (of.functions, "sine-cosine pair", "sine-cosine pairs"),
        (of.roots, "square root", "square roots"),
        (of.divisions, "division", "divisions"),
        (of.multiplications, "multiplication", "multiplications"),
        (of.additions, "addition", "additions"),
    ];
    let words = counts
        .iter()
        .filter(|(count, ..)| *count > 0)
        .map(|(count, one, many)| format!("{count} {}", if *count == 1 { one } else { many }));
    let words = words.collect::<Vec<_>>().join(", ");
    match of.fused {
        0 => words,
        fused => {
            format!("{words}, {fused} of these fused with a multiplication where the target can")
        }
    }
}

/// The effects of dimensions, the largest first.
fn dimensions(entry: &EntryReport, text: &mut String) {
    let is_told = |result: &&ResultReport| result.rates == 0 && result.bounds.is_ok();
    let results: Vec<&ResultReport> = entry.results.iter().filter(is_told).collect();
    if results.iter().all(|result| result.sensitivities.is_empty()) {
        return;
    }
    line(text, "A change of a dimension by one changes at most:");
    for result in results {
        let mut slopes: Vec<&(String, f64)> = result.sensitivities.iter().collect();
        slopes.sort_by(|a, b| b.1.total_cmp(&a.1));
        let told = slopes.iter().filter(|(_, slope)| *slope > 0.0).take(DIMENSIONS);
        let told: Vec<String> = told.map(|(name, slope)| format!("{name}: {slope:.2}")).collect();
        if !told.is_empty() {
            line(text, &format!("  {}  {}", result.name, told.join("; ")));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::angle_ends;

    #[test]
    fn angles_are_rounded_outwards() {
        assert_eq!(angle_ends([65.37_f64.to_radians(), 114.21_f64.to_radians()]), [65.3, 114.3]);
        assert_eq!(angle_ends([0.0, core::f64::consts::PI + 1e-15]), [0.0, 180.0]);
    }
}
