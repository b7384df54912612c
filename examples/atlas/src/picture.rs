//! The picture: the drawn path, and on it the curves that come nearest with the four-bars that draw them.

use std::f64::consts::TAU;

use charts::{BLACK, COLOURS, Curve, Panel};
use linkage_core::SolveError;

use crate::drawn_path::DrawnPath;
use crate::search::Found;

/// A curve that was found, and where.
#[derive(Clone, Debug)]
pub struct Drawn {
    /// Of its panel.
    pub title: String,
    /// The curve.
    pub found: Found,
}

/// Writes `target/charts/atlas.svg` and says so.
///
/// # Errors
/// Where a curve's poses cannot be assembled, which those of the grid can.
pub fn write(path: &DrawnPath, curves: &[Drawn]) -> Result<(), SolveError> {
    let panels: Result<Vec<Panel>, SolveError> =
        curves.iter().map(|curve| panel(path, curve)).collect();
    let title = "A drawn path, and the coupler curves that come nearest";
    charts::write("atlas", title, 2, panels?);
    Ok(())
}

fn panel(path: &DrawnPath, Drawn { title, found }: &Drawn) -> Result<Panel, SolveError> {
    let placed = |x: f64, y: f64| {
        let [x, y] = found.placement.place([x, y]);
        (x, y)
    };
    let four_bar = found.dimensions.four_bar();
    let angle = |k: u32| TAU * f64::from(k) / 720.0;
    let mut curve = Vec::new();
    for k in 0..=720 {
        let pose = four_bar.position(angle(k))?;
        curve.push(placed(pose.P.x, pose.P.y));
    }
    let pose = four_bar.position(1.0)?;
    let [a, d] = [placed(0.0, 0.0), placed(found.dimensions.base, 0.0)];
    let [b, c, p] = [pose.B, pose.C, pose.P].map(|pin| placed(pin.x, pin.y));
    let curves = vec![
        Curve::band(path.closed()),
        Curve::named("curve", COLOURS[1], curve),
        Curve::named("crank", COLOURS[0], vec![a, b]),
        Curve::named("coupler", COLOURS[2], vec![b, c, p, b]),
        Curve::named("follower", COLOURS[3], vec![c, d]),
        Curve::named("ground", BLACK, vec![a, d]),
    ];
    Ok(Panel::plane(title, ["x", "y"], curves))
}
