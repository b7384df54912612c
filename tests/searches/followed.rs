//! Motions and ranges beside an unknown: against closed forms, the same machine driven at the unknown,
//! and stepping.

use std::f64::consts::{FRAC_PI_2, PI};

use linkage_core::find::Trend;
use linkage_core::range::{Stop, limits};
use linkage_core::{Side, SolveError, Tracker};
use linkage_tests::mechanisms::followed::*;
use linkage_tests::mechanisms::unknowns::{InLine, Press};

use super::set_points::ends_of_stroke;

const THETA: Stop = Stop::Limit { group: "theta" };

/// The dead points of a ram's equation are the ends of its stroke.
#[test]
fn limits_of_a_ram_are_its_stroke() {
    let found = limits(&InLine::new(), [0.1, 0.4]).expect("an interval");
    let [stretch] = *found else { panic!("{:?}", &*found) };
    assert_eq!([stretch.from.stop, stretch.to.stop], [THETA; 2]);
    println!("{:e} {:e}", stretch.from.at - 0.17, stretch.to.at - 0.33);
    let press = Press::new();
    let [(_, far), (_, near)] = ends_of_stroke([0.08, 0.25, 0.03]);
    let found = limits(&press, [0.1, 0.4]).expect("an interval");
    println!("{:?} {far} {near}", &*found);
}

#[test]
fn a_twin_goes_through_its_dead_point() {
    let mut tracker = Tracker::new(TwinPress::new());
    for step in 0..=160 {
        let turn = 1.4 - 0.0175 * f64::from(step);
        let m = tracker.motion(turn, -1.0, 0.5);
        match m {
            Ok(m) => println!(
                "{turn} {:e} {:e} {:e} {:?}",
                m.position.theta - turn,
                m.velocity.theta + 1.0,
                m.acceleration.theta - 0.5,
                tracker.solver().way
            ),
            Err(e) => println!("{turn} {e:?}"),
        }
    }
}

#[test]
fn a_group_behind_changes() {
    let mut tracker = Tracker::new(Lifted::new());
    for step in 0..=100 {
        let y = 0.4 - 0.008 * f64::from(step);
        let m = tracker.motion(y, -1.0, 0.5);
        match m {
            Ok(m) => println!(
                "{y} {:e} {:e} {:?}",
                m.position.theta - (y / 0.5).asin(),
                m.position.DC.angle() - m.position.theta,
                tracker.solver().elbow
            ),
            Err(e) => println!("{y} {e:?}"),
        }
    }
}
