//! The result of the search, as a chart.

use std::f64::consts::SQRT_2;

use linkage_core::SolveError;

use crate::generator::{Lengths, error, steps, wanted};
use crate::search::{Outcome, STARTS};
use charts::{BLACK, COLOURS, Curve, GREY, Panel};

type Points = Vec<(f64, f64)>;

pub(crate) fn draw(outcomes: &[Outcome]) -> Result<(), SolveError> {
    let found = outcomes[0].lengths();
    charts::write(
        "function_generator",
        "Crank-rocker that generates a parabola",
        2,
        vec![turns(found)?, errors(found)?, convergence(outcomes), paths(outcomes)],
    );
    Ok(())
}

/// Over the crank's turn, what a function of it says; angles in degrees.
fn over_the_turn(value: impl Fn(f64) -> Result<f64, SolveError>) -> Result<Points, SolveError> {
    let at = |turn: f64| Ok((turn.to_degrees(), value(turn)?.to_degrees()));
    std::iter::once(0.0).chain(steps()).map(at).collect()
}

fn turns(found: Lengths) -> Result<Panel, SolveError> {
    let reached = |lengths| over_the_turn(move |turn| Ok(wanted(turn) + error(lengths, turn)?));
    let curves = vec![
        Curve::named("wanted", BLACK, over_the_turn(|turn| Ok(wanted(turn)))?),
        Curve::named("at the first start", GREY, reached(STARTS[0])?),
        Curve::named("optimal", COLOURS[0], reached(found)?),
    ];
    let axes = ["crank past the limit in deg", "rocker past the limit in deg"];
    Ok(Panel::over("Wanted and reached", axes, curves))
}

fn errors(found: Lengths) -> Result<Panel, SolveError> {
    let errors = |lengths| over_the_turn(move |turn| error(lengths, turn));
    let curves = vec![
        Curve::named("at the first start", GREY, errors(STARTS[0])?),
        Curve::named("optimal", COLOURS[0], errors(found)?),
    ];
    let axes = ["crank past the limit in deg", "reached − wanted in deg"];
    Ok(Panel::over("Error", axes, curves))
}

/// The distance of the best lengths so far from the optimum, by evaluation.
fn convergence(outcomes: &[Outcome]) -> Panel {
    let optimum = outcomes[0].lengths();
    let distances = |outcome: &Outcome| -> Points {
        let away = |lengths: Lengths| {
            (lengths[0] - optimum[0]).hypot(lengths[1] - optimum[1]).max(1e-9).log10()
        };
        (1..)
            .zip(&outcome.steps)
            .map(|(count, step)| (f64::from(count), away(step.lengths)))
            .collect()
    };
    let axes = ["evaluations", "log₁₀ of the distance from the optimum"];
    let curves = by_start(outcomes, distances);
    Panel::over("Convergence from six starts", axes, curves)
}

/// The lengths that the searches went through, and the limit of the transmission angle.
fn paths(outcomes: &[Outcome]) -> Panel {
    let path = |outcome: &Outcome| -> Points {
        outcome.steps.iter().map(|step| (step.lengths[0], step.lengths[1])).collect()
    };
    let mut curves = vec![Curve::named("transmission angle 135°", BLACK, limit())];
    curves.extend(by_start(outcomes, path));
    Panel::plane("Lengths tried", ["coupler in cranks", "rocker in cranks"], curves)
}

/// Where the largest transmission angle is 135°: by the law of cosines, with 6 between the pins,
/// coupler² + rocker² + √2 coupler·rocker = 6².
fn limit() -> Points {
    let rocker = |coupler: f64| ((72.0 - coupler * coupler).sqrt() - coupler) / SQRT_2;
    (0..=75).map(|step| 3.25 + f64::from(step) * 0.025).map(|l| (l, rocker(l))).collect()
}

/// A curve for every search; the first has the name.
fn by_start(outcomes: &[Outcome], points: impl Fn(&Outcome) -> Points) -> Vec<Curve> {
    let curve = |(start, outcome): (usize, &Outcome)| match start {
        0 => Curve::named("slsqp, exact slopes", COLOURS[0], points(outcome)),
        _ => Curve::line(COLOURS[0], &points(outcome)),
    };
    outcomes.iter().enumerate().map(curve).collect()
}
