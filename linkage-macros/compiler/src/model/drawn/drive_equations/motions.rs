//! The motions of a drawing that several inputs move: how fast each turns, slides and stretches what it drives.

use crate::chain::machine::{Driven, Driving, InputRates};
use crate::chain::plane::Complex;
use crate::syntax::tree::{
    DriveStatement, Expr, GroupFieldValue, GroupStatement, PointPlace, PointStatement,
    StatementKind,
};

use crate::model::drawn::outline::bodies::{Bodies, LinkOutline};
use crate::model::drawn::reading::values::Measured;

/// The angle of a crank that is declared by hand and turns against the ground.
pub(in crate::model::drawn) fn turned_by(group: &GroupStatement) -> Option<&Expr> {
    let is_of_the_ground = group.keyword == "crank" && field(group, "relative_to").is_none();
    field(group, "angle").filter(|_| is_of_the_ground)
}

/// The slide of a slider that is declared by hand.
pub(in crate::model::drawn) fn slid_by(group: &GroupStatement) -> Option<&Expr> {
    field(group, "slide").filter(|_| group.keyword == "slider")
}

fn field<'t>(group: &'t GroupStatement, name: &str) -> Option<&'t Expr> {
    let found = group.fields.iter().find(|field| field.name == name)?;
    match &found.value {
        GroupFieldValue::One(value) => Some(value),
        GroupFieldValue::Pair(_) => None,
    }
}

/// The rates at which bodies turn against the ground where drives at these rates turn them, one on another, from those
/// that are known; zero where they follow from more than drives.
fn turned_on(drives: &[Driving], rates: &[f64], mut known: Vec<Option<f64>>) -> Vec<f64> {
    for _ in drives {
        for (driving, rate) in drives.iter().zip(rates) {
            let [body, to] = driving.bodies;
            match (driving.kind, known[body], known[to]) {
                (Driven::Angle, None, Some(turn)) => known[body] = Some(turn + rate),
                (Driven::Angle, Some(turn), None) => known[to] = Some(turn - rate),
                _ => {}
            }
        }
    }
    known.into_iter().map(Option::unwrap_or_default).collect()
}

impl Measured<'_> {
    /// The motions of the inputs; none where one drive is all that moves the machine.
    pub(in crate::model::drawn) fn motions(&mut self, bodies: &Bodies<'_>) -> Vec<InputRates> {
        let moves =
            |link: &LinkOutline<'_>| link.is_given || matches!(link.length, Some((_, None)));
        if bodies.drives.len() < 2 && !bodies.links.iter().any(moves) {
            return Vec::new();
        }
        let count = self.mechanism().inputs.len();
        let drawn = self.inputs_of_the_drawing(bodies).unwrap_or(vec![0.0; count]);
        (0..count).map(|input| self.motion(bodies, &drawn, input)).collect()
    }

    /// The motion of an input, at these inputs.
    fn motion(&mut self, bodies: &Bodies<'_>, drawn: &[f64], input: usize) -> InputRates {
        // The ground comes first.
        let (mut turns, mut shifts) = (vec![Some(0.0)], vec![Complex::new(0.0, 0.0)]);
        for link in &bodies.links {
            let (mut turn, mut shift) = (None, [0.0; 2]);
            match &bodies.tree.statements[link.statement].kind {
                StatementKind::Group(group) if link.is_given => {
                    turn =
                        turned_by(group).map(|angle| self.rate(bodies, angle, (drawn, input), &[]));
                }
                StatementKind::Point(PointStatement {
                    on: None,
                    place: PointPlace::Cartesian(at),
                    ..
                }) => {
                    shift = [0, 1].map(|i| self.rate(bodies, &at[i], (drawn, input), &[]));
                }
                _ => {}
            }
            turns.push(turn);
            shifts.push(Complex::new(shift[0], shift[1]));
        }
        // A drive may read the angle of a link that another one turns.
        let mut drives = vec![0.0; bodies.drives.len()];
        for _ in 0..bodies.drives.len() {
            let turned = turned_on(&bodies.machine.drives, &drives, turns.clone());
            let rate = |(_, drive): &(usize, &DriveStatement)| {
                self.rate(bodies, &drive.value, (drawn, input), &turned)
            };
            drives = bodies.drives.iter().map(rate).collect();
        }
        let length = |link: &LinkOutline<'_>| match link.length {
            Some((length, None)) => self.rate(bodies, length, (drawn, input), &[]),
            _ => 0.0,
        };
        let lengths = [0.0].into_iter().chain(bodies.links.iter().map(length)).collect();
        let turns = turns.into_iter().map(Option::unwrap_or_default).collect();
        InputRates { drives, lengths, turns, shifts }
    }

    /// The rate of an expression where an input goes at one and links turn at these rates; zero where it has
    /// none.
    fn rate(
        &mut self,
        bodies: &Bodies<'_>,
        expr: &Expr,
        (drawn, input): (&[f64], usize),
        turns: &[f64],
    ) -> f64 {
        const STEP: f64 = 1e-4;
        let mut at = |step: f64| {
            let turned: Vec<_> = turns.iter().map(|turn| step * turn).collect();
            let mut inputs = drawn.to_vec();
            inputs[input] += step;
            self.at_inputs(&bodies.as_drawn(expr, &turned), &inputs)
        };
        let rate = at(STEP).zip(at(-STEP)).map(|(ahead, behind)| (ahead - behind) / (2.0 * STEP));
        // Differences of numbers of order one, over the step.
        rate.filter(|rate| rate.abs() > 1e-9).unwrap_or(0.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diagnostics::Diagnostics;
    use crate::model::drawn::reading::framing;
    use crate::model::drawn::reading::reader::Reader;
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
}
