//! Tests of `model/wheels`.

use crate::model::expr::{Operator, Scalar};
use crate::model::mechanism::Carrier;
use crate::oracle::mechanism;
pub(crate) use linkage_compiler::model::wheels::*;

/// Names of both wheels and their ratio.
fn pairs(statements: &str) -> Vec<String> {
    let mechanism = mechanism(&format!(
        "struct M {{ input t, u: angle; param p = 2; ground A(0, 0), D(1m, 0), F(0, 1m); \
             crank AB(A) -> B {{ length: 0.3m, angle: t }} crank FG(F) -> G {{ length: p * 0.1m, angle: u }} \
             {statements} output B, G, E; }}"
    ));
    let name = |body: Carrier| match body {
        Carrier::Link(link) => mechanism.links[link.index()].name.to_string(),
        Carrier::Ground => "ground".to_string(),
    };
    let wheels = wheels(&mechanism).into_iter().map(|wheels| {
        let [first, second] = wheels.bodies.map(name);
        format!("{first} {second} {}", value(&wheels.ratio))
    });
    wheels.collect()
}

/// The value of a ratio where the parameter is 2.
fn value(ratio: &Scalar) -> f64 {
    match ratio {
        Scalar::Constant(number) => number.to_f64(),
        Scalar::Param(_) => 2.0,
        Scalar::Negate(number) => -value(number),
        Scalar::Chain(first, rest) => {
            rest.iter().fold(value(first), |a, (operator, b)| match operator {
                Operator::Add => a + value(b),
                Operator::Sub => a - value(b),
                Operator::Mul => a * value(b),
                Operator::Div => a / value(b),
            })
        }
        other => panic!("{other:?} is none of a ratio"),
    }
}

#[test]
fn cranks_that_a_ratio_couples_are_wheels() {
    let on_d = |angle: &str| format!("crank DE(D) -> E {{ length: 0.2m, angle: {angle} }}");
    let on_b = |angle: &str| {
        format!("crank BE(B) -> E {{ length: 0.2m, angle: {angle}, relative_to: AB }}")
    };
    for (crank, expected) in [
        (on_d("-2 * AB.angle + 10deg"), &["AB DE -2"][..]),
        (on_d("20deg - t * 3 / 2"), &["AB DE -1.5"]),
        (on_d("(t + 5deg) / 4 + t"), &["AB DE 1.25"]),
        (on_b("-3 * t"), &["ground BE 3"]),
        (on_b("2 * AB.angle"), &["ground BE -2"]),
        // Parallel cranks, and a crank on another that keeps its direction, roll on nothing.
        (on_d("t + 10deg"), &[]),
        (on_b("-t"), &[]),
        (on_d("-2 * u"), &["FG DE -2"]),
        // A parameter in the ratio.
        (on_d("p * t"), &["AB DE 2"]),
        (on_d("10deg - t * 3 / (p + 2)"), &["AB DE -0.75"]),
        (on_b("t / p - t"), &["ground BE 0.5"]),
        // Another input, or no multiple.
        (on_b("u"), &[]),
        (on_d("sin(t)"), &[]),
        (on_d("t + u"), &[]),
    ] {
        assert_eq!(pairs(&crank), expected, "{crank}");
    }
}
