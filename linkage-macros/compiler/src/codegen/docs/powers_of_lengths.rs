//! The powers of lengths that numbers have, by which constants among them are written with a unit or without.
//!
//! A resolved constant is a number of metres, of radians, or of nothing: what stands beside it says which.

use crate::function::Measures;
use crate::model::mechanism::{Mechanism, Operator, ParamKind, Scalar};

/// The unit in which a number is written.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum DeclaredUnit {
    Length,
    Angle,
    /// Metres or radians, or no unit at all.
    Bare,
}

impl DeclaredUnit {
    const fn power(self) -> i32 {
        matches!(self, Self::Length) as i32
    }

    const fn of_power(power: i32) -> Self {
        if power == 1 { Self::Length } else { Self::Bare }
    }
}

/// The power of a length that a number has; none of a constant, which takes what its place asks for.
pub(super) fn power(mechanism: &Mechanism, value: &Scalar) -> Option<i32> {
    let power = |value: &Scalar| power(mechanism, value);
    match value {
        Scalar::Constant(_) => None,
        Scalar::Input(input) => Some(mechanism.inputs[input.index()].dimension.length),
        Scalar::Unknown(unknown) => Some(mechanism.unknowns[unknown.index()].dimension.length),
        Scalar::Param(param) => match mechanism.params[param.index()].kind {
            ParamKind::Number { dimension, .. } => Some(dimension.length),
            ParamKind::Mode { .. } => Some(0),
        },
        Scalar::Slide(_) | Scalar::Coordinate(..) | Scalar::Distance(_) | Scalar::Offset(..) => {
            Some(1)
        }
        Scalar::Let(id) => power(&mechanism.lets[id.index()].rest),
        Scalar::AboveZero(number) => power(&number.value),
        Scalar::Negate(inner) => power(inner),
        Scalar::Chain(first, rest) => {
            rest.iter().fold(power(first), |so_far, (operator, operand)| match operator {
                Operator::Add | Operator::Sub => so_far.or(power(operand)),
                Operator::Mul => Some(so_far? + power(operand)?),
                Operator::Div => Some(so_far? - power(operand)?),
            })
        }
        Scalar::Call(function, arguments) => match function.measures() {
            Measures::Common => arguments.iter().find_map(power),
            Measures::Root => power(&arguments[0]).map(|of| of / 2),
            Measures::Power => None,
            _ => Some(0),
        },
        Scalar::Load(_)
        | Scalar::Pull
        | Scalar::Law(_)
        | Scalar::Twist(_)
        | Scalar::Effort(..)
        | Scalar::Rate(_) => Some(0),
    }
}

/// The units of the operands of products and quotients that have this unit together: of a constant what is left by the
/// others.
pub(super) fn units_of_factors(
    mechanism: &Mechanism,
    first: &Scalar,
    rest: &[(Operator, Scalar)],
    unit: DeclaredUnit,
) -> Vec<DeclaredUnit> {
    let signs = [1]
        .into_iter()
        .chain(rest.iter().map(|(operator, _)| if *operator == Operator::Div { -1 } else { 1 }));
    let operands = [first].into_iter().chain(rest.iter().map(|(_, operand)| operand));
    let mut factors: Vec<(i32, Option<i32>)> =
        signs.zip(operands.map(|operand| power(mechanism, operand))).collect();
    let mut left =
        unit.power() - factors.iter().map(|(sign, of)| sign * of.unwrap_or(0)).sum::<i32>();
    for (sign, of) in &mut factors {
        if of.is_none() && left * *sign > 0 {
            *of = Some(1);
            left -= *sign;
        }
    }
    factors.iter().map(|(_, of)| DeclaredUnit::of_power(of.unwrap_or(0))).collect()
}

/// The common unit of a function's arguments.
pub(super) fn unit_of_arguments(
    mechanism: &Mechanism,
    measures: Measures,
    arguments: &[Scalar],
    unit: DeclaredUnit,
) -> DeclaredUnit {
    let known = arguments.iter().find_map(|argument| power(mechanism, argument));
    match (measures, known) {
        (Measures::Common | Measures::Direction | Measures::Number, Some(power)) => {
            DeclaredUnit::of_power(power)
        }
        (Measures::Common, None) => unit,
        _ => DeclaredUnit::Bare,
    }
}
