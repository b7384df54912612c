//! The choice among the ways to solve a group: each is followed from the drawing both ways, one input after the
//! other, and the one whose interval holds the longest motion is taken.

use super::cutting::{Found, SearchedGroup};
use super::following::{self, Band, is_inside, run};
use super::limits::{at_limit, sine};
use super::machine::Machine;
use super::pose::Posed;
use super::trace::{Sample, Trace, Way, drawn};

/// The count of options that are followed: those that are farthest from their limits in the drawing.
const FOLLOWED: usize = 8;
/// The count of parts into which an unknown's interval is divided to count its roots.
const PARTS: usize = 16;
/// The most poses of a stretch for which an interval is looked at.
const LOOKED_AT: usize = 12;
/// The least measure of an option in the drawing.
const LEAST: f64 = 1e-4;
/// The part of an unknown's unit to which roots are found.
const ROUNDING: f64 = 1e-11;
/// The share of a motion for which a shorter way to write an interval is taken.
const ENOUGH: f64 = 0.99;

/// An option with its score in the drawing.
struct Rated {
    search: SearchedGroup,
    score: f64,
}

/// The motions that an interval holds.
#[derive(Clone, Copy, Debug)]
struct Motion {
    /// The count of those that go on from the drawing both ways, and of inputs that move nothing.
    going_on: usize,
    /// In steps.
    length: f64,
}

impl Motion {
    fn of(stretches: &[[f64; 2]], ways: &[Way]) -> Self {
        let of = || stretches.iter().zip(ways);
        let going_on = of().filter(|(stretch, way)| way.rests() || is_inside(**stretch)).count();
        Self { going_on, length: of().map(|([from, to], way)| (to - from) / way.step).sum() }
    }

    fn is_better_than(self, other: Self) -> bool {
        match self.going_on == other.going_on {
            true => self.length > 1.001 * other.length,
            false => self.going_on > other.going_on,
        }
    }
}

impl SearchedGroup {
    fn motion(&self, ways: &[Way]) -> Motion {
        Motion::of(&self.stretches, ways)
    }
}

/// The reasons why no option is chosen.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Unchosen {
    /// The group is at a dead point in the drawing, or next to one.
    DeadPoint,
    /// Each option has a dyad at its limit: of one of them, the first links of its legs.
    DyadsAtLimits([usize; 2]),
    /// No interval about the drawing holds one root alone.
    NoInterval,
}

/// The option whose interval holds longest.
pub fn chosen(
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
    // Without an interval, a motion that ends where it is drawn does so at a dead point.
    let mut ends = !rated.is_empty();
    let ways = Way::all(machine);
    let mut best: Option<SearchedGroup> = None;
    for Rated { search, .. } in rated {
        let traces: Vec<_> =
            ways.iter().map(|way| Trace::of(machine, before, &search, way)).collect();
        ends &= traces.iter().any(Trace::ends_at_the_drawing);
        let best_so_far = best.as_ref().map(|best| best.motion(&ways));
        let whole: Vec<_> = traces.iter().map(Trace::whole).collect();
        // An interval holds no more than its motions.
        if best_so_far.is_some_and(|best| !Motion::of(&whole, &ways).is_better_than(best)) {
            continue;
        }
        let Some(found) = followed(machine, &traces, search, &ways) else { continue };
        if best_so_far.is_none_or(|best| found.motion(&ways).is_better_than(best)) {
            best = Some(found);
        }
    }
    let otherwise = otherwise.or(ends.then_some(Unchosen::DeadPoint));
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
    let mut given = drawn(machine);
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
fn followed(
    machine: &Machine,
    traces: &[Trace<'_>],
    search: SearchedGroup,
    ways: &[Way],
) -> Option<SearchedGroup> {
    let band = match traces {
        [trace] if machine.has_one_motion() => following::band(trace, &search),
        _ => None,
    };
    let constant = with_constant_ends(machine, traces, &search, ways);
    match (constant, band) {
        (Some(constant), Some(band))
            if constant.motion(ways).length >= ENOUGH * band.length() / ways[0].step
                && constant.motion(ways).going_on >= usize::from(is_inside(band.stretch)) =>
        {
            Some(constant)
        }
        (_, Some(Band { following, half, stretch })) => Some(SearchedGroup {
            between: [-half, half],
            stretches: vec![stretch],
            following: Some(following),
            ..search
        }),
        (constant, None) => constant,
    }
}

/// The option with an interval of constant ends: one that grows by long stretches first, or where some motion ends in
/// the drawing then, by a pose of each before.
fn with_constant_ends(
    machine: &Machine,
    traces: &[Trace<'_>],
    search: &SearchedGroup,
    ways: &[Way],
) -> Option<SearchedGroup> {
    let growing = Growing::of(machine, traces, search)?;
    let found = growing.clone().grown()?;
    let going_on = |found: &SearchedGroup| found.motion(ways).going_on;
    if going_on(&found) == ways.len() {
        return Some(found);
    }
    let mut evenly = growing;
    evenly.grow(1);
    let evenly = evenly.grown()?;
    Some(if going_on(&evenly) > going_on(&found) { evenly } else { found })
}

/// An interval of constant ends that grows with the stretches that it holds.
#[derive(Clone)]
struct Growing<'t, 'm> {
    machine: &'m Machine,
    traces: &'t [Trace<'m>],
    search: &'t SearchedGroup,
    /// The first and the last index of each stretch.
    good: Vec<[usize; 2]>,
    between: [f64; 2],
}

impl<'t, 'm> Growing<'t, 'm> {
    /// About the drawing alone.
    fn of(
        machine: &'m Machine,
        traces: &'t [Trace<'m>],
        search: &'t SearchedGroup,
    ) -> Option<Self> {
        let good: Vec<_> = traces.iter().map(|trace| [trace.drawn; 2]).collect();
        let between = checked(machine, search, traces, &good)?;
        Some(Self { machine, traces, search, good, between })
    }

    /// Lets each stretch grow by so many poses both ways; false where none can.
    fn grow(&mut self, size: usize) -> bool {
        let mut grew = false;
        for way in 0..self.traces.len() {
            let [first, last] = self.good[way];
            let end = self.traces[way].samples.len() - 1;
            let wider = [[first, (last + size).min(end)], [first.saturating_sub(size), last]];
            for wider in wider {
                let wider = [wider[0].min(self.good[way][0]), wider[1].max(self.good[way][1])];
                let mut all = self.good.clone();
                all[way] = wider;
                if wider != self.good[way]
                    && let Some(found) = checked(self.machine, self.search, self.traces, &all)
                {
                    (self.good, self.between, grew) = (all, found, true);
                }
            }
        }
        grew
    }

    fn grown(mut self) -> Option<SearchedGroup> {
        for size in [16, 8, 4, 2, 1] {
            while self.grow(size) {}
        }
        let Self { traces, search, between, .. } = self;
        // Only a part of the poses was looked at so far.
        let mut stretches = Vec::new();
        for (trace, good) in traces.iter().zip(self.good) {
            let is_well =
                |index: usize| has_one_root(trace, search, &trace.samples[index], between);
            let good = run(trace.drawn, good, is_well)?;
            stretches.push(good.map(|index| trace.samples[index].drive));
        }
        Some(SearchedGroup { between, stretches, ..search.clone() })
    }
}

/// The interval of the unknown over stretches, where everything in it assembles with one root of the
/// trend.
fn checked(
    machine: &Machine,
    search: &SearchedGroup,
    traces: &[Trace<'_>],
    good: &[[usize; 2]],
) -> Option<[f64; 2]> {
    let stretches = traces.iter().zip(good).map(|(trace, [first, last])| {
        let poses = trace.samples.get(*first..=*last)?;
        Some((trace, poses))
    });
    let stretches: Vec<_> = stretches.collect::<Option<_>>()?;
    let unknowns =
        || stretches.iter().flat_map(|(_, poses)| poses.iter().map(|sample| sample.unknown));
    let (low, high) =
        (unknowns().fold(f64::INFINITY, f64::min), unknowns().fold(f64::NEG_INFINITY, f64::max));
    let unit = search.unit(machine);
    let margins = [0.1, 0.03, 0.01].map(|share| share * (high - low).max(0.5 * unit));
    margins.into_iter().map(|margin| [low - margin, high + margin]).find(|&between| {
        stretches.iter().all(|(trace, poses)| {
            let step = poses.len().div_ceil(LOOKED_AT).max(1);
            let looked_at = poses.iter().step_by(step).chain(poses.last());
            looked_at.into_iter().all(|sample| has_one_root(trace, search, sample, between))
        })
    })
}

fn has_one_root<'m>(
    trace: &Trace<'m>,
    search: &SearchedGroup,
    sample: &Sample<'m>,
    [low, high]: [f64; 2],
) -> bool {
    // The root that is followed is the only one: the equation has its sign on each side. At the root it has none.
    let (mut residual, rounding) =
        (trace.residuals(search, sample), ROUNDING * search.unit(trace.machine));
    let is_on_its_side = |part: usize| {
        let unknown = low + (high - low) * part as f64 / PARTS as f64;
        let from_root = unknown - sample.unknown;
        let is_root = from_root.abs() < rounding;
        residual(unknown).is_some_and(|residual| {
            is_root || (residual > 0.0) == ((from_root > 0.0) == search.rises)
        })
    };
    (0..=PARTS).all(is_on_its_side)
}
