//! Every record that a declaration makes, and every result type, written and read by serde.

use std::fmt::Debug;

use linkage_core::find::{Search, Trend};
use linkage_core::range::{Extremum, Turn, extrema, limits};
use linkage_core::{Real, Status, mechanism};
use serde::{Serialize, de::DeserializeOwned};

mechanism! {
    /// Two inputs and two loads, masses, margins, energy and a reaction.
    struct Robot {
        input a: angle;
        input b: angle;
        load push: force;
        load twist: torque;
        param rod = 0.4m;
        gravity (0, -9.81(m/s^2));
        ground A(0, 0), D(0.3m, 0);
        crank AB(A) -> B      { length: 0.3m, angle: a }
        crank DE(D) -> E      { length: 0.3m, angle: b }
        rrr BC(B), EC(E) -> C { lengths: (rod, 0.4m), mode: left }
        mass 1kg on C;
        mass 0.5kg on B;
        mass 0.5kg on E;
        force (push, 0) on C;
        torque twist on AB;
        output B, C, AB, BC, BC.margin, energy, AB.drive, BC.B;
    }
}

mechanism! {
    /// A declaration that names a path seen from where it stands: without a module of its own.
    struct Press {
        crate = linkage_core;
        input theta: angle;
        ground A(0, 0);
        guide bed through (0, 30mm) along 0deg;
        crank AB(A) -> B           { length: 80mm, angle: theta }
        rrp   BC(B), ram(bed) -> C { length: 250mm, mode: ahead }
        output ram, C;
    }
}

/// The text of a value, from which the same value is read, to the last bit.
fn kept<V: Serialize + DeserializeOwned + PartialEq + Debug>(value: &V) -> String {
    let text = serde_json::to_string(value).expect("it can be written");
    let read: V = serde_json::from_str(&text).expect("what was written can be read");
    // Numbers are finite, and `PartialEq` tells all of those apart but for the sign of zero.
    assert_eq!(&read, value, "{text}");
    text
}

fn every_record_is_kept<T>(robot: &Robot<T>)
where
    T: Real + Serialize + DeserializeOwned + PartialEq + Debug,
{
    let [a, b] = [T::lit(1.2, 1.2), T::lit(2.1, 2.1)];
    let (at, rates) = (RobotInput { a, b }, RobotInput { a: b, b: a });
    let loads = RobotLoads { push: a, twist: b };
    assert!(kept(&at).starts_with("{\"a\":1.2"));
    kept(&loads);
    let motion = robot.motion(at, rates, rates).expect("it assembles");
    let text = kept(&motion);
    assert!(text.starts_with("{\"position\":{"), "{text}");
    assert!(text.contains("\"BC\":{\"cos\":"), "{text}");
    kept(&motion.position);
    kept(&motion.velocity);
    kept(&motion.acceleration);
    kept(&robot.margins(at).expect("it assembles"));
    let forces = robot.forces(at, rates, rates, loads).expect("it assembles");
    assert!(kept(&forces).contains("\"drive\":"));
    kept(&robot.statics(at, loads).expect("it assembles"));
    kept(&robot.energy(at, rates).expect("it assembles"));
    let equations = robot.equations_of_motion(at, rates, loads).expect("it assembles");
    // Two rows of the mass matrix.
    assert!(kept(&equations).contains("[["));
}

#[test]
fn every_record_is_read_as_it_was_written() {
    every_record_is_kept(&Robot::<f64>::default());
    every_record_is_kept(&Robot::<f32>::default());
    kept(&Press::new().position(0.3).expect("it assembles"));
}

#[test]
fn a_record_is_a_map_of_its_fields_by_the_declared_names() {
    let position = Press::new().position(core::f64::consts::FRAC_PI_2).expect("it assembles");
    let value = serde_json::to_value(position).expect("it can be written");
    // B at (0, 80 mm), C 50 mm below it: √(250² − 50²) mm along the bed.
    let slide = value["ram"]["slide"].as_f64().expect("a number");
    assert!((slide - f64::sqrt(0.06)).abs() < 1e-15, "{slide}");
    assert_eq!(value["C"]["x"], value["ram"]["slide"]);
}

#[test]
fn results_of_searches_are_written() {
    let press = Press::new();
    let slide = |theta| -> Result<[f64; 3], linkage_core::SolveError> {
        let at = press.motion(theta, 1.0, 0.0)?;
        Ok([at.position.ram.slide, at.velocity.ram.slide, at.acceleration.ram.slide])
    };
    let turns = extrema([-3.0, 3.0], slide).expect("every pose assembles");
    let text = serde_json::to_string(&turns).expect("it can be written");
    let read: Vec<Extremum> = serde_json::from_str(&text).expect("what was written can be read");
    assert_eq!(read, *turns);
    assert!(read.iter().any(|turn| turn.turn == Turn::Maximum), "{text}");

    let whole = limits(&press, [0.0, 1.0]).expect("a parameter lets poses be solved");
    let text = serde_json::to_string(&whole).expect("it can be written");
    let end = |at: &str| format!("{{\"at\":{at},\"stop\":\"Edge\"}}");
    assert_eq!(text, format!("[{{\"from\":{},\"to\":{}}}]", end("0.0"), end("1.0")));

    let search = Search::new([0.5, 2.0], Trend::Falling);
    kept(&search.find(|theta: f64| [theta.cos(), -theta.sin()]).expect("π/2 is inside"));
    let error = search.find(|_: f64| [1.0, 0.0]).expect_err("a constant has no root");
    assert!(serde_json::to_string(&error).expect("it can be written").contains("\"by\":1.0"));
    assert_eq!(kept(&Status::OutOfReach), "\"OutOfReach\"");
}
