//! The choice among the ways to solve a group: each is followed from the drawing both ways, and the one whose
//! interval holds the longest motion is taken.

use super::cutting::Found;
use super::limits::sine;
use super::machine::{Driven, Machine};
use super::options::Search;
use super::pose::{Given, Posed};

/// The count of options that are followed: those that are farthest from their limits in the drawing.
const FOLLOWED: usize = 5;
/// The most poses each way.
const POSES: usize = 60;
/// The count of parts into which an unknown's interval is divided to count its roots.
const PARTS: usize = 16;
/// The most poses of a stretch for which an interval is looked at.
const LOOKED_AT: usize = 12;
/// The least measure of an option in the drawing.
const LEAST: f64 = 1e-4;

/// A pose along the motion: the first drive, the unknown, and the bodies before the group.
struct Sample<'m> {
    drive: f64,
    unknown: f64,
    before: Posed<'m>,
}

/// An option with its score in the drawing.
struct Rated {
    search: Search,
    score: f64,
}

/// The option whose interval holds longest; `None` where there is none off its limits.
pub(super) fn chosen(machine: &Machine, before: &[Found], options: Vec<Search>) -> Option<Search> {
    let mut rated: Vec<_> =
        options.into_iter().filter_map(|search| rated(machine, before, search)).collect();
    // The order of options decides between equals.
    rated.sort_by(|a, b| b.score.total_cmp(&a.score));
    rated.truncate(FOLLOWED);
    let mut best: Option<Search> = None;
    for Rated { search, .. } in rated {
        let Some(found) = followed(machine, before, search) else { continue };
        let length = |search: &Search| search.stretch[1] - search.stretch[0];
        if best.as_ref().is_none_or(|best| length(&found) > 1.001 * length(best)) {
            best = Some(found);
        }
    }
    best
}

fn given(machine: &Machine, drive: f64) -> Given {
    let mut drives = vec![0.0; machine.drives.len()];
    if let Some(first) = drives.first_mut() {
        *first = drive;
    }
    Given { drives, unknowns: vec![0.0; machine.bodies.len()] }
}

fn rated(machine: &Machine, before: &[Found], mut search: Search) -> Option<Rated> {
    let mut given = given(machine, 0.0);
    let mut posed = Posed::new(machine);
    posed.run(before, &mut given, 0.0)?;
    let slope = posed.slope(&search, &mut given, 0.0)?;
    let unit = unit(machine, &search);
    let dyads = search.steps.iter().filter_map(|step| match step {
        Found::Dyad(dyad) => Some(sine(machine, dyad).abs()),
        _ => None,
    });
    let score = dyads.fold(slope.abs() * unit / machine.size(), f64::min);
    search.rises = slope > 0.0;
    (score > LEAST).then_some(Rated { search, score })
}

/// The unit of an unknown: a radian, or the size of the machine.
fn unit(machine: &Machine, search: &Search) -> f64 {
    match search.steps[0] {
        Found::Slider { .. } => machine.size(),
        _ => 1.0,
    }
}

/// The option with the interval that holds the longest stretch about the drawing.
fn followed(machine: &Machine, before: &[Found], mut search: Search) -> Option<Search> {
    let (samples, drawn) = traced(machine, before, &search);
    let mut good = [drawn, drawn];
    let mut between = checked(machine, &search, &samples, good)?;
    for size in [16, 8, 4, 2, 1] {
        loop {
            let wider = [
                [good[0], (good[1] + size).min(samples.len() - 1)],
                [good[0].saturating_sub(size), good[1]],
            ];
            let mut grew = false;
            for wider in wider.into_iter() {
                let wider = [wider[0].min(good[0]), wider[1].max(good[1])];
                if wider != good
                    && let Some(found) = checked(machine, &search, &samples, wider)
                {
                    (good, between, grew) = (wider, found, true);
                }
            }
            if !grew {
                break;
            }
        }
    }
    search.between = between;
    search.stretch = good.map(|index| samples[index].drive);
    Some(search)
}

/// The motion both ways from the drawing until the option ends, and the place of the drawing in it.
fn traced<'m>(machine: &'m Machine, before: &[Found], search: &Search) -> (Vec<Sample<'m>>, usize) {
    let step = match machine.drives.first().map(|drive| drive.kind) {
        Some(Driven::Slide(_)) => machine.size() / 60.0,
        _ => std::f64::consts::PI / POSES as f64,
    };
    let way = |sign: f64| {
        let mut samples: Vec<Sample<'m>> = Vec::new();
        let mut given = given(machine, 0.0);
        let mut unknown = 0.0;
        for index in 0..=POSES {
            let drive = sign * step * index as f64;
            if let Some(first) = given.drives.first_mut() {
                *first = drive;
            }
            let mut posed = Posed::new(machine);
            let found = posed.run(before, &mut given, 0.0).and_then(|()| {
                let before = posed.clone();
                let root = posed.solve(search, &mut given, unknown)?;
                let slope = before.slope(search, &mut given, root)?;
                let is_near = (root - unknown).abs() < 0.4 * unit(machine, search);
                (is_near && (slope > 0.0) == search.rises).then_some((root, before))
            });
            let Some((root, before)) = found else { break };
            unknown = root;
            samples.push(Sample { drive, unknown, before });
        }
        samples
    };
    let (mut samples, ahead) = (way(-1.0), way(1.0));
    samples.reverse();
    let drawn = samples.len().saturating_sub(1);
    samples.extend(ahead.into_iter().skip(1));
    (samples, drawn)
}

/// The interval of the unknown over a stretch, where everything in it assembles with one root of the
/// trend.
fn checked(
    machine: &Machine,
    search: &Search,
    samples: &[Sample<'_>],
    [first, last]: [usize; 2],
) -> Option<[f64; 2]> {
    let stretch = samples.get(first..=last)?;
    let unknowns = || stretch.iter().map(|sample| sample.unknown);
    let (low, high) =
        (unknowns().fold(f64::INFINITY, f64::min), unknowns().fold(f64::NEG_INFINITY, f64::max));
    let unit = unit(machine, search);
    let margins = [0.1, 0.03, 0.01].map(|share| share * (high - low).max(0.5 * unit));
    margins.into_iter().map(|margin| [low - margin, high + margin]).find(|&between| {
        let step = stretch.len().div_ceil(LOOKED_AT).max(1);
        let looked_at = stretch.iter().step_by(step).chain(stretch.last());
        looked_at.into_iter().all(|sample| has_one_root(machine, search, sample, between))
    })
}

fn has_one_root(
    machine: &Machine,
    search: &Search,
    sample: &Sample<'_>,
    [low, high]: [f64; 2],
) -> bool {
    let mut given = given(machine, sample.drive);
    let residuals: Option<Vec<_>> = (0..=PARTS)
        .map(|part| {
            let unknown = low + (high - low) * part as f64 / PARTS as f64;
            sample.before.clone().residual(search, &mut given, unknown)
        })
        .collect();
    let Some(residuals) = residuals else { return false };
    let changes = residuals.windows(2).filter(|pair| (pair[0] > 0.0) != (pair[1] > 0.0)).count();
    changes == 1 && (residuals[PARTS] > 0.0) == search.rises
}
