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
