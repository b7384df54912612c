//! The calibration as a chart.

use linkage_core::SolveError;

use crate::CALIBRATIONS;
use crate::fit::Calibration;
use crate::machine::{Dimensions, UNKNOWNS, built, drawn, tracked};
use crate::measurement::Measurement;
use charts::{BLACK, COLOURS, Curve, GREY, MarkerShape, Panel};

pub(crate) fn draw(
    measurement: &Measurement,
    found: &Calibration,
    held: [u32; UNKNOWNS],
) -> Result<(), SolveError> {
    let panels =
        vec![pins(measurement), residuals(measurement, found)?, intervals(found), coverage(held)];
    charts::write("calibration", "Calibration of a six-bar", 2, panels);
    Ok(())
}

/// Where the pins were seen.
fn pins(measurement: &Measurement) -> Panel {
    let shapes = [MarkerShape::Circle, MarkerShape::Square, MarkerShape::Diamond];
    let curves = ["C", "E", "F"].into_iter().zip(shapes).enumerate().map(|(pin, (name, shape))| {
        let rows = measurement.seen.iter();
        let seen = rows.map(|row| (row[2 * pin] * 1e3, row[2 * pin + 1] * 1e3));
        Curve::dots(name, charts::colour_of_pin(name), shape, seen.collect())
    });
    Panel::plane("Where the pins were seen", ["x in mm", "y in mm"], curves.collect())
}

/// The distance between each pin as seen and as computed from the dimensions, on average over the pins.
fn residuals(measurement: &Measurement, found: &Calibration) -> Result<Panel, SolveError> {
    let away = |dimensions: Dimensions| -> Result<Vec<(f64, f64)>, SolveError> {
        let poses = measurement.thetas.iter().zip(&measurement.seen);
        poses
            .map(|(theta, seen)| {
                let explained = tracked(dimensions, *theta)?;
                let squares = explained.iter().zip(seen).map(|(x, seen)| (x - seen) * (x - seen));
                let mean = (squares.sum::<f64>() / 3.0).sqrt();
                Ok((theta.to_degrees(), (mean * 1e3).log10()))
            })
            .collect()
    };
    let curves = vec![
        Curve::named("as drawn", COLOURS[1], away(drawn())?),
        Curve::named("calibrated", COLOURS[0], away(found.dimensions)?),
    ];
    let axes = ["encoder in deg", "log₁₀ of the distance in mm"];
    Ok(Panel::over("From where a pin is seen to where it should be", axes, curves))
}

/// A bar for each dimension's interval about the true dimension, and a mark for what was found.
fn intervals(found: &Calibration) -> Panel {
    let true_ones = built();
    let mut curves = vec![Curve::line(BLACK, &[(0.5, 0.0), (UNKNOWNS as f64 + 0.5, 0.0)])];
    for (i, built) in true_ones.iter().enumerate() {
        let x = i as f64 + 1.0;
        let (width, error) = (found.half_widths[i] * 1e3, (found.dimensions[i] - built) * 1e3);
        let bar = [(x, error - width), (x, error + width)];
        let mark = [(x - 0.25, error), (x + 0.25, error)];
        curves.push(Curve::line(COLOURS[0], &bar));
        curves.push(Curve::line(COLOURS[1], &mark));
    }
    let axes = ["dimension, as listed", "found − built, ± 95 %, in mm or mrad"];
    Panel::over("Found dimensions", axes, curves)
}

/// The counts of intervals that held the true dimension, and the band of 19 of 20 such counts.
fn coverage(held: [u32; UNKNOWNS]) -> Panel {
    let percent = |count: u32| 100.0 * f64::from(count) / f64::from(CALIBRATIONS);
    let shares: Vec<_> = (1..).zip(held).map(|(i, count)| (f64::from(i), percent(count))).collect();
    let deviation = 100.0 * (0.95_f64 * 0.05 / f64::from(CALIBRATIONS)).sqrt();
    let level = |y: f64| [(0.5, y), (UNKNOWNS as f64 + 0.5, y)];
    let curves = vec![
        Curve::line(BLACK, &level(95.0)),
        Curve::line(GREY, &level(95.0 - 2.0 * deviation)),
        Curve::line(GREY, &level(95.0 + 2.0 * deviation)),
        Curve::line(COLOURS[0], &shares),
    ];
    let axes = ["dimension, as listed", "intervals that hold it in %"];
    Panel::over("Four hundred calibrations", axes, curves)
}
