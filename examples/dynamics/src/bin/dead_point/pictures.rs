//! The swinging four-bar as charts.

use charts::{COLOURS, Curve, Panel};

use crate::{Machine, Piece, Pose};

type Points = Vec<(f64, f64)>;

/// The time over which the motion is drawn: two swings, in s. The energy is drawn over all of it.
const SHOWN: f64 = 3.7;

pub(crate) fn draw(pieces: &[Piece], poses: &[(f64, Pose)]) {
    let over_time = |value: &dyn Fn(&Pose) -> f64, until: f64| -> Points {
        let shown = poses.iter().filter(|(time, _)| *time <= until);
        shown.map(|(time, pose)| (*time, value(pose))).collect()
    };
    let rockers = |value: fn(&Pose, usize) -> f64| {
        let named = ["left rocker", "right rocker"].into_iter().zip(COLOURS).enumerate();
        named.map(move |(i, (name, colour))| {
            Curve::named(name, colour, over_time(&|pose| value(pose, i), SHOWN))
        })
    };
    let start = poses[0].1.energy;
    let off = |pose: &Pose| (pose.energy / start - 1.0).abs().max(1e-16).log10();
    charts::write(
        "dead_point",
        "A four-bar that changes its coordinate before each dead point",
        2,
        vec![
            plane(poses),
            Panel::over(
                "Rockers; over grey, which of them is the coordinate",
                ["t in s", "angle in deg"],
                coordinates(pieces).chain(rockers(angle)).collect(),
            ),
            Panel::over(
                "Between coupler and rocker: 0 is the other one's dead point",
                ["t in s", "sine of the angle"],
                rockers(|pose, i| pose.sines[i]).collect(),
            ),
            Panel::over(
                "What the energy is off by, as a share",
                ["t in s", "log₁₀ of the share"],
                vec![Curve::line(COLOURS[1], &over_time(&off, f64::INFINITY))],
            ),
        ],
    );
}

/// In degrees, without a jump: the left rocker swings about the right side of the picture, the right
/// one about its left side.
fn angle(pose: &Pose, rocker: usize) -> f64 {
    let degrees = pose.angles[rocker].to_degrees();
    if rocker == 0 { degrees } else { degrees.rem_euclid(360.0) - 360.0 }
}

/// The paths of both pins.
fn plane(poses: &[(f64, Pose)]) -> Panel {
    let path = |point: fn(&Pose) -> (f64, f64)| poses.iter().map(|(_, pose)| point(pose)).collect();
    let curves = vec![
        Curve::named("B", charts::colour_of_pin("B"), path(|pose| (pose.b.x, pose.b.y))),
        Curve::named("C", charts::colour_of_pin("C"), path(|pose| (pose.c.x, pose.c.y))),
    ];
    Panel::plane("Paths of the pins", ["x in m", "y in m"], curves)
}

/// A broad curve of the coordinate for every piece.
fn coordinates(pieces: &[Piece]) -> impl Iterator<Item = Curve> + '_ {
    let shown = pieces.iter().filter(|piece| piece.times.last().is_some_and(|end| *end <= SHOWN));
    shown.map(|piece| {
        let rocker = usize::from(matches!(piece.machine, Machine::ByRight(_)));
        let both = piece.times.iter().zip(&piece.states);
        let at = |(time, state): (&f64, &[f64; 2])| {
            let pose = piece.machine.pose(*state).ok()?;
            Some((*time, angle(&pose, rocker)))
        };
        Curve::band(both.filter_map(at).collect())
    })
}
