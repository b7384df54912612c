//! Tests of `interface/dimensions`.

use crate::interface::units_in_words::unit;
use crate::interface::{Interface, labels};
use crate::model::mechanism::Mechanism;
use crate::oracle::mechanism;
pub(crate) use linkage_compiler::interface::dimensions::*;

/// The units of a result by the names of its numbers.
fn units(mechanism: &Mechanism, method: &str) -> Vec<String> {
    let interface = Interface::of(mechanism);
    let entries = interface.entries.iter();
    let entry = entries.into_iter().find(|entry| entry.name() == method);
    let entry = entry.expect("it is offered");
    let found = of_result(&interface, mechanism, entry);
    assert_eq!(found.len(), interface.numbers(entry.result), "{method}");
    let names = labels::of_result(&interface, mechanism, entry);
    let named = names.iter().zip(&found);
    named.map(|(name, (dimension, order))| format!("{name} {}", unit(*dimension, *order))).collect()
}

#[test]
fn every_number_of_a_result_has_the_unit_of_what_it_is() {
    let press = mechanism(
        "struct Press { input theta: angle; load work: force;
             ground A(0, 0); guide way through (0, 0) along -90deg;
             crank AB(A) -> B { length: 100mm, angle: theta }
             rrp BC(B), ram(way) -> C { length: 400mm, mode: ahead }
             spring buffer between A and C { stiffness: 100(N/m), free_length: 300mm }
             mass 8kg on ram at (0, 0); force (0, work) on C;
             let area = C.y * C.x;
             output C, BC, ram.slide, BC.margin, area;
             output theta.drive, BC.C, ram.way, buffer.force, shaking, energy; }",
    );
    assert_eq!(
        units(&press, "position"),
        ["C.x m", "C.y m", "BC.angle 1", "BC.angle 1", "ram.slide m", "BC.margin m", "area m²"]
    );
    assert_eq!(
        units(&press, "motion")[7..13],
        [
            "velocity of C.x m/s",
            "velocity of C.y m/s",
            "BC.omega rad/s",
            "velocity of ram.slide m/s",
            "velocity of BC.margin m/s",
            "velocity of area m²/s"
        ]
    );
    assert_eq!(
        units(&press, "forces"),
        [
            "theta.drive N·m",
            "BC.C.x N",
            "BC.C.y N",
            "ram.way.normal N",
            "ram.way.couple N·m",
            "buffer.force N",
            "shaking.x N",
            "shaking.y N",
            "shaking.couple N·m"
        ]
    );
    assert_eq!(units(&press, "energy"), ["kinetic energy N·m", "potential energy N·m"]);
}

/// A crank and a slider: a mass matrix has as many units as inputs' pairs.
#[test]
fn equations_of_motion_have_units_of_efforts_and_inertias() {
    let arm = mechanism(
        "struct Arm { input theta: angle; input s: length; ground A(0, 0);
             crank AB(A) -> B { length: 1, angle: theta }
             guide rail on AB through (0, 0) along 0deg;
             slider block(rail) -> C { slide: s }
             mass 2kg on AB uniform; mass 3kg on block at (0, 0); output C, theta.drive; }",
    );
    let found = units(&arm, "equations_of_motion");
    let units: Vec<_> = found.iter().map(|line| line.rsplit(' ').next()).collect();
    assert_eq!(units, ["kg·m²", "kg·m", "kg·m", "kg", "N·m", "N"].map(Some));
}
