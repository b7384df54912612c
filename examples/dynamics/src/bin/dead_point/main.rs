//! A four-bar no link of which can turn fully, swinging freely: whichever of its rockers is chosen as
//! the coordinate, the motion comes to its dead points.
//!
//! At a dead point the chosen rocker stands still while the rest moves: its rate says nothing, the mass
//! that it seems to have grows beyond bounds, and forward dynamics is `Singular`. The machine itself
//! feels nothing. So it is declared twice, by the left rocker and by the right one, and where the
//! coupler comes nearer in line with the far rocker than with the near one, an event changes the
//! coordinate: value, rate and assembly mode of the other follow from position and velocity.

mod pictures;
#[cfg(test)]
mod reference;

use dynamics::{Motion, Stopped};
use linkage_core::{Direction, Point, Side, SolveError, mechanism};

mechanism! {
    /// The machine by the angle of its left rocker.
    pub struct ByLeft {
        input phi: angle;
        param elbow: mode = left;
        ground A(0, 0), D(1m, 0);
        crank AB(A) -> B        { length: 0.6m, angle: phi }
        rrr   BC(B), DC(D) -> C { lengths: (0.5m, 0.7m), mode: elbow }
        gravity (0, -9.81(m/s^2));
        mass 1.2kg on AB uniform;
        mass 1kg   on BC uniform;
        mass 1.4kg on DC uniform;
        output AB, BC, DC, B, C, energy;
    }
}

mechanism! {
    /// The same machine by the angle of its right rocker.
    pub struct ByRight {
        input psi: angle;
        param elbow: mode = left;
        ground A(0, 0), D(1m, 0);
        crank DC(D) -> C        { length: 0.7m, angle: psi }
        rrr   CB(C), AB(A) -> B { lengths: (0.5m, 0.6m), mode: elbow }
        gravity (0, -9.81(m/s^2));
        mass 1.2kg on AB uniform;
        mass 1kg   on CB uniform;
        mass 1.4kg on DC uniform;
        output AB, CB, DC, B, C, energy;
    }
}

/// The machine by one of its coordinates.
#[derive(Clone, Copy, Debug)]
enum Machine {
    ByLeft(ByLeft),
    ByRight(ByRight),
}

/// Everything that both declarations tell.
#[derive(Clone, Copy, Debug)]
struct Pose {
    b: Point<f64>,
    c: Point<f64>,
    /// Angles of the rockers, left and right, in rad, and their rates.
    angles: [f64; 2],
    rates: [f64; 2],
    /// Sines of the angles between coupler and rockers, left and right: 0 at the dead point of the other
    /// rocker's angle as the coordinate.
    sines: [f64; 2],
    /// Kinetic and potential energy together, in J.
    energy: f64,
}

/// A coordinate is given up where the other's sine is so many times its own. Afterwards the new one's is
/// as many times the old one's, so that they are not changed back at once.
const BETTER: f64 = 1.5;
/// In rad, and in rad/s: where the left rocker is let go.
const START: [f64; 2] = [-0.2, 0.0];
const SECONDS: f64 = 10.0;
const APART: f64 = 0.01;

impl Machine {
    fn state_rates(&self, state: [f64; 2]) -> Result<[f64; 2], SolveError> {
        match self {
            Self::ByLeft(machine) => machine.state_rates(state, 0.0),
            Self::ByRight(machine) => machine.state_rates(state, 0.0),
        }
    }

    fn pose(&self, [q, rate]: [f64; 2]) -> Result<Pose, SolveError> {
        let sine =
            |one: Direction<f64>, other: Direction<f64>| one.cos * other.sin - one.sin * other.cos;
        match self {
            Self::ByLeft(machine) => {
                let (m, energy) = (machine.motion(q, rate, 0.0)?, machine.energy(q, rate)?);
                let (p, v) = (m.position, m.velocity);
                Ok(Pose {
                    b: p.B,
                    c: p.C,
                    angles: [q, p.DC.angle()],
                    rates: [rate, v.DC.omega],
                    sines: [sine(p.AB, p.BC), sine(p.BC, p.DC)],
                    energy: energy.kinetic + energy.potential,
                })
            }
            Self::ByRight(machine) => {
                let (m, energy) = (machine.motion(q, rate, 0.0)?, machine.energy(q, rate)?);
                let (p, v) = (m.position, m.velocity);
                Ok(Pose {
                    b: p.B,
                    c: p.C,
                    angles: [p.AB.angle(), q],
                    rates: [v.AB.omega, rate],
                    // The coupler's frame begins at its other end here.
                    sines: [-sine(p.AB, p.CB), -sine(p.CB, p.DC)],
                    energy: energy.kinetic + energy.potential,
                })
            }
        }
    }

    /// The weighted difference of both coordinates' distances from their dead points: positive where the
    /// coordinate is to be changed.
    fn strain(&self, state: [f64; 2]) -> f64 {
        // Where there is no pose there is no event: the right side has said so already.
        self.pose(state).map_or(f64::NAN, |pose| {
            let [left, right] = pose.sines.map(f64::abs);
            match self {
                Self::ByLeft(_) => left - BETTER * right,
                Self::ByRight(_) => right - BETTER * left,
            }
        })
    }

    /// The same pose and velocity by the other coordinate.
    fn changed(&self, state: [f64; 2]) -> Result<(Self, [f64; 2]), SolveError> {
        let Pose { b, c, angles, rates, .. } = self.pose(state)?;
        let [a, d] = [Point { x: 0.0, y: 0.0 }, Point { x: 1.0, y: 0.0 }];
        // A mode is the side of the inner joint, seen from the first outer joint to the second.
        let side = |from: Point<f64>, to: Point<f64>, inner: Point<f64>| {
            if (to - from).cross(inner - from) > 0.0 { Side::Left } else { Side::Right }
        };
        Ok(match self {
            Self::ByLeft(_) => {
                let machine = ByRight { elbow: side(c, a, b), ..ByRight::new() };
                (Self::ByRight(machine), [angles[1], rates[1]])
            }
            Self::ByRight(_) => {
                let machine = ByLeft { elbow: side(b, d, c), ..ByLeft::new() };
                (Self::ByLeft(machine), [angles[0], rates[0]])
            }
        })
    }
}

/// A motion in pieces, each by one coordinate.
struct Piece {
    machine: Machine,
    times: Vec<f64>,
    states: Vec<[f64; 2]>,
}

fn swung(tolerance: f64) -> Result<Vec<Piece>, Stopped> {
    let (mut machine, mut state) = (Machine::ByLeft(ByLeft::new()), START);
    let (mut time, mut pieces) = (0.0, Vec::new());
    while time < SECONDS {
        let rates = |_: f64, state| machine.state_rates(state);
        let motion = Motion::new([time, SECONDS], state, rates).tolerance(tolerance);
        let run = motion.until(APART, |_, state| machine.strain(state))?;
        let last = run.last();
        pieces.push(Piece { machine, times: run.times, states: run.states });
        if !run.is_interrupted {
            break;
        }
        time = last.0;
        (machine, state) =
            machine.changed(last.1).map_err(|error| Stopped::Refused(time, error))?;
    }
    Ok(pieces)
}

/// Times and poses of all pieces.
fn poses(pieces: &[Piece]) -> Result<Vec<(f64, Pose)>, SolveError> {
    let of_piece = |piece: &Piece| -> Result<Vec<(f64, Pose)>, SolveError> {
        let both = piece.times.iter().zip(&piece.states);
        both.map(|(time, state)| Ok((*time, piece.machine.pose(*state)?))).collect()
    };
    Ok(pieces.iter().map(of_piece).collect::<Result<Vec<_>, _>>()?.concat())
}

/// The left rocker's angle where coupler and right rocker are in line, in rad: |BD| = 1.2 m, by the law
/// of cosines.
fn dead_point() -> f64 {
    ((0.6_f64.powi(2) + 1.0 - 1.2_f64.powi(2)) / 1.2).acos()
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    println!("Towards a dead point of the left rocker, at {:.6}°:\n", dead_point().to_degrees());
    println!("{:>16} {:>16} {:>14}", "short of it", "seeming inertia", "acceleration");
    for power in 1..=5 {
        let short = 10.0_f64.powi(-2 * power);
        let machine = ByLeft::new();
        let mass = machine.equations_of_motion(short - dead_point(), 0.0)?.mass[0][0];
        let acceleration = machine.forward_dynamics(short - dead_point(), 1.0, 0.0)?;
        println!("{short:12.0e} rad {mass:10.3e} kg·m² {acceleration:8.1e} rad/s²");
    }
    match ByLeft::new().forward_dynamics(-dead_point(), 1.0, 0.0) {
        Ok(_) => println!("{:>16} found one rounding off", "at it"),
        Err(error) => println!("{:>16} {error}", "at it"),
    }
    let pieces = swung(1e-13)?;
    let poses = poses(&pieces)?;
    println!("\nLet go at {:.1}°, it changes its coordinate at", START[0].to_degrees());
    for piece in &pieces[1..] {
        let pose = piece.machine.pose(piece.states[0])?;
        let name = if matches!(piece.machine, Machine::ByLeft(_)) { "left" } else { "right" };
        let [left, right] = pose.angles.map(f64::to_degrees);
        println!("{:9.5} s to the {name:>5} one: {left:9.3}° {right:9.3}°", piece.times[0]);
    }
    let start = poses[0].1.energy;
    let off = poses.iter().map(|(_, pose)| (pose.energy / start - 1.0).abs()).fold(0.0, f64::max);
    println!("\nenergy off by at most {off:.1e} of itself");
    pictures::draw(&pieces, &poses);
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_dead_point_of_the_coordinate_is_singular() {
        let machine = ByLeft::new();
        // B at 1.2 m from D: the input is rounded, and so is the pose; within the limit rule of four
        // units in the last place some double next to the angle is on it.
        let near = (-4..=4).map(|step| -dead_point() + f64::from(step) * f64::EPSILON);
        let found: Vec<_> = near.map(|phi| machine.forward_dynamics(phi, 1.0, 0.0)).collect();
        let singular = Err(SolveError::Singular { group: "BC, DC" });
        assert!(found.contains(&singular), "{found:?}");
        assert!(found.iter().flatten().all(|value| value.is_finite()));
        // As the square of the coefficients: the coefficient grows as the root of the distance.
        let mass =
            |short: f64| machine.equations_of_motion(short - dead_point(), 0.0).unwrap().mass[0][0];
        let ratio = mass(1e-8) / mass(1e-6);
        assert!((ratio - 100.0).abs() < 1.0, "{ratio}");
    }

    #[test]
    fn without_a_change_the_motion_stops() {
        let machine = ByLeft::new();
        let rates = |_: f64, state| machine.state_rates(state, 0.0);
        let stopped = Motion::new([0.0, SECONDS], START, rates).ended();
        assert!(stopped.is_err(), "{stopped:?}");
    }

    /// With changes it goes through many dead points of both rockers, and is the motion of three bars
    /// with multipliers in their joints.
    #[test]
    fn with_changes_it_is_the_motion_of_the_bars() {
        let pieces = swung(1e-13).unwrap();
        assert!(pieces.len() > 20, "{}", pieces.len());
        let poses = poses(&pieces).unwrap();
        let start = poses[0].1;
        for (time, pose) in &poses {
            let off = (pose.energy - start.energy).abs();
            assert!(off < 1e-10 * start.energy.abs(), "{time}: {off:e}");
        }
        let (time, last) = *poses.last().unwrap();
        assert!((time - SECONDS).abs() < 1e-12);
        let [b, c] = reference::ends(&start, SECONDS);
        let apart = (last.b.x - b[0]).hypot(last.b.y - b[1]);
        let apart = apart.max((last.c.x - c[0]).hypot(last.c.y - c[1]));
        assert!(apart < 1e-8, "{apart:e}");
    }

    #[test]
    fn changes_come_when_they_are_due() {
        let (exact, rough) = (swung(1e-13).unwrap(), swung(1e-9).unwrap());
        assert_eq!(exact.len(), rough.len());
        for (exact, rough) in exact.iter().zip(&rough).skip(1) {
            let sines = exact.machine.pose(exact.states[0]).unwrap().sines.map(f64::abs);
            let ratio = (sines[0] / sines[1]).max(sines[1] / sines[0]);
            assert!((ratio - BETTER).abs() < 1e-10, "{sines:?}");
            assert!((exact.times[0] - rough.times[0]).abs() < 1e-5, "{}", rough.times[0]);
        }
    }

    #[test]
    fn a_change_changes_nothing() {
        for pair in swung(1e-10).unwrap().windows(2) {
            let before = pair[0].machine.pose(*pair[0].states.last().unwrap()).unwrap();
            let after = pair[1].machine.pose(pair[1].states[0]).unwrap();
            let moved = (before.b.x - after.b.x).hypot(before.b.y - after.b.y);
            assert!(moved < 1e-14 && (before.energy - after.energy).abs() < 1e-13, "{moved:e}");
            assert!((before.rates[0] - after.rates[0]).abs() < 1e-13);
            assert!((before.rates[1] - after.rates[1]).abs() < 1e-13);
        }
    }
}
