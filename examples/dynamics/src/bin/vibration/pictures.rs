//! The vibrations as charts.

use charts::{COLOURS, Curve, Panel};

use crate::{Cases, Trace};

pub(crate) fn draw(cases: &Cases) {
    let one: Vec<&Trace> = cases.free.iter().chain(&cases.forced).collect();
    let two: Vec<&Trace> = cases.two_free.iter().chain(&cases.two_forced).collect();
    charts::write(
        "vibration",
        "Vibrations (lines) over their closed forms (grey)",
        2,
        vec![
            motion("One mass, let go at 10 m", 1.0, "x in m", &cases.free),
            motion("One mass from rest, 1 N at 1 Hz", 1e3, "x in mm", &cases.forced),
            motion("Two masses, the second let go at 10 m", 1.0, "x in m", &cases.two_free),
            motion(
                "Two masses from rest, 0.5 N at 1 Hz on the second",
                1e3,
                "x in mm",
                &cases.two_forced[..2],
            ),
            errors("One mass: what the integrator adds", &one),
            errors("Two masses: what the integrator adds", &two),
        ],
    );
}

/// The computed motion, drawn over the exact one.
fn motion(title: &str, scale: f64, unit: &str, traces: &[Trace]) -> Panel {
    let scaled = |points: &[(f64, f64)]| points.iter().map(|(t, x)| (*t, x * scale)).collect();
    let behind = traces.iter().map(|trace| Curve::band(scaled(&trace.exact)));
    let lines = traces.iter().zip(COLOURS);
    let lines = lines.map(|(trace, colour)| Curve::named(trace.name, colour, scaled(&trace.found)));
    Panel::over(title, ["t in s", unit], behind.chain(lines).collect())
}

/// Decimal logarithms; a difference of nothing is drawn at 1e-17.
fn errors(title: &str, traces: &[&Trace]) -> Panel {
    let curve = |(trace, colour): (&&Trace, &str)| {
        // The worst of every half second: zero crossings say nothing.
        let points = trace.errors();
        let worst = points.chunks(20).map(|chunk| {
            let worst = chunk.iter().map(|(_, error)| *error).fold(1e-17, f64::max);
            (chunk[0].0, worst.log10())
        });
        Curve::named(trace.name, colour, worst.collect())
    };
    let curves = traces.iter().zip(COLOURS).map(curve).collect();
    Panel::over(title, ["t in s", "log₁₀ of the error over the amplitude"], curves)
}
