//! Clearance of an equation from having no root, in closed form: the height of a crank's pin, 2 sin θ, is
//! to be x.

use crate::ir::interpret::{ProgramValues, interpret};
use crate::oracle::mechanism;
use crate::{equations, passes};

const HEIGHT: &str =
    "struct M { input x: length; unknown theta: angle between (0.2, 1.2); ground A(0, 0);
    crank AB(A) -> B { length: 2m, angle: theta }
    solve theta { B.y = x, mode: rising, near: 0.5 } output theta; }";

#[test]
fn ends_and_root_of_an_equation_are_as_far_as_by_hand() {
    let mechanism = mechanism(HEIGHT);
    let program = passes::optimise(&equations::derive(&mechanism, passes::RULES));
    let (x, rate) = (1.1, 0.4);
    let (params, loads, drives) = (Vec::new(), Vec::new(), Vec::new());
    let given = ProgramValues { inputs: vec![[x, rate, 0.0]], params, loads, drives, unit: None };
    let values = interpret(&program, &given);
    let (from, to) = (0.2_f64, 1.2_f64);
    // Left and right, and the change over a quarter of the interval by slope and curvature.
    let scale = |end: f64| {
        let quarter = (to - from) / 4.0;
        let (sin, cos) = end.sin_cos();
        let changes = [2.0 * cos * quarter, -2.0 * sin * quarter * quarter];
        let squares = [2.0 * sin, x, changes[0], changes[1]].map(|part| part * part);
        squares.iter().sum::<f64>().sqrt()
    };
    // Rising, the difference is below zero at the lower end and above it at the upper one.
    let ends = [(from, x - 2.0 * from.sin(), rate), (to, 2.0 * to.sin() - x, -rate)];
    let ends = ends.map(|(end, distance, rate)| [distance, scale(end), rate, 0.0]);
    // 2 cos θ θ̇ = ẋ and 2 cos θ θ̈ = 2 sin θ θ̇².
    let theta = (x / 2.0).asin();
    let first = rate / (2.0 * theta.cos());
    let second = theta.tan() * first * first;
    let root = [theta - from + (to - from), to - from, first, second];
    assert_eq!(program.clearances.len(), 3);
    for (found, expected) in program.clearances.iter().zip([ends[0], ends[1], root]) {
        let [rate, second] = found.rates.expect("they are known beside an unknown");
        let found = [found.value, found.scale, rate, second].map(|id| values[id.index()]);
        for (found, expected) in found.into_iter().zip(expected) {
            // Some ten roundings of numbers up to two, and Newton's last step.
            assert!((found - expected).abs() < 32.0 * f64::EPSILON, "{found} {expected}");
        }
    }
}

/// A bar from P to a block: X² = l² − (e − y)², with the scale l² + e² + |AP|².
#[test]
fn a_bar_is_as_clear_of_its_guide_as_by_hand() {
    let mechanism = mechanism(
        "struct M { input x: length; input y: length; ground A(0, 0); guide rail through A along 0deg;
        point P at (x, y);
        rrp bar(P), block(rail) -> C { length: 3m, offset: 0.5m, mode: ahead } output C; }",
    );
    let program = passes::optimise(&equations::derive(&mechanism, passes::RULES));
    let (x, y, l, e) = (0.7, -1.1, 3.0, 0.5);
    let (params, loads, drives) = (Vec::new(), Vec::new(), Vec::new());
    let inputs: Vec<[f64; 3]> = vec![[x, 0.0, 0.0], [y, 0.0, 0.0]];
    let values = interpret(&program, &ProgramValues { inputs, params, loads, drives, unit: None });
    let [clearance] = &program.clearances[..] else { panic!("one group has a mode") };
    let found = [clearance.value, clearance.scale].map(|id| values[id.index()]);
    let expected = [l * l - (e - y) * (e - y), l * l + e * e + x * x + y * y];
    for (found, expected) in found.into_iter().zip(expected) {
        // Some five roundings of numbers up to eleven.
        assert!((found - expected).abs() < 64.0 * f64::EPSILON, "{found} {expected}");
    }
}
