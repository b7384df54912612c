//! The motions of a machine on one way to solve a group: each followed from the drawing both ways until it
//! ends.

use super::cutting::{Found, SearchedGroup};
use super::machine::{Driven, InputRates, Machine};
use super::pose::{PoseChanges, Posed};

/// The most poses each way at full steps, of half a turn or the machine's size.
pub(super) const POSES: usize = 60;
/// The least count of poses that show the shape of a motion; shorter ones are followed once more in
/// smaller steps.
const FEWEST: usize = 40;
/// The count of times that the step is halved in front of an end.
const HALVINGS: usize = 10;
/// The most poses each way, with steps that were halved beside places where the unknown changes fast.
const MOST: usize = 2 * POSES;
/// The part of a step over which a rate is measured. Roots are found to 1e-11, and a step is some hundredths.
const BEHIND: f64 = 2e-5;
/// The part of the difference of two rates, and of the unknown's unit, by which its change may be off them.
const APART: f64 = 0.25;
const OFF: f64 = 0.02;
/// The widths about a root, as parts of the unknown's unit, that are tried as its room.
const ROOMS: [f64; 7] = [0.3, 0.1, 0.03, 0.01, 0.004, 0.002, LEAST_ROOM];
/// The least of them.
pub(super) const LEAST_ROOM: f64 = 1e-3;
/// The greatest width about a root, as a part of the unknown's unit, on which it is asked to be alone.
const MOST_ALONE: f64 = 0.3;
/// The ratio of a width to the one before it.
const WIDER: f64 = 1.15;

/// A pose along the motion: the drive or the input, the unknown, and the bodies before the group.
pub struct Sample<'m> {
    pub drive: f64,
    pub unknown: f64,
    /// The slope of the equation over the unknown, zero at a dead point.
    pub slope: f64,
    /// The rate of the unknown over the drive; none beside the end of what stands before the group.
    rate: Option<f64>,
    before: Posed<'m>,
}

impl Sample<'_> {
    /// True if a pose is one of the same motion: the unknown changes by no less than its lower rate says and by no more
    /// than the higher, but for a part of their difference and of its unit. At a dead point in front the rate grows
    /// without bound. A jump to another motion stays as large when the step is halved.
    fn leads_to(&self, next: &Self, unit: f64) -> bool {
        let (Some(from), Some(to)) = (self.rate, next.rate) else { return true };
        let [from, to] = [from, to].map(|rate| rate * (next.drive - self.drive));
        let change = next.unknown - self.unknown;
        let beyond = (from.min(to) - change).max(change - from.max(to));
        beyond < APART * (to - from).abs() + OFF * unit
    }
}

/// The poses of a motion in the order of what drives it.
pub struct Trace<'m> {
    pub machine: &'m Machine,
    way: Way,
    pub samples: Vec<Sample<'m>>,
    /// The index of the drawing.
    pub drawn: usize,
    /// The turns of the unknown in a full turn of the drive, where the motion closes.
    pub closes: Option<i32>,
}

/// A motion, and its step.
#[derive(Clone, Debug)]
pub struct Way {
    motion: InputRates,
    pub step: f64,
    /// True if it is one of an angle that turns the machine on by itself.
    pub turns: bool,
}

impl Way {
    /// The motions that are followed: those of the inputs, or that of the first drive.
    pub fn all(machine: &Machine) -> Vec<Self> {
        let first = match machine.motions.is_empty() {
            true => {
                let mut drives = vec![0.0; machine.drives.len()];
                drives.iter_mut().take(1).for_each(|first| *first = 1.0);
                Some(InputRates { drives, ..InputRates::default() })
            }
            false => None,
        };
        let motions = machine.motions.iter().cloned().chain(first);
        motions.map(|motion| Self::of(machine, motion)).collect()
    }

    /// No drive turns by more a step than a part of a half turn, no slide or length changes by more than that part of the
    /// machine's size.
    fn of(machine: &Machine, motion: InputRates) -> Self {
        let most = |drive: usize| match machine.drives.get(drive).map(|drive| drive.kind) {
            Some(Driven::Slide(_)) => machine.size(),
            _ => std::f64::consts::PI,
        };
        let drives = motion.drives.iter().enumerate().map(|(drive, rate)| most(drive) / rate.abs());
        let lengths = motion.lengths.iter().map(|rate| machine.size() / rate.abs());
        let turns = motion.turns.iter().map(|rate| std::f64::consts::PI / rate.abs());
        let shifts = motion.shifts.iter().map(|rate| machine.size() / rate.length());
        let least = drives.chain(lengths).chain(turns).chain(shifts).fold(f64::INFINITY, f64::min);
        let turns = match machine.drives.first().map(|drive| drive.kind) {
            Some(Driven::Slide(_)) => false,
            _ => machine.motions.is_empty(),
        };
        Self { motion, step: least / POSES as f64, turns }
    }

    /// True if the input moves nothing.
    pub(super) fn rests(&self) -> bool {
        !self.motion.moves()
    }

    pub(super) fn given(&self, machine: &Machine, at: f64) -> PoseChanges {
        let unknowns = vec![0.0; machine.bodies.len()];
        let mut given = PoseChanges { unknowns, ..PoseChanges::default() };
        self.give(&mut given, at);
        given
    }

    fn give(&self, given: &mut PoseChanges, at: f64) {
        let of = |rates: &[f64]| rates.iter().map(|rate| rate * at).collect();
        given.drives = of(&self.motion.drives);
        given.lengths = of(&self.motion.lengths);
        given.turns = of(&self.motion.turns);
        given.shifts = self.motion.shifts.iter().map(|shift| shift.times(at)).collect();
    }
}

/// The drawing.
pub fn drawn(machine: &Machine) -> PoseChanges {
    PoseChanges {
        drives: vec![0.0; machine.drives.len()],
        unknowns: vec![0.0; machine.bodies.len()],
        ..PoseChanges::default()
    }
}

impl<'m> Trace<'m> {
    /// A motion both ways from the drawing until the option ends.
    pub fn of(machine: &'m Machine, before: &[Found], search: &SearchedGroup, way: &Way) -> Self {
        let mut trace = Self::in_steps(machine, before, search, way.clone());
        let count = trace.samples.len();
        if count < FEWEST && !way.rests() {
            let finer = way.step * count as f64 / (2 * FEWEST) as f64;
            trace = Self::in_steps(machine, before, search, Way { step: finer, ..way.clone() });
        }
        if let (true, [first, .., last]) = (way.turns, &trace.samples[..]) {
            let [first, last] = [first, last].map(|at| [at.drive, at.unknown]);
            trace.closes = closing(search, first, last);
        }
        trace
    }

    fn in_steps(machine: &'m Machine, before: &[Found], search: &SearchedGroup, way: Way) -> Self {
        let mut samples = followed(machine, before, search, (&way, -way.step));
        samples.reverse();
        let drawn = samples.len().saturating_sub(1);
        samples.extend(followed(machine, before, search, (&way, way.step)).into_iter().skip(1));
        Self { machine, way, samples, drawn, closes: None }
    }

    /// The ends of the motion; nothing where there is none.
    pub(super) fn whole(&self) -> [f64; 2] {
        match &self.samples[..] {
            [first, .., last] => [first.drive, last.drive],
            [only] => [only.drive; 2],
            [] => [0.0; 2],
        }
    }

    /// True if the motion goes on one way alone, but for a thousandth.
    pub(super) fn ends_at_the_drawing(&self) -> bool {
        let [first, .., last] = &self.samples[..] else { return false };
        let [back, ahead] = [-first.drive, last.drive];
        back.min(ahead) < 1e-3 * back.max(ahead)
    }

    /// The residual of the equation in a pose, over the unknown.
    pub fn residuals<'t>(
        &'t self,
        search: &'t SearchedGroup,
        sample: &'t Sample<'m>,
    ) -> impl FnMut(f64) -> Option<f64> + 't {
        let mut given = self.way.given(self.machine, sample.drive);
        let mut trial = sample.before.clone();
        move |at| sample.before.beside(&mut trial, search, &mut given, at)
    }

    /// The width on both sides of a root on which everything assembles and the equation keeps its
    /// trend; zero where there is none.
    pub(super) fn room(&self, search: &SearchedGroup, sample: &Sample<'m>) -> f64 {
        const PARTS: usize = 4;
        let unit = search.unit(self.machine);
        let mut residual = self.residuals(search, sample);
        let mut has_trend = |room: &f64| {
            let mut last = None;
            (0..=PARTS).all(|part| {
                let share = 2.0 * part as f64 / PARTS as f64 - 1.0;
                let now = residual(sample.unknown + share * room);
                let grows = |last: f64| now.is_some_and(|now| (now > last) == search.rises);
                now.is_some() && last.replace(now.unwrap_or_default()).is_none_or(grows)
            })
        };
        ROOMS.map(|room| room * unit).into_iter().find(|room| has_trend(room)).unwrap_or(0.0)
    }

    /// The width on both sides of a root on which everything assembles and no other root of the trend lies. The equation
    /// may turn back there, and pass zero against the trend: the search tells such a root apart.
    pub fn width_alone(&self, search: &SearchedGroup, sample: &Sample<'m>) -> f64 {
        let unit = search.unit(self.machine);
        let mut residual = self.residuals(search, sample);
        let mut reach = |side: f64, most: f64| {
            let (mut alone, mut width, mut is_back) = (0.0, LEAST_ROOM * unit, false);
            while width <= most {
                let Some(now) = residual(sample.unknown + side * width) else { break };
                let has_its_sign = (now > 0.0) == ((side > 0.0) == search.rises);
                if is_back && has_its_sign {
                    break;
                }
                is_back |= !has_its_sign;
                (alone, width) = (width, width * WIDER);
            }
            alone
        };
        let below = reach(-1.0, MOST_ALONE * unit);
        reach(1.0, below)
    }
}

/// The turns of the unknown between two poses a turn apart, if they are one pose: of each the drive and the unknown.
pub fn closing(search: &SearchedGroup, first: [f64; 2], last: [f64; 2]) -> Option<i32> {
    const TURN: f64 = std::f64::consts::TAU;
    // Roots are found to 1e-11.
    const CLOSED: f64 = 1e-8;
    let [driven, change] = [0, 1].map(|i| last[i] - first[i]);
    let turns = match search.steps[0] {
        Found::Slider { .. } => 0.0,
        _ => (change / TURN).round(),
    };
    let is_turn = (driven - TURN).abs() < CLOSED;
    (is_turn && (change - TURN * turns).abs() < CLOSED).then_some(turns as i32)
}

/// The poses from the drawing on, with the step halved where it leads beyond the end or to another motion, and doubled
/// again behind that.
fn followed<'m>(
    machine: &'m Machine,
    before: &[Found],
    search: &SearchedGroup,
    (way, step): (&Way, f64),
) -> Vec<Sample<'m>> {
    let mut given = drawn(machine);
    let Some(drawing) = next(machine, before, search, (way, step), (0.0, 0.0), &mut given) else {
        return Vec::new();
    };
    let mut samples = vec![drawing];
    // All steps and the next one, as parts of a full one: halves of halves, without rounding.
    let (mut done, mut part) = (0.0, 1.0);
    let last = if way.rests() { 0.0 } else { POSES as f64 };
    while done < last && samples.len() <= MOST {
        let from = &samples[samples.len() - 1];
        let start = given.unknowns.clone();
        let at = (step * (done + part), from.unknown);
        let found = next(machine, before, search, (way, step), at, &mut given);
        match found.filter(|sample| from.leads_to(sample, search.unit(machine))) {
            Some(sample) => {
                samples.push(sample);
                done += part;
                if part < 1.0 && (done / (2.0 * part)).fract() == 0.0 {
                    part *= 2.0;
                }
            }
            None => {
                given.unknowns = start;
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
    (way, step): (&Way, f64),
    (drive, unknown): (f64, f64),
    given: &mut PoseChanges,
) -> Option<Sample<'m>> {
    way.give(given, drive);
    let mut posed = Posed::new(machine);
    posed.run(before, given, 0.0)?;
    let placed = posed.clone();
    let root = posed.solve(search, given, unknown)?;
    let slope = placed.slope(search, given, root)?;
    let is_near = (root - unknown).abs() < 0.4 * search.unit(machine);
    let is_kept = is_near && (slope > 0.0) == search.rises;
    // On the side of the pose before, where everything assembles.
    let behind = BEHIND * step;
    let missed = || {
        let unknowns = given.unknowns.clone();
        let mut given = PoseChanges { unknowns, ..way.given(machine, drive - behind) };
        let mut posed = Posed::new(machine);
        posed.run(before, &mut given, 0.0)?;
        posed.residual(search, &mut given, root)
    };
    let rate = missed().map(|missed| missed / (behind * slope));
    is_kept.then_some(Sample { drive, unknown: root, slope, rate, before: placed })
}
