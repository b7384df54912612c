//! Fits of all unknowns over the drive, piece by piece from the drawing outwards, each on a stretch on which it is
//! certified.

use super::LIMIT;
use super::follow::{GroupMotion, Pose, beside};
use super::loop_equations::{System, certificate};
use crate::chain::curve::{node_angle, powers_through};
use crate::chain::cutting::TrackedGroup;
use crate::chain::fit::Piece;

/// The degree of every piece.
pub(crate) const DEGREE: usize = 8;
/// The most pieces.
const MOST: usize = 16;
/// The share of the limit that the product of Newton and Kantorovich has at most where it is asked: between these places
/// it may be higher.
const SHARE: f64 = 0.6;
/// The count of places of a piece where it is asked.
const ASKED: usize = 4 * (DEGREE + 1);
/// The ratio of a length that is tried to the one before it.
const SHORTER: f64 = 0.8;
/// The share of the motion one way in front of its end that is given up, and the least length of a piece.
const GIVEN_UP: f64 = 2e-3;
const LEAST: f64 = 1e-5;

/// The group with the pieces that reach farthest; `None` where none holds beside the drawing.
pub(super) fn fitted(system: System<'_>, motion: &GroupMotion<'_>) -> Option<TrackedGroup> {
    let bends = bends(motion);
    let pieces = Pieces { system: &system, motion, bends: &bends };
    let mut behind = pieces.one_way(-1.0, MOST / 2);
    let ahead = pieces.one_way(1.0, MOST - behind.len());
    if ahead.len() < MOST / 2 && behind.len() == MOST / 2 {
        behind = pieces.one_way(-1.0, MOST - ahead.len());
    }
    behind.reverse();
    let all = [behind, ahead].concat();
    let [from, to] = [all.first()?.ends[0], all.last()?.ends[1]];
    let whole = motion.ends();
    let closes = motion.closes && [from, to] == whole;
    Some(TrackedGroup { pieces: all, closes, ..system.group(bends) })
}

/// The greatest bounds on second derivatives along the motion, and a little more for what lies between its poses.
fn bends(motion: &GroupMotion<'_>) -> Vec<f64> {
    const MORE: f64 = 1.01;
    let poses = &motion.poses;
    let most = |closing: usize| poses.iter().map(|pose| pose.bends[closing]).fold(0.0, f64::max);
    (0..poses[0].bends.len()).map(|closing| MORE * most(closing)).collect()
}

struct Pieces<'p, 'm> {
    system: &'p System<'m>,
    motion: &'p GroupMotion<'m>,
    bends: &'p [f64],
}

impl Pieces<'_, '_> {
    /// The pieces one way from the drawing, in this order.
    fn one_way(&self, side: f64, most: usize) -> Vec<Piece> {
        let [first, last] = self.motion.ends();
        let end = if side > 0.0 { last } else { first };
        let (mut pieces, mut at, mut tried) = (Vec::new(), 0.0, f64::INFINITY);
        while pieces.len() < most && (end - at).abs() > GIVEN_UP * end.abs() {
            // The next piece is rarely much longer than the last one.
            let mut length = (side * (end - at)).min(tried);
            let found = loop {
                if length < LEAST * end.abs() {
                    return pieces;
                }
                let to = if length == side * (end - at) { end } else { at + side * length };
                match self.piece(if side > 0.0 { [at, to] } else { [to, at] }) {
                    Some(piece) => break piece,
                    None => length *= SHORTER,
                }
            };
            at = if side > 0.0 { found.ends[1] } else { found.ends[0] };
            tried = 4.0 * length;
            pieces.push(found);
        }
        pieces
    }

    /// The polynomials through the roots at Chebyshev's nodes, if they are certified.
    fn piece(&self, ends: [f64; 2]) -> Option<Piece> {
        let nodes = DEGREE + 1;
        let drive = |place: f64| (ends[0] + ends[1] + (ends[1] - ends[0]) * place) / 2.0;
        let roots = (0..nodes).map(|node| self.root(drive(node_angle(node, nodes).cos())));
        let roots: Vec<Pose<'_>> = roots.collect::<Option<_>>()?;
        let units = self.system.units().into_iter().enumerate();
        let powers = units.map(|(unknown, unit)| {
            let values: Vec<_> = roots.iter().map(|root| root.unknowns[unknown] * unit).collect();
            powers_through(&values, DEGREE)
        });
        let piece = Piece { ends, powers: powers.collect() };
        let is_well = |part: usize| {
            let place = 2.0 * part as f64 / ASKED as f64 - 1.0;
            self.product(&piece, drive(place)).is_some_and(|h| h <= SHARE * LIMIT)
        };
        // The ends are the worst.
        let order = [0, ASKED].into_iter().chain(1..ASKED);
        order.into_iter().all(is_well).then_some(piece)
    }

    /// The root of the motion at a drive.
    fn root(&self, drive: f64) -> Option<Pose<'_>> {
        let poses = &self.motion.poses;
        let above = poses.partition_point(|pose| pose.drive < drive).min(poses.len() - 1);
        let below = above.saturating_sub(1);
        let nearest = [below, above].map(|index| &poses[index]);
        let is_first = drive - nearest[0].drive < nearest[1].drive - drive;
        beside(self.system, nearest[usize::from(!is_first)], drive)
    }

    /// The product h at a fit.
    fn product(&self, piece: &Piece, drive: f64) -> Option<f64> {
        let unknowns = piece.at(drive).zip(self.system.units());
        let unknowns: Vec<_> = unknowns.map(|(at, unit)| at / unit).collect();
        let posed = self.system.posed(drive)?;
        certificate(&self.system.at(&posed, drive, &unknowns)?, self.bends)
    }
}
