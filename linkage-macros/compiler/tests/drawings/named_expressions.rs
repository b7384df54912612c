//! Named expressions that read pins.

use super::machine::{Machine, machine};

fn of(statements: &str) -> Machine {
    machine(&format!("pub struct M {{ {statements} }}")).unwrap_or_else(|told| panic!("{told:?}"))
}

/// A damper on a drawn pin by a named expression, and by its own.
#[test]
fn a_law_reads_the_rate_of_a_drawn_pin() {
    let four_bar = "input t: angle; ground A(0, 0), D(665.7mm, 0); pin B(80mm, 0), C(600mm, 360mm), E(570mm, 90mm);
        link AB(A, B), BC(B, C, E), DC(D, C); drive AB.angle = t;";
    let input = [[0.3, 1.0, 0.0]];
    let [named, plain] = [
        "let w = -2(N*s/m) * rate(E.x); force (w, 0) on E;",
        "force (-2(N*s/m) * rate(E.x), 0) on E;",
    ]
    .map(|law| of(&format!("{four_bar} {law}")).answers("forces", &input).named("t.drive"));
    assert_eq!(named, plain);
    assert!(named.abs() > 1e-4);
    // A pin is drawn where a logarithm has no value, and moves to where it has one.
    let law = "let l = ln(E.y / 90mm - 1); force (0, 1N * l) on E;";
    assert!(machine(&format!("pub struct M {{ {four_bar} {law} }}")).is_ok());
    // Where such a number places a pin, it is told.
    let told = machine(&format!(
        "pub struct M {{ {four_bar} let l = sqrt(E.y - 1m) * 1mm; pin G(l, 0); link CG(C, G), AG(A, G); }}"
    ));
    assert_ne!(told.err().expect("no place"), [""; 0]);
}
