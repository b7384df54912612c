//! The knee and ankle at rest under gravity, beside MuJoCo with the loop closed by a constraint.
//!
//! The table's numbers are MuJoCo's, written by `against_mujoco.py`, which computes them anew where MuJoCo is
//! installed. Its constraint is soft: the pin of rod and foot is open by a gap, which the table has too and which
//! the tolerances are made of.

use linkage_core::mechanism;

mechanism! {
    /// The model of `against_mujoco.py`.
    pub struct Held {
        input knee, motor: angle;
        ground K(0, 0);
        crank shank(K) -> A        { length: 400mm, angle: knee - 90deg }
        crank arm(K) -> B          { length: 50mm, angle: motor }
        rrr   rod(B), foot(A) -> H { lengths: (400mm, 60mm), mode: left }
        let ankle_angle = foot.angle - shank.angle - 90deg;

        gravity (0, -9.81);
        mass 3kg on shank at (200mm, 0) inertia 0.04(kg*m^2);
        mass 1kg on foot at (30mm, 0) inertia 0.0003(kg*m^2);
        mass 0.3kg on arm at (25mm, 0) inertia 0.0000625(kg*m^2);
        mass 0.25kg on rod at (200mm, 0) inertia 0.00333333333333333(kg*m^2);
        output ankle = ankle_angle, rod, foot, knee.drive, motor.drive, rod.H;
    }
}

/// Knee, motor, ankle, torques of both, the gap and the largest speed.
fn rows() -> Vec<[f64; 7]> {
    let lines = include_str!("mujoco.csv").lines().skip(2);
    lines
        .map(|line| {
            let numbers: Vec<f64> = line.split(',').map(|x| x.parse().expect("a number")).collect();
            numbers.try_into().expect("seven columns")
        })
        .collect()
}

#[test]
fn angles_and_torques_are_mujocos_to_the_gap_of_its_pin() {
    let (leg, rows) = (Held::new(), rows());
    assert_eq!(rows.len(), 7);
    for [knee, motor, ankle, knee_torque, motor_torque, gap, speed] in rows {
        // Nothing moves but by rounding.
        assert!(gap < 1e-9 && speed < 1e-11, "{gap} {speed}");
        let pose = leg.position([knee, motor]).expect("the rod reaches");
        // The rod stands at an angle on the foot, whose lever across it is 60 mm times the sine of that.
        let sine = (pose.rod.cos * pose.foot.sin - pose.rod.sin * pose.foot.cos).abs();
        let lever = 0.06 * sine;
        assert!(sine > 0.8, "{sine}");
        let found = (pose.ankle.angle() - ankle).abs();
        assert!(found <= gap / lever, "{found} for a gap of {gap}");
        assert!(found > gap * 1e-3, "a table of our own numbers would be nearer: {found}");

        let torques = leg.statics([knee, motor]).expect("it stands");
        let apart = [torques.knee.drive - knee_torque, torques.motor.drive - motor_torque];
        // Weights of 9.81 N and the rod's force, turned by the angle of the gap on levers below 0.4 m, and what the
        // constraint's force does on the gap itself.
        let force = 9.81 * 1.25 + torques.rod.H.x.hypot(torques.rod.H.y);
        let slack = force * (gap / lever * 0.4 + gap);
        println!(
            "knee {knee:5.2}: ankle {:.1e} of {:.1e} rad, torques {:.1e} {:.1e} of {slack:.1e} N·m",
            found,
            gap / lever,
            apart[0].abs(),
            apart[1].abs()
        );
        assert!(apart.iter().all(|apart| apart.abs() <= slack), "{apart:?} beyond {slack}");
    }
}
