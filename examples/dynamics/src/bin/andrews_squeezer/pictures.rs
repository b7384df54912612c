//! The two forms beside each other, and the motion.

use charts::{COLOURS, Curve, Panel};
use dynamics::Run;

use crate::{Measured, TOLERANCES};

const NAMES: [&str; 2] = ["declared, 2 states", "index 1, 14 states"];
const COLOUR: [&str; 2] = [COLOURS[1], COLOURS[0]];

pub(crate) fn draw(points: &[[Measured; 2]], run: &Run<2>) {
    let against = |title: &str, axes: [&str; 2], at: &dyn Fn(f64, &Measured) -> (f64, f64)| {
        let curves = [0, 1].map(|form| {
            let both = TOLERANCES.iter().zip(points);
            let points = both.map(|(tolerance, both)| at(*tolerance, &both[form]));
            Curve::named(NAMES[form], COLOUR[form], points.collect())
        });
        Panel::over(title, axes, curves.into())
    };
    let error = "log₁₀ of the worst angle's error";
    charts::write(
        "andrews_squeezer",
        "Andrews' squeezer by one integrator at tolerances from 1e-3 to 1e-13",
        2,
        vec![
            against(
                "Speed against error",
                ["log₁₀ of a run's time in µs", error],
                &|_, run| (run.time.log10(), -run.digits[0]),
            ),
            against("Evaluations against error", ["log₁₀ of evaluations", error], &|_, run| {
                ((run.evaluations as f64).log10(), -run.digits[0])
            }),
            against(
                "How far the loops open",
                ["log₁₀ of 1/tolerance", "log₁₀ of the gap in m"],
                &|tolerance, run| (-tolerance.log10(), run.open.max(1e-18).log10()),
            ),
            Panel::over(
                "The crank from rest under 0.033 N·m",
                ["t in ms", "speed in 1000 rad/s"],
                vec![Curve::line(
                    COLOURS[1],
                    &run.curve(|_, [_, rate]| rate / 1e3)
                        .into_iter()
                        .map(|(t, rate)| (t * 1e3, rate))
                        .collect::<Vec<_>>(),
                )],
            ),
        ],
    );
}
