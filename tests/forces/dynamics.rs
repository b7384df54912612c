//! From forces to motion: equations that agree with the efforts they come from, closed forms, and
//! energy.

use linkage_core::num_dual::DualSVec;
use linkage_core::{SolveError, differentiate, differentiate_twice};
use linkage_tests::mechanisms::forces::*;

/// Whether a drive comes back within 64 ε of the sum of its terms' sizes.
#[track_caller]
fn returns(found: f64, given: f64, terms: &[f64]) {
    let size: f64 = terms.iter().map(|term| term.abs()).sum();
    assert!((found - given).abs() <= 64.0 * f64::EPSILON * size, "{found} {given} of {size}");
}

#[test]
fn forces_at_the_accelerations_are_the_drives() {
    let four_bar = HeavyFourBar::new();
    let shaken = ShakenFourBar::new();
    for step in 0..60 {
        let (q, dq, drive) = (0.11 * f64::from(step), 4.0 - 0.1 * f64::from(step), 0.3);
        let e = four_bar.equations_of_motion(q, dq).unwrap();
        let ddq = four_bar.forward_dynamics(q, dq, drive).unwrap();
        let f = four_bar.forces(q, dq, ddq).unwrap();
        returns(f.theta.drive, drive, &[e.mass[0][0] * ddq, e.force[0], drive, 1.0]);
        let e = shaken.equations_of_motion(q, dq).unwrap();
        let ddq = shaken.forward_dynamics(q, dq, drive).unwrap();
        let f = shaken.forces(q, dq, ddq).unwrap();
        returns(f.theta.drive, drive, &[e.mass[0][0] * ddq, e.force[0], drive, 1.0]);
    }
    let press = Press::new();
    let loads = [300.0, -2.0];
    for step in 0..60 {
        let (q, dq) = (0.11 * f64::from(step), 2.0);
        let ddq = press.forward_dynamics(q, dq, 5.0, loads).unwrap();
        let e = press.equations_of_motion(q, dq, loads).unwrap();
        let f = press.forces(q, dq, ddq, loads).unwrap();
        returns(f.theta.drive, 5.0, &[e.mass[0][0] * ddq, e.force[0], 5.0, 100.0]);
        assert_eq!(press.state_rates([q, dq], 5.0, loads).unwrap(), [dq, ddq]);
    }
    let lift = SprungLift::new();
    for step in 0..20 {
        let x = 0.05 * f64::from(step);
        let (q, dq, drive) = ([0.7 + 0.3 * x, 0.4 - x], [0.3 - x, 1.0 + x], [400.0, -30.0 * x]);
        let ddq = lift.forward_dynamics(q, dq, drive).unwrap();
        let e = lift.equations_of_motion(q, dq).unwrap();
        let f = lift.forces(q, dq, ddq).unwrap();
        for (row, found) in [f.lift.drive, f.tilt.drive].into_iter().enumerate() {
            let terms = [e.mass[row][0] * ddq[0], e.mass[row][1] * ddq[1], e.force[row], 1e3];
            returns(found, drive[row], &terms);
        }
        assert_eq!(e.mass[0][1], e.mass[1][0]);
        let rates = lift.state_rates([q[0], q[1], dq[0], dq[1]], drive).unwrap();
        assert_eq!(rates, [dq[0], dq[1], ddq[0], ddq[1]]);
    }
}

#[test]
fn the_mass_matrix_is_the_hessian_of_the_kinetic_energy() {
    let (lift, q) = (SprungLift::new(), [0.8, 0.3]);
    let mass = lift.equations_of_motion(q, [0.1, 0.2]).unwrap().mass;
    let hessian = differentiate_twice([0.1, 0.2], |dq| {
        Ok(lift.lift().energy(q.map(|q| q.into()), dq)?.kinetic)
    })
    .unwrap()
    .hessian;
    for row in 0..2 {
        for column in 0..2 {
            let apart = mass[row][column] - hessian[(row, column)];
            assert!(apart.abs() < 1e-13 * mass[0][0].max(mass[1][1]), "{row} {column}: {apart}");
        }
    }
}

#[test]
fn parallelograms_fall_like_one_pendulum() {
    let machine = TwoParallelograms::new();
    for step in 0..60 {
        let (q, dq) = (0.2 * f64::from(step), 1.5);
        let expected = -7.0 / 6.0 * 9.81 * q.cos();
        let found = machine.forward_dynamics(q, dq, 0.0).unwrap();
        assert!((found - expected).abs() < 1e-14, "{q}: {found} {expected}");
    }
    let cost = TwoParallelograms::COST.forward_dynamics;
    assert!(cost.total() <= 9 && cost.roots == 0 && cost.sines == 1, "{cost}");
}

#[test]
fn natural_frequencies_are_those_of_the_linearised_motion() {
    let (k, m) = (15.0_f64, 1.6632_f64);
    let machine = TwoMasses::new();
    let slope = differentiate([0.0, 0.0], |q: [DualSVec<f64, 2>; 2]| {
        let zero = DualSVec::from_re(0.0);
        machine.lift().forward_dynamics(q, [zero; 2], [zero; 2], zero)
    })
    .unwrap();
    let (trace, det) = (
        slope[(0, 0)] + slope[(1, 1)],
        slope[(0, 0)] * slope[(1, 1)] - slope[(0, 1)] * slope[(1, 0)],
    );
    let root = (trace * trace / 4.0 - det).sqrt();
    for (square, sign) in [(-trace / 2.0 - root, -1.0), (-trace / 2.0 + root, 1.0)] {
        let expected = ((3.0 + sign * 5.0_f64.sqrt()) * k / (2.0 * m)).sqrt();
        assert!((square.sqrt() - expected).abs() < 1e-14 * expected, "{square} {expected}");
    }
    // A crane's sway, its trolley free: ω² = g (M + m)/(M l) for a point; here with the rope's inertia.
    let crane = Crane::new();
    let slope = differentiate([0.0], |[sway]: [DualSVec<f64, 1>; 1]| {
        let zero = DualSVec::from_re(0.0);
        crane.lift().forward_dynamics([zero, sway], [zero; 2], [zero; 2])
    })
    .unwrap();
    let (trolley, load, length, inertia) = (5.0_f64, 3.0_f64, 2.0_f64, 0.1);
    let turning = load * length * length + inertia - (load * length).powi(2) / (trolley + load);
    let expected = -load * 9.81 * length / turning;
    assert!((slope[(1, 0)] - expected).abs() < 1e-14 * expected.abs(), "{}", slope[(1, 0)]);
}

#[test]
fn what_swings_keeps_its_energy() {
    // Classical Runge–Kutta steps of a fifth-order local error; the energy follows.
    let four_bar = ShakenFourBar::new();
    let total = |[q, dq]: [f64; 2]| {
        let e = four_bar.energy(q, dq).unwrap();
        e.kinetic + e.potential
    };
    let rates = |x: [f64; 2]| four_bar.state_rates(x, 0.0).unwrap();
    let mut state = [1.0, 14.0];
    let (start, h) = (total(state), 1e-3);
    for _ in 0..2000 {
        let along = |x: [f64; 2], k: [f64; 2], h: f64| [x[0] + h * k[0], x[1] + h * k[1]];
        let k1 = rates(state);
        let k2 = rates(along(state, k1, h / 2.0));
        let k3 = rates(along(state, k2, h / 2.0));
        let k4 = rates(along(state, k3, h));
        for i in 0..2 {
            state[i] += h / 6.0 * (k1[i] + 2.0 * (k2[i] + k3[i]) + k4[i]);
        }
    }
    assert!((total(state) - start).abs() < 1e-6 * start.abs(), "{} {start}", total(state));
}

#[test]
fn what_cannot_be_driven_is_refused() {
    let refused = HeavyFourBar::new().forward_dynamics(1.0, f64::NAN, 0.0);
    assert!(matches!(refused, Err(SolveError::NotFinite { .. })), "{refused:?}");
    let refused = HeavyFourBar::new().forward_dynamics(1.0, 0.0, f64::INFINITY);
    assert_eq!(refused, Err(SolveError::NotFinite { name: "drive of theta" }));
    let press = Press { counterweight: 0.0, ..Press::new() };
    assert!(press.forward_dynamics(0.3, 1.0, 0.0, [0.0; 2]).is_ok());
    let free = Oscillator { c: 2.0, ..Oscillator::new() };
    let found = free.forward_dynamics(0.5, 0.25, 1.0, 3.0).unwrap();
    assert!((found - (1.0 + 3.0 - 7.5 - 0.5) / 1.6632).abs() < 1e-15, "{found}");
    let narrow = Oscillator::<f32>::default().forward_dynamics(0.5, 0.0, 0.0, 0.0).unwrap();
    assert!((narrow + 7.5 / 1.6632).abs() < 1e-6);
    assert!(HeavyFourBar::COST.forward_dynamics.total() > 0);
}
