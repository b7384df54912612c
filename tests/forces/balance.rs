//! The laws that every mechanism's forces obey: balance with weight and inertia, action and reaction.

use linkage_tests::mechanisms::forces::*;

/// A sum without rounding errors of its own to speak of: pairs are added error-free.
fn sum(terms: &[f64]) -> f64 {
    let (mut high, mut low) = (0.0_f64, 0.0_f64);
    for &term in terms {
        let total = high + term;
        let z = total - high;
        low += (high - (total - z)) + (term - z);
        high = total;
    }
    high + low
}

#[test]
fn the_ground_carries_weight_and_inertia() {
    let four_bar = HeavyFourBar::new();
    let masses = [0.05221, 0.10421, 0.10221];
    for step in 0..97 {
        let theta = 0.065 * f64::from(step);
        let (omega, alpha) = (7.0, -11.0);
        let f = four_bar.forces(theta, omega, alpha).unwrap();
        let a = four_bar.motion(theta, omega, alpha).unwrap().acceleration;
        let zero = [0.0, 0.0];
        let (b, c) = ([a.B.x, a.B.y], [a.C.x, a.C.y]);
        for axis in 0..2 {
            let weight = [0.0, -9.81][axis];
            let ground = [[f.AB.A.x, f.AB.A.y][axis], [f.DC.D.x, f.DC.D.y][axis]];
            let ends = [(zero, b), (b, c), (c, zero)];
            let mut terms: Vec<f64> = ground.to_vec();
            for (mass, (from, to)) in masses.into_iter().zip(ends) {
                terms.push(mass * weight);
                terms.extend([-0.5 * mass * from[axis], -0.5 * mass * to[axis]]);
            }
            let largest = terms.iter().map(|term| term.abs()).fold(0.0, f64::max);
            assert!(sum(&terms).abs() <= 8.0 * f64::EPSILON * largest, "{theta} {axis}");
        }
        // Two bodies exert opposite forces on each other.
        assert_eq!((f.BC.C.x, f.BC.C.y), (-f.DC.C.x, -f.DC.C.y));
        assert_eq!((f.AB.B.x, f.AB.B.y), (-f.BC.B.x, -f.BC.B.y));
    }
}

#[test]
fn statics_are_forces_at_rest() {
    let press = Press::new();
    for step in 0..40 {
        let theta = 0.1 + 0.15 * f64::from(step);
        let loads = [500.0, -3.0];
        let rest = press.statics(theta, loads).unwrap();
        let still = press.forces(theta, 0.0, 0.0, loads).unwrap();
        // Two orders of the same dozen operations on forces of up to some thousand newtons.
        let apart = [
            rest.theta.drive - still.theta.drive,
            rest.BC.B.x - still.BC.B.x,
            rest.BC.B.y - still.BC.B.y,
            rest.ram.way.normal - still.ram.way.normal,
            rest.AB.A.y - still.AB.A.y,
        ];
        assert!(apart.iter().all(|apart| apart.abs() < 1e-11), "{theta}: {apart:?}");
    }
}

#[test]
fn a_force_on_the_ram_is_worked_by_the_drive() {
    // Virtual work: the drive's torque times dθ is minus the work of what acts, and what a load of
    // one newton adds is minus the ram's kinematic coefficient.
    let press = Press::new();
    for step in 0..40 {
        let theta = 0.1 + 0.15 * f64::from(step);
        let without = press.statics(theta, [0.0, 0.0]).unwrap();
        let with = press.statics(theta, [1.0, 0.0]).unwrap();
        let coefficients = press.coefficients(theta).unwrap();
        let row = Press::OUTPUTS.iter().position(|row| *row == "C.y").unwrap();
        let expected = -coefficients[row][0];
        assert!((with.theta.drive - without.theta.drive - expected).abs() < 1e-12, "{theta}");
        let friction = press.statics(theta, [0.0, -2.5]).unwrap();
        assert!((friction.AB.drive - without.AB.drive - 2.5).abs() < 1e-12, "{theta}");
    }
}

#[test]
fn a_cylinder_carries_what_its_lift_lifts() {
    let lift = Lift::new();
    let (inputs, cargo) = ([1.1, 0.4], 800.0);
    let rest = lift.statics(inputs, cargo).unwrap();
    assert_eq!(rest.tube.push, rest.lift.drive);
    assert_eq!(rest.jib.drive, rest.tilt.drive);
    // The drives' efforts are the slope of the potential energy.
    let energy = |inputs: [f64; 2]| {
        let p = lift.position(inputs).unwrap();
        let (u, l) = (p.tube.sin, inputs[0]);
        let tube = -0.2 + 0.3 * u;
        let rod = -0.2 + (l - 0.25) * u;
        let weights = 12.0 * tube + 4.0 * rod + 20.0 * (p.C.y / 2.0);
        9.81 * (weights + 9.0 * (p.C.y + p.T.y) / 2.0) + cargo * p.T.y
    };
    let h = 1e-5;
    let slope = |k: usize| {
        let at = |sign: f64| {
            let mut inputs = inputs;
            inputs[k] += sign * h;
            energy(inputs)
        };
        (at(1.0) - at(-1.0)) / (2.0 * h)
    };
    // Central differences of some 1e3 J: h² times a third derivative, and 1e-13/h of rounding.
    assert!((rest.lift.drive - slope(0)).abs() < 1e-5, "{} {}", rest.lift.drive, slope(0));
    assert!((rest.tilt.drive - slope(1)).abs() < 1e-5, "{} {}", rest.tilt.drive, slope(1));
}
