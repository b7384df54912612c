//! The shapes that bodies are made of, in pixels of their own frame.

use std::format;
use std::string::String;
use std::vec;
use std::vec::Vec;

use super::scene::Pose;
use super::style::{BLOCK, Palette, TUBE};
use super::svg::{Transform, View, fine, path, short};

#[derive(Clone, Debug)]
pub(super) enum Shape {
    Bar([[f64; 2]; 2]),
    /// A body through three joints or more: their convex hull.
    Hull(Vec<[f64; 2]>),
    /// A line that connects a part to the rest.
    Stub([[f64; 2]; 2]),
    /// A block along x.
    Block([f64; 2]),
    /// From the origin along x.
    Tube(f64),
    /// From the origin backwards along x.
    Rod(f64),
}

impl Shape {
    /// A line that stands for it.
    pub(super) fn line(&self) -> Vec<[f64; 2]> {
        match self {
            Self::Bar(ends) | Self::Stub(ends) => ends.into(),
            Self::Hull(corners) => corners.iter().chain(corners.first()).copied().collect(),
            Self::Tube(length) => vec![[0.0; 2], [*length, 0.0]],
            Self::Rod(length) => vec![[-*length, 0.0], [0.0; 2]],
            Self::Block([x, y]) => vec![[x - BLOCK[0] / 2.0, *y], [x + BLOCK[0] / 2.0, *y]],
        }
    }

    /// True if its outline shows the position of the body, so that a faint copy of it makes sense.
    pub(super) fn is_long(&self) -> bool {
        !matches!(self, Self::Block(_))
    }

    /// Half the width across its line.
    pub(super) fn half_width(&self) -> f64 {
        match self {
            Self::Block(_) => BLOCK[1] / 2.0 + 1.0,
            Self::Tube(_) => TUBE / 2.0 + 1.0,
            _ => 2.5,
        }
    }

    pub(super) fn draw(&self, colour: &str, palette: &Palette) -> String {
        let line = |ends: &[[f64; 2]; 2], width: &str| {
            format!(r#"<path d="{}" stroke="{colour}" stroke-width="{width}"/>"#, path(ends, false))
        };
        let (paper, ink) = (palette.paper, palette.ink);
        match self {
            Self::Bar(ends) => line(ends, "5"),
            Self::Stub(ends) => line(ends, "5"),
            Self::Hull(corners) => format!(
                r#"<path d="{}" stroke="{colour}" stroke-width="4" fill="{colour}" fill-opacity=".16"/>"#,
                path(corners, true)
            ),
            Self::Block([x, y]) => {
                let (x, y) = (fine(x - BLOCK[0] / 2.0), fine(y - BLOCK[1] / 2.0));
                let [width, height] = BLOCK;
                format!(
                    r#"<rect x="{x}" y="{y}" width="{width}" height="{height}" rx="2" fill="{paper}"/><rect x="{x}" y="{y}" width="{width}" height="{height}" rx="2" fill="{colour}" fill-opacity=".25" stroke="{colour}" stroke-width="2"/>"#
                )
            }
            Self::Tube(length) => {
                let (x, width, y) = (TUBE_START, short(length - TUBE_START), -TUBE / 2.0);
                format!(
                    r#"<path d="M0 0H{x}" stroke="{colour}" stroke-width="4"/><rect x="{x}" y="{y}" width="{width}" height="{TUBE}" rx="2" fill="{paper}"/><rect x="{x}" y="{y}" width="{width}" height="{TUBE}" rx="2" fill="{colour}" fill-opacity=".25" stroke="{colour}" stroke-width="2"/>"#
                )
            }
            // The tube, drawn later, hides what of the rod is inside.
            Self::Rod(length) => {
                format!(
                    r#"<path d="M{}0H0" stroke="{ink}" stroke-width="4"/>"#,
                    short(-length) + " "
                )
            }
        }
    }
}

/// Where a tube begins, behind its joint.
const TUBE_START: f64 = 8.0;

/// A bar through points that lie on a line, the hull of others; nothing for less than two.
pub(super) fn skeleton(points: &[(usize, [f64; 2])]) -> Vec<Shape> {
    let spots: Vec<[f64; 2]> = points.iter().map(|&(_, spot)| spot).collect();
    let distance = |a: [f64; 2], b: [f64; 2]| (a[0] - b[0]).hypot(a[1] - b[1]);
    let pairs = spots.iter().flat_map(|&a| spots.iter().map(move |&b| [a, b]));
    let far = pairs.max_by(|a, b| distance(a[0], a[1]).total_cmp(&distance(b[0], b[1])));
    let Some([a, b]) = far.filter(|&[a, b]| distance(a, b) > 0.5) else { return Vec::new() };
    let length = distance(a, b);
    let beside =
        |[x, y]: [f64; 2]| ((b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0])).abs() / length;
    if spots.iter().all(|&spot| beside(spot) < 1.5) {
        return vec![Shape::Bar([a, b])];
    }
    vec![Shape::Hull(hull(spots))]
}

/// The corners of the convex hull, in turn (Andrew's monotone chain).
fn hull(mut spots: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
    spots.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    let chain = |spots: &mut dyn Iterator<Item = [f64; 2]>| {
        let mut chain: Vec<[f64; 2]> = Vec::new();
        for spot in spots {
            while let [.., a, b] = chain[..] {
                let turn = (b[0] - a[0]) * (spot[1] - a[1]) - (b[1] - a[1]) * (spot[0] - a[0]);
                if turn > 1e-9 {
                    break;
                }
                chain.pop();
            }
            chain.push(spot);
        }
        chain.pop();
        chain
    };
    let mut corners = chain(&mut spots.iter().copied());
    corners.extend(chain(&mut spots.iter().rev().copied()));
    corners
}

/// A frame of a link as its group's pixels have it.
pub(super) fn turned(view: View, pose: Pose) -> Transform {
    let on_link = View { origin: [0.0; 2], ..view };
    on_link.seat(pose)
}
