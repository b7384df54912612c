//! The path of a cart that a crank-rocker steers: while it advances, its wheels turn a crank over gears,
//! and the rocker turns the front wheel from side to side, so that the cart winds its way between poles.
//!
//! With the distance s, the heading ψ, the steering angle δ − δ₀ and the wheelbase L,
//!
//! > x′ = cos ψ,  y′ = sin ψ,  ψ′ = tan(δ(θ) − δ₀)/L,  θ = 2π s/S,
//!
//! which needs positions and an integrator alone. The task is from a course work whose numbers are
//! lost. All dimensions here are invented; the trim δ₀ is chosen so that a turn of the crank leaves the
//! heading as it was, and the heading at the start so that the cart comes back to its line.

mod truth;

use std::f64::consts::TAU;

use charts::{BLACK, COLOURS, Curve, GREY, Panel};
use dynamics::{Motion, Run, Stopped, show};
use linkage_core::{SolveError, mechanism};

mechanism! {
    /// The steering: a crank on the gears, and a rocker on the fork of the front wheel.
    pub struct Steering {
        input theta: angle;
        ground A(0, 0), D(110mm, 0);
        crank AB(A) -> B        { length: 20mm, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (100mm, 60mm), mode: left }
        output DC;
    }
}

/// From the front wheel to the axle, and between the wheels of the axle, in m.
const WHEELBASE: f64 = 0.2;
const TRACK: f64 = 0.16;
/// The way for which the crank turns once, in m.
const ADVANCE: f64 = 3.0;
/// The rocker's angle with the wheel straight, in rad.
const TRIM: f64 = truth::TRIM;
const TOLERANCE: f64 = 1e-14;

/// The steering angle of the wheel at an angle of the crank, in rad.
fn steered(theta: f64) -> Result<f64, SolveError> {
    Ok(Steering::new().position(theta)?.DC.angle() - TRIM)
}

/// x, y in m and heading in rad over so many turns of the crank; the run's times are these turns.
fn driven(turns: u32, samples: u32) -> Result<Run<3>, Stopped> {
    let rates = |turn: f64, [_, _, heading]: [f64; 3]| {
        let (sin, cos) = heading.sin_cos();
        let bend = steered(TAU * turn)?.tan() / WHEELBASE;
        Ok([cos, sin, bend].map(|rate| ADVANCE * rate))
    };
    let motion = Motion::new([0.0, f64::from(turns)], [0.0, 0.0, truth::HEADING], rates)
        .tolerance(TOLERANCE);
    motion.sampled(turns * samples)
}

/// The farthest from the truth, of x and y in m and of the heading in rad.
fn worst(run: &Run<3>) -> f64 {
    let states = run
        .states
        .iter()
        .zip(truth::POSES)
        .flat_map(|(state, truth)| [0, 1, 2].map(|i| (state[i] - truth[i]).abs()));
    states.fold(0.0, f64::max)
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let run = driven(1, 12)?;
    println!("A cart of {WHEELBASE} m, whose crank turns once in {ADVANCE} m\n");
    println!("{:>6} {:>8} {:>18} {:>18} {:>10}", "turn", "wheel", "x", "y", "heading");
    println!("{:>6} {:>8} {:>18} {:>18} {:>10}", "", "deg", "m", "m", "deg");
    for (turn, [x, y, heading]) in run.iter() {
        let wheel = steered(TAU * turn)?.to_degrees();
        println!("{turn:6.3} {wheel:8.3} {x:18.14} {y:18.14} {:10.4}", heading.to_degrees());
    }
    println!("\nfarthest from quadrature in 30 digits: {:.1e}", worst(&run));
    draw()?;
    let turn = (0..=120).map(|k| f64::from(k) * TAU / 120.0);
    show("cart_film", &Steering::new().film(turn).trace("C"))?;
    Ok(())
}

fn draw() -> Result<(), Stopped> {
    let run = driven(3, 240)?;
    let path = |run: &Run<3>| run.states.iter().map(|[x, y, _]| (*x, *y)).collect::<Vec<_>>();
    let one = driven(1, 240)?;
    let wheel = one.curve(|turn, _| steered(TAU * turn).map_or(f64::NAN, f64::to_degrees));
    let heading = one.curve(|_, [_, _, heading]| heading.to_degrees());
    let degrees = |points: Vec<(f64, f64)>| -> Vec<(f64, f64)> {
        points.into_iter().map(|(turn, value)| (turn * 360.0, value)).collect()
    };
    // The cart at every twelfth of the turn: its axle behind, its wheel in front.
    let carts = driven(1, 12)?.states.into_iter().map(|[x, y, heading]| {
        let (sin, cos) = heading.sin_cos();
        let at = |along: f64, across: f64| {
            (x + along * cos - across * sin, y + along * sin + across * cos)
        };
        let wheels = [TRACK / 2.0, -TRACK / 2.0].map(|across| at(0.0, across));
        Curve::line(BLACK, &[wheels[0], at(WHEELBASE, 0.0), wheels[1], wheels[0]])
    });
    let mut paths = vec![
        Curve::named("three turns", GREY, path(&run)),
        Curve::named("one turn", COLOURS[1], path(&one)),
    ];
    paths.extend(carts);
    charts::write(
        "cart",
        "A cart steered by a crank-rocker",
        2,
        vec![
            Panel::plane(
                "Path of the axle; the cart at twelfths of a turn",
                ["x in m", "y in m"],
                paths,
            ),
            Panel::over(
                "Over a turn of the crank",
                ["crank in deg", "angle in deg"],
                vec![
                    Curve::named("wheel", COLOURS[0], degrees(wheel)),
                    Curve::named("heading", COLOURS[1], degrees(heading)),
                ],
            ),
        ],
    );
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_path_is_that_of_quadrature_in_30_digits() {
        let run = driven(1, 12).unwrap();
        assert_eq!(run.states.len(), truth::POSES.len());
        assert!(worst(&run) < 1e-12, "{:e}", worst(&run));
        // The path is compared: the cart winds, and returns to the x axis.
        let [x, y, heading] = run.last().1;
        let winds = run.states.iter().any(|[_, y, _]| *y < -0.5);
        assert!((heading - truth::HEADING).abs() < 1e-12 && winds, "{heading}");
        assert!(x > 2.0 && y.abs() < 1e-6, "{x} {y}");
    }

    /// The rate of ψ over a turn is the mean of the steering: the trapezium rule on the period of an
    /// analytic function is exact to rounding.
    #[test]
    fn the_trim_keeps_the_heading() {
        let samples = (0..360).map(|k| steered(f64::from(k) * TAU / 360.0).unwrap().tan());
        let mean = samples.sum::<f64>() / 360.0;
        assert!(mean.abs() < 1e-15, "{mean:e}");
    }
}
