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

/// A point that inputs move, a crank and a slider that are declared by hand: their inputs in the drawing.
#[test]
fn the_drawn_inputs_are_those_of_what_is_declared_by_hand_too() {
    let point = of("input x, y: length; ground A(-50mm, 0); pin B(-120mm, 90mm), tool(1mm, 200mm); link AB(A, B), BC(B, tool);
         point tool at (x, 2 * y);");
    assert_eq!(point.drawn_inputs(), [0.001, 0.1]);
    let crank = of("input theta: angle; ground A(0, 0), D(4m, 0); crank AB(A) -> B { length: 1m, angle: theta + 10deg }
         pin B(0.6m, 0.8m), C(3m, 2m); link BC(B, C), DC(D, C);");
    let angle = 0.8_f64.atan2(0.6) - 10_f64.to_radians();
    assert!((crank.drawn_inputs()[0] - angle).abs() < 1e-15);
    let slider = of("input s: length; ground D(4m, 0); guide bed through (1m, 0) along 0deg;
         slider ram(bed) -> B { slide: s } pin B(1.5m, 0), C(3m, 2m); link BC(B, C), DC(D, C);");
    assert_eq!(slider.drawn_inputs(), [0.5]);
}

/// A group whose pins are drawn takes its mode from the drawing: at the drawn inputs its pin is where it is drawn, on
/// either side of its limit.
#[test]
fn a_mode_that_is_left_out_is_that_of_the_drawing() {
    let bars = |c: [f64; 2]| {
        format!(
            "ground A(0, 0), D(4m, 0); pin B(0.6m, 0.8m), C({:?}m, {:?}m); link AB(A, B); drive AB.angle = t;
             rrr BC(B), DC(D) -> C {{ lengths: ({:?}m, {:?}m) }}",
            c[0],
            c[1],
            (c[0] - 0.6).hypot(c[1] - 0.8),
            (c[0] - 4.0).hypot(c[1]),
        )
    };
    let block = |c: [f64; 2], along: f64| {
        let (sin, cos) = along.to_radians().sin_cos();
        format!(
            "ground A(0, 0); pin B(0.6m, 0.8m), C({:?}m, {:?}m); link AB(A, B); drive AB.angle = t;
             guide bed through (0, 0) along {along:?}deg;
             rrp BC(B), ram(bed) -> C {{ length: {:?}m, offset: {:?}m }}",
            c[0],
            c[1],
            (c[0] - 0.6).hypot(c[1] - 0.8),
            c[1] * cos - c[0] * sin,
        )
    };
    let mut machines = Vec::new();
    for c in [[3.0, 2.0], [3.0, -1.5], [1.5, 2.5]] {
        machines.push((c, bars(c)));
    }
    for c in [[3.0, 0.5], [-2.0, 0.5]] {
        machines.extend([0.0, 20.0, 180.0].map(|along| (c, block(c, along))));
    }
    let by_hand = machines.clone().into_iter().map(|(c, statements)| {
        let crank = "crank AB(A) -> B { length: 1m, angle: t }";
        (c, statements.replace("link AB(A, B); drive AB.angle = t;", crank))
    });
    machines.extend(by_hand.collect::<Vec<_>>());
    for (c, statements) in machines {
        let machine = of(&format!("input t: angle; {statements}"));
        let answers = machine.answers("position", &[[machine.drawn_inputs()[0], 0.0, 0.0]]);
        let off = (answers.named("C.x") - c[0]).hypot(answers.named("C.y") - c[1]);
        assert!(off < 1e-12, "{statements}: {off:e}");
    }
}

/// Where the drawing does not tell the two modes apart, or places no pin, one is asked for.
#[test]
fn a_mode_that_no_drawing_tells_is_asked_for() {
    for (pin, lengths) in [
        ("pin E(1m, 1m);", "(2m, 3m)"),
        ("pin C(2.3m, 0.4m), E(1m, 1m);", "(hypot(1.7m, -0.4m), hypot(1.7m, 0.4m))"),
    ] {
        let told = machine(&format!(
            "pub struct M {{ input t: angle; ground A(0, 0), D(4m, 0); pin B(0.6m, 0.8m); {pin} link AB(A, B, E);
             drive AB.angle = t; rrr BC(B), DC(D) -> C {{ lengths: {lengths} }} }}"
        ));
        let told = told.err().expect("it has two modes");
        assert!(told[0].contains("`mode`"), "{told:?}");
    }
}
