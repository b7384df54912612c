//! The picture: the ten best curves over the drawn path, and the best four-bars at work on it.

use std::f64::consts::TAU;

use charts::{BLACK, COLOURS, Curve, Panel};
use linkage_core::SolveError;

use crate::drawn_path::DrawnPath;
use crate::search::Found;

/// Writes `target/charts/NAME.svg` and says so: all curves in the first panel, and the first three with their
/// linkages.
///
/// # Errors
/// Where a curve's poses cannot be assembled, which those of the grid can.
pub fn write(name: &str, path: &DrawnPath, curves: &[Found]) -> Result<(), SolveError> {
    let mut panels = vec![all(path, curves)?];
    for (nth, found) in (1..).zip(curves.iter().take(3)) {
        panels.push(panel(
            path,
            &format!("{nth}: apart by {:.5} of its size", found.distance),
            found,
        )?);
    }
    charts::write(name, "A drawn path, and the coupler curves that come nearest", 2, panels);
    Ok(())
}

/// The curve, laid onto the path.
fn placed_curve(found: &Found) -> Result<Vec<(f64, f64)>, SolveError> {
    let four_bar = found.dimensions.four_bar();
    let mut curve = Vec::new();
    for k in 0..=720 {
        let pose = four_bar.position(TAU * f64::from(k) / 720.0)?;
        let [x, y] = found.placement.place([pose.P.x, pose.P.y]);
        curve.push((x, y));
    }
    Ok(curve)
}

fn all(path: &DrawnPath, curves: &[Found]) -> Result<Panel, SolveError> {
    let mut drawn = vec![Curve::band(path.closed())];
    for (nth, found) in curves.iter().enumerate() {
        let name = format!("{}: {:.5}", nth + 1, found.distance);
        drawn.push(Curve::named(&name, COLOURS[nth % COLOURS.len()], placed_curve(found)?));
    }
    Ok(Panel::plane(&format!("the {} best designs", curves.len()), ["x", "y"], drawn))
}

fn panel(path: &DrawnPath, title: &str, found: &Found) -> Result<Panel, SolveError> {
    let placed = |x: f64, y: f64| {
        let [x, y] = found.placement.place([x, y]);
        (x, y)
    };
    let four_bar = found.dimensions.four_bar();
    let pose = four_bar.position(1.0)?;
    let [a, d] = [placed(0.0, 0.0), placed(found.dimensions.base, 0.0)];
    let [b, c, p] = [pose.B, pose.C, pose.P].map(|pin| placed(pin.x, pin.y));
    let curves = vec![
        Curve::band(path.closed()),
        Curve::named("curve", COLOURS[1], placed_curve(found)?),
        Curve::named("crank", COLOURS[0], vec![a, b]),
        Curve::named("coupler", COLOURS[2], vec![b, c, p, b]),
        Curve::named("follower", COLOURS[3], vec![c, d]),
        Curve::named("ground", BLACK, vec![a, d]),
    ];
    Ok(Panel::plane(title, ["x", "y"], curves))
}
