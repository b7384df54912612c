//! Derivatives of a torque with friction by dual numbers, against differences in fifty digits.
//!
//! The full Newton-Euler matrix of the four-bar was solved with its amounts in seventy digits, at steps of 10⁻¹² to
//! both sides: five points, whose error is of the fourth order, leave fifty digits of the first derivative
//! and thirty of the second.

use linkage_tests::mechanisms::friction::RubbingFourBar;
use num_dual::{Dual2_64, Dual64};

/// Coefficient and radius; angle, rate and acceleration; torque, its derivatives by the angle, and by the rate.
#[rustfmt::skip]
const TORQUES: [([f64; 2], [f64; 3], [f64; 4]); 4] = [
    ([0.1, 0.02], [0.7, 12.0, -20.0],
        [1.057_099_522_804_343_2, -9.768_492_527_197_285_8, -9.585_259_486_760_188_9, 0.184_562_564_793_164_78]),
    ([0.3, 0.02], [2.9, -4.0, -20.0],
        [-15.807_850_549_825_604, 8.432_806_735_815_739_2, 11.559_743_539_783_943, 0.170_708_237_726_281_75]),
    ([0.5, 0.03], [4.4, 9.0, 5.0],
        [15.572_810_921_438_715, 14.362_851_914_529_074, -8.949_470_969_333_774_6, 0.576_560_538_654_252_04]),
    ([0.9, 0.03], [5.7, -3.0, 30.0],
        [5.874_882_510_888_664_9, -2.531_236_876_181_299_6, -15.975_531_074_036_968, 0.017_515_280_639_224_707]),
];

/// The torque is a sum of terms of some 50 N·m, each right to some ε. A derivative by the angle passes each link's
/// formulas twice, and a second one four times.
fn close(found: f64, expected: f64, roundings: f64) {
    let off = (found - expected).abs();
    assert!(off <= roundings * f64::EPSILON * 100.0, "{found} is not {expected}: {off:e}");
}

#[test]
fn duals_of_both_orders_are_those_of_differences_in_fifty_digits() {
    for ([mu, radius], [q, rate, accel], [torque, first, second, by_rate]) in TORQUES {
        let four_bar = RubbingFourBar { mu, radius };
        close(four_bar.forces(q, rate, accel).unwrap().theta.drive, torque, 8.0);
        let lift = Dual2_64::from_re;
        let along = four_bar.lift::<Dual2_64>();
        let found = along.forces(lift(q).derivative(), lift(rate), lift(accel)).unwrap();
        close(found.theta.drive.re, torque, 8.0);
        close(found.theta.drive.v1, first, 16.0);
        close(found.theta.drive.v2, second, 64.0);
        let lift = Dual64::from_re;
        let along = four_bar.lift::<Dual64>();
        let found = along.forces(lift(q), lift(rate).derivative(), lift(accel)).unwrap();
        close(found.theta.drive.eps, by_rate, 16.0);
    }
}
