//! The user's options for a picture.

use std::string::{String, ToString};
use std::vec::Vec;

use super::forces::DrawnLoads;
use super::plan::Applied;
use super::style::{Theme, Unit, WIDTH};
use crate::{Record, SolveError};

/// The user's options for a picture.
#[derive(Clone, Debug)]
pub(super) struct Options {
    pub traces: Vec<String>,
    /// None for those that there is room for.
    pub labels: Option<Vec<String>>,
    pub theme: Theme,
    pub width: f64,
    pub unit: Option<Unit>,
    pub title: Option<String>,
    pub loads: DrawnLoads,
    pub has_scale: bool,
    pub poses: usize,
    /// True if only the first pose is drawn in full.
    pub is_still: bool,
    pub seconds: f64,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            traces: Vec::new(),
            labels: None,
            theme: Theme::Auto,
            width: WIDTH,
            unit: None,
            title: None,
            loads: DrawnLoads::default(),
            has_scale: true,
            poses: 1,
            is_still: false,
            seconds: 4.0,
        }
    }
}

/// The reactions by their joints, no numbers where there is no result.
pub(super) fn reactions<R: Record<Number = f64>>(
    results: impl IntoIterator<Item = Result<R, SolveError>>,
) -> Vec<(String, Vec<[f64; 2]>)> {
    let mut found: Vec<(&str, Vec<[f64; 2]>)> = Vec::new();
    let mut count = 0;
    for result in results {
        // A path of two names is a link and its joint; what shakes the ground has one.
        let joints =
            result.into_iter().flat_map(Record::points).filter(|(path, _)| path.contains('.'));
        for (path, force) in joints {
            let known = found.iter().position(|(name, _)| *name == path);
            let place = known.unwrap_or_else(|| {
                found.push((path, Vec::new()));
                found.len() - 1
            });
            found[place].1.resize(count, [f64::NAN; 2]);
            found[place].1.push([force.x, force.y]);
        }
        count += 1;
    }
    let joint = |path: &str| path.rsplit('.').next().unwrap_or_default().to_string();
    found
        .into_iter()
        .map(|(path, mut forces)| {
            forces.resize(count, [f64::NAN; 2]);
            (joint(path), forces)
        })
        .collect()
}

/// The applied forces in the order of the declaration, no numbers where there is no result.
pub(super) fn applied(
    results: impl IntoIterator<Item = Result<Applied, SolveError>>,
) -> Vec<(String, Vec<[f64; 2]>)> {
    let results: Vec<_> = results.into_iter().map(Result::ok).collect();
    let Some(first) = results.iter().flatten().next() else { return Vec::new() };
    let force = |(nth, (point, _)): (usize, &(&str, _))| {
        let of = |result: &Option<Applied>| Some(result.as_ref()?.forces.get(nth)?.1);
        let forces = results.iter().map(|result| of(result).unwrap_or([f64::NAN; 2]));
        (point.to_string(), forces.collect())
    };
    first.forces.iter().enumerate().map(force).collect()
}
