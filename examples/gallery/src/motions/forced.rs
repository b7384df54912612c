//! Motions under forces: of the mechanisms of `examples/dynamics`, integrated, and of a block that rubs, in closed
//! form.

use std::f64::consts::{PI, TAU};

use linkage_core::SolveError;
use linkage_core::sketch::Film;

use super::{Kind, POSES, Piece, turn};
use crate::declarations::{
    andrews_squeezer, cart, computed_torque, counterweight, crane, dead_point, parallelograms,
    run_up, stick_slip, vibration,
};

pub(super) fn pieces() -> Vec<Piece> {
    let mut pieces = vec![
        Piece {
            name: "vibration::Oscillator",
            kind: Kind::Free,
            text: "A mass on a spring, let go, over two periods.",
            film: oscillator(),
        },
        Piece {
            name: "stick_slip::DryBlock",
            kind: Kind::Free,
            text: "A block on a spring that rubs on its bed: eight half swings, and it rests beside the middle.",
            film: stick_slip::DryBlock::new().film(dry_swings()).seconds(8.0),
        },
        Piece {
            name: "stick_slip::CreepingBlock",
            kind: Kind::Free,
            text: "The same swings by a smooth law, which would let the block creep on.",
            film: stick_slip::CreepingBlock::new().film(dry_swings()).seconds(8.0),
        },
        Piece {
            name: "vibration::TwoMasses",
            kind: Kind::Free,
            text: "Two masses in a row on two springs; the outer one was pulled and let go.",
            film: two_masses(),
        },
        Piece {
            name: "andrews_squeezer::Squeezer",
            kind: Kind::Free,
            text: "Andrews' squeezing mechanism under a constant torque, 500 times slower.",
            film: squeezer(),
        },
        Piece {
            name: "parallelograms::TwoParallelograms",
            kind: Kind::Free,
            text: "Two parallelograms, let go where their cranks are level.",
            film: falling(),
        },
        Piece {
            name: "crane::Crane",
            kind: Kind::Free,
            text: "A crane that speeds up and brakes within a period of its load, which then hangs still.",
            film: riding(),
        },
        Piece {
            name: "dead_point::ByLeft",
            kind: Kind::FourBar,
            text: "A triple-rocker, its left rocker moved to and fro; the example lets it swing.",
            film: dead_point::ByLeft::new().film(turn().map(|q| -0.6 * (1.0 - q.cos()))).trace("C"),
        },
    ];
    pieces.extend(turning());
    pieces
}

fn turning() -> Vec<Piece> {
    vec![
        Piece {
            name: "dead_point::ByRight",
            kind: Kind::FourBar,
            text: "The same triple-rocker, its right rocker moved to and fro.",
            film: dead_point::ByRight::new().film(turn().map(|q| 2.35 - 0.5 * q.cos())).trace("B"),
        },
        Piece {
            name: "run_up::FourBar",
            kind: Kind::FourBar,
            text: "A four-bar at constant speed; the example runs it up by a motor.",
            film: run_up::FourBar::new().film(turn()).trace("C"),
        },
        Piece {
            name: "cart::Steering",
            kind: Kind::SixBar,
            text: "The steering of a cart: a crank on its gears turns the front wheel's fork.",
            film: cart::Steering::new().film(turn()).trace("C"),
        },
        Piece {
            name: "computed_torque::Robot",
            kind: Kind::SeveralInputs,
            text: "A five-bar robot, its tool on the wanted circle; the example controls it there.",
            film: computed_torque::Robot::new().film(motors()).trace("P"),
        },
        Piece {
            name: "computed_torque::Arms",
            kind: Kind::SeveralInputs,
            text: "The same robot by the place of its tool.",
            film: computed_torque::Arms::new().film(circle()).trace("P"),
        },
        Piece {
            name: "counterweight::FourBar",
            kind: Kind::Loaded,
            text: "The four-bar that is balanced by counterweights.",
            film: counterweight::FourBar::new().film(turn()),
        },
    ]
}

/// The states at as many times as poses, evenly over the seconds (Runge and Kutta's method of order 4,
/// forty steps a pose).
///
/// # Panics
/// Where the mechanism refuses: a mistake in this file.
fn integrated<const N: usize>(
    start: [f64; N],
    seconds: f64,
    rates: impl Fn(f64, [f64; N]) -> Result<[f64; N], SolveError>,
) -> Vec<[f64; N]> {
    const STEPS: u32 = 40;
    let step = seconds / f64::from(STEPS * (POSES - 1));
    let slope = |time: f64, state| rates(time, state).expect("the motion stays in reach");
    let mut states = vec![start];
    let mut state = start;
    for nth in 0..STEPS * (POSES - 1) {
        let time = f64::from(nth) * step;
        let ahead = |by: f64, slope: [f64; N]| std::array::from_fn(|i| state[i] + by * slope[i]);
        let first = slope(time, state);
        let second = slope(time + 0.5 * step, ahead(0.5 * step, first));
        let third = slope(time + 0.5 * step, ahead(0.5 * step, second));
        let fourth = slope(time + step, ahead(step, third));
        let mean =
            std::array::from_fn(|i| (first[i] + 2.0 * (second[i] + third[i]) + fourth[i]) / 6.0);
        state = ahead(step, mean);
        if (nth + 1) % STEPS == 0 {
            states.push(state);
        }
    }
    states
}

fn oscillator() -> Film {
    let machine = vibration::Oscillator::new();
    let period = TAU * (1.6632_f64 / machine.k).sqrt();
    let states =
        integrated([10.0, 0.0], 2.0 * period, |_, state| machine.state_rates(state, 0.0, 0.0));
    machine.film(states.into_iter().map(|[x, _]| x)).seconds(2.0 * period)
}

/// The half swings of a block that is let go: cosines about the place to which the spring pulls against friction,
/// μmg/k on this side and that, in turn.
fn dry_swings() -> impl Iterator<Item = f64> {
    const CENTRE: f64 = 0.25 * 2.0 * 9.81 / 800.0;
    let swing = |half: i32| {
        let (side, from) = (f64::from(1 - 2 * (half % 2)), 0.1 - 2.0 * CENTRE * f64::from(half));
        (0..12).map(move |step| {
            side * (CENTRE + (from - CENTRE) * (PI * f64::from(step) / 12.0).cos())
        })
    };
    let rest = 0.1 - 16.0 * CENTRE;
    (0..8).flat_map(swing).chain([rest; 12])
}

fn two_masses() -> Film {
    let machine = vibration::TwoMasses::new();
    let rates = |_, state| machine.state_rates(state, [0.0; 2], 0.0);
    let states = integrated([0.0, 10.0, 0.0, 0.0], 8.0, rates);
    machine.film(states.into_iter().map(|[x, y, ..]| [x, y])).seconds(8.0)
}

fn squeezer() -> Film {
    let machine = andrews_squeezer::Squeezer::new();
    let rates = |_, state| machine.state_rates(state, 0.033);
    let states = integrated([-0.062_013_890_753_353_2, 0.0], 0.015, rates);
    let film = machine.film(states.into_iter().map(|[beta, _]| beta));
    film.trace("P").trace("E").trace("F").seconds(7.5)
}

fn falling() -> Film {
    let machine = parallelograms::TwoParallelograms::new();
    // From level to level: half of a period, after which it swings back the same way.
    let half = 3.708_149_354_602_744 / (7.0 / 6.0 * 9.81_f64).sqrt();
    let states = integrated([0.0; 2], half, |_, state| machine.state_rates(state, 0.0));
    let film = machine.film(states.into_iter().map(|[q, _]| q)).there_and_back();
    film.trace("B1").label(["A0", "A1", "A2", "B0", "B1", "B2"]).seconds(2.0 * half)
}

/// Speeds up for one period of the load, cruises, brakes for another, and stands: the acceleration is
/// given, and the sway follows.
fn riding() -> Film {
    const ACCELERATION: f64 = 0.5;
    let machine = crane::Crane::new();
    let period = 5.12;
    let acceleration = |time: f64| match time {
        _ if time < period => ACCELERATION,
        _ if time < period + 1.0 => 0.0,
        _ if time < 2.0 * period + 1.0 => -ACCELERATION,
        _ => 0.0,
    };
    let rates = |time: f64, [x, sway, v, rate]: [f64; 4]| {
        let e = machine.equations_of_motion([x, sway], [v, rate])?;
        let given = acceleration(time);
        Ok([v, rate, given, (e.force[1] - e.mass[1][0] * given) / e.mass[1][1]])
    };
    let states = integrated([0.0; 4], 2.0 * period + 4.0, rates);
    let film = machine.film(states.into_iter().map(|[x, sway, ..]| [x, sway]));
    film.trace("L").label(["P", "L"]).seconds(12.0)
}

/// The circle of the robot's tool.
fn circle() -> impl Iterator<Item = [f64; 2]> {
    turn().map(|q| [0.02 + 0.05 * q.cos(), 0.3 + 0.05 * q.sin()])
}

/// The motors' angles on it.
fn motors() -> Vec<[f64; 2]> {
    let arms = computed_torque::Arms::new();
    let angles = circle().map(|at| arms.position(at).map(|p| [p.AB.angle(), p.DE.angle()]));
    angles.map(|angles| angles.expect("the circle is in reach")).collect()
}
