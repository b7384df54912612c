//! Tests of `model/drawn/drive_equations/motions`.

use crate::diagnostics::Diagnostics;
use crate::model::drawn::reading::framing;
use crate::model::drawn::reading::reader::Reader;
use crate::model::drawn::reading::values::Measured;
use crate::syntax::parse;

/// By input, the rates of a declaration's drives.
fn rates(statements: &str) -> Vec<Vec<f64>> {
    let mut diagnostics = Diagnostics::new();
    let source = format!("pub struct M {{ {statements} }}");
    let tree = parse(source.parse().expect("tokens"), &mut diagnostics).expect("it has a name");
    let mut values = Measured::of(&tree, &mut diagnostics).expect("numbers");
    let (mut reader, drives) = Reader::of(&tree, &mut values).expect("a drawing");
    let frames = framing::written(&mut reader).expect("frames");
    let bodies = reader.machine(drives, frames).expect("a machine");
    let rates = values.motions(&bodies).into_iter().map(|motion| motion.drives).collect();
    assert!(diagnostics.into_mistakes().is_empty());
    rates
}

/// A drive that reads the angle of a link turns at that link's rate against the ground: of BC on AB it is the sum of
/// both drives', and of a crank that is declared by hand that of its angle.
#[test]
fn drives_that_read_an_angle_turn_at_its_rate_against_the_ground() {
    let arm = "input t, p: angle; ground A(0, 0), D(4, 0); pin B(0.5, 0.9), C(3.2, 2.6), E(4.3, 0.9), F(3.4, 1.9); \
                   link AB(A, B), BC(B, C), DE(D, E), EF(E, F), CF(C, F);";
    let cases = [
        (
            "drive AB.angle = t; drive BC.angle - AB.angle = 3 * p; drive DE.angle = 0.5 * BC.angle + 55deg;",
            [[1.0, 0.0, 0.5], [0.0, 3.0, 1.5]],
        ),
        (
            "drive DE.angle = 0.5 * BC.angle + 55deg; drive BC.angle - AB.angle = 3 * p; drive AB.angle = 2 * t;",
            [[1.0, 0.0, 2.0], [1.5, 3.0, 0.0]],
        ),
        (
            "drive AB.angle = t; drive AB.angle - BC.angle = 3 * p; drive DE.angle = 0.5 * BC.angle + 55deg;",
            [[1.0, 0.0, 0.5], [0.0, 3.0, -1.5]],
        ),
        (
            "drive AB.angle = t; drive BC.angle = p; drive DE.angle = 0.5 * BC.angle - AB.angle + 116deg;",
            [[1.0, 0.0, -1.0], [0.0, 1.0, 0.5]],
        ),
    ];
    for (drives, wanted) in cases {
        let found = rates(&format!("{arm} {drives}"));
        let pairs = found.concat().into_iter().zip(wanted.concat());
        for (found, wanted) in pairs {
            // Roundings of numbers of order one over a step of 1e-4.
            assert!((found - wanted).abs() < 1e-10, "{drives}: {found} in place of {wanted}");
        }
    }
    let declared = arm.replace(
        "pin B(0.5, 0.9),",
        "crank AB(A) -> B { length: hypot(0.5, 0.9), angle: 2 * t } pin B(0.5, 0.9),",
    );
    let declared = declared.replace("AB(A, B), BC", "BC");
    let found = rates(&format!(
        "{declared} drive BC.angle - AB.angle = 3 * p; drive DE.angle = 0.5 * BC.angle + AB.angle;"
    ));
    for (found, wanted) in found.concat().into_iter().zip([0.0, 3.0, 3.0, 1.5]) {
        assert!((found - wanted).abs() < 1e-10, "{found} in place of {wanted}");
    }
}
