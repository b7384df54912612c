//! The inputs of the drawing: those at which all drives and driven lengths are as they are drawn.
//!
//! Where there are more of them than inputs, as where gears turn several links by one input, they have to agree with
//! the drawing: otherwise the modes and intervals that it gives are those of another machine.

use std::f64::consts::TAU;

use proc_macro2::Ident;

use crate::chain::machine::{Driven, Driving, GROUND};
use crate::chain::plane::Complex;
use crate::diagnostics::Extent;
use crate::syntax::tree::{Expr, PointPlace, PointStatement, StatementKind};

use crate::model::drawn::drive_equations::motions::{slid_by, turned_by};
use crate::model::drawn::outline::bodies::Bodies;
use crate::model::drawn::outline::lengths::in_words;
use crate::model::drawn::outline::messages::drive_as_written;
use crate::model::drawn::reading::values::{Measured, value};
use crate::model::mechanism::{Mechanism, Scalar};

/// The angle, the part of the machine's size and that of a length by which a drive may differ from the drawing: about
/// what a drawing is off by whose small links are drawn to two digits.
const CARELESS: f64 = 0.05;
/// The turns by which the angle of a link that is geared up may differ from what is drawn.
const TURNS: i32 = 4;

/// The thing that a number gives and that the drawing has as well.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Given {
    Drive(usize),
    Length,
    /// A coordinate of a point that inputs move.
    Place,
    /// The angle of a crank or the slide of a slider that is declared by hand.
    Driver,
}

/// A drive, a driven length, or what a declaration by hand drives, and its value in the drawing.
struct DrawnEquation<'t> {
    value: &'t Expr,
    /// It by the inputs, links standing as they are drawn; none where it is no number.
    number: Option<Scalar>,
    drawn: f64,
    given: Given,
    /// The body that is driven.
    body: usize,
    is_angle: bool,
}

impl DrawnEquation<'_> {
    /// The difference of a value from the drawing; angles differ by less than half a turn.
    fn off(&self, value: f64) -> f64 {
        let off = value - self.drawn;
        if self.is_angle { off - TAU * (off / TAU).round() } else { off }
    }

    /// The thing that is given, in words.
    fn told(&self, bodies: &Bodies<'_>) -> String {
        let of = bodies.name(self.body);
        match self.given {
            Given::Drive(drive) => {
                let drive = bodies.drives[drive].1;
                let own = format!("`drive {}`", drive_as_written(drive));
                if drive.written.is_some() { format!("{of} by {own}") } else { own }
            }
            Given::Length => format!("the length of {of}"),
            Given::Place => format!("the place of {of}"),
            Given::Driver => format!("what drives {of}"),
        }
    }

    fn in_words(&self, value: f64) -> String {
        match self.is_angle {
            true => degrees(Complex::turned(value).angle()),
            false => in_words(value),
        }
    }
}

fn equations<'t>(bodies: &Bodies<'t>) -> Vec<DrawnEquation<'t>> {
    let mut equations = Vec::new();
    for (index, (_, drive)) in bodies.drives.iter().enumerate() {
        let Driving { kind, bodies: [body, _], .. } = bodies.machine.drives[index];
        let (drawn, given) = (bodies.drawn_value(index), Given::Drive(index));
        let is_angle = kind == Driven::Angle;
        equations.push(equation(&drive.value, drawn, (given, body), is_angle));
    }
    for (index, link) in bodies.links.iter().enumerate() {
        if let (Some((length, None)), &[first, second]) = (&link.length, &link.pins[..]) {
            let between = bodies.machine.pins[second] - bodies.machine.pins[first];
            equations.push(equation(length, between.length(), (Given::Length, index + 1), false));
        }
        equations.extend(by_hand(bodies, index + 1));
    }
    equations
}

fn equation(
    value: &Expr,
    drawn: f64,
    (given, body): (Given, usize),
    is_angle: bool,
) -> DrawnEquation<'_> {
    DrawnEquation { value, number: None, drawn, given, body, is_angle }
}

/// The numbers that drive a body that is declared by hand, where the drawing says where it is: a point, a crank against
/// the ground, a slider on a guide of the ground.
fn by_hand<'t>(bodies: &Bodies<'t>, body: usize) -> Vec<DrawnEquation<'t>> {
    let link = bodies.link(body);
    let equation = |value, drawn, given, is_angle| equation(value, drawn, (given, body), is_angle);
    let place = |name: &Ident| {
        let pin = bodies.pin(name).filter(|&pin| bodies.pins[pin].on.is_none());
        pin.map(|pin| bodies.machine.pins[pin])
    };
    match &bodies.tree.statements[link.statement].kind {
        StatementKind::Point(PointStatement {
            name,
            on: None,
            place: PointPlace::Cartesian(at),
        }) => {
            let Some(drawn) = place(name) else { return Vec::new() };
            let coordinates = at.iter().zip([drawn.x, drawn.y]);
            coordinates.map(|(value, drawn)| equation(value, drawn, Given::Place, false)).collect()
        }
        StatementKind::Group(group) if link.is_given => {
            let end = group.pin.as_ref().and_then(place);
            let joint = group.legs.first().and_then(|leg| leg.joint.as_ref());
            let (Some(end), Some(joint)) = (end, joint) else { return Vec::new() };
            let of_crank = turned_by(group)
                .zip(place(joint))
                .map(|(angle, pivot)| equation(angle, (end - pivot).angle(), Given::Driver, true));
            let guide =
                bodies.guides.iter().find(|guide| guide.name == joint && guide.on == GROUND);
            let of_slider = slid_by(group).zip(guide).map(|(slide, guide)| {
                let [through, along] = [&guide.line.through, &guide.line.along]
                    .map(|[x, y]| Complex::new(x.value, y.value));
                equation(slide, along.unit().dot(end - through), Given::Driver, false)
            });
            of_crank.into_iter().chain(of_slider).collect()
        }
        _ => Vec::new(),
    }
}

/// The equations of a drawing, which give its inputs.
pub struct DriveEquations<'b, 't> {
    bodies: &'b Bodies<'t>,
    mechanism: &'b Mechanism,
    all: Vec<DrawnEquation<'t>>,
}

impl Measured<'_> {
    pub fn equations<'b, 't>(&'b mut self, bodies: &'b Bodies<'t>) -> DriveEquations<'b, 't> {
        let mut all = equations(bodies);
        for equation in &mut all {
            let value = bodies.as_drawn(equation.value, &[]);
            equation.number = self.by_inputs(&value);
        }
        DriveEquations { bodies, mechanism: self.mechanism(), all }
    }

    /// The inputs at which the drives are as they are drawn; `None` where the drives do not determine
    /// them.
    pub(in crate::model::drawn) fn inputs_of_the_drawing(
        &mut self,
        bodies: &Bodies<'_>,
    ) -> Option<Vec<f64>> {
        self.equations(bodies).inputs()
    }

    /// The values of drives at the inputs of the drawing, with the whole turns of those whose angles they read.
    pub(in crate::model::drawn) fn driven(
        &mut self,
        bodies: &Bodies<'_>,
        inputs: Option<&[f64]>,
    ) -> Vec<f64> {
        let count = bodies.drives.len();
        let mut values: Vec<_> = (0..count).map(|drive| bodies.drawn_value(drive)).collect();
        let Some(inputs) = inputs else { return values };
        let mut turns = vec![0.0; bodies.frames.len()];
        // A drive may read what another one turns.
        for _ in 0..count {
            for (index, (_, drive)) in bodies.drives.iter().enumerate() {
                let value = bodies.as_drawn(&drive.value, &turns);
                values[index] = self.at_inputs(&value, inputs).unwrap_or(values[index]);
                let Driving { kind: Driven::Angle, bodies: [body, to], .. } =
                    bodies.machine.drives[index]
                else {
                    continue;
                };
                let turned = bodies.drawn_angle(to) + turns[to] + values[index];
                turns[body] = TAU * ((turned - bodies.drawn_angle(body)) / TAU).round();
            }
        }
        values
    }

    /// Reports a drive or a length that contradicts the drawing, or that no input brings to where it is drawn; `None`
    /// where there is one.
    pub(in crate::model::drawn) fn drives_agree(&mut self, bodies: &Bodies<'_>) -> Option<()> {
        let Some((at, message, reason)) = self.equations(bodies).contradiction() else {
            return Some(());
        };
        self.scope.diagnostics.error_because(at, message, reason);
        None
    }
}

impl DriveEquations<'_, '_> {
    fn inputs(&self) -> Option<Vec<f64>> {
        let count = self.count();
        // A function may be none where its secant ends.
        let rows = self.rows();
        let Some(rows) = rows.clone().filter(|rows| self.are_linear(rows)) else {
            let secant = rows.and_then(|rows| solved(rows, count));
            return self.approached(secant.map(|solution| solution.inputs));
        };
        let Solution { inputs, .. } = solved(rows.clone(), count)?;
        if self.disagreement(&inputs).is_none() {
            return Some(inputs);
        }
        Some(self.turned_on(&rows).unwrap_or(inputs))
    }

    /// The count of inputs.
    pub(super) fn count(&self) -> usize {
        self.mechanism.inputs.len()
    }

    /// The count of equations.
    pub(super) fn len(&self) -> usize {
        self.all.len()
    }

    /// The value of an equation at these inputs.
    fn value(&self, equation: &DrawnEquation<'_>, inputs: &[f64]) -> Option<f64> {
        value(equation.number.as_ref()?, self.mechanism, inputs)
    }

    /// The difference of an equation's value at these inputs from the drawing.
    pub(super) fn off(&self, index: usize, inputs: &[f64]) -> Option<f64> {
        let equation = &self.all[index];
        self.value(equation, inputs).map(|value| equation.off(value))
    }

    /// True if all equations are, as all but few are: their inputs are those of one system.
    fn are_linear(&self, rows: &[Vec<f64>]) -> bool {
        // No place where a function that bends comes back to its secant.
        const ELSEWHERE: [f64; 3] = [0.618, -0.773, 2.236];
        let count = self.count();
        self.all.iter().zip(rows).all(|(equation, row)| {
            ELSEWHERE.iter().all(|&at| {
                let terms = row[..count].iter().map(|coefficient| coefficient * at);
                let linear = equation.drawn - row[count] + terms.sum::<f64>();
                let found = self.value(equation, &vec![at; count]);
                // Sums of a few numbers of the machine's size are rounded by less.
                found.is_some_and(|found| (found - linear).abs() <= 1e-9 * (1.0 + found.abs()))
            })
        })
    }

    /// The inputs where an angle is drawn that is whole turns less than that of its drive.
    fn turned_on(&self, rows: &[Vec<f64>]) -> Option<Vec<f64>> {
        let count = self.count();
        let angles = self.all.iter().enumerate().filter(|(_, equation)| equation.is_angle);
        let ways = (-TURNS..=TURNS).filter(|turns| *turns != 0);
        let tried =
            ways.flat_map(|turns| angles.clone().map(move |(index, _)| (index, f64::from(turns))));
        let agreeing = tried.filter_map(|(index, turns)| {
            let mut rows = rows.to_vec();
            rows[index][count] += TAU * turns;
            let Solution { inputs, .. } = solved(rows, count)?;
            self.disagreement(&inputs).is_none().then_some(inputs)
        });
        // The one nearest to zero, as angles of the drawing are.
        let size = |inputs: &Vec<f64>| inputs.iter().map(|input| input.abs()).sum::<f64>();
        agreeing.min_by(|a, b| size(a).total_cmp(&size(b)))
    }

    /// The equations over the inputs, each with its right side last.
    fn rows(&self) -> Option<Vec<Vec<f64>>> {
        let row = |equation: &DrawnEquation<'_>| {
            let mut inputs = vec![0.0; self.count()];
            let rest = self.value(equation, &inputs)?;
            let mut row = Vec::new();
            for input in 0..inputs.len() {
                inputs[input] = 1.0;
                row.push(self.value(equation, &inputs)? - rest);
                inputs[input] = 0.0;
            }
            row.push(equation.drawn - rest);
            Some(row)
        };
        self.all.iter().map(row).collect()
    }

    /// The last equation that does not hold in the drawing, and its value there.
    fn disagreement(&self, inputs: &[f64]) -> Option<(usize, f64)> {
        self.all.iter().enumerate().rev().find_map(|(index, equation)| {
            let value = self.value(equation, inputs)?;
            let unit = match equation.given {
                _ if equation.is_angle => 1.0,
                Given::Length => equation.drawn,
                _ => self.bodies.machine.size(),
            };
            (equation.off(value).abs() > CARELESS * unit).then_some((index, value))
        })
    }

    /// The message about a drive or a length that contradicts the drawing, or that no input brings to where it is drawn,
    /// and where it stands; none where there is none.
    fn contradiction(&self) -> Option<(Extent, String, String)> {
        let (index, value) = match self.inputs() {
            Some(inputs) => {
                let (index, value) = self.disagreement(&inputs)?;
                (index, Some(value))
            }
            None => (self.never_as_drawn()?, None),
        };
        let equation = &self.all[index];
        let (link, told) = (self.bodies.name(equation.body), equation.told(self.bodies));
        let drawn = equation.in_words(equation.drawn);
        let (message, reason) = match value.map(|value| equation.in_words(value)) {
            Some(value) => (
                format!(
                    "{told} contradicts the drawing: it is {value} where the others are as drawn, and drawn as {drawn}"
                ),
                format!("draw {link} there, or change the value: in the drawing every drive holds"),
            ),
            None => (
                format!("{told} cannot be as drawn: no input was found at which it is {drawn}"),
                format!("draw {link} where its value takes it, or change the value"),
            ),
        };
        Some((equation.value.span, message, reason))
    }
}

/// An angle to a tenth of a degree.
fn degrees(angle: f64) -> String {
    format!("{:.1}°", angle.to_degrees())
}

/// The solution of linear equations, and the places of those that determine it.
pub(super) struct Solution {
    pub inputs: Vec<f64>,
    pub decided_by: Vec<usize>,
}

/// The solution of linear equations, each with its right side last; `None` where there is not exactly one.
pub(super) fn solved(mut rows: Vec<Vec<f64>>, count: usize) -> Option<Solution> {
    let mut order: Vec<usize> = (0..rows.len()).collect();
    for column in 0..count {
        // The first that says something of the input, so that a later one is what contradicts it. Coefficients are ratios
        // of gears and lengths of racks: far from rounding errors.
        let pivot = (column..rows.len()).find(|&row| rows[row][column].abs() > 1e-9)?;
        rows.swap(column, pivot);
        order.swap(column, pivot);
        let pivot = rows[column].clone();
        for (index, row) in rows.iter_mut().enumerate() {
            let factor = row[column] / pivot[column];
            if index != column {
                row.iter_mut().zip(&pivot).for_each(|(value, pivot)| *value -= factor * pivot);
            }
        }
    }
    let solution = (0..count).map(|i| rows[i][count] / rows[i][i]);
    let inputs = solution.map(|value| value.is_finite().then_some(value)).collect::<Option<_>>()?;
    order.truncate(count);
    Some(Solution { inputs, decided_by: order })
}
