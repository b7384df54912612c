//! The choice among the ways to solve a group: each is followed from the drawing both ways, and the one whose
//! interval holds the longest motion is taken.

use super::cutting::{Found, SearchedGroup};
use super::following::{self, Band, is_inside, run};
use super::limits::{at_limit, sine};
use super::machine::Machine;
use super::pose::Posed;
use super::trace::{Sample, Trace, given};

/// The count of options that are followed: those that are farthest from their limits in the drawing.
const FOLLOWED: usize = 8;
/// The count of parts into which an unknown's interval is divided to count its roots.
const PARTS: usize = 16;
/// The most poses of a stretch for which an interval is looked at.
const LOOKED_AT: usize = 12;
/// The least measure of an option in the drawing.
const LEAST: f64 = 1e-4;
/// The share of a motion for which a shorter way to write an interval is taken.
const ENOUGH: f64 = 0.99;

/// An option with its score in the drawing.
struct Rated {
    search: SearchedGroup,
    score: f64,
}

fn length(search: &SearchedGroup) -> f64 {
    search.stretch[1] - search.stretch[0]
}

/// The reasons why no option is chosen.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Unchosen {
    /// The group is at a dead point in the drawing, or next to one.
    DeadPoint,
    /// Each option has a dyad at its limit: of one of them, the first links of its legs.
    DyadsAtLimits([usize; 2]),
    /// No interval about the drawing holds one root alone.
    NoInterval,
}

/// The option whose interval holds longest.
pub(super) fn chosen(
    machine: &Machine,
    before: &[Found],
    options: Vec<SearchedGroup>,
) -> Result<SearchedGroup, Unchosen> {
    let all: Vec<_> = options.into_iter().map(|search| rated(machine, before, search)).collect();
    // The determinant of a group is the slope of its equation times those of its dyads: where these are
    // off their limits a small slope is a dead point of the machine, whatever the option.
    let refused = all.iter().filter_map(|rated| rated.as_ref().err());
    let refused = refused.min_by_key(|cause| !matches!(cause, Unchosen::DeadPoint)).cloned();
    let mut rated: Vec<_> = all.into_iter().filter_map(Result::ok).collect();
    // The order of options decides between equals.
    rated.sort_by(|a, b| b.score.total_cmp(&a.score));
    rated.truncate(FOLLOWED);
    let otherwise = if rated.is_empty() { refused } else { None };
    let mut best: Option<SearchedGroup> = None;
    for Rated { search, .. } in rated {
        let Some(found) = followed(machine, before, search) else { continue };
        let is_better =
            |best: &SearchedGroup| match (is_inside(found.stretch), is_inside(best.stretch)) {
                (now, before) if now != before => now,
                _ => length(&found) > 1.001 * length(best),
            };
        if best.as_ref().is_none_or(is_better) {
            best = Some(found);
        }
    }
    best.ok_or(otherwise.unwrap_or(Unchosen::NoInterval))
}

fn rated(
    machine: &Machine,
    before: &[Found],
    mut search: SearchedGroup,
) -> Result<Rated, Unchosen> {
    if let Some(dyad) = at_limit(machine, &search.steps, LEAST) {
        return Err(Unchosen::DyadsAtLimits(dyad.legs.each_ref().map(|leg| leg.bodies[0])));
    }
    let mut given = given(machine, 0.0);
    let mut posed = Posed::new(machine);
    let slope = posed
        .run(before, &mut given, 0.0)
        .and_then(|()| posed.slope(&search, &mut given, 0.0))
        .unwrap_or(0.0);
    let unit = search.unit(machine);
    let dyads = search.steps.iter().filter_map(|step| match step {
        Found::Dyad(dyad) => Some(sine(machine, dyad).abs()),
        _ => None,
    });
    let score = dyads.fold(slope.abs() * unit / machine.size(), f64::min);
    search.rises = slope > 0.0;
    if score > LEAST { Ok(Rated { search, score }) } else { Err(Unchosen::DeadPoint) }
}

/// The option with the interval that holds the longest stretch about the drawing: one with constant
/// ends where it holds about as much as one that follows the drive.
fn followed(machine: &Machine, before: &[Found], search: SearchedGroup) -> Option<SearchedGroup> {
    let trace = Trace::of(machine, before, &search);
    let band = match machine.has_one_motion() {
        true => following::band(&trace, &search),
        false => None,
    };
    let constant = with_constant_ends(machine, &trace, search.clone());
    match (constant, band) {
        (Some(constant), Some(band))
            if length(&constant) >= ENOUGH * band.length()
                && is_inside(constant.stretch) >= is_inside(band.stretch) =>
        {
            Some(constant)
        }
        (_, Some(Band { following, half, stretch })) => Some(SearchedGroup {
            between: [-half, half],
            stretch,
            following: Some(following),
            ..search
        }),
        (constant, None) => constant,
    }
}

fn with_constant_ends(
    machine: &Machine,
    trace: &Trace<'_>,
    mut search: SearchedGroup,
) -> Option<SearchedGroup> {
    let last = trace.samples.len().checked_sub(1)?;
    let mut good = [trace.drawn; 2];
    let mut between = checked(machine, &search, trace, good)?;
    for size in [16, 8, 4, 2, 1] {
        loop {
            let wider =
                [[good[0], (good[1] + size).min(last)], [good[0].saturating_sub(size), good[1]]];
            let mut grew = false;
            for wider in wider.into_iter() {
                let wider = [wider[0].min(good[0]), wider[1].max(good[1])];
                if wider != good
                    && let Some(found) = checked(machine, &search, trace, wider)
                {
                    (good, between, grew) = (wider, found, true);
                }
            }
            if !grew {
                break;
            }
        }
    }
    // Only a part of the poses was looked at so far.
    let is_well = |index: usize| has_one_root(trace, &search, &trace.samples[index], between);
    good = run(trace.drawn, good, is_well)?;
    search.between = between;
    search.stretch = good.map(|index| trace.samples[index].drive);
    Some(search)
}

/// The interval of the unknown over a stretch, where everything in it assembles with one root of the
/// trend.
fn checked(
    machine: &Machine,
    search: &SearchedGroup,
    trace: &Trace<'_>,
    [first, last]: [usize; 2],
) -> Option<[f64; 2]> {
    let stretch = trace.samples.get(first..=last)?;
    let unknowns = || stretch.iter().map(|sample| sample.unknown);
    let (low, high) =
        (unknowns().fold(f64::INFINITY, f64::min), unknowns().fold(f64::NEG_INFINITY, f64::max));
    let unit = search.unit(machine);
    let margins = [0.1, 0.03, 0.01].map(|share| share * (high - low).max(0.5 * unit));
    margins.into_iter().map(|margin| [low - margin, high + margin]).find(|&between| {
        let step = stretch.len().div_ceil(LOOKED_AT).max(1);
        let looked_at = stretch.iter().step_by(step).chain(stretch.last());
        looked_at.into_iter().all(|sample| has_one_root(trace, search, sample, between))
    })
}

fn has_one_root<'m>(
    trace: &Trace<'m>,
    search: &SearchedGroup,
    sample: &Sample<'m>,
    [low, high]: [f64; 2],
) -> bool {
    // The root that is followed is the only one: the equation has its sign on each side.
    let is_on_its_side = |part: usize| {
        let unknown = low + (high - low) * part as f64 / PARTS as f64;
        let residual = trace.residual(search, sample, unknown);
        residual.is_some_and(|residual| {
            (residual > 0.0) == ((unknown > sample.unknown) == search.rises)
        })
    };
    (0..=PARTS).all(is_on_its_side)
}
