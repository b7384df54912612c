//! Natural frequencies from the exact derivatives of the accelerations.

use linkage_core::differentiate;
use linkage_core::num_dual::DualSVec;
use linkage_tests::mechanisms::dynamics::SwingingFourBar;
use linkage_tests::mechanisms::forces::{Crane, TwoMasses};

#[test]
fn two_masses_between_springs() {
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
}

#[test]
fn a_crane_sways_faster_than_its_rope_alone() {
    // M₀₀ = M + m, M₀₁ = m l, M₁₁ = m l² + J: ω² = m g l/(M₁₁ − M₀₁²/M₀₀), the trolley being free.
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

/// The numbers of `tables/swinging_four_bar.txt`, which knows nothing of the formulas here.
fn table() -> [f64; 4] {
    let text = include_str!("../../src/tables/swinging_four_bar.txt");
    let numbers = text.lines().filter(|line| !line.starts_with('#'));
    let numbers: Vec<f64> = numbers.map(|line| line.parse().expect("a number")).collect();
    numbers.try_into().expect("four numbers")
}

#[test]
fn a_four_bar_on_a_torsion_spring_swings_as_in_50_digits() {
    let [rest, square, at_rest, at_three] = table();
    let machine = SwingingFourBar::new();
    // Fifty operations, and at 1.25 rad the terms are of the size of the sum.
    let found = machine.forward_dynamics(1.25, 0.0, 0.0).unwrap();
    assert!((found - at_rest).abs() < 1e-14 * at_rest.abs(), "{found} {at_rest}");
    let found = machine.forward_dynamics(1.25, 3.0, 0.0).unwrap();
    assert!((found - at_three).abs() < 1e-14 * at_three.abs(), "{found} {at_three}");
    let slope = |q: f64, dq: f64| {
        differentiate([q, dq], |[q, dq]: [DualSVec<f64, 2>; 2]| {
            Ok([machine.lift().forward_dynamics(q, dq, DualSVec::from_re(0.0))?])
        })
        .unwrap()
    };
    // Where it rests, by that slope.
    let mut found = 0.3;
    for _ in 0..6 {
        found -= machine.forward_dynamics(found, 0.0, 0.0).unwrap() / slope(found, 0.0)[(0, 0)];
    }
    // Weight and spring are some ten times the slope there.
    assert!((found - rest).abs() < 1e-15, "{found} {rest}");
    // The rest is rounded, which the third derivative enlarges some ten times.
    let linear = slope(rest, 0.0);
    assert!((linear[(0, 0)] + square).abs() < 1e-13 * square, "{} {square}", linear[(0, 0)]);
    assert_eq!(linear[(0, 1)], 0.0, "a rate at rest changes nothing without a damper");
    let damped = SwingingFourBar { c: 0.25, ..machine };
    let damping = differentiate([0.0], |[dq]: [DualSVec<f64, 1>; 1]| {
        let rest = DualSVec::from_re(rest);
        Ok([damped.lift().forward_dynamics(rest, dq, DualSVec::from_re(0.0))?])
    })
    .unwrap()[(0, 0)];
    let (k, mass) = (
        machine.velocity(rest, 1.0).unwrap().DC.omega,
        machine.equations_of_motion(rest, 0.0).unwrap().mass[0][0],
    );
    assert!((damping + 0.25 * k * k / mass).abs() < 1e-13 * damping.abs(), "{damping}");
}
