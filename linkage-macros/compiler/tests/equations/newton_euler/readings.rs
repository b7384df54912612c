//! Readings of earlier links in dimensions, and how much the dimensions change with them.

use super::whole;
use crate::ir::interpret::Number;
use crate::model::mechanism::{Mechanism, Operator, Scalar};
use crate::oracle::Digits;

/// Collects the readings of earlier links in an expression, each once.
pub(super) fn readings(mechanism: &Mechanism, expr: &Scalar, leaves: &mut Vec<Scalar>) {
    match expr {
        Scalar::Slide(_)
        | Scalar::Coordinate(..)
        | Scalar::Distance(_)
        | Scalar::Offset(..)
        | Scalar::Unknown(_)
        | Scalar::Tracked(..) => {
            if !leaves.iter().any(|known| same(known, expr)) {
                leaves.push(expr.clone());
            }
        }
        Scalar::Let(id) => readings(mechanism, &mechanism.lets[id.index()].rest, leaves),
        Scalar::Negate(value) => readings(mechanism, value, leaves),
        Scalar::AboveZero(inner) => readings(mechanism, &inner.value, leaves),
        Scalar::Chain(first, rest) => {
            readings(mechanism, first, leaves);
            rest.iter().for_each(|(_, operand)| readings(mechanism, operand, leaves));
        }
        Scalar::Call(_, arguments) => {
            arguments.iter().for_each(|argument| readings(mechanism, argument, leaves));
        }
        Scalar::Constant(_)
        | Scalar::Input(_)
        | Scalar::Param(_)
        | Scalar::Load(_)
        | Scalar::Pull => {}
        Scalar::Twist(_) | Scalar::Rate(_) | Scalar::Law(_) | Scalar::Effort(..) => {
            unreachable!("none of these is part of a dimension")
        }
    }
}

fn same(a: &Scalar, b: &Scalar) -> bool {
    format!("{a:?}") == format!("{b:?}")
}

/// ∂expr/∂leaf by a central difference with the step 2⁻¹⁰⁰: good to h² = 2⁻²⁰⁰.
pub(super) fn slope(
    mechanism: &Mechanism,
    expr: &Scalar,
    leaf: &Scalar,
    given: &dyn Fn(&Scalar) -> Digits,
) -> Digits {
    let step = Digits::float(0.5f64.powi(100));
    let at = |shift: &Digits| {
        let leaf_at = |asked: &Scalar| match same(asked, leaf) {
            true => given(asked).add(shift),
            false => given(asked),
        };
        evaluate(mechanism, expr, &leaf_at)
    };
    at(&step).sub(&at(&step.neg())).div(&step.mul(&whole(2)))
}

pub(super) fn evaluate(
    mechanism: &Mechanism,
    expr: &Scalar,
    given: &dyn Fn(&Scalar) -> Digits,
) -> Digits {
    let value = |expr: &Scalar| evaluate(mechanism, expr, given);
    match expr {
        Scalar::Constant(constant) => Digits::exact(constant),
        Scalar::Let(id) => value(&mechanism.lets[id.index()].rest),
        Scalar::Negate(inner) => value(inner).neg(),
        Scalar::AboveZero(inner) => value(&inner.value),
        Scalar::Chain(first, rest) => rest.iter().fold(value(first), |a, (operator, b)| {
            let b = value(b);
            match operator {
                Operator::Add => a.add(&b),
                Operator::Sub => a.sub(&b),
                Operator::Mul => a.mul(&b),
                Operator::Div => a.div(&b),
            }
        }),
        Scalar::Call(function, arguments) => {
            let values: Vec<_> = arguments.iter().map(value).collect();
            Digits::of(*function, &values.iter().collect::<Vec<_>>())
        }
        leaf => given(leaf),
    }
}
