//! Energy, shaking and the centre of mass, against each mass for itself and against each other.

use linkage_core::num_dual::DualSVec;
use linkage_core::{Record, SolveError, Status, differentiate};
use linkage_tests::mechanisms::forces::*;

type V = [f64; 2];

fn cross(a: V, b: V) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

/// A mass with its position, velocity and acceleration, its inertia, and ω and α of its link.
struct Body {
    mass: f64,
    at: [V; 3],
    inertia: f64,
    turning: [f64; 2],
}

/// Position, velocity and acceleration at coordinates of a link that turns about a moving origin, the
/// coordinates along its axis moving too.
fn placed(origin: [V; 3], unit: V, [omega, alpha]: [f64; 2], x: [f64; 3], y: f64) -> [V; 3] {
    let normal = [-unit[1], unit[0]];
    let rho = [x[0] * unit[0] + y * normal[0], x[0] * unit[1] + y * normal[1]];
    let component = |k: usize| {
        let across = [-rho[1], rho[0]][k];
        let velocity = origin[1][k] + omega * across + x[1] * unit[k];
        let coriolis = 2.0 * omega * x[1] * normal[k];
        let acceleration =
            origin[2][k] + alpha * across - omega * omega * rho[k] + coriolis + x[2] * unit[k];
        [origin[0][k] + rho[k], velocity, acceleration]
    };
    let [a, b] = [component(0), component(1)];
    [[a[0], b[0]], [a[1], b[1]], [a[2], b[2]]]
}

/// The masses of `ShakenFourBar`.
fn bodies(machine: &ShakenFourBar, [theta, rate, accel]: [f64; 3]) -> Vec<Body> {
    let m = machine.motion(theta, rate, accel).unwrap();
    let (p, v, a) = (m.position, m.velocity, m.acceleration);
    let still = |x: f64, y: f64| [[x, y], [0.0; 2], [0.0; 2]];
    let b = [[p.B.x, p.B.y], [v.B.x, v.B.y], [a.B.x, a.B.y]];
    let c = [[p.C.x, p.C.y], [v.C.x, v.C.y], [a.C.x, a.C.y]];
    let g = [[p.G.x, p.G.y], [v.G.x, v.G.y], [a.G.x, a.G.y]];
    let half = |a: [V; 3], b: [V; 3]| {
        [0, 1, 2].map(|order| [0, 1].map(|k| 0.5 * (a[order][k] + b[order][k])))
    };
    let (sin, cos) = theta.sin_cos();
    let slide = [0.1 * sin, 0.1 * cos * rate, 0.1 * (cos * accel - sin * rate * rate)];
    let turning = [v.BC.omega, a.BC.alpha];
    let loose = placed(b, [p.BC.cos, p.BC.sin], turning, slide, -0.03);
    let body = |mass, at, inertia, turning| Body { mass, at, inertia, turning };
    vec![
        body(0.05221, half(still(0.1, -0.05), b), 0.05221 * 0.0625 / 12.0, [rate, accel]),
        body(0.10421, g, 0.002, turning),
        body(0.10221, half(still(0.85, 0.0), c), 0.10221 * 0.25 / 12.0, [v.DC.omega, a.DC.alpha]),
        body(machine.extra, c, 0.0, [0.0; 2]),
        body(0.0, b, 0.001, [rate, accel]),
        body(0.02, loose, 0.0001, turning),
    ]
}

const STATES: [[f64; 3]; 6] = [
    [0.3, 7.0, -11.0],
    [1.9, -3.0, 20.0],
    [2.8, 0.0, 5.0],
    [4.1, 12.0, 0.0],
    [5.5, -6.0, -9.0],
    [6.2, 1.0, 2.0],
];

#[test]
fn energy_is_that_of_each_mass() {
    let machine = ShakenFourBar::new();
    for state in STATES {
        let (mut kinetic, mut potential) = (0.0, 0.0);
        for Body { mass, at, inertia, turning } in bodies(&machine, state) {
            let square = at[1][0] * at[1][0] + at[1][1] * at[1][1];
            kinetic += 0.5 * (mass * square + inertia * turning[0] * turning[0]);
            potential += mass * 9.81 * at[0][1];
        }
        let energy = machine.energy(state[0], state[1]).unwrap();
        // Fifty operations on some joules.
        assert!((energy.kinetic - kinetic).abs() <= 1e-14 * kinetic.max(1.0), "{state:?}");
        assert!((energy.potential - potential).abs() < 1e-14, "{state:?}");
        let plain = HeavyFourBar::new();
        let (sin, cos) = state[0].sin_cos();
        let [by_angle, by_circle] =
            [plain.energy(state[0], state[1]), plain.energy_at(cos, sin, state[1])];
        assert!((by_angle.unwrap().kinetic - by_circle.unwrap().kinetic).abs() < 1e-14);
    }
}

#[test]
fn shaking_and_the_centre_are_those_of_each_mass() {
    let machine = ShakenFourBar::new();
    for state in STATES {
        let [mut force, mut couple, mut total, mut first] =
            [[0.0; 2], [0.0; 2], [0.0; 2], [0.0; 2]];
        for Body { mass, at, inertia, turning } in bodies(&machine, state) {
            for k in 0..2 {
                force[k] -= mass * at[2][k];
                first[k] += mass * at[0][k];
            }
            couple[0] -= mass * cross(at[0], at[2]) + inertia * turning[1];
            total[0] += mass;
        }
        let f = machine.forces(state[0], state[1], state[2]).unwrap();
        let m = machine.motion(state[0], state[1], state[2]).unwrap();
        let [largest, total] = [force[0].hypot(force[1]).max(1.0), total[0]];
        let apart = [f.shaking.x - force[0], f.shaking.y - force[1], f.shaking.couple - couple[0]];
        assert!(apart.iter().all(|apart| apart.abs() < 1e-14 * largest), "{state:?} {apart:?}");
        let centre = m.position.centre_of_mass;
        assert!(
            (centre.x - first[0] / total).abs() < 1e-15
                && (centre.y - first[1] / total).abs() < 1e-15
        );
        // Newton's law for all of it.
        let centre = m.acceleration.centre_of_mass;
        assert!((total * centre.x + force[0]).abs() < 1e-14 * largest, "{state:?}");
        assert!((total * centre.y + force[1]).abs() < 1e-14 * largest, "{state:?}");
        // The ground carries the weight, the shaking and the reaction of the drive's couple.
        let weight = -9.81 * total;
        assert!((-(f.AB.A.x + f.DC.D.x) - f.shaking.x).abs() < 1e-14 * largest);
        assert!((-(f.AB.A.y + f.DC.D.y) - f.shaking.y - weight).abs() < 1e-14 * largest);
        let [on_a, on_d] = [[f.AB.A.x, f.AB.A.y], [f.DC.D.x, f.DC.D.y]];
        let moment = -cross([0.1, -0.05], on_a) - cross([0.85, 0.0], on_d) - f.AB.drive;
        let of_weight = -9.81 * first[0];
        assert!((moment - f.shaking.couple - of_weight).abs() < 1e-14 * largest, "{state:?}");
    }
    let statics = machine.statics(0.3).unwrap();
    assert_eq!(statics.shaking.into_numbers(), [0.0; 3]);
}

/// The numbers of a shaking.
trait Numbers {
    fn into_numbers(self) -> [f64; 3];
}

impl Numbers for linkage_core::Shaking<f64> {
    fn into_numbers(self) -> [f64; 3] {
        [self.x, self.y, self.couple]
    }
}

#[test]
fn energy_grows_by_what_drives_put_in() {
    let machine = ShakenFourBar::new();
    for [theta, rate, accel] in STATES {
        let growth = differentiate([0.0], |[t]| {
            let at = |x: f64| DualSVec::from_re(x);
            let (q, dq) =
                (t * (t * at(accel / 2.0) + at(rate)) + at(theta), t * at(accel) + at(rate));
            let energy = machine.lift::<DualSVec<f64, 1>>().energy(q, dq)?;
            Ok([energy.kinetic + energy.potential])
        })
        .unwrap()[(0, 0)];
        let power = machine.forces(theta, rate, accel).unwrap().theta.drive * rate;
        assert!(
            (growth - power).abs() <= 1e-13 * power.abs().max(1.0),
            "{theta}: {growth} {power}"
        );
    }
    let lift = SprungLift::new();
    for step in 0..12 {
        let x = 0.1 * f64::from(step);
        let (q, dq, ddq) = ([0.7 + 0.05 * x, 0.4 - x], [0.3 - x, 1.0 + x], [2.0 * x, -3.0]);
        let growth = differentiate([0.0], |[t]| {
            let at = |x: f64| DualSVec::from_re(x);
            let k = [0, 1];
            let q = k.map(|k| t * (t * at(ddq[k] / 2.0) + at(dq[k])) + at(q[k]));
            let dq = k.map(|k| t * at(ddq[k]) + at(dq[k]));
            let energy = lift.lift::<DualSVec<f64, 1>>().energy(q, dq)?;
            Ok([energy.kinetic + energy.potential])
        })
        .unwrap()[(0, 0)];
        let f = lift.forces(q, dq, ddq).unwrap();
        let stretching = lift.velocity(q, dq).unwrap().dT;
        let heat = 40.0 * stretching * stretching + 2.0 * dq[1] * dq[1];
        let power = f.lift.drive * dq[0] + f.tilt.drive * dq[1] - heat;
        // Some hundred operations on powers of up to some 1e3 W.
        assert!((growth - power).abs() <= 1e-13 * 1e3, "{x}: {growth} {power}");
    }
}

#[test]
fn what_is_given_together_is_labelled() {
    let rows = ["shaking.x", "shaking.y", "shaking.couple"];
    assert!(rows.iter().all(|row| SprungLift::FORCES.contains(row)), "{:?}", SprungLift::FORCES);
    assert!(SprungLift::OUTPUTS.contains(&"centre_of_mass.x"));
    assert_eq!(<SprungLiftEnergy<f64> as Record>::LABELS, ["kinetic energy", "potential energy"]);
    let refused = SprungLift::new().energy([f64::NAN, 0.0], [0.0; 2]);
    assert!(matches!(refused, Err(SolveError::NotFinite { .. })), "{refused:?}");
    assert!(ShakenFourBar::COST.energy.total() > 0);
    let narrow = SprungLift::<f32>::default().energy([0.7, 0.4], [0.3, 1.0]).unwrap();
    let wide = SprungLift::new().energy([0.7_f32.into(), 0.4_f32.into()], [0.3_f32.into(), 1.0]);
    assert!((f64::from(narrow.kinetic) - wide.unwrap().kinetic).abs() < 1e-4);
}

#[test]
fn a_sweep_gives_what_single_calls_give() {
    let press = Press::new();
    let angles: Vec<f64> = (0..37).map(|step| 0.17 * f64::from(step)).collect();
    let work: Vec<f64> =
        (0..37).map(|step| if step == 9 { f64::NAN } else { 20.0 * f64::from(step) }).collect();
    let (mut drives, mut normals, mut status) = ([0.0; 37], [0.0; 37], [Status::Solved; 37]);
    let nothing = || {
        <PressForces<&mut [f64]> as Record>::from_array(
            [(); PressForces::<f64>::LABELS.len()].map(|()| &mut [][..]),
        )
    };
    let mut out = nothing();
    out.theta.drive = &mut drives;
    out.ram.way.normal = &mut normals;
    let loads = PressLoads { work: (&work[..]).into(), friction: 2.5.into() };
    press.sweep_forces(&angles, 3.0, -1.0, loads, out, &mut status, ()).unwrap();
    for (k, &theta) in angles.iter().enumerate() {
        match press.forces(theta, 3.0, -1.0, [work[k], 2.5]) {
            Ok(f) => {
                // A sweep may fuse where a single call does not.
                assert!((drives[k] - f.theta.drive).abs() < 1e-10 && status[k] == Status::Solved);
                assert!((normals[k] - f.ram.way.normal).abs() < 1e-10, "{theta}");
            }
            Err(_) => assert_eq!(status[k], Status::NotFinite),
        }
    }
    assert_eq!(status[9], Status::NotFinite);
    let mut out = nothing();
    out.theta.drive = &mut drives;
    let loads = PressLoads { work: 1.0.into(), friction: 0.0.into() };
    press.sweep_statics(&angles, loads, out, &mut [], ()).unwrap();
    let single = press.statics(angles[5], [1.0, 0.0]).unwrap().theta.drive;
    assert!((drives[5] - single).abs() < 1e-12);
    let mut kinetic = [0.0; 37];
    let out = PressEnergy { kinetic: &mut kinetic[..], potential: &mut [] };
    press.sweep_energy(&angles, 3.0, out, &mut [], ()).unwrap();
    assert!((kinetic[7] - press.energy(angles[7], 3.0).unwrap().kinetic).abs() < 1e-12);
}

#[test]
fn a_load_may_be_called_like_a_rate() {
    let drive = Loads::new().forces(0.0, 5.0, 0.0, 20.0).unwrap().theta.drive;
    assert!((drive - 2.0).abs() < 1e-15, "{drive}");
    let drives = Rates::new().forces([0.1, 0.2], [1.0; 2], [0.0; 2], 3.0).unwrap();
    assert_eq!((drives.a.drive, drives.b.drive), (3.0, -3.0));
}
