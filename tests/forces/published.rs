//! Torques and reactions of two course works.

use core::f64::consts::{FRAC_PI_3, PI};
use linkage_tests::mechanisms::forces::*;
use linkage_tests::tables::forces::{FOUR_BAR, SIX_BAR};

fn number(text: &str) -> f64 {
    text.parse().expect("the table holds numbers")
}

#[test]
fn the_four_bar_has_its_driving_torques() {
    let omega = 0.4 * PI;
    let largest = FOUR_BAR.iter().map(|row| number(row.2).abs()).fold(0.0, f64::max);
    // The angle is rounded once, by up to 4.4e-16 at 7.3; the torque changes by less than 1.2 N·m per
    // radian, and some fifty operations round: 1e-13 of the largest is a hundred times that.
    let tolerance = 1e-13 * largest;
    let mut compared = 0;
    for &(time, without, with) in FOUR_BAR {
        let theta = FRAC_PI_3 + omega * time;
        for (g, expected) in [(0.0, number(without)), (9.81, number(with))] {
            let by_walk = HeavyFourBar { g }.forces(theta, omega, 0.0).unwrap();
            let by_power = DrivenFourBar { g }.forces(theta, omega, 0.0).unwrap();
            for found in [by_walk.theta.drive, by_walk.AB.drive, by_power.theta.drive] {
                assert!((found - expected).abs() <= tolerance, "{time}: {found} is not {expected}");
                compared += 1;
            }
        }
    }
    assert_eq!(compared, 66);
}

#[test]
fn the_six_bar_has_its_reactions() {
    let mut compared = 0;
    for (degrees, expected) in SIX_BAR {
        let f = HeavySixBar::new().forces(f64::to_radians(*degrees), 10.0, 0.0).unwrap();
        let found =
            [f.block.B.x, f.block.B.y, f.block.rod.normal, f.rod.D.x, f.rod.D.y, f.AB.drive];
        for (found, expected) in found.into_iter().zip(expected.map(number)) {
            // The largest is 876 N, and rounding the angle changes it by 1e-12.
            assert!((found - expected).abs() <= 1e-11, "{degrees}: {found} is not {expected}");
            compared += 1;
        }
    }
    assert_eq!(compared, 36);
}
