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
//! The grid holds four-bars whose crank goes round, crank-rockers and drag links, and both branches. It does
//! not list the branch `right`: this is the mirror image of `left` with the coupler point on the other side,
//! which the grid also has, and [`shape`](crate::shape) takes mirror images for the same. Linkages whose
//! crank only swings are not included.

use std::fmt;

use linkage_core::Side;

use crate::four_bar::Dimensions;

/// The lengths of coupler, follower and ground over that of the crank.
pub type Lengths = [f64; 3];

/// True if the crank goes all the way round: the crank or the base is the shortest link, and the shortest
/// and the longest are together no longer than the others (Grashof). At equality it passes change points.
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
    /// The number of curves.
    #[must_use]
    pub fn count(&self) -> usize {
        self.linkages.len() * self.points.len()
    }

    /// The candidate of this number: the linkages in order, each with all its coupler points.
    #[must_use]
    pub fn dimensions(&self, candidate: usize) -> Option<Dimensions> {
        let per_linkage = self.points.len().max(1);
        let lengths = self.linkages.get(candidate / per_linkage)?;
        Some(curve(*lengths, *self.points.get(candidate % per_linkage)?))
    }
}

/// The candidates of a search by three numbers: how many lengths each bar has, and how many columns and rows
/// of coupler points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Grid {
    /// Lengths in equal steps from 1.1 to 5 cranks; at least two.
    pub lengths: u32,
    /// Coupler points along the coupler; at least two.
    pub columns: u32,
    /// Coupler points across it; at least two.
    pub rows: u32,
}

impl Grid {
    /// Ten million candidates: lengths in tenths, and 21 × 15 coupler points.
    pub const TEN_MILLION: Self = Self { lengths: 40, columns: 21, rows: 15 };

    /// By how much the sums of lengths differ at least: at a change point the curve may turn off.
    pub const SLACK: f64 = 0.05;

    /// The three numbers with commas between them, as `40,21,15`; none where one of them is below two.
    #[must_use]
    pub fn parse(text: &str) -> Option<Self> {
        let numbers: Option<Vec<u32>> = text.split(',').map(|number| number.parse().ok()).collect();
        match numbers?[..] {
            [lengths, columns, rows] if lengths.min(columns).min(rows) >= 2 => {
                Some(Self { lengths, columns, rows })
            }
            _ => None,
        }
    }

    /// The candidates, in an order that depends on the three numbers alone.
    #[must_use]
    pub fn candidates(self) -> Candidates {
        // Whole numbers divided once, so that forty lengths are the tenths themselves.
        let of = |k: u32| {
            f64::from(11 * (self.lengths - 1) + 39 * k) / f64::from(10 * (self.lengths - 1))
        };
        let lengths: Vec<f64> = (0..self.lengths).map(of).collect();
        let points = coupler_points([self.columns, self.rows]);
        Candidates { linkages: linkages(&lengths, Self::SLACK), points }
    }
}

impl fmt::Display for Grid {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{},{},{}", self.lengths, self.columns, self.rows)
    }
}

/// The atlas: see the module.
#[must_use]
pub fn atlas() -> Candidates {
    let lengths: Vec<f64> = (3..=8).map(|halves| f64::from(halves) / 2.0).collect();
    Candidates { linkages: linkages(&lengths, 0.0), points: coupler_points([10, 5]) }
}
