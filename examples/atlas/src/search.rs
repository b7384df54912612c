//! The search: every candidate is traced and compared, on all cores.
//!
//! Each is traced through [`POSES`] poses by one sweep and described. A linkage counts by the nearest of its
//! curves, so that the short list holds as many linkages, and not one linkage with all its coupler points. Only
//! where the bound of the distance, which is cheap, is not above the linkage's best and the worst of the list is
//! the distance itself computed: the list is that of a comparison of all with all, and which thread was how fast
//! does not matter. The [`SHORT_LIST`] is traced once more through ten times as many poses, and the nearest of
//! these is the answer.
//!
//! The list of a part of the linkages is [`short_list`], and the lists of all parts together are, by
//! [`shortest`], the list of the whole.

use std::collections::BinaryHeap;
use std::ops::Range;
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

/// As many linkages are compared once more.
pub const SHORT_LIST: usize = 1000;

/// The most by which rounding lifts a bound above its distance. Each is a root of a sum of 48 squares; a term
/// is off by some 50 ε, of twelve powers of a unit number, and all together by some 400 ε.
const ROUNDING: f64 = 1e-12;

/// A linkage on a short list, with the nearest of its curves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Entry {
    /// Through [`POSES`] poses.
    pub distance: f64,
    /// The number of the candidate in its grid.
    pub candidate: usize,
}

impl Entry {
    /// Distances are not negative, so that their bits are in their order; equal ones are in that of the grid.
    fn key(&self) -> (u64, usize) {
        (self.distance.to_bits(), self.candidate)
    }

    fn nearer(self, other: Self) -> Self {
        if other.key() < self.key() { other } else { self }
    }
}

/// A curve, and how it is laid onto the drawn path.
#[derive(Clone, Copy, Debug)]
pub struct Found {
    /// The number of the candidate in its grid.
    pub candidate: usize,
    /// The four-bar, as in the grid or refined; mirrored if the placement says so.
    pub dimensions: Dimensions,
    /// Through [`FINE_POSES`] poses; see [`shape`](crate::shape).
    pub distance: f64,
    /// From the four-bar's axes to the path's.
    pub placement: Placement,
}

/// The nearest curves that were seen so far, the farthest of them on top.
struct ShortList {
    nearest: Mutex<BinaryHeap<(u64, usize)>>,
    /// The bits of the distance of the farthest once the list is full, infinity before.
    limit: AtomicU64,
    length: usize,
}

impl ShortList {
    fn new(length: usize) -> Self {
        let limit = AtomicU64::new(f64::INFINITY.to_bits());
        Self { nearest: Mutex::new(BinaryHeap::new()), limit, length }
    }

    /// True if a distance of at least this may be on the list.
    fn may_take(&self, least: f64) -> bool {
        least <= f64::from_bits(self.limit.load(Ordering::Relaxed))
    }

    fn offer(&self, entry: Entry) {
        let mut nearest = self.nearest.lock().unwrap_or_else(PoisonError::into_inner);
        nearest.push(entry.key());
        if nearest.len() > self.length {
            nearest.pop();
        }
        if let (true, Some(&(farthest, _))) = (nearest.len() == self.length, nearest.peek()) {
            self.limit.store(farthest, Ordering::Relaxed);
        }
    }

    /// Nearest first.
    fn into_entries(self) -> Vec<Entry> {
        let nearest = self.nearest.into_inner().unwrap_or_else(PoisonError::into_inner);
        let entry = |(bits, candidate)| Entry { distance: f64::from_bits(bits), candidate };
        nearest.into_sorted_vec().into_iter().map(entry).collect()
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
    let all = 0..candidates.linkages.len();
    compared_again(path, candidates, &short_list(path, candidates, all, length, progress)?)
}

/// The short list of these linkages, nearest first: as many as `length` says, or all there are.
///
/// # Errors
/// Never: all slices of a sweep are of one length.
pub fn short_list(
    path: &Descriptor,
    candidates: &Candidates,
    linkages: Range<usize>,
    length: usize,
    progress: &Progress,
) -> Result<Vec<Entry>, LengthMismatch> {
    let (list, points) = (ShortList::new(length), &candidates.points);
    linkages.into_par_iter().try_for_each_init(
        || (Tracer::new(POSES), Describer::default()),
        |(tracer, describer), linkage| {
            let Some(&lengths) = candidates.linkages.get(linkage) else { return Ok(()) };
            let mut best: Option<Entry> = None;
            for (nth, &point) in points.iter().enumerate() {
                if !tracer.trace(&grid::curve(lengths, point))? {
                    continue;
                }
                let Some(curve) = describer.describe(&tracer.x, &tracer.y) else { continue };
                let least = path.bound(&curve) - ROUNDING;
                if list.may_take(least) && best.is_none_or(|best| least <= best.distance) {
                    let candidate = linkage * points.len() + nth;
                    let entry = Entry { distance: path.distance(&curve).0, candidate };
                    best = Some(best.map_or(entry, |best| best.nearer(entry)));
                }
            }
            best.into_iter().for_each(|entry| list.offer(entry));
            progress.advance(points.len() as u64);
            Ok(())
        },
    )?;
    Ok(list.into_entries())
}

/// The short list of several: the nearest of all, in the order of [`short_list`].
#[must_use]
pub fn shortest(mut entries: Vec<Entry>, length: usize) -> Vec<Entry> {
    entries.sort_unstable_by_key(Entry::key);
    entries.truncate(length);
    entries
}

/// The curves of the short list through [`FINE_POSES`] poses, nearest first.
///
/// # Errors
/// Never: all slices of a sweep are of one length.
pub fn compared_again(
    path: &Descriptor,
    candidates: &Candidates,
    list: &[Entry],
) -> Result<Vec<Found>, LengthMismatch> {
    let compared: Result<Vec<Option<Found>>, LengthMismatch> = list
        .par_iter()
        .map(|entry| {
            let Some(dimensions) = candidates.dimensions(entry.candidate) else { return Ok(None) };
            compared(path, entry.candidate, dimensions)
        })
        .collect();
    let mut found: Vec<Found> = compared?.into_iter().flatten().collect();
    sort(&mut found);
    Ok(found)
}

/// A four-bar's curve through [`FINE_POSES`] poses; none where it has no size or its crank does not turn.
///
/// # Errors
/// Never: all slices of a sweep are of one length.
pub fn compared(
    path: &Descriptor,
    candidate: usize,
    dimensions: Dimensions,
) -> Result<Option<Found>, LengthMismatch> {
    let mut tracer = Tracer::new(FINE_POSES);
    if !tracer.trace(&dimensions)? {
        return Ok(None);
    }
    let curve = Describer::default().describe(&tracer.x, &tracer.y);
    Ok(curve.map(|curve| {
        let (distance, placement) = path.distance(&curve);
        Found { candidate, dimensions, distance, placement }
    }))
}

/// Nearest first, equal ones in the order of the grid.
pub(crate) fn sort(found: &mut [Found]) {
    found.sort_by_key(|found| (found.distance.to_bits(), found.candidate));
}

/// The first, which is the nearest where they are in order, and after it the first of those that are another
/// design: from each linkage that was taken, one of its three lengths at least differs by half a crank or more.
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
