//! Reports as JSON, with every number in SI and nothing rounded.

use linkage_compiler::{BoundReport, EntryReport, LimitReport, Report, ResultReport};
use serde_json::{Map, Value, json};

use super::WIDTHS;
use super::numbers::digits;

/// Suppositions about the target.
const ASSUMES: &str =
    "round to nearest, subnormal numbers are kept; with fused operations and without";

pub(super) fn written(reports: &[Report], widths: &[usize]) -> String {
    let reports: Vec<Value> = reports.iter().map(|report| of_report(report, widths)).collect();
    let text = serde_json::to_string_pretty(&reports).expect("numbers and texts are JSON");
    format!("{text}\n")
}

fn of_report(report: &Report, widths: &[usize]) -> Value {
    let entries: Vec<Value> = report.entries.iter().map(|entry| of_entry(entry, widths)).collect();
    json!({ "mechanism": report.mechanism, "assumes": ASSUMES, "entries": entries })
}

fn of_entry(entry: &EntryReport, widths: &[usize]) -> Value {
    let ranges = entry.ranges.iter().map(|range| {
        json!({ "name": range.name, "unit": range.unit, "from": range.ends[0], "to": range.ends[1] })
    });
    let transmissions = entry.transmissions.iter().map(|of| {
        json!({
            "group": of.group,
            "least": of.least,
            "least_at": of.least_at,
            "largest": of.largest,
            "largest_at": of.largest_at,
        })
    });
    let operations = json!({
        "additions": entry.operations.additions,
        "multiplications": entry.operations.multiplications,
        "fused": entry.operations.fused,
        "divisions": entry.operations.divisions,
        "roots": entry.operations.roots,
        "functions": entry.operations.functions,
    });
    let largest_rate =
        entry.largest_rate.map(|rates| by_width(widths, |width| json!(rates[width])));
    json!({
        "entry": entry.name,
        "ranges": ranges.collect::<Vec<_>>(),
        "given": entry.given,
        "straight": entry.is_straight,
        "comparisons": entry.comparisons,
        "proved_over": entry.stretches,
        "open": entry.open,
        "share": entry.share,
        "largest_rate": largest_rate,
        "results": entry.results.iter().map(|result| of_result(result, widths)).collect::<Vec<_>>(),
        "limits": entry.limits.iter().map(|limit| of_limit(entry, limit, widths)).collect::<Vec<_>>(),
        "transmissions": transmissions.collect::<Vec<_>>(),
        "operations": operations,
        "beside": entry.beside,
    })
}

/// An object with a field a width.
fn by_width(widths: &[usize], of: impl Fn(usize) -> Value) -> Value {
    let fields = widths.iter().map(|&width| (WIDTHS[width].to_string(), of(width)));
    Value::Object(fields.collect::<Map<_, _>>())
}

fn of_result(result: &ResultReport, widths: &[usize]) -> Value {
    let sensitivities: Map<String, Value> =
        result.sensitivities.iter().map(|(name, slope)| (name.clone(), json!(slope))).collect();
    let mut told = json!({
        "result": result.name,
        "unit": result.unit,
        "power_of_rates": result.rates,
        "sensitivities": sensitivities,
    });
    let fields = told.as_object_mut().expect("it is an object");
    match &result.bounds {
        Ok(bounds) => {
            fields.insert("largest".to_string(), json!(bounds[0].largest));
            for &width in widths {
                fields.insert(WIDTHS[width].to_string(), of_bound(&bounds[width]));
            }
        }
        Err(why) => {
            fields.insert("not_proved".to_string(), json!(why));
        }
    }
    told
}

fn of_bound(bound: &BoundReport) -> Value {
    json!({
        "within": bound.within,
        "within_by_second_rates": bound.with_acceleration,
        "attained": bound.attained,
        "digits": digits(bound.within, bound.largest),
        "worst_at": bound.at,
    })
}

fn of_limit(entry: &EntryReport, limit: &LimitReport, widths: &[usize]) -> Value {
    let of_result = |(result, bounds): (&ResultReport, &Vec<[Option<f64>; 2]>)| {
        let of_width =
            |width: usize| json!(bounds.iter().map(|both| both[width]).collect::<Vec<_>>());
        (result.name.clone(), by_width(widths, of_width))
    };
    let bounds: Map<String, Value> =
        entry.results.iter().zip(&limit.bounds).map(of_result).collect();
    json!({
        "at": limit.at,
        "poses": if limit.is_lower { "above" } else { "below" },
        "group": limit.group,
        "distances": limit.distances,
        "within": bounds,
    })
}
