//! Machines that were seen to leave their assembly, to come apart or to keep too many states in others' solvers.
//! Each is named by where it was seen; what is measured here is ours.

use std::f64::consts::{PI, TAU};

use linkage_core::{Point, Side, Tracker, mechanism};
use linkage_tests::integration::step;
use linkage_tests::mechanisms::dynamics::leg_opening;
use linkage_tests::random::{Random, cases};

mechanism! {
    /// Articraft, issue 127 of articraftresearch/Articraft (August 2026), "the loop solver returns the mirror
    /// assembly branch over part of a crank revolution, silently": ground 1.0, crank 0.5, coupler 1.2, rocker 0.8.
    pub struct Articraft {
        input theta: angle;
        param branch: mode = left;
        ground A(0, 0), D(1m, 0);
        crank AB(A) -> B        { length: 0.5m, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (1.2m, 0.8m), mode: branch }
        output B, C;
    }
}

/// The statistic: the sign of (D − B) × (C − B).
fn side(p: &ArticraftPosition<f64>) -> Side {
    let d = Point { x: 1.0, y: 0.0 };
    if (d - p.B).cross(p.C - p.B) > 0.0 { Side::Left } else { Side::Right }
}

/// A hundred thousand poses of each kind in `.ci/nightly`, of which an ordinary run takes every fifth.
#[test]
fn articrafts_bars_stay_on_their_branch_in_every_order_of_poses() {
    for branch in [Side::Left, Side::Right] {
        let (solver, mut random) = (Articraft { branch, ..Articraft::new() }, Random::new(127));
        let mut tracker = Tracker::new(solver);
        let poses = cases(20_000, 100_000) as u32;
        for k in 0..poses {
            let part = f64::from(k) / f64::from(poses);
            // In order round the turn, and wherever chance leads.
            for theta in [TAU * part, random.anywhere(-PI, PI)] {
                let p = solver.position(theta).expect("the crank turns");
                assert_eq!(side(&p), branch, "{theta}");
                let d = Point { x: 1.0, y: 0.0 };
                let opening = (p.B.distance(p.C) - 1.2).abs() + (p.C.distance(d) - 0.8).abs();
                // Two distances of coordinates below 2, each with four roundings.
                assert!(opening < 8.0 * f64::EPSILON, "{theta}: {opening}");
            }
            // A motion that is followed, forwards and back.
            let back_and_forth = 20.0 * (10.0 * part).sin();
            let p = tracker.position(back_and_forth).expect("the crank turns");
            assert_eq!(side(&p), branch, "{back_and_forth}");
        }
    }
}

/// The loop closed by Newton's method from a start, as a solver of constraints does: angles of coupler and rocker.
fn newton(theta: f64, mut angles: [f64; 2]) -> [f64; 2] {
    for _ in 0..50 {
        let [(sb, cb), (sr, cr)] = angles.map(f64::sin_cos);
        let (st, ct) = theta.sin_cos();
        let left = [0.5 * ct + 1.2 * cb - 1.0 - 0.8 * cr, 0.5 * st + 1.2 * sb - 0.8 * sr];
        let determinant = 1.2 * 0.8 * (sb * cr - cb * sr);
        angles[0] -= (-0.8 * cr * left[0] - 0.8 * sr * left[1]) / determinant;
        angles[1] -= (-1.2 * cb * left[0] - 1.2 * sb * left[1]) / determinant;
    }
    angles
}

#[test]
fn the_statistic_sees_a_solver_that_changes_the_branch() {
    // The negative control: Newton's method from the pose at rest, at 0, where it is on the left.
    let rest = Articraft::new().position(0.0).expect("the crank turns");
    let d = Point { x: 1.0, y: 0.0 };
    let angle = |v: Point| v.y.atan2(v.x);
    let start = [angle(rest.C - rest.B), angle(rest.C - d)];
    let (mut mirrored, mut closed) = (0, 0);
    for k in 0..4000 {
        let theta = TAU * f64::from(k) / 4000.0 - PI;
        let [coupler, rocker] = newton(theta, start);
        let b = Point { x: 0.5 * theta.cos(), y: 0.5 * theta.sin() };
        let c = b + Point { x: 1.2 * coupler.cos(), y: 1.2 * coupler.sin() };
        let by_rocker = d + Point { x: 0.8 * rocker.cos(), y: 0.8 * rocker.sin() };
        if c.distance(by_rocker) < 1e-9 {
            closed += 1;
            mirrored += u32::from(side(&ArticraftPosition { B: b, C: c }) == Side::Right);
        }
    }
    println!("Newton: {closed} of 4000 poses closed, {mirrored} of them mirrored");
    assert!(closed > 3500 && mirrored > 100, "{closed} {mirrored}");
}

mechanism! {
    /// Multibody.jl, pull request 34 of JuliaComputing/Multibody.jl (October 2023): four bars of 1 m, closed in
    /// the plane. Its author found two states in OpenModelica, "which is the correct result", and thirteen and a
    /// singular start in his own. The masses are those of the open chain beside it, 1, 3 and 1 kg.
    pub struct Multibody {
        input q: angle;
        ground A(0, 0), D(-1m, 0);
        crank AB(A) -> B        { length: 1m, angle: q }
        rrr   BC(B), DC(D) -> C { lengths: (1m, 1m), mode: left }
        gravity (0, -9.81);
        mass 1kg on AB uniform;
        mass 3kg on BC uniform;
        mass 1kg on DC uniform;
        output B, C, AB, DC, energy;
    }
}

#[test]
fn multibodys_four_bars_have_two_states() {
    let solver = Multibody::new();
    // The rhombus hangs from A and D, swings as a parallelogram, and no constraint is integrated.
    let mut state = [-2.3, 0.0];
    let rates = |state: [f64; 2]| solver.state_rates(state, 0.0);
    assert_eq!(rates(state).expect("it moves").len(), 2);
    // ((m₁ + m₃)/3 + m₂) q̈ = −((m₁ + m₃)/2 + m₂) g cos q.
    let closed = |q: f64| -(1.0 + 3.0) * 9.81 * q.cos() / (2.0 / 3.0 + 3.0);
    let energy = |[q, dq]: [f64; 2]| {
        let e = solver.energy(q, dq).expect("every pose is there");
        e.kinetic + e.potential
    };
    let (start, mut most, mut off, mut swing) = (energy(state), 0.0_f64, 0.0_f64, [state[0]; 2]);
    // Ten seconds, as its tutorial runs.
    for _ in 0..10_000 {
        state = step(rates, state, 1e-3).expect("every pose is there");
        let [_, acceleration] = rates(state).expect("it moves");
        off = off.max((acceleration - closed(state[0])).abs());
        let p = solver.position(state[0]).expect("every pose is there");
        let turned = (p.AB.angle() - p.DC.angle()).abs();
        assert!(turned < 16.0 * f64::EPSILON, "{state:?}: {turned}");
        let opening = (p.B.distance(p.C) - 1.0).abs();
        assert!(opening < 4.0 * f64::EPSILON, "{state:?}: {opening}");
        swing = [swing[0].min(state[0]), swing[1].max(state[0])];
        most = most.max((energy(state) - start).abs());
    }
    // Four roundings of 10 m/s²: the bodies that keep parallel cancel from the equation exactly or nearly.
    println!("acceleration {off:.1e} from the closed form, energy within {most:.1e} J");
    assert!(off < 4.0 * 10.0 * f64::EPSILON, "{off}");
    // It swings to the mirror image of its start and back; an error of the fourth order in steps of 1 ms.
    assert!((swing[1] + PI - 2.3).abs() < 1e-5 && swing[0] > -2.3 - 1e-8, "{swing:?}");
    assert!(most < 1e-10, "{most}");
}

mechanism! {
    /// A Strandbeest's leg, Jansen's: issue 480 of JuliaRobotics/RigidBodyDynamics.jl (August 2018), "the
    /// constraints still exponentially drift apart, and the mechanism basically falls apart (and starts
    /// returning NaN states) after a little more than 4 seconds". The lengths are Jansen's eleven numbers, the
    /// masses ours.
    pub struct Strandbeest {
        input theta: angle;
        ground A(0, 0), D(-38cm, -7.8cm);
        crank AB(A) -> B           { length: 15cm, angle: theta }
        rrr   upper(B), b(D) -> U  { lengths: (50cm, 41.5cm), mode: right }
        rrr   lower(B), c(D) -> L  { lengths: (61.9cm, 39.3cm), mode: left }
        point E on b at distances (40.1cm, 55.8cm) left;
        rrr   f(E), g(L) -> F      { lengths: (39.4cm, 36.7cm), mode: right }
        point foot on g at distances (49cm, 65.7cm) left;

        gravity (0, -9.81);
        inertia 0.05(kg*m^2) on AB;
        mass 0.5kg on upper uniform;
        mass 0.6kg on lower uniform;
        mass 0.4kg on U;
        mass 0.4kg on f uniform;
        mass 0.8kg on foot;
        output B, U, L, E, F, foot, energy;
    }
}

fn opening(p: &StrandbeestPosition<f64>) -> f64 {
    leg_opening([p.B, p.U, p.L, p.E, p.F, p.foot])
}

/// Forty seconds in `.ci/nightly`, and twelve in an ordinary run.
#[test]
fn a_strandbeest_is_whole_after_four_seconds_and_after_forty() {
    let leg = Strandbeest::new();
    let energy = |[q, dq]: [f64; 2]| {
        let e = leg.energy(q, dq).expect("every pose is there");
        (e.kinetic, e.kinetic + e.potential)
    };
    let mut state = [0.4, 20.0];
    let ((_, start), mut drift, mut moving) = (energy(state), 0.0_f64, 0.0_f64);
    let milliseconds = cases(12_000, 40_000);
    for count in 1..=milliseconds {
        state = step(|state| leg.state_rates(state, 0.0), state, 1e-3).expect("it moves");
        let p = leg.position(state[0]).expect("every pose is there");
        // The coordinates are below 1 m: each bar is as long as it is to eight of their last places.
        assert!(opening(&p) < 4.0 * f64::EPSILON, "after {count} ms: {}", opening(&p));
        let (kinetic, total) = energy(state);
        moving = moving.max(kinetic);
        drift = drift.max((total - start).abs());
    }
    let turns = (state[0] - 0.4) / TAU;
    println!("{turns:.0} turns, energy within {:.1e} of what moves", drift / moving);
    let least = 2.5e-3 * milliseconds as f64;
    assert!(turns.abs() > least && drift < 1e-5 * moving, "{turns} {drift}");
}
