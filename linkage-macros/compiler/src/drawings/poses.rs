//! The poses of machines beside their drawings.

use super::cases;
use crate::diagnostics::Diagnostics;
use crate::exact::Exact;
use crate::ir::interpret::{Given, Number};
use crate::ir::program::Program;
use crate::model::mechanism::{Mechanism, OutputKind};
use crate::oracle::{Digits, defaults, values};
use crate::syntax::tree::{Declaration, StatementKind};
use crate::{equations, model, passes, syntax};

/// A machine as it is declared, and the program of its solver.
struct Machine {
    tree: Declaration,
    mechanism: Mechanism,
    program: Program,
}

fn machine(source: &str) -> Option<Machine> {
    let mut diagnostics = Diagnostics::new();
    let tokens = source.parse().expect("these are tokens");
    let tree = syntax::parse(tokens, &mut diagnostics).expect("it has a name");
    let mechanism = model::resolve(&tree, &mut diagnostics).ok();
    diagnostics.into_mistakes();
    let mechanism = mechanism?;
    let program = equations::derive(&mechanism, passes::RULES);
    Some(Machine { tree, mechanism, program })
}

impl Machine {
    /// The pins by name, at these inputs.
    fn pins(&self, inputs: &[f64]) -> Vec<(String, [Digits; 2])> {
        let given = Given {
            inputs: inputs.iter().map(|&value| [value, 0.0, 0.0].map(Digits::float)).collect(),
            params: defaults(&self.mechanism),
            loads: Vec::new(),
            drives: Vec::new(),
            unit: None,
        };
        let all = values(&self.program, "position", &given);
        let (mut row, mut pins) = (0, Vec::new());
        for output in &self.mechanism.outputs {
            match &output.kind {
                OutputKind::Point(_) => {
                    let at = [all[row].clone(), all[row + 1].clone()];
                    pins.push((output.field.to_string(), at));
                    row += 2;
                }
                OutputKind::Link { direction, slide, .. } => {
                    row += 2 * usize::from(*direction) + usize::from(*slide);
                }
                OutputKind::Angle(_) => row += 2,
                _ => row += 1,
            }
        }

        pins.extend(self.drawn(true));
        pins
    }

    /// The places of the drawing: those of the ground, or of the pins.
    fn drawn(&self, of_ground: bool) -> Vec<(String, [Digits; 2])> {
        let points = self.tree.statements.iter().flat_map(|statement| match &statement.kind {
            StatementKind::Ground { points } if of_ground => &points[..],
            StatementKind::Pin { points } if !of_ground => &points[..],
            _ => &[],
        });
        let number = |expr: &syntax::tree::Expr| Digits::exact(&literal(expr));
        points.map(|(name, at)| (name.to_string(), at.each_ref().map(number))).collect()
    }

    /// The pins of every link.
    fn links(&self) -> Vec<Vec<String>> {
        let links = self.tree.statements.iter().flat_map(|statement| match &statement.kind {
            StatementKind::Link { links, .. } => &links[..],
            _ => &[],
        });
        links.map(|link| link.pins.iter().map(ToString::to_string).collect()).collect()
    }
}

/// The value of a decimal.
fn literal(expr: &syntax::tree::Expr) -> Exact {
    use syntax::tree::ExprKind;
    match &expr.kind {
        ExprKind::Number { digits, .. } => Exact::decimal(digits).expect("a decimal"),
        ExprKind::Negate(inner) => literal(inner).neg(),
        _ => panic!("the drawings of these tests are decimals"),
    }
}

fn place<'p>(pins: &'p [(String, [Digits; 2])], name: &str) -> &'p [Digits; 2] {
    &pins.iter().find(|(known, _)| known == name).expect("every pin is an output").1
}

/// The product of the conjugate of the first vector with the second: the cosine and the sine
/// between them times their lengths.
fn product(a: [Digits; 2], b: [Digits; 2]) -> [f64; 2] {
    let [dot, cross] =
        [a[0].mul(&b[0]).add(&a[1].mul(&b[1])), a[0].mul(&b[1]).sub(&a[1].mul(&b[0]))];
    [dot.to_f64(), cross.to_f64()]
}

fn between(pins: &[(String, [Digits; 2])], from: &str, to: &str) -> [Digits; 2] {
    let [from, to] = [place(pins, from), place(pins, to)];
    [to[0].sub(&from[0]), to[1].sub(&from[1])]
}

#[test]
fn every_pin_is_where_it_is_drawn_and_every_body_stays_rigid() {
    let (mut dyads, mut searched) = (0, 0);
    for case in cases() {
        let Some(machine) = machine(&case.declaration()) else { continue };
        if !machine.mechanism.unknowns.is_empty() {
            // In a hundred digits a search takes a second.
            searched += 1;
            if searched % 4 != 1 {
                continue;
            }
        }
        let inputs = machine.mechanism.drawn.clone().expect("drives determine the inputs");
        let now = machine.pins(&inputs);
        for (name, at) in machine.drawn(false) {
            let found = place(&now, &name);
            for i in 0..2 {
                let off = found[i].sub(&at[i]).to_f64().abs();
                // The inputs are floats of the drawing's angles.
                assert!(off < 1e-12, "{}: {name} is off by {off:e}", case.name);
            }
        }
        let drawn = [machine.drawn(true), machine.drawn(false)].concat();
        let beside: &[i32] = match machine.mechanism.unknowns.is_empty() {
            true => &[-5, -4, -3, -2, -1, 1, 2, 3, 4, 5],
            false => &[1],
        };
        for &step in beside {
            let inputs: Vec<_> =
                inputs.iter().map(|input| input + 1e-6 * f64::from(step)).collect();
            let now = machine.pins(&inputs);
            for link in machine.links() {
                let [first, rest @ ..] = &link[..] else { continue };
                for (i, a) in rest.iter().enumerate() {
                    for b in &rest[i..] {
                        let [was, is] = [&drawn, &now]
                            .map(|pins| product(between(pins, first, a), between(pins, first, b)));
                        for (was, is) in was.iter().zip(is) {
                            let off = (was - is).abs();
                            assert!(off < 1e-14, "{}: {a}, {b} off by {off:e}", case.name);
                        }
                    }
                }
            }
        }
        dyads += usize::from(machine.mechanism.unknowns.is_empty());
    }
    assert_eq!([dyads, searched], [25, 22]);
}
