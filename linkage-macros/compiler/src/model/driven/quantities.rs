//! The quantities that inputs are, for whoever drives them by other means than groups.

use proc_macro2::Ident;

use super::coordinate::{Coordinate, Moves};
use crate::syntax::tree::{BinaryOp, Declaration, Expr, ExprKind, StatementKind};

/// A quantity of a drawing, by the names of its parts.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum PlanarQuantity {
    /// The angle of a body, against another where there is one.
    Angle(String, Option<String>),
    /// The slide of a body.
    Slide(String),
    /// A coordinate of a point: 0 is x.
    Place(String, usize),
    /// The distance of two points.
    Distance([String; 2]),
}

/// A quantity that an input is, and the value of it.
pub(crate) struct DrivenQuantity {
    pub of: PlanarQuantity,
    value: Expr,
}

impl DrivenQuantity {
    /// The factor before the quantity, by the values of parameters: the input's change where the quantity changes by one.
    pub(crate) fn factor(&self, known: &dyn Fn(&Ident) -> Option<f64>) -> Option<f64> {
        Some(1.0 / slope(&self.value, known)?)
    }
}

/// The change of an expression where the input in it changes by one: it is affine.
fn slope(value: &Expr, known: &dyn Fn(&Ident) -> Option<f64>) -> Option<f64> {
    match &value.kind {
        ExprKind::Name(_) => Some(1.0),
        ExprKind::Negate(inner) => Some(-slope(inner, known)?),
        ExprKind::Chain(first, rest) => {
            let mut slope = slope(first, known)?;
            for (operator, operand) in rest {
                match operator {
                    BinaryOp::Add | BinaryOp::Sub => {}
                    BinaryOp::Mul => slope *= number(operand, known)?,
                    BinaryOp::Div => slope /= number(operand, known)?,
                }
            }
            Some(slope)
        }
        _ => None,
    }
}

/// A number of digits and parameters.
fn number(expr: &Expr, known: &dyn Fn(&Ident) -> Option<f64>) -> Option<f64> {
    match &expr.kind {
        ExprKind::Number { digits, units } if units.is_empty() => digits.parse().ok(),
        ExprKind::Name(name) => known(name),
        ExprKind::Negate(inner) => Some(-number(inner, known)?),
        ExprKind::Chain(first, rest) => {
            rest.iter().try_fold(number(first, known)?, |so_far, (operator, operand)| {
                let operand = number(operand, known)?;
                Some(match operator {
                    BinaryOp::Add => so_far + operand,
                    BinaryOp::Sub => so_far - operand,
                    BinaryOp::Mul => so_far * operand,
                    BinaryOp::Div => so_far / operand,
                })
            })
        }
        _ => None,
    }
}

/// The quantities of a declaration's inputs: those that they are, and what a `drive` or a length gives them.
pub(crate) fn driven_quantities(tree: &Declaration) -> Vec<(Ident, DrivenQuantity)> {
    let mut found = Vec::new();
    for statement in &tree.statements {
        match &statement.kind {
            StatementKind::Input(input) => {
                let all = input.names.iter().zip(&input.of);
                let all = all.filter_map(|(name, of)| Coordinate::of(name, of));
                found.extend(all.filter_map(|own| quantity(tree, own)));
            }
            StatementKind::Drive(drive) => {
                let ExprKind::Name(input) = &drive.value.kind else { continue };
                let own = [&drive.link, &drive.member];
                let to = drive.to.as_ref().map(|(link, member)| [link, member]);
                let of = of_link(own, to);
                found.extend(
                    of.map(|of| (input.clone(), DrivenQuantity { of, value: drive.value.clone() })),
                );
            }
            StatementKind::Link(link) => {
                let Some(fields) = &link.fields else { continue };
                let [drawn] = &link.links[..] else { continue };
                for value in fields.values() {
                    if let (ExprKind::Name(input), [p, q]) = (&value.kind, &drawn.pins[..]) {
                        let of = PlanarQuantity::Distance([p.to_string(), q.to_string()]);
                        found.push((input.clone(), DrivenQuantity { of, value: value.clone() }));
                    }
                }
            }
            _ => {}
        }
    }
    found
}

fn of_link([link, member]: [&Ident; 2], to: Option<[&Ident; 2]>) -> Option<PlanarQuantity> {
    match &member.to_string()[..] {
        "angle" => {
            Some(PlanarQuantity::Angle(link.to_string(), to.map(|[other, _]| other.to_string())))
        }
        "slide" => Some(PlanarQuantity::Slide(link.to_string())),
        _ => None,
    }
}

fn quantity(tree: &Declaration, coordinate: Coordinate<'_>) -> Option<(Ident, DrivenQuantity)> {
    let of = match coordinate.moves {
        Moves::Link(own, to) => of_link(own, to)?,
        Moves::Length([link, _]) => {
            let mut links = tree.statements.iter().filter_map(|statement| match &statement.kind {
                StatementKind::Link(of) => of.links.iter().find(|drawn| drawn.name == *link),
                _ => None,
            });
            let [p, q] = &links.next()?.pins[..] else { return None };
            PlanarQuantity::Distance([p.to_string(), q.to_string()])
        }
        Moves::Place(point, axis) => PlanarQuantity::Place(point.to_string(), axis),
        Moves::Distance(points) => PlanarQuantity::Distance(points.map(Ident::to_string)),
    };
    Some((coordinate.name.clone(), DrivenQuantity { of, value: coordinate.value }))
}
