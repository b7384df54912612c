//! A quantity that is an input: what moves, and the value that it has at a value of the input.

use proc_macro2::Ident;

use crate::diagnostics::Extent;
use crate::syntax::tree::{BinaryOp, Expr, ExprKind};

use crate::model::as_written::text;

/// A thing that an input moves, by the names that were written.
#[derive(Clone)]
pub(super) enum Moves<'t> {
    /// A link's member, and the one that it is measured against.
    Link([&'t Ident; 2], Option<[&'t Ident; 2]>),
    /// The length of a link, and its member.
    Length([&'t Ident; 2]),
    /// A coordinate of a point: its index.
    Place(&'t Ident, usize),
    Distance([&'t Ident; 2]),
}

/// An input, what it moves and how far.
pub(super) struct Coordinate<'t> {
    pub name: &'t Ident,
    pub moves: Moves<'t>,
    /// The value of what it moves.
    pub value: Expr,
    /// The quantity as it is written.
    pub written: String,
    /// Where the input and its quantity are written.
    pub at: Extent,
}

impl Moves<'_> {
    /// True if this is the same quantity as the other.
    pub(super) fn is(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Link(own, to), Self::Link(other, against)) => own == other && to == against,
            (Self::Length(own), Self::Length(other)) => own == other,
            (Self::Place(own, axis), Self::Place(other, along)) => own == other && axis == along,
            (Self::Distance([p, q]), Self::Distance(other)) => {
                *other == [*p, *q] || *other == [*q, *p]
            }
            _ => false,
        }
    }
}

impl<'t> Coordinate<'t> {
    /// The coordinate of an input; `None` where the expression is not one quantity.
    pub(super) fn of(name: &'t Ident, of: &'t Expr) -> Option<Self> {
        let at = Extent::from(name.span()).to(of.span);
        let value = Expr { kind: ExprKind::Name(name.clone()), span: at };
        let (moves, value) = moved(of, value)?;
        Some(Self { name, moves, value, written: text(of), at })
    }

    /// The kind of the input, at the word that it follows from.
    pub(super) fn kind(&self) -> Ident {
        let (word, at) = match &self.moves {
            Moves::Link([_, member], _) if *member == "angle" => ("angle", member),
            Moves::Link([_, member], _) | Moves::Length([_, member]) => ("length", member),
            Moves::Place(point, _) | Moves::Distance([point, _]) => ("length", point),
        };
        Ident::new(word, at.span())
    }
}

/// True if this part of an expression, by itself, is one of the machine.
pub(super) fn is_of_the_machine(part: &Expr) -> bool {
    match &part.kind {
        ExprKind::Member(..) | ExprKind::Part(..) | ExprKind::Mistake => true,
        ExprKind::Call(function, _) => function == "distance",
        _ => false,
    }
}

fn is_constant(expr: &Expr) -> bool {
    let mut found = false;
    expr.each_part(&mut |part| found |= is_of_the_machine(part));
    !found
}

/// The thing that an expression of this value moves, and the value of that.
fn moved(expr: &Expr, value: Expr) -> Option<(Moves<'_>, Expr)> {
    let span = value.span;
    let chain = |value: Expr, rest| Expr { kind: ExprKind::Chain(Box::new(value), rest), span };
    match &expr.kind {
        ExprKind::Negate(inner) => moved(inner, Expr { span, ..value.negated() }),
        ExprKind::Chain(first, rest) if matches!(rest[0].0, BinaryOp::Add | BinaryOp::Sub) => {
            let against = match (&first.kind, &rest[0]) {
                (
                    ExprKind::Member(link, member),
                    (BinaryOp::Sub, Expr { kind: ExprKind::Member(to, angle), .. }),
                ) if member == "angle" && angle == "angle" => Some(([link, member], [to, angle])),
                _ => None,
            };
            let added = &rest[usize::from(against.is_some())..];
            if !added.iter().all(|(_, operand)| is_constant(operand)) {
                return None;
            }
            let taken = added.iter().map(|(operator, operand)| {
                let back = if *operator == BinaryOp::Add { BinaryOp::Sub } else { BinaryOp::Add };
                (back, operand.clone())
            });
            let taken: Vec<_> = taken.collect();
            let value = if taken.is_empty() { value } else { chain(value, taken) };
            match against {
                Some((own, to)) => Some((Moves::Link(own, Some(to)), value)),
                None => moved(first, value),
            }
        }
        ExprKind::Chain(first, rest) => {
            let ((_, last), others) = rest.split_last()?;
            let is_product = rest.iter().all(|(operator, _)| *operator == BinaryOp::Mul);
            let mut factors =
                std::iter::once(&**first).chain(others.iter().map(|(_, other)| other));
            if !is_product || !factors.all(is_constant) {
                return None;
            }
            let factor = match others {
                [] => (**first).clone(),
                _ => {
                    Expr { kind: ExprKind::Chain(first.clone(), others.to_vec()), span: first.span }
                }
            };
            moved(last, chain(value, vec![(BinaryOp::Div, factor)]))
        }
        _ => Some((whole(expr)?, value)),
    }
}

/// The thing that is a quantity by itself.
fn whole(expr: &Expr) -> Option<Moves<'_>> {
    match &expr.kind {
        ExprKind::Member(owner, member) => match &member.to_string()[..] {
            "x" => Some(Moves::Place(owner, 0)),
            "y" => Some(Moves::Place(owner, 1)),
            "length" => Some(Moves::Length([owner, member])),
            "angle" | "slide" => Some(Moves::Link([owner, member], None)),
            _ => None,
        },
        ExprKind::Call(function, arguments) if function == "distance" => match &arguments[..] {
            [
                Expr { kind: ExprKind::Name(first), .. },
                Expr { kind: ExprKind::Name(second), .. },
            ] => Some(Moves::Distance([first, second])),
            _ => None,
        },
        _ => None,
    }
}
