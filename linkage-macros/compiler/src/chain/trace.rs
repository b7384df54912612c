//! The motion of a machine on one way to solve a group: followed from the drawing both ways until it
//! ends.

use super::cutting::{Found, SearchedGroup};
use super::machine::{Driven, Machine};
use super::pose::{Given, Posed};

/// The most poses each way at full steps.
const POSES: usize = 60;
/// The least count of poses that show the shape of a motion; shorter ones are followed once more in
/// smaller steps.
const FEWEST: usize = 40;
/// The count of times that the step is halved in front of an end.
const HALVINGS: usize = 10;
/// The widths about a root, as parts of the unknown's unit, that are tried as its room.
const ROOMS: [f64; 7] = [0.3, 0.1, 0.03, 0.01, 0.004, 0.002, LEAST_ROOM];
/// The least of them.
pub(super) const LEAST_ROOM: f64 = 1e-3;

/// A pose along the motion: the first drive, the unknown, and the bodies before the group.
pub(super) struct Sample<'m> {
    pub drive: f64,
    pub unknown: f64,
    /// The slope of the equation over the unknown, zero at a dead point.
    pub slope: f64,
    before: Posed<'m>,
}

/// The poses of a motion in the order of the first drive.
pub(super) struct Trace<'m> {
    pub machine: &'m Machine,
    pub samples: Vec<Sample<'m>>,
    /// The index of the drawing.
    pub drawn: usize,
    /// The turns of the unknown in a full turn of the drive, where the motion closes.
    pub closes: Option<i32>,
}

pub(super) fn given(machine: &Machine, drive: f64) -> Given {
    let mut drives = vec![0.0; machine.drives.len()];
    if let Some(first) = drives.first_mut() {
        *first = drive;
    }
    Given { drives, unknowns: vec![0.0; machine.bodies.len()] }
}

impl<'m> Trace<'m> {
    /// The motion both ways from the drawing until the option ends.
    pub(super) fn of(machine: &'m Machine, before: &[Found], search: &SearchedGroup) -> Self {
        let slides =
            matches!(machine.drives.first().map(|drive| drive.kind), Some(Driven::Slide(_)));
        let step = if slides { machine.size() } else { std::f64::consts::PI } / POSES as f64;
        let mut trace = Self::in_steps(machine, before, search, step);
        let count = trace.samples.len();
        if count < FEWEST {
            let finer = step * count as f64 / (2 * FEWEST) as f64;
            trace = Self::in_steps(machine, before, search, finer);
        }
        if let (false, [first, .., last]) = (slides, &trace.samples[..]) {
            trace.closes = closing(search, first, last);
        }
        trace
    }

    fn in_steps(machine: &'m Machine, before: &[Found], search: &SearchedGroup, step: f64) -> Self {
        let mut samples = way(machine, before, search, -step);
        samples.reverse();
        let drawn = samples.len().saturating_sub(1);
        samples.extend(way(machine, before, search, step).into_iter().skip(1));
        Self { machine, samples, drawn, closes: None }
    }

    /// The residual of the equation in a pose.
    pub(super) fn residual(
        &self,
        search: &SearchedGroup,
        sample: &Sample<'m>,
        at: f64,
    ) -> Option<f64> {
        sample.before.clone().residual(search, &mut given(self.machine, sample.drive), at)
    }

    /// The width on both sides of a root on which everything assembles and the equation keeps its
    /// trend; zero where there is none.
    pub(super) fn room(&self, search: &SearchedGroup, sample: &Sample<'m>) -> f64 {
        const PARTS: usize = 4;
        let unit = search.unit(self.machine);
        let has_trend = |room: &f64| {
            let mut last = None;
            (0..=PARTS).all(|part| {
                let share = 2.0 * part as f64 / PARTS as f64 - 1.0;
                let now = self.residual(search, sample, sample.unknown + share * room);
                let grows = |last: f64| now.is_some_and(|now| (now > last) == search.rises);
                now.is_some() && last.replace(now.unwrap_or_default()).is_none_or(grows)
            })
        };
        ROOMS.map(|room| room * unit).into_iter().find(has_trend).unwrap_or(0.0)
    }
}

/// The turns of the unknown between two poses a turn apart, if they are one pose.
fn closing(search: &SearchedGroup, first: &Sample<'_>, last: &Sample<'_>) -> Option<i32> {
    const TURN: f64 = std::f64::consts::TAU;
    // Roots are found to 1e-11.
    const OFF: f64 = 1e-8;
    let change = last.unknown - first.unknown;
    let turns = match search.steps[0] {
        Found::Slider { .. } => 0.0,
        _ => (change / TURN).round(),
    };
    let is_turn = (last.drive - first.drive - TURN).abs() < OFF;
    (is_turn && (change - TURN * turns).abs() < OFF).then_some(turns as i32)
}

/// The poses from the drawing on, with the step halved where it leads beyond the end.
fn way<'m>(
    machine: &'m Machine,
    before: &[Found],
    search: &SearchedGroup,
    step: f64,
) -> Vec<Sample<'m>> {
    let mut samples: Vec<Sample<'m>> = Vec::new();
    let mut given = given(machine, 0.0);
    let (mut part, mut done, mut index) = (1.0, 0.0, 0);
    while index <= POSES {
        let drive = if samples.is_empty() { 0.0 } else { step * (done + part) };
        let unknown = samples.last().map_or(0.0, |sample| sample.unknown);
        match next(machine, before, search, (drive, unknown), &mut given) {
            Some(sample) => {
                done = drive / step;
                samples.push(sample);
                index += 1;
            }
            None if samples.is_empty() => break,
            None => {
                part /= 2.0;
                if part < 0.5_f64.powi(HALVINGS as i32) {
                    break;
                }
            }
        }
    }
    samples
}

/// The pose at a drive beside one with this unknown.
fn next<'m>(
    machine: &'m Machine,
    before: &[Found],
    search: &SearchedGroup,
    (drive, unknown): (f64, f64),
    given: &mut Given,
) -> Option<Sample<'m>> {
    if let Some(first) = given.drives.first_mut() {
        *first = drive;
    }
    let mut posed = Posed::new(machine);
    posed.run(before, given, 0.0)?;
    let before = posed.clone();
    let root = posed.solve(search, given, unknown)?;
    let slope = before.slope(search, given, root)?;
    let is_near = (root - unknown).abs() < 0.4 * search.unit(machine);
    let is_kept = is_near && (slope > 0.0) == search.rises;
    is_kept.then_some(Sample { drive, unknown: root, slope, before })
}
