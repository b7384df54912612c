//! Intervals that follow the drive: the unknown is measured from a fit of its traced value.
//!
//! A dimension of the fit is never part of a result: the unknown makes up for what the fit is off by.
//! All that it decides is where the search looks, so a fit is good once it is within a part of the room
//! about the roots, and the lowest degree that is good is taken.

use std::cell::OnceCell;
use std::f64::consts::PI;
use std::ops::RangeInclusive;

use super::curve::{Beside, Curve};
use super::cutting::SearchedGroup;
use super::fit::Following;
use super::machine::Driven;
use super::trace::{LEAST_ROOM, Sample, Trace};

/// The degrees that are tried, without and with square roots towards dead points.
const FITS: [(usize, Beside); 12] = [
    (3, Beside::Nothing),
    (5, Beside::Nothing),
    (5, Beside::DeadEnds),
    (8, Beside::Nothing),
    (8, Beside::DeadEnds),
    (12, Beside::Nothing),
    (12, Beside::DeadEnds),
    (16, Beside::Nothing),
    (16, Beside::DeadEnds),
    (20, Beside::DeadEnds),
    (24, Beside::DeadEnds),
    (24, Beside::Nothing),
];
/// Those behind them, with bends next to dead points.
const BENT: [(usize, Beside); 4] =
    [(8, Beside::NearDead), (12, Beside::NearDead), (16, Beside::NearDead), (24, Beside::NearDead)];
/// The share of the longest stretch for which a lower degree is taken.
const ENOUGH: f64 = 0.99;
/// The ratio of lengths from which on an interval in which the equation turns back is taken for one in which it does not.
const LONGER: f64 = 1.001;
/// The half width of an interval, as a multiple of what its fit is off by in the poses that were
/// followed: between them it may be off by more.
const MARGIN: f64 = 3.0;
/// The longest stretch of an angle that is no full turn: near a turn sin x is zero at both ends.
const ALMOST_A_TURN: f64 = 1.8 * PI;

/// An interval about a fit, and the stretch on which it is good.
#[derive(Clone)]
pub struct Band {
    pub following: Following,
    pub half: f64,
    pub stretch: [f64; 2],
}

impl Band {
    pub(super) fn length(&self) -> f64 {
        self.stretch[1] - self.stretch[0]
    }
}

/// The interval that holds the longest stretch about the drawing. Where intervals in which the equation keeps its trend
/// do not hold the motion, it may turn back in them.
pub fn band(trace: &Trace<'_>, search: &SearchedGroup) -> Option<Band> {
    let [first, .., last] = &trace.samples[..] else { return None };
    let mut rooms = Rooms::of(trace, search);
    let narrow = longest(trace, &rooms);
    let whole = last.drive - first.drive;
    let enough = if trace.closes.is_some() { 1.0 } else { ENOUGH };
    if narrow.as_ref().is_some_and(|band| band.length() >= enough * whole) {
        return narrow;
    }
    rooms.may_turn_back = true;
    let wide = longest(trace, &rooms);
    match (narrow, wide) {
        (narrow, Some(wide)) if is_inside(wide.stretch) && is_longer(&wide, narrow.as_ref()) => {
            Some(wide)
        }
        (narrow, _) => narrow,
    }
}

/// True if a band that goes on from the drawing both ways is longer than another one, or that one does not.
fn is_longer(band: &Band, other: Option<&Band>) -> bool {
    other.is_none_or(|other| !is_inside(other.stretch) || band.length() > LONGER * other.length())
}

fn longest(trace: &Trace<'_>, rooms: &Rooms<'_, '_>) -> Option<Band> {
    let bent = if rooms.may_turn_back { &BENT[..] } else { &[] };
    let fits = FITS.iter().chain(bent);
    // No interval holds more than the whole motion.
    let mut is_whole = false;
    let bands = fits.map_while(|&fit| {
        let band = if is_whole { return None } else { fitted(trace, rooms, fit) };
        is_whole = band.as_ref().is_some_and(|band| band.stretch == trace.whole());
        Some(band)
    });
    let bands: Vec<_> = bands.flatten().collect();
    let inside: Vec<_> = bands.iter().filter(|band| is_inside(band.stretch)).cloned().collect();
    let bands = if inside.is_empty() { bands } else { inside };
    let longest = bands.iter().map(Band::length).fold(0.0, f64::max);
    bands.into_iter().find(|band| band.length() >= ENOUGH * longest)
}

/// The widths about the roots of a trace in which an interval may lie.
struct Rooms<'t, 'm> {
    trace: &'t Trace<'m>,
    search: &'t SearchedGroup,
    /// The widths on which the equation keeps its trend.
    with_trend: Vec<f64>,
    /// Those on which a root is the only one of the trend, as far as they were asked for.
    alone: Vec<OnceCell<f64>>,
    may_turn_back: bool,
}

impl<'t, 'm> Rooms<'t, 'm> {
    fn of(trace: &'t Trace<'m>, search: &'t SearchedGroup) -> Self {
        let with_trend = trace.samples.iter().map(|sample| trace.room(search, sample)).collect();
        let alone = trace.samples.iter().map(|_| OnceCell::new()).collect();
        Self { trace, search, with_trend, alone, may_turn_back: false }
    }

    /// True if there is as much room about the root of a pose. Next to its own dead point it has none.
    fn have(&self, index: usize, width: f64) -> bool {
        let with_trend = self.with_trend[index];
        let alone = || self.trace.width_alone(self.search, &self.trace.samples[index]);
        width <= with_trend
            || self.may_turn_back
                && with_trend > 0.0
                && width <= *self.alone[index].get_or_init(alone)
    }
}

/// True if the motion goes on from the drawing both ways.
pub(super) fn is_inside(stretch: [f64; 2]) -> bool {
    stretch[0] < 0.0 && stretch[1] > 0.0
}

fn length(samples: &[Sample<'_>], [first, last]: [usize; 2]) -> f64 {
    samples[last].drive - samples[first].drive
}

/// The longest run about an index where all is well.
pub(super) fn run(
    from: usize,
    all: [usize; 2],
    is_well: impl Fn(usize) -> bool,
) -> Option<[usize; 2]> {
    if !is_well(from) {
        return None;
    }
    let first = (all[0]..from).rev().take_while(|&index| is_well(index)).last().unwrap_or(from);
    let last = (from..=all[1]).take_while(|&index| is_well(index)).last().unwrap_or(from);
    Some([first, last])
}

fn fitted(trace: &Trace<'_>, rooms: &Rooms<'_, '_>, fit: (usize, Beside)) -> Option<Band> {
    let samples = &trace.samples;
    let least = LEAST_ROOM * rooms.search.unit(trace.machine);
    let is_angle = trace.machine.drives.first().is_none_or(|drive| drive.kind == Driven::Angle);
    let all = [0, samples.len().checked_sub(1)?];
    let mut range = run(trace.drawn, all, |index| rooms.have(index, least))?;
    loop {
        let is_whole = range == all;
        let turns = trace.closes.filter(|_| is_whole);
        while is_angle && turns.is_none() && length(samples, range) > ALMOST_A_TURN {
            // The end farther from the drawing.
            match samples[range[1]].drive > -samples[range[0]].drive {
                true => range[1] -= 1,
                false => range[0] += 1,
            }
        }
        let curve = Curve::of(&samples[range[0]..=range[1]], turns, is_angle)?;
        let following = curve.fitted(fit)?;
        let digits = (MARGIN * curve.off(&following)).max(least).log10().floor();
        let following = following.rounded(10_f64.powf(digits - 3.0));
        let half = (MARGIN * curve.off(&following)).max(least);
        // Rounded up to two digits.
        let step = 10_f64.powf(half.log10().floor() - 1.0);
        let half = (half / step).ceil() * step;
        let off =
            |index: usize| (samples[index].unknown - following.at(samples[index].drive)).abs();
        let is_well = |index: usize| rooms.have(index, off(index) + half);
        match run(trace.drawn, range, is_well) {
            Some(same) if same == range => {
                let stretch = range.map(|index| samples[index].drive);
                return Some(Band { following, half, stretch });
            }
            Some(less) => range = less,
            None => {
                // A fit that is bad everywhere is so by one of its ends.
                let cut = (range[1] - range[0]).div_ceil(10);
                let worst = |range: RangeInclusive<usize>| range.map(off).fold(0.0, f64::max);
                let [first, last] = range;
                match worst(first..=first + cut) > worst(last - cut..=last) {
                    true if first + cut <= trace.drawn => range[0] += cut,
                    _ if last - cut >= trace.drawn => range[1] -= cut,
                    _ if first + cut <= trace.drawn => range[0] += cut,
                    _ => return None,
                }
            }
        }
    }
}
