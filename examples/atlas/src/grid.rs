//! Which four-bars are drawn, and which are searched.
//!
//! The atlas has pages of ten curves each, by the lengths A, B and C of coupler, follower and ground over that
//! of the crank, in steps of one half. Our [`atlas`] takes every combination of 1.5, 2, … 4 whose crank turns
//! all the way round, 156 of them, and for each of them fifty coupler points in five rows of ten, 7,800 curves.
//! The book has some 7,300: it leaves out some of these combinations, and our places of the coupler points in
//! units of the coupler are our own, not read off the book's pages.
//!
//! The [`Candidates`] of a search are a finer and wider grid of the same.
//!
//! What is included: four-bars whose crank goes round, crank-rockers and drag links, both branches. The branch
//! `right` is not listed: it is the mirror image of `left` with the coupler point on the other side, which the
//! grid also has, and [`shape`](crate::shape) takes mirror images for the same. Linkages whose crank only swings
//! are not included.

use linkage_core::Side;

use crate::four_bar::Dimensions;

/// The lengths of coupler, follower and ground over that of the crank.
pub type Lengths = [f64; 3];

/// Whether the crank goes all the way round: it, the shortest or at the side of the shortest, and the longest
/// link are together no longer than the others (Grashof). At equality it passes through change points.
///
/// The crank's length is 1; `slack` is by how much the sums must differ.
#[must_use]
pub fn crank_turns([coupler, follower, base]: Lengths, slack: f64) -> bool {
    // |BD| runs from |C − 1| to C + 1: at neither end may the bars be too short or too long for it.
    coupler + follower >= base + 1.0 + slack
        && (coupler - follower).abs() + slack <= (base - 1.0).abs()
}

/// Every combination of these lengths whose crank goes all the way round.
#[must_use]
pub fn linkages(lengths: &[f64], slack: f64) -> Vec<Lengths> {
    let with = |a: f64| lengths.iter().flat_map(move |&b| lengths.iter().map(move |&c| [a, b, c]));
    let all = lengths.iter().flat_map(|&a| with(a));
    all.filter(|&lengths| crank_turns(lengths, slack)).collect()
}

/// So many numbers in equal steps from `first` to `last`.
fn steps(first: f64, last: f64, count: u32) -> impl Iterator<Item = f64> + Clone {
    (0..count).map(move |k| first + (last - first) * f64::from(k) / f64::from(count - 1))
}

/// A grid of coupler points for linkages of any size: `columns` from half a coupler behind the crank's pin to
/// half a coupler beyond the follower's, `rows` from half a coupler on the right to as much on the left.
#[must_use]
pub fn coupler_points([columns, rows]: [u32; 2]) -> Vec<[f64; 2]> {
    let along = steps(-0.5, 1.5, columns);
    along.flat_map(|along| steps(-0.5, 0.5, rows).map(move |across| [along, across])).collect()
}

/// The curve of a coupler point given in lengths of the coupler.
#[must_use]
pub fn curve([coupler, follower, base]: Lengths, [along, across]: [f64; 2]) -> Dimensions {
    let (along, across) = (along * coupler, across * coupler);
    Dimensions { coupler, follower, base, along, across, branch: Side::Left }
}

/// Linkages and the coupler points of each.
#[derive(Clone, Debug)]
pub struct Candidates {
    /// Coupler, follower and ground.
    pub linkages: Vec<Lengths>,
    /// In lengths of the coupler.
    pub points: Vec<[f64; 2]>,
}

impl Candidates {
    /// How many curves these are.
    #[must_use]
    pub fn count(&self) -> usize {
        self.linkages.len() * self.points.len()
    }

    /// Ten million of them: lengths from 1.1 to 5 in tenths, and 21 × 15 coupler points.
    #[must_use]
    pub fn ten_million() -> Self {
        // At a change point the curve may turn off: these linkages are left out.
        let lengths: Vec<f64> = (11..=50).map(|tenths| f64::from(tenths) / 10.0).collect();
        Self { linkages: linkages(&lengths, 0.05), points: coupler_points([21, 15]) }
    }
}

/// The atlas: see the module.
#[must_use]
pub fn atlas() -> Candidates {
    let lengths: Vec<f64> = (3..=8).map(|halves| f64::from(halves) / 2.0).collect();
    Candidates { linkages: linkages(&lengths, 0.0), points: coupler_points([10, 5]) }
}
