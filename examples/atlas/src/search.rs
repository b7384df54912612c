//! The search: every candidate is traced and compared, on all cores.
//!
//! Each is traced through [`POSES`] poses by one sweep and described. Only where the bound of the distance,
//! which is cheap, is not above the worst of a short list is the distance itself computed, so that the list is
//! that of a comparison of all with all; which thread was how fast does not matter. The [`SHORT_LIST`] is traced
//! once more through ten times as many poses, and the nearest of these is the answer.

use std::collections::BinaryHeap;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Mutex, PoisonError};

use linkage_core::LengthMismatch;
use rayon::prelude::*;

use crate::four_bar::{Dimensions, Tracer};
use crate::grid::{self, Candidates};
use crate::progress::Progress;
use crate::shape::{Describer, Descriptor, Placement};

/// Poses of a curve in the search.
pub const POSES: u32 = 64;

/// Poses of a curve of the short list.
pub const FINE_POSES: u32 = 10 * POSES;

/// As many curves are compared once more.
pub const SHORT_LIST: usize = 1000;

/// A curve, and how it is laid onto the drawn path.
#[derive(Clone, Copy, Debug)]
pub struct Found {
    /// The four-bar, as in the grid; mirrored if the placement says so.
    pub dimensions: Dimensions,
    /// See [`shape`](crate::shape).
    pub distance: f64,
    /// From the four-bar's axes to the path's.
    pub placement: Placement,
}

/// The nearest curves that were seen so far, the farthest of them on top.
struct ShortList {
    /// The bits of a distance, which are in the order of the distances, and whose it is.
    nearest: Mutex<BinaryHeap<(u64, usize)>>,
    /// The distance of the farthest once the list is full, infinity before: bits again.
    limit: AtomicU64,
    length: usize,
}

impl ShortList {
    fn new(length: usize) -> Self {
        let limit = AtomicU64::new(f64::INFINITY.to_bits());
        Self { nearest: Mutex::new(BinaryHeap::new()), limit, length }
    }

    fn may_take(&self, bound: f64) -> bool {
        bound.to_bits() <= self.limit.load(Ordering::Relaxed)
    }

    fn offer(&self, distance: f64, candidate: usize) {
        let mut nearest = self.nearest.lock().unwrap_or_else(PoisonError::into_inner);
        nearest.push((distance.to_bits(), candidate));
        if nearest.len() > self.length {
            nearest.pop();
        }
        if let (true, Some(&(farthest, _))) = (nearest.len() == self.length, nearest.peek()) {
            self.limit.store(farthest, Ordering::Relaxed);
        }
    }

    fn into_candidates(self) -> Vec<usize> {
        let nearest = self.nearest.into_inner().unwrap_or_else(PoisonError::into_inner);
        nearest.into_iter().map(|(_, candidate)| candidate).collect()
    }
}

/// The nearest candidates, nearest first, from a short list of `length`: [`SHORT_LIST`] is long enough for the
/// difference that the poses make.
///
/// # Errors
/// Never: all slices of a sweep are of one length.
pub fn nearest(
    path: &Descriptor,
    candidates: &Candidates,
    length: usize,
    progress: &Progress,
) -> Result<Vec<Found>, LengthMismatch> {
    let (list, points) = (ShortList::new(length), &candidates.points);
    candidates.linkages.par_iter().enumerate().try_for_each_init(
        || (Tracer::new(POSES), Describer::default()),
        |(tracer, describer), (linkage, &lengths)| {
            for (nth, &point) in points.iter().enumerate() {
                if !tracer.trace(&grid::curve(lengths, point))? {
                    continue;
                }
                let Some(curve) = describer.describe(&tracer.x, &tracer.y) else { continue };
                if list.may_take(path.bound(&curve)) {
                    list.offer(path.distance(&curve).0, linkage * points.len() + nth);
                }
            }
            progress.advance(points.len() as u64);
            Ok(())
        },
    )?;
    let mut found = compared_again(path, candidates, &list.into_candidates())?;
    found.sort_by(|one, two| one.distance.total_cmp(&two.distance));
    Ok(found)
}

/// The curves of the short list through many poses.
fn compared_again(
    path: &Descriptor,
    candidates: &Candidates,
    list: &[usize],
) -> Result<Vec<Found>, LengthMismatch> {
    let (mut tracer, mut describer) = (Tracer::new(FINE_POSES), Describer::default());
    let mut found = Vec::new();
    for &candidate in list {
        let per_linkage = candidates.points.len();
        let lengths = candidates.linkages[candidate / per_linkage];
        let dimensions = grid::curve(lengths, candidates.points[candidate % per_linkage]);
        if !tracer.trace(&dimensions)? {
            continue;
        }
        if let Some(curve) = describer.describe(&tracer.x, &tracer.y) {
            let (distance, placement) = path.distance(&curve);
            found.push(Found { dimensions, distance, placement });
        }
    }
    Ok(found)
}

/// The nearest, and after it the nearest of those that are another design: from each linkage that was taken, one
/// of its three lengths at least differs by half a crank or more.
#[must_use]
pub fn designs(found: &[Found], count: usize) -> Vec<Found> {
    let lengths = |found: &Found| {
        let Dimensions { coupler, follower, base, .. } = found.dimensions;
        [coupler, follower, base]
    };
    let is_like = |one: &Found, two: &Found| {
        lengths(one).iter().zip(lengths(two)).all(|(one, two)| (one - two).abs() < 0.5)
    };
    let mut designs: Vec<Found> = Vec::new();
    for one in found {
        if designs.len() < count && !designs.iter().any(|design| is_like(design, one)) {
            designs.push(*one);
        }
    }
    designs
}
