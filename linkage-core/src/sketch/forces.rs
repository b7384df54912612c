//! Forces and couples on points: arrows and arcs to one scale each, but none too short to be seen.

use std::format;
use std::string::String;
use std::vec::Vec;

use super::boxes::Box2;
use super::scene::Scene;
use super::sketch_error::SketchError;
use super::style::Palette;
use super::svg::{Timing, View, three_digits};
use super::symbols::{moving_arrow, moving_path, on_circle, turning_arrow};
use super::traces::point;

/// A force or a couple on a point, in every pose.
#[derive(Clone, Debug)]
pub(super) struct Load {
    pub point: usize,
    kind: Kind,
    is_reaction: bool,
    /// Its line on the page: from the point to the tip, or along the arc.
    lines: Vec<Option<Vec<[f64; 2]>>>,
    /// Its size in every pose, in newtons or newton metres.
    sizes: Vec<f64>,
    /// The largest of its kind.
    largest: f64,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Force,
    Couple,
}

/// The loads that the user wants drawn: names of points with x and y of a force, or a couple, in each pose.
#[derive(Clone, Debug, Default)]
pub(super) struct DrawnLoads {
    pub forces: Vec<(String, Vec<[f64; 2]>)>,
    /// The same of joints.
    pub reactions: Vec<(String, Vec<[f64; 2]>)>,
    pub couples: Vec<(String, Vec<f64>)>,
}

impl DrawnLoads {
    pub(super) fn is_empty(&self) -> bool {
        self.forces.is_empty() && self.reactions.is_empty() && self.couples.is_empty()
    }
}

/// Length of the largest force's arrow, and of the smallest that is drawn.
const LONGEST: f64 = 90.0;
const SHORTEST: f64 = 15.0;
/// Radius of a couple's arc, outside the arrow of a crank; degrees of the largest and the smallest.
const RADIUS: f64 = 29.0;
const WIDEST: f64 = 270.0;
const NARROWEST: f64 = 50.0;
/// The share of the largest below which there is neither arrow nor arc.
const NOTHING: f64 = 1e-3;

impl Load {
    /// All forces to one scale, and all couples to another.
    pub(super) fn all(
        scene: &Scene,
        view: View,
        asked: &DrawnLoads,
    ) -> Result<Vec<Self>, SketchError> {
        let forces = || asked.forces.iter().chain(&asked.reactions);
        let sizes = forces().flat_map(|(_, force)| force).map(|[x, y]| x.hypot(*y));
        let strongest = largest(sizes);
        let force = |(name, values): &(String, Vec<[f64; 2]>)| {
            let draw = |at: [f64; 2], [x, y]: [f64; 2]| {
                let size = x.hypot(y);
                let length = (size / strongest * LONGEST).max(SHORTEST);
                (size, [at, [at[0] + x / size * length, at[1] - y / size * length]].into())
            };
            Self::new(scene, view, (name, values), (Kind::Force, strongest), draw)
        };
        let sizes = asked.couples.iter().flat_map(|(_, couple)| couple).map(|couple| couple.abs());
        let hardest = largest(sizes);
        let couple = |(name, values): &(String, Vec<f64>)| {
            let draw = |at: [f64; 2], couple: f64| {
                let half = 0.5 * (couple.abs() / hardest * WIDEST).max(NARROWEST);
                let step = -couple.signum() * half / f64::from(STEPS);
                let degrees = (-STEPS..=STEPS).map(|nth| f64::from(nth) * step - 90.0);
                (couple.abs(), degrees.map(|degrees| on_circle(at, RADIUS, degrees)).collect())
            };
            Self::new(scene, view, (name, values), (Kind::Couple, hardest), draw)
        };
        let mut all: Vec<Self> = forces()
            .map(force)
            .chain(asked.couples.iter().map(couple))
            .collect::<Result<_, _>>()?;
        let reactions = all.iter_mut().skip(asked.forces.len()).take(asked.reactions.len());
        reactions.for_each(|load| load.is_reaction = true);
        Ok(all)
    }

    fn new<V: Copy>(
        scene: &Scene,
        view: View,
        (name, values): (&str, &[V]),
        (kind, largest): (Kind, f64),
        draw: impl Fn([f64; 2], V) -> (f64, Vec<[f64; 2]>),
    ) -> Result<Self, SketchError> {
        let point = point(scene.plan, name)?;
        let of = |frame: usize| {
            // One value is the same in all poses.
            let &value = values.get(scene.pose(frame)).or(values.last())?;
            let (size, line) = draw(view.pixels(scene.point(frame, point)?), value);
            let is_seen = size > NOTHING * largest && line.iter().flatten().all(|x| x.is_finite());
            Some((size, is_seen.then_some(line)))
        };
        let (mut sizes, mut lines) = (Vec::new(), Vec::new());
        for found in scene.frames().map(of) {
            let (size, line) = found.unwrap_or((f64::NAN, None));
            sizes.push(size);
            lines.push(line);
        }
        Ok(Self { point, kind, is_reaction: false, lines, sizes, largest })
    }

    pub(super) fn extent(&self) -> Box2 {
        Box2::around(self.lines.iter().flatten().flatten().copied())
    }

    /// Its colour.
    pub(super) fn colour(&self, palette: &Palette) -> &'static str {
        if self.is_reaction { palette.push } else { palette.accent }
    }

    /// The sides of its line in a pose.
    pub(super) fn sides(&self, frame: usize) -> impl Iterator<Item = [[f64; 2]; 2]> {
        let line = self.lines[frame].iter();
        line.flat_map(|line| line.windows(2).map(|ends| [ends[0], ends[1]]))
    }

    /// Where a value is written in a pose, and the value.
    pub(super) fn value(&self, frame: usize) -> Option<([f64; 2], String)> {
        let line = self.lines[frame].as_ref()?;
        let at = match self.kind {
            Kind::Force => *line.last()?,
            Kind::Couple => line[line.len() / 2],
        };
        Some((at, self.kind.written(self.sizes[frame])))
    }

    pub(super) fn shift(&mut self, by: [f64; 2]) {
        let spots = self.lines.iter_mut().flatten().flatten();
        spots.for_each(|spot| *spot = [spot[0] + by[0], spot[1] + by[1]]);
    }

    pub(super) fn drawn(&self, name: &str, timing: Option<Timing>, palette: &Palette) -> String {
        let kind = match self.kind {
            Kind::Force => "force",
            Kind::Couple => "couple",
        };
        let look = format!(
            r#"data-{kind}="{name}" stroke="{}" stroke-width="2" stroke-linecap="round" stroke-linejoin="round""#,
            self.colour(palette)
        );
        match self.kind {
            Kind::Force => {
                let ends = self
                    .lines
                    .iter()
                    .map(|line| Some([*line.as_ref()?.first()?, *line.as_ref()?.last()?]));
                moving_arrow(&ends.collect::<Vec<_>>(), false, timing, &look)
            }
            Kind::Couple => {
                let paths = self.lines.iter().map(|line| line.as_deref().map(turning_arrow));
                moving_path(&paths.collect::<Vec<_>>(), timing, &look)
            }
        }
    }
}

/// Half of the steps of an arc.
const STEPS: i32 = 8;

fn largest(sizes: impl Iterator<Item = f64>) -> f64 {
    sizes.filter(|size| size.is_finite()).fold(0.0, f64::max)
}

impl Kind {
    fn written(self, size: f64) -> String {
        let (value, prefix) = if size >= 1e3 { (size / 1e3, "k") } else { (size, "") };
        let unit = match self {
            Self::Force => "N",
            Self::Couple => "N\u{b7}m",
        };
        format!("{} {prefix}{unit}", three_digits(value))
    }

    /// The size below which arrows or arcs do not shrink.
    fn least(self, largest: f64) -> f64 {
        match self {
            Self::Force => largest * SHORTEST / LONGEST,
            Self::Couple => largest * NARROWEST / WIDEST,
        }
    }
}

/// The largest force on each point over all poses, and how arrows are drawn; the same of couples.
pub(super) fn legend(loads: &[Load], points: &[&'static str]) -> Vec<String> {
    [Kind::Force, Kind::Couple].into_iter().filter_map(|kind| line(loads, points, kind)).collect()
}

fn line(loads: &[Load], points: &[&'static str], kind: Kind) -> Option<String> {
    let own: Vec<&Load> = loads.iter().filter(|load| load.kind == kind).collect();
    let all = own.first()?.largest;
    let most = own.iter().map(|load| {
        let most = largest(load.sizes.iter().copied());
        format!("{} {}", points[load.point], kind.written(most))
    });
    let most: Vec<String> = most.collect();
    let (what, drawn) = match kind {
        Kind::Force => ("forces", "arrows"),
        Kind::Couple => ("couples", "arcs"),
    };
    let sizes = own.iter().flat_map(|load| &load.sizes);
    let is_short = |&size: &f64| size > NOTHING * all && size < kind.least(all);
    let note = match sizes.copied().any(|size| is_short(&size)) {
        true => format!("; {drawn} to scale from {} on", kind.written(kind.least(all))),
        false => String::new(),
    };
    let largest = if own[0].sizes.len() > 1 { "largest " } else { "" };
    Some(format!("{largest}{what}: {}{note}", most.join(", ")))
}
