//! The powers of lengths that numbers have, by which constants among them are written with a unit or without.
//!
//! A resolved constant is a number of metres, of radians, or of nothing: what stands beside it says which.

use crate::function::Measures;
use crate::model::mechanism::{Mechanism, Operator, ParamKind, Scalar};

/// The unit in which a number is written.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum DeclaredUnit {
    Length,
    /// A power of metres, two or higher.
    Power(i32),
    Angle,
    /// Metres or radians, or no unit at all.
    Bare,
}

impl DeclaredUnit {
    const fn power(self) -> i32 {
        match self {
            Self::Length => 1,
            Self::Power(power) => power,
            Self::Angle | Self::Bare => 0,
        }
    }

    pub(super) const fn of_power(power: i32) -> Self {
        match power {
            1 => Self::Length,
            2.. => Self::Power(power),
            _ => Self::Bare,
        }
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
        Scalar::Tracked(group, index) => {
            let is_angle = mechanism.tracked[group.index()].fit.unknowns[*index].is_angle;
            Some(if is_angle { 0 } else { 1 })
        }
        Scalar::Let(id) => power(&mechanism.lets[id.index()].rest),
        Scalar::AboveZero(number) => power(&number.value),
        Scalar::Negate(inner) => power(inner),
        Scalar::Chain(first, rest) => power_of_chain(mechanism, first, rest),
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

fn power_of_chain(
    mechanism: &Mechanism,
    first: &Scalar,
    rest: &[(Operator, Scalar)],
) -> Option<i32> {
    let power = |value: &Scalar| power(mechanism, value);
    rest.iter().fold(power(first), |so_far, (operator, operand)| match operator {
        Operator::Add | Operator::Sub => so_far.or(power(operand)),
        Operator::Mul => Some(so_far? + power(operand)?),
        Operator::Div => Some(so_far? - power(operand)?),
    })
}

/// The units of a chain's operands, each operator on what the one before has made, which have this unit together.
pub(super) fn units_of_operands(
    mechanism: &Mechanism,
    first: &Scalar,
    rest: &[(Operator, Scalar)],
    unit: DeclaredUnit,
) -> Vec<DeclaredUnit> {
    if rest.is_empty() {
        return vec![unit];
    }
    let is_sum = |sign: Operator| matches!(sign, Operator::Add | Operator::Sub);
    let Some(last_sum) = rest.iter().rposition(|(sign, _)| is_sum(*sign)) else {
        return units_of_powers(mechanism, power(mechanism, first), rest, unit);
    };
    let (sum, factors) = rest.split_at(last_sum + 1);
    let of_sum = power_of_chain(mechanism, first, sum);
    let of_factors = units_of_powers(mechanism, of_sum, factors, unit);
    let (before, (_, term)) = (&sum[..last_sum], &sum[last_sum]);
    // All terms of a sum have one unit.
    let own = match of_sum.or(power(mechanism, term)) {
        Some(power) if power > 0 => DeclaredUnit::of_power(power),
        _ if factors.is_empty() => unit,
        _ => of_factors[0],
    };
    let mut units = units_of_operands(mechanism, first, before, own);
    units.push(own);
    units.extend(&of_factors[1..]);
    units
}

/// The units of factors and divisors that have this unit together, the first of which has this power of a length: the first
/// constant that can have it has what is left by the others.
fn units_of_powers(
    mechanism: &Mechanism,
    first: Option<i32>,
    rest: &[(Operator, Scalar)],
    unit: DeclaredUnit,
) -> Vec<DeclaredUnit> {
    let signs = rest.iter().map(|(operator, _)| if *operator == Operator::Div { -1 } else { 1 });
    let powers = rest.iter().map(|(_, operand)| power(mechanism, operand));
    let mut factors = vec![(1, first)];
    factors.extend(signs.zip(powers));
    let mut left =
        unit.power() - factors.iter().map(|(sign, of)| sign * of.unwrap_or(0)).sum::<i32>();
    for (sign, of) in &mut factors {
        if of.is_none() && left * *sign > 0 {
            *of = Some(left * *sign);
            left = 0;
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
        (
            Measures::Common | Measures::Direction | Measures::Number | Measures::Root,
            Some(power),
        ) => DeclaredUnit::of_power(power),
        (Measures::Common, None) => unit,
        (Measures::Root, None) => DeclaredUnit::of_power(2 * unit.power()),
        _ => DeclaredUnit::Bare,
    }
}
