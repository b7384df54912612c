//! Points and groups that are declared by hand beside a drawing.

use super::machine::{Machine, machine};

fn of(statements: &str) -> Machine {
    machine(&format!("pub struct M {{ {statements} }}")).unwrap_or_else(|told| panic!("{told:?}"))
}

/// A pin that a group makes and a drawing places is declared once for editors.
#[test]
fn a_pin_is_made_once() {
    let crank = of("input theta: angle; ground A(0, 0), D(4m, 0); crank AB(A) -> B { length: 1m, angle: theta }
         pin B(0, 1m), C(3m, 2m); link BC(B, C), DC(D, C); output DC.angle;");
    let made = &crank.mechanism.references.made;
    for (nth, (name, _)) in made.iter().enumerate() {
        assert!(made[..nth].iter().all(|(other, _)| other != name), "`{name}` is made twice");
    }
}

fn drawn(machine: &Machine) -> Vec<f64> {
    machine.mechanism.drawn.clone().expect("drives determine the inputs")
}

/// A point that inputs move, a crank and a slider that are declared by hand: their inputs in the drawing.
#[test]
fn the_drawn_inputs_are_those_of_what_is_declared_by_hand_too() {
    let point = of("input x, y: length; ground A(-50mm, 0); pin B(-120mm, 90mm), tool(1mm, 200mm); link AB(A, B), BC(B, tool);
         point tool at (x, 2 * y);");
    assert_eq!(drawn(&point), [0.001, 0.1]);
    let crank = of("input theta: angle; ground A(0, 0), D(4m, 0); crank AB(A) -> B { length: 1m, angle: theta + 10deg }
         pin B(0.6m, 0.8m), C(3m, 2m); link BC(B, C), DC(D, C);");
    let angle = 0.8_f64.atan2(0.6) - 10_f64.to_radians();
    assert!((drawn(&crank)[0] - angle).abs() < 1e-15);
    let slider = of("input s: length; ground D(4m, 0); guide bed through (1m, 0) along 0deg;
         slider ram(bed) -> B { slide: s } pin B(1.5m, 0), C(3m, 2m); link BC(B, C), DC(D, C);");
    assert_eq!(drawn(&slider), [0.5]);
}
