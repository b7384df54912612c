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
    pub fn motions(&mut self, bodies: &Bodies<'_>) -> Vec<InputRates> {
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
