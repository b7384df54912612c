//! A knee and an ankle, both driven by motors at the hip's end of the leg: one declaration each way.
//!
//! The second motor turns the foot by a four-bar along the shank, so that the ankle depends on both motors: the
//! "four-bar linkage transmission" of ros2_control, here with bars of any length. For years the efforts of that
//! one did not have the power of its rates (ros-controls/ros2_control, issue 1746 and pull request 1837).

use linkage_core::{Side, mechanism};
use linkage_tests::random::{Random, cases};

mechanism! {
    /// From the motors to the joints.
    pub struct FromMotors {
        /// The bend of the knee, and the angle of the second motor's arm, both against the thigh.
        input knee, motor: angle;
        /// The torques that the joints put out.
        load at_knee, at_ankle: torque;

        ground K(0, 0);
        crank shank(K) -> A        { length: 400mm, angle: knee - 90deg }
        crank arm(K) -> B          { length: 50mm, angle: motor }
        rrr   rod(B), foot(A) -> H { lengths: (400mm, 60mm), mode: left }
        let ankle_angle = foot.angle - shank.angle - 90deg;

        torque -at_knee on shank;
        torque -at_ankle between shank and foot;
        inertia 0.02(kg*m^2) on shank;
        inertia 0.003(kg*m^2) on foot;
        output ankle = ankle_angle, B, A, H, knee.drive, motor.drive;
    }
}

mechanism! {
    /// From the joints to the motors.
    pub struct FromJoints {
        input knee, ankle: angle;
        /// The torques that the motors put in.
        load knee_motor, arm_motor: torque;

        ground K(0, 0);
        crank shank(K) -> A       { length: 400mm, angle: knee - 90deg }
        crank foot(A) -> H        { length: 60mm, angle: ankle + 90deg, relative_to: shank }
        rrr   arm(K), rod(H) -> B { lengths: (50mm, 400mm), mode: left }

        torque -knee_motor on shank;
        torque -arm_motor on arm;
        inertia 0.01(kg*m^2) on shank;
        inertia 0.004(kg*m^2) on arm;
        output motor = arm.angle, B, A, H, knee.drive, ankle.drive;
    }
}

/// Rotors of the two motors, as the second declaration has them.
const ROTORS: [f64; 2] = [0.01, 0.004];

pub(super) struct Pose {
    joints: [f64; 2],
    rates: [f64; 2],
    torques: [f64; 2],
}

fn poses(count: u32) -> impl Iterator<Item = Pose> {
    let mut random = Random::new(42);
    (0..count).map(move |_| {
        let mut both = |size: f64| [random.anywhere(-size, size), random.anywhere(-size, size)];
        let [knee, ankle] = both(0.6);
        // The knee bends backwards, to 120°.
        Pose { joints: [1.75 * (knee - 0.6), ankle], rates: both(10.0), torques: both(100.0) }
    })
}

fn power(efforts: [f64; 2], rates: [f64; 2]) -> f64 {
    efforts[0] * rates[0] + efforts[1] * rates[1]
}

/// By how many ε of their products two powers differ. These are the products of which each of the two is made,
/// every torque through every ratio, before they cancel.
fn apart(one: f64, two: f64, products: [f64; 3]) -> f64 {
    let size: f64 = products.iter().map(|product| product.abs()).sum();
    (one - two).abs() / (2.0 * size) / f64::EPSILON
}

/// Which side of the line from `a` to `c` the point `b` is on: the sign of the assembly.
fn side(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> Side {
    let cross = (c[0] - a[0]) * (b[1] - a[1]) - (c[1] - a[1]) * (b[0] - a[0]);
    if cross > 0.0 { Side::Left } else { Side::Right }
}

/// The largest differences in ε: power from the motors, power from the joints, angles there and back.
fn worst(count: u32) -> [f64; 3] {
    let (motors, joints) = (FromMotors::new(), FromJoints::new());
    let mut worst = [0.0_f64; 3];
    for Pose { joints: at @ [knee, ankle], rates, torques } in poses(count) {
        // The joints move at given rates, and the motors put in what the joints put out.
        let pose = joints.position(at).expect("the rod reaches");
        let motor = pose.motor.angle();
        let motor_rates = [rates[0], joints.velocity(at, rates).expect("it moves").motor.omega];
        let out = motors.statics([knee, motor], torques).expect("it stands");
        let put_in = [out.knee.drive, out.motor.drive];
        let [by_knee, by_ankle] = ratios(at);
        let through = torques[1] / by_ankle;
        let products =
            [torques[0] * rates[0], through * by_knee * rates[0], through * motor_rates[1]];
        worst[0] = worst[0].max(apart(power(put_in, motor_rates), power(torques, rates), products));

        // The motors' torques are given, and the joints put out what they put in.
        let held = joints.statics(at, torques).expect("it stands");
        let put_out = [held.knee.drive, held.ankle.drive];
        let through = torques[1] * by_knee * rates[0];
        let products = [torques[0] * rates[0], through, torques[1] * by_ankle * rates[1]];
        worst[1] =
            worst[1].max(apart(power(put_out, rates), power(torques, motor_rates), products));

        // There and back, on the branch that is declared, never on its mirror image.
        let back = motors.position([knee, motor]).expect("the rod reaches");
        worst[2] = worst[2].max((back.ankle.angle() - ankle).abs() / f64::EPSILON);
        let point = |p: linkage_core::Point| [p.x, p.y];
        assert_eq!(side(point(pose.B), point(pose.H), point(pose.A)), Side::Left, "{at:?}");
        assert_eq!(side(point(back.B), point(back.H), point(back.A)), Side::Left, "{at:?}");
        assert_eq!(side([0.0; 2], point(back.B), point(back.H)), Side::Left, "{at:?}");
    }
    worst
}

/// A million poses in `.ci/nightly`, of which an ordinary run samples some.
#[test]
fn power_is_the_same_on_both_sides_of_an_ankle() {
    let [one, other, there_and_back] = worst(cases(60_000, 1_000_000) as u32);
    println!("power {one:.2} ε and {other:.2} ε apart, angles {there_and_back:.1} ε");
    assert!(one <= 8.0 && other <= 8.0, "{one} {other}");
    // Angles of up to two radians are recovered over lengths of 0.4 m at a lever of 0.05 m.
    assert!(there_and_back <= 64.0, "{there_and_back}");
}

#[test]
fn efforts_of_inverted_ratios_would_be_seen() {
    // As ros2_control had it: efforts mapped like rates.
    let (joints, mut most) = (FromJoints::new(), 0.0_f64);
    for Pose { joints: at, rates, torques } in poses(100) {
        let motor_rate = joints.velocity(at, rates).expect("it moves").motor.omega;
        let mapped_like_rates = joints.velocity(at, torques).expect("it moves").motor.omega;
        let put_in = power([torques[0], mapped_like_rates], [rates[0], motor_rate]);
        let products = [put_in, torques[0] * rates[0], torques[1] * rates[1]];
        most = most.max(apart(put_in, power(torques, rates), products));
    }
    assert!(most > 1e14, "{most}");
}

#[test]
fn the_mirror_image_is_another_pose() {
    // The negative control of the sides: the other mode is on the other side in every pose.
    let joints = FromJoints::new();
    for Pose { joints: at @ [knee, _], .. } in poses(100) {
        let pose = joints.position(at).expect("the rod reaches");
        // H mirrored on the line from B to A.
        let (b, a, h) = (pose.B, pose.A, pose.H);
        let along = (a - b) * ((h - b).dot(a - b) / (a - b).dot(a - b));
        let mirrored = b + along * 2.0 - (h - b);
        let [b, a, h] = [b, a, mirrored].map(|p| [p.x, p.y]);
        assert_eq!(side(b, h, a), Side::Right, "{knee}");
    }
}

/// J of the joints' rates to the motors', by the coefficients of the second declaration.
fn ratios(at: [f64; 2]) -> [f64; 2] {
    let joints = FromJoints::new();
    let row = FromJoints::<f64>::OUTPUTS.iter().position(|output| output.starts_with("motor"));
    joints.coefficients(at).expect("it moves")[row.expect("it is an output")]
}

#[test]
fn rotors_are_felt_at_the_joints_by_the_squares_of_the_ratios() {
    let joints = FromJoints::new();
    for Pose { joints: at, rates, .. } in poses(10_000) {
        let felt = joints.equations_of_motion(at, rates, [0.0; 2]).expect("it moves").mass;
        let [by_knee, by_ankle] = ratios(at);
        // JᵀMJ with J = [[1, 0], [∂motor/∂knee, ∂motor/∂ankle]].
        let expected = [
            [ROTORS[0] + ROTORS[1] * by_knee * by_knee, ROTORS[1] * by_knee * by_ankle],
            [ROTORS[1] * by_knee * by_ankle, ROTORS[1] * by_ankle * by_ankle],
        ];
        for (felt, expected) in felt.concat().into_iter().zip(expected.concat()) {
            // A ratio of lengths with a dozen roundings, squared.
            assert!((felt - expected).abs() <= 32.0 * f64::EPSILON * expected.abs(), "{at:?}");
        }
    }
}

#[test]
fn joints_are_felt_at_the_motors_by_the_inverse() {
    let motors = FromMotors::new();
    for Pose { joints: at @ [knee, _], .. } in poses(10_000) {
        let motor = FromJoints::new().position(at).expect("the rod reaches").motor.angle();
        let felt = motors.equations_of_motion([knee, motor], [0.0; 2], [0.0; 2]);
        let felt = felt.expect("it moves").mass;
        let [by_knee, by_ankle] = ratios(at);
        // The ankle's rate is (motor − by_knee·knee)/by_ankle, and the foot turns with knee and ankle.
        let foot = [1.0 - by_knee / by_ankle, 1.0 / by_ankle];
        let of = |i: usize, j: usize| 0.003 * foot[i] * foot[j];
        let expected = [[0.02 + of(0, 0), of(0, 1)], [of(1, 0), of(1, 1)]];
        for (felt, expected) in felt.concat().into_iter().zip(expected.concat()) {
            // 1 − by_knee/by_ankle cancels where the foot's turn by the knee is small.
            assert!(
                (felt - expected).abs() <= 64.0 * f64::EPSILON * 0.02,
                "{at:?}: {felt} {expected}"
            );
        }
    }
}
