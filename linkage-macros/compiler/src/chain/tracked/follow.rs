//! The motion of a group from the drawing both ways, as far as its equations are regular.

use super::loop_equations::{LoopEquations, System, certificate, greatest, inverse, times};
use crate::chain::pose::Posed;

/// The most poses each way: half a turn, or what a slide can go, in these steps.
const POSES: f64 = 120.0;
/// The count of times that a step is halved in front of an end.
const HALVINGS: i32 = 16;
/// The most poses each way with steps that were halved.
const MOST: usize = 360;
/// The greatest change of an unknown in a step: a part of a radian or of the machine's size.
const FAR: f64 = 0.2;
/// The greatest product h of a step's start: Newton's method finds the root of the motion from there.
const SURE: f64 = 0.5;
/// The part of an unknown's unit to which roots are found.
const FOUND: f64 = 1e-12;
/// The least share of the size for the determinant's root in the drawing.
const REGULAR: f64 = 1e-4;

/// A pose of the motion.
#[derive(Clone)]
pub(super) struct Pose<'m> {
    pub drive: f64,
    pub unknowns: Vec<f64>,
    /// The unknowns over the drive.
    rates: Vec<f64>,
    /// The determinant of the derivatives, zero at a dead point.
    pub determinant: f64,
    /// By closing pin, the bound on its second derivatives.
    pub bends: Vec<f64>,
    pub before: Posed<'m>,
}

impl Pose<'_> {
    /// The unknowns at another drive, along the tangent.
    fn ahead(&self, drive: f64) -> Vec<f64> {
        let along = |(at, rate): (&f64, &f64)| at + rate * (drive - self.drive);
        self.unknowns.iter().zip(&self.rates).map(along).collect()
    }
}

pub(super) struct GroupMotion<'m> {
    pub poses: Vec<Pose<'m>>,
    /// True if it is one pose a turn of the drive on.
    pub closes: bool,
}

impl GroupMotion<'_> {
    /// The first and the last drive.
    pub(super) fn ends(&self) -> [f64; 2] {
        [self.poses[0].drive, self.poses[self.poses.len() - 1].drive]
    }
}

/// The motion; `None` where the drawing is at a dead point.
pub(super) fn motion<'m>(system: &System<'m>) -> Option<GroupMotion<'m>> {
    let drawing = found(system, 0.0, &vec![0.0; system.count()])?;
    let (rows, _) = inverse(&system.at(&drawing.before, 0.0, &drawing.unknowns)?.columns)?;
    let worst = rows.iter().map(|row| greatest(row)).fold(0.0, f64::max) * system.size;
    if worst * REGULAR > 1.0 {
        return None;
    }
    let step = system.way.step * crate::chain::trace::POSES as f64 / POSES;
    let mut poses = followed(system, &drawing, -step);
    poses.reverse();
    poses.push(drawing.clone());
    poses.extend(followed(system, &drawing, step));
    let closes = closes(system, &poses);
    Some(GroupMotion { poses, closes })
}

/// The poses beyond the drawing one way.
fn followed<'m>(system: &System<'m>, drawing: &Pose<'m>, step: f64) -> Vec<Pose<'m>> {
    let mut poses: Vec<Pose<'m>> = Vec::new();
    let (mut done, mut part) = (0.0, 1.0);
    while done < POSES && poses.len() < MOST {
        let from = poses.last().unwrap_or(drawing);
        match next(system, from, step * (done + part)) {
            Some(pose) => {
                poses.push(pose);
                done += part;
                if part < 1.0 && (done / (2.0 * part)).fract() == 0.0 {
                    part *= 2.0;
                }
            }
            None => {
                part /= 2.0;
                if part < 0.5_f64.powi(HALVINGS) {
                    break;
                }
            }
        }
    }
    poses
}

/// The pose at a drive beside another, certified from the tangent there.
fn next<'m>(system: &System<'m>, from: &Pose<'m>, drive: f64) -> Option<Pose<'m>> {
    let start = from.ahead(drive);
    let posed = system.posed(drive)?;
    let equations = system.at(&posed, drive, &start)?;
    let bends = system.bends(&posed, drive, &start)?;
    if certificate(&equations, &bends)? > SURE {
        return None;
    }
    let pose = found(system, drive, &start)?;
    let moved = pose.unknowns.iter().zip(&from.unknowns).map(|(to, from)| to - from);
    let is_near = greatest(&moved.collect::<Vec<_>>()) < FAR;
    (is_near && pose.determinant * from.determinant > 0.0).then_some(pose)
}

/// The pose at a drive next to one of the motion.
pub(super) fn beside<'m>(system: &System<'m>, from: &Pose<'m>, drive: f64) -> Option<Pose<'m>> {
    found(system, drive, &from.ahead(drive))
}

/// Newton's root from a start.
fn found<'m>(system: &System<'m>, drive: f64, start: &[f64]) -> Option<Pose<'m>> {
    const STEPS: usize = 12;
    let posed = system.posed(drive)?;
    let mut unknowns = start.to_vec();
    for _ in 0..STEPS {
        let LoopEquations { missed, columns } = system.at(&posed, drive, &unknowns)?;
        let (rows, _) = inverse(&columns)?;
        let step = times(&rows, &missed);
        unknowns.iter_mut().zip(&step).for_each(|(unknown, step)| *unknown -= step);
        if greatest(&step) < FOUND {
            return pose(system, posed, drive, unknowns);
        }
    }
    None
}

fn pose<'m>(
    system: &System<'m>,
    before: Posed<'m>,
    drive: f64,
    unknowns: Vec<f64>,
) -> Option<Pose<'m>> {
    let (rows, determinant) = inverse(&system.at(&before, drive, &unknowns)?.columns)?;
    let beside = 1e-6 * system.way.step;
    let missed = |at: f64| Some(system.at(&system.posed(at)?, at, &unknowns)?.missed);
    // Next to the end of what stands before, one side is enough.
    let (ahead, behind) = (missed(drive + beside), missed(drive - beside));
    let here = missed(drive)?;
    let (ahead, behind, width) = match (ahead, behind) {
        (Some(ahead), Some(behind)) => (ahead, behind, 2.0 * beside),
        (Some(ahead), None) => (ahead, here, beside),
        (None, Some(behind)) => (here, behind, beside),
        (None, None) => return None,
    };
    let slopes: Vec<_> = ahead.iter().zip(&behind).map(|(a, b)| (b - a) / width).collect();
    let rates = times(&rows, &slopes);
    let bends = system.bends(&before, drive, &unknowns)?;
    Some(Pose { drive, unknowns, rates, determinant, bends, before })
}

/// True if the first and the last pose are a turn apart and one pose.
fn closes(system: &System<'_>, poses: &[Pose<'_>]) -> bool {
    const TURN: f64 = std::f64::consts::TAU;
    const CLOSED: f64 = 1e-8;
    let [first, .., last] = poses else { return false };
    let is_turn = system.way.turns && (last.drive - first.drive - TURN).abs() < CLOSED;
    let changes = last.unknowns.iter().zip(&first.unknowns).map(|(last, first)| last - first);
    let is_closed = |(change, is_angle): (f64, bool)| {
        let turns = if is_angle { (change / TURN).round() } else { 0.0 };
        (change - TURN * turns).abs() < CLOSED
    };
    is_turn && changes.zip(system.angles()).all(is_closed)
}
