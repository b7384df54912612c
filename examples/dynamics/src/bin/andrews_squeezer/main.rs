//! Andrews' squeezer: seven bodies that one motor drives at rest to 11,000 turns a minute in 0.03 s.
//!
//! The Test Set for Initial Value Problem Solvers has it as 27 equations of index 3. Declared, it is a
//! crank and three dyads, so two states. The same motion is integrated as the test set's index-1 form
//! beside it, 14 states and a 13 × 13 system to solve at each evaluation, by the same integrator.

mod index_one;
mod pictures;
mod truth;

use std::f64::consts::{FRAC_PI_2, PI};
use std::time::Instant;

use dynamics::{Motion, Run, Stopped, show};
use linkage_core::{Direction, SolveError, mechanism};

mechanism! {
    /// Andrews' squeezing mechanism.
    pub struct Squeezer {
        input beta: angle;

        ground O(0, 0), A(-69.34mm, -2.27mm), B(-36.35mm, 32.73mm), C(14mm, 72mm);
        crank K1(O) -> Q        { length: 7mm, angle: beta }
        rrr   K2(Q), K3(B) -> P { lengths: (28mm, 35mm), mode: left }
        rrr   K4(P), K5(A) -> E { lengths: (20mm, 40mm), mode: right }
        rrr   K6(P), K7(A) -> F { lengths: (20mm, 40mm), mode: left }
        /// Where the spring holds K3.
        point D on K3 at (18mm, 20mm);

        mass 43.25g on K1 at (0.92mm, 0)         inertia 2.194e-6;
        mass 3.65g  on K2 at (11.5mm, 0)         inertia 4.41e-7;
        mass 23.73g on K3 at (10.43mm, 18.74mm)  inertia 5.255e-6;
        mass 7.06g  on K4 at (14.21mm, 0)        inertia 5.667e-7;
        mass 70.5g  on K5 at (23.08mm, 9.16mm)   inertia 1.169e-5;
        mass 7.06g  on K6 at (14.21mm, 0)        inertia 5.667e-7;
        mass 54.98g on K7 at (12.28mm, 4.49mm)   inertia 1.912e-5;
        spring between D and C { stiffness: 4530(N/m), free_length: 77.85mm }

        output K2, K3, K4, K5, K6, K7, K3.P, K4.P, K6.P, beta.drive, energy;
    }
}

/// The motor's torque, in N·m.
const TORQUE: f64 = 33e-3;
/// In s.
const END: f64 = 0.03;
const TOLERANCES: [f64; 11] =
    [1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13];
/// Times of a run are the best of so many.
const REPETITIONS: u32 = 25;

/// The test set's 27 numbers, in its order: angles, their rates and accelerations, and the forces on
/// K3, K4 and K6 at P.
fn test_set_row([beta, rate]: [f64; 2]) -> Result<[f64; 27], SolveError> {
    let squeezer = Squeezer::new();
    let second = squeezer.forward_dynamics(beta, rate, TORQUE)?;
    let m = squeezer.motion(beta, rate, second)?;
    let forces = squeezer.forces(beta, rate, second)?;
    let (p, v, a) = (m.position, m.velocity, m.acceleration);
    // The test set counts some angles from the other end of the bar, and some from its normal.
    let turned = |link: Direction<f64>, by: f64| (link.angle() + by + PI).rem_euclid(2.0 * PI) - PI;
    let [delta, epsilon] = [turned(p.K5, 0.0), turned(p.K7, FRAC_PI_2)];
    let angles = [
        beta,
        turned(p.K2, PI) - beta,
        turned(p.K3, FRAC_PI_2),
        turned(p.K4, -FRAC_PI_2) - delta,
        delta,
        turned(p.K6, PI) - epsilon,
        epsilon,
    ];
    let relative = |own: f64, [k2, k3, k4, k5, k6, k7]: [f64; 6]| {
        [own, k2 - own, k3, k4 - k5, k5, k6 - k7, k7]
    };
    let links = [v.K2, v.K3, v.K4, v.K5, v.K6, v.K7];
    let rates = relative(rate, links.map(|link| link.omega));
    let links = [a.K2, a.K3, a.K4, a.K5, a.K6, a.K7];
    let seconds = relative(second, links.map(|link| link.alpha));
    let pins = [forces.K3.P, forces.K4.P, forces.K6.P];
    let mut row = [0.0; 27];
    let all = angles.into_iter().chain(rates).chain(seconds);
    let all = all.chain(pins.into_iter().flat_map(|force| [force.x, force.y]));
    row.iter_mut().zip(all).for_each(|(to, value)| *to = value);
    Ok(row)
}

/// Right digits of angles, rates, accelerations and reactions: of the worst of each, the test set's
/// "significant correct digits".
fn digits(row: [f64; 27]) -> [f64; 4] {
    [0..7, 7..14, 14..21, 21..27].map(|part| {
        let both = row[part.clone()].iter().zip(&truth::ROW[part]);
        -both.map(|(found, exact)| (found / exact - 1.0).abs()).fold(1e-17, f64::max).log10()
    })
}

fn two_states(tolerance: f64) -> Result<Run<2>, Stopped> {
    let squeezer = Squeezer::new();
    let rates = |_: f64, state| squeezer.state_rates(state, TORQUE);
    Motion::new([0.0, END], [truth::START[0], 0.0], rates).tolerance(tolerance).ended()
}

/// The error in the energy balance of motion, spring and motor, over the energy at the start.
fn lost(run: &Run<2>) -> Result<f64, SolveError> {
    let squeezer = Squeezer::new();
    let total = |beta, rate| {
        let energy = squeezer.energy(beta, rate)?;
        Ok(energy.kinetic + energy.potential - TORQUE * beta)
    };
    let (_, [beta, rate]) = run.last();
    let start = total(truth::START[0], 0.0)?;
    Ok((total(beta, rate)? - start) / start)
}

/// One run of one form.
struct Measured {
    evaluations: usize,
    /// In µs.
    time: f64,
    digits: [f64; 4],
    /// The largest gap of the loops, in m.
    open: f64,
}

/// The best time of several runs, in µs.
fn timed<T>(run: impl Fn() -> T) -> (T, f64) {
    let mut best = f64::INFINITY;
    let mut last = None;
    for _ in 0..REPETITIONS {
        let start = Instant::now();
        last = Some(std::hint::black_box(run()));
        best = best.min(start.elapsed().as_secs_f64() * 1e6);
    }
    (last.expect("it ran"), best)
}

fn measured(tolerance: f64) -> Result<[Measured; 2], Stopped> {
    let refused = |error| Stopped::Refused(END, error);
    let (run, time) = timed(|| two_states(tolerance));
    let run = run?;
    let row = test_set_row(run.last().1).map_err(refused)?;
    let own = Measured {
        evaluations: run.evaluations,
        time,
        digits: digits(row),
        open: index_one::open(row[..7].try_into().expect("seven angles")),
    };
    let (run, time) = timed(|| index_one::run(tolerance));
    let run = run?;
    let state = run.last().1;
    let row = index_one::test_set_row(state).map_err(refused)?;
    let other = Measured {
        evaluations: run.evaluations,
        time,
        digits: digits(row),
        open: index_one::open(state[..7].try_into().expect("seven angles")),
    };
    Ok([own, other])
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    println!(
        "Andrews' squeezer after 0.03 s: right digits of 7 angles, rates, accelerations and of"
    );
    println!("6 reactions, how far the loops are open, and what it took\n");
    println!("{:>10} {:>34} {:>14}", "", "digits", "open by m");
    let mut points = Vec::new();
    for tolerance in TOLERANCES {
        let both = measured(tolerance)?;
        for (name, run) in ["2 states", "index 1"].into_iter().zip(&both) {
            let [angles, rates, seconds, reactions] = run.digits;
            println!(
                "{tolerance:8.0e} {name} {angles:8.2} {rates:7.2} {seconds:7.2} {reactions:7.2} \
                 {:9.1e} {:6} evaluations {:8.0} µs",
                run.open, run.evaluations, run.time
            );
        }
        points.push(both);
    }
    let run = two_states(TOLERANCES[10])?;
    println!("\nT + V − work, over the energy at the start: {:.1e}", lost(&run)?);
    println!("an acceleration takes {}", Squeezer::COST.forward_dynamics);
    let squeezer = Squeezer::new();
    let rates = |_: f64, state| squeezer.state_rates(state, TORQUE);
    let run = Motion::new([0.0, END], [truth::START[0], 0.0], rates).sampled(300)?;
    pictures::draw(&points, &run);
    let film = squeezer.film(run.states.iter().step_by(2).map(|[beta, _]| *beta));
    show("andrews_squeezer_film", &film.trace("P").trace("E").trace("F").seconds(9.0))?;
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// At rest, against the initial values that the test set publishes, to all their digits: angles of
    /// the modes that the declaration chose, accelerations, and the reactions at the first dyad.
    #[test]
    fn the_start_is_the_test_sets() {
        let row = test_set_row([truth::START[0], 0.0]).unwrap();
        for (found, published) in row[..7].iter().zip(truth::START) {
            assert!((found - published).abs() < 1e-14, "{found} {published}");
        }
        let published = [
            (row[14], 14_222.443_919_954_114),
            (row[15], -10_666.832_939_965_586),
            (row[21], 98.566_870_396_241_09),
            (row[22], -6.122_688_344_255_663),
        ];
        for (found, published) in published {
            assert!((found / published - 1.0).abs() < 1e-12, "{found} {published}");
        }
    }

    #[test]
    fn two_states_have_the_asked_digits() {
        let run = two_states(1e-13).unwrap();
        let row = test_set_row(run.last().1).unwrap();
        let [angles, rates, seconds, reactions] = digits(row);
        assert!(angles >= 11.5, "{angles}");
        assert!(rates >= 9.5 && seconds >= 9.5, "{rates} {seconds}");
        assert!(reactions >= 10.5, "{reactions}");
        assert!(run.evaluations <= 4200, "{}", run.evaluations);
        assert!(lost(&run).unwrap().abs() <= 1e-12, "{:e}", lost(&run).unwrap());
        // Positions are solved: the loops of any state are closed to rounding.
        let open = index_one::open(row[..7].try_into().unwrap());
        assert!(open < 1e-16, "{open:e}");
    }

    /// The other form, by other formulas, ends at the same numbers, and its loops open.
    #[test]
    fn the_index_one_form_agrees() {
        let run = index_one::run(1e-11).unwrap();
        let row = index_one::test_set_row(run.last().1).unwrap();
        let [angles, ..] = digits(row);
        assert!(angles > 8.0, "{angles}");
        let state: [f64; 7] = index_one::run(1e-8).unwrap().last().1[..7].try_into().unwrap();
        assert!(index_one::open(state) > 1e-12, "{:e}", index_one::open(state));
    }
}
