//! Readings of earlier links in dimensions, and how much the dimensions change with them.

use super::whole;
use crate::ir::interpret::Number;
use crate::model::mechanism::{Expr, Mechanism, Operator};
use crate::oracle::Digits;

/// Collects the readings of earlier links in an expression, each once.
pub(super) fn readings(mechanism: &Mechanism, expr: &Expr, leaves: &mut Vec<Expr>) {
    match expr {
        Expr::Slide(_)
        | Expr::Coordinate(..)
        | Expr::Distance(_)
        | Expr::Offset(..)
        | Expr::Unknown(_) => {
            if !leaves.iter().any(|known| same(known, expr)) {
                leaves.push(expr.clone());
            }
        }
        Expr::Let(id) => readings(mechanism, &mechanism.lets[id.index()].rest, leaves),
        Expr::Negate(value) => readings(mechanism, value, leaves),
        Expr::AboveZero(inner) => readings(mechanism, &inner.value, leaves),
        Expr::Chain(first, rest) => {
            readings(mechanism, first, leaves);
            rest.iter().for_each(|(_, operand)| readings(mechanism, operand, leaves));
        }
        Expr::Call(_, arguments) => {
            arguments.iter().for_each(|argument| readings(mechanism, argument, leaves));
        }
        Expr::Constant(_) | Expr::Input(_) | Expr::Param(_) | Expr::Load(_) | Expr::Pull => {}
        Expr::Twist(_) | Expr::Rate(_) | Expr::Law(_) | Expr::Effort(..) => {
            unreachable!("none of these is part of a dimension")
        }
    }
}

fn same(a: &Expr, b: &Expr) -> bool {
    format!("{a:?}") == format!("{b:?}")
}

/// ∂expr/∂leaf by a central difference with the step 2⁻¹⁰⁰: good to h² = 2⁻²⁰⁰.
pub(super) fn slope(
    mechanism: &Mechanism,
    expr: &Expr,
    leaf: &Expr,
    given: &dyn Fn(&Expr) -> Digits,
) -> Digits {
    let step = Digits::float(0.5f64.powi(100));
    let at = |shift: &Digits| {
        let leaf_at = |asked: &Expr| match same(asked, leaf) {
            true => given(asked).add(shift),
            false => given(asked),
        };
        evaluate(mechanism, expr, &leaf_at)
    };
    at(&step).sub(&at(&step.neg())).div(&step.mul(&whole(2)))
}

pub(super) fn evaluate(
    mechanism: &Mechanism,
    expr: &Expr,
    given: &dyn Fn(&Expr) -> Digits,
) -> Digits {
    let value = |expr: &Expr| evaluate(mechanism, expr, given);
    match expr {
        Expr::Constant(constant) => Digits::exact(constant),
        Expr::Let(id) => value(&mechanism.lets[id.index()].rest),
        Expr::Negate(inner) => value(inner).neg(),
        Expr::AboveZero(inner) => value(&inner.value),
        Expr::Chain(first, rest) => rest.iter().fold(value(first), |a, (operator, b)| {
            let b = value(b);
            match operator {
                Operator::Add => a.add(&b),
                Operator::Sub => a.sub(&b),
                Operator::Mul => a.mul(&b),
                Operator::Div => a.div(&b),
            }
        }),
        Expr::Call(function, arguments) => {
            let values: Vec<_> = arguments.iter().map(value).collect();
            Digits::of(*function, &values.iter().collect::<Vec<_>>())
        }
        leaf => given(leaf),
    }
}
