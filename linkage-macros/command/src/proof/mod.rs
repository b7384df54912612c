//! `linkage report`: what is proved of a solver, as text or JSON.

mod json;
mod narrowed;
mod numbers;
mod text;

use linkage_compiler::{Report, ReportOptions};

use crate::arguments;
use crate::output::{self, Failure};
use crate::program::Program;
use crate::style;

/// Double and single precision, as reports hold them.
pub(crate) const WIDTHS: [&str; 2] = ["f64", "f32"];

pub(crate) fn run(arguments: &arguments::ReportArguments) -> Result<(), Failure> {
    let program = Program::read(&arguments.file, &arguments.chosen)?;
    let mut options = ReportOptions::default();
    options.between = pairs(&arguments.between)?;
    options.set = [pairs(&arguments.at)?, pairs(&arguments.load)?].concat();
    options.rate = pairs(&arguments.rate)?;
    options.only = arguments.only.clone();
    options.within = arguments.within.clone();
    options.sine_error = arguments.sine_error.clone();
    options.root_error = arguments.sqrt_error.clone();
    let make = |declaration| linkage_compiler::report(declaration, &options);
    let reports = program.all(make)?;
    // Single precision first: it is what is asked about.
    let widths: Vec<usize> = (0..WIDTHS.len())
        .rev()
        .filter(|&width| arguments.width.as_deref().is_none_or(|only| only == WIDTHS[width]))
        .collect();
    let written = match arguments.json {
        true => json::written(&reports, &widths),
        false => reports.iter().map(|report| text::written(report, &widths)).collect(),
    };
    output::text(arguments.target.output.as_deref(), &written, arguments.target.stale)?;
    let missed: Vec<String> = reports.iter().flat_map(|report| missed(report, &widths)).collect();
    missed.iter().for_each(|line| style::tell(line));
    if missed.is_empty() { Ok(()) } else { Err(Failure::Told) }
}

/// `NAME=VALUE`
fn pairs(texts: &[String]) -> Result<Vec<(String, String)>, Failure> {
    let pair = |text: &String| {
        let (name, value) = text
            .split_once('=')
            .ok_or_else(|| Failure::Unusable(format!("write `NAME=VALUE` in place of `{text}`")))?;
        Ok((name.trim().to_string(), value.trim().to_string()))
    };
    texts.iter().map(pair).collect()
}

/// The part of the wish that is not shown.
fn missed(report: &Report, widths: &[usize]) -> Vec<String> {
    let Some((wished, unit)) = &report.within else { return Vec::new() };
    let mut missed = Vec::new();
    let mut has_one = false;
    for entry in &report.entries {
        let own = entry.results.iter().filter(|result| result.unit == *unit && result.rates == 0);
        for result in own {
            has_one = true;
            let name = format!("{}.{} {}", report.mechanism, entry.name, result.name);
            match &result.bounds {
                Err(why) => missed.push(format!("`{name}` is not proved: {why}")),
                Ok(bounds) => {
                    for &width in widths.iter().filter(|&&width| bounds[width].within > *wished) {
                        missed.push(format!(
                            "`{name}` is proved within {} in {}, not within {}",
                            numbers::with_unit(bounds[width].within, unit),
                            WIDTHS[width],
                            numbers::with_unit(*wished, unit)
                        ));
                    }
                }
            }
        }
        if !entry.is_straight {
            let narrowed = narrowed::narrowed(entry, (*wished, unit), widths);
            missed.push(format!(
                "`{}.{}` is not proved over the whole range: narrow it by `{}`",
                report.mechanism,
                entry.name,
                narrowed.as_deref().unwrap_or("--between")
            ));
        }
    }
    if !has_one {
        missed.push(format!("`{}` has no result in {unit}", report.mechanism));
    }
    missed
}
