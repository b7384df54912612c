//! Numbers of a mechanism as a declaration has them.

use std::collections::BTreeSet;

use proc_macro2::Ident;

use super::powers_of_lengths::{DeclaredUnit, unit_of_arguments, units_of_operands};
use crate::exact::Exact;
use crate::model::mechanism::{
    Axis, GuideId, InputId, LinkId, Mechanism, Operator, ParamId, PointId, Scalar,
};

/// A constant, without error where its text is not too long.
pub(super) fn constant(value: &Exact, unit: DeclaredUnit) -> String {
    match unit {
        _ if value.is_zero() => "0".to_string(),
        DeclaredUnit::Bare => match decimal(value) {
            Some(number) => number,
            None => format!("({})", formula(value).unwrap_or_else(|| float(value))),
        },
        DeclaredUnit::Length => length(value),
        DeclaredUnit::Power(power) => in_unit(value, &format!("(m^{power})")),
        DeclaredUnit::Angle => {
            let degrees = Exact::pi().div(&Exact::integer(180)).and_then(|one| value.div(&one));
            match (degrees.as_ref().and_then(decimal), formula(value)) {
                (Some(degrees), _) => format!("{degrees}deg"),
                (None, Some(angle)) => angle.replace("pi", "180deg"),
                (None, None) => format!("{}rad", float(value)),
            }
        }
    }
}

/// In millimetres below a metre.
fn length(value: &Exact) -> String {
    let millimetres = value.mul(&Exact::integer(1000));
    let (number, unit) =
        if value.to_f64().abs() < 1.0 { (&millimetres, "mm") } else { (value, "m") };
    in_unit(number, unit)
}

fn in_unit(number: &Exact, unit: &str) -> String {
    match (decimal(number), formula(number)) {
        (Some(number), _) => format!("{number}{unit}"),
        (None, Some(number)) => format!("({number}) * 1{unit}"),
        (None, None) => format!("{}{unit}", float(number)),
    }
}

/// The digits of a number that is a short decimal.
fn decimal(value: &Exact) -> Option<String> {
    let text = value.to_string();
    let digits = text.strip_prefix('-').unwrap_or(&text);
    let is_decimal = digits.bytes().all(|digit| digit.is_ascii_digit() || digit == b'.');
    is_decimal.then_some(text)
}

/// The operations that a number is made by, if these are few.
fn formula(value: &Exact) -> Option<String> {
    Some(value.to_string()).filter(|text| !text.contains(['~', '^']))
}

fn float(value: &Exact) -> String {
    format!("{:?}", value.to_f64())
}

/// Writes statements, and notes which inputs and parameters they read.
pub(super) struct Declared<'m> {
    pub(super) mechanism: &'m Mechanism,
    pub(super) inputs: BTreeSet<usize>,
    pub(super) params: BTreeSet<usize>,
}

impl Declared<'_> {
    pub(super) fn number(&mut self, value: &Scalar, unit: DeclaredUnit) -> String {
        match value {
            Scalar::Constant(value) => constant(value, unit),
            Scalar::Input(input) => self.input(*input),
            Scalar::Param(param) => self.param(*param),
            Scalar::Load(load) => self.mechanism.dynamics.loads[load.index()].name.to_string(),
            Scalar::Unknown(unknown) => self.mechanism.unknowns[unknown.index()].name.to_string(),
            Scalar::Tracked(group, index) => {
                self.mechanism.tracked[group.index()].fit.unknowns[*index].name.clone()
            }
            Scalar::Let(id) => self.number(&self.mechanism.lets[id.index()].rest, unit),
            Scalar::Slide(link) => format!("{}.slide", self.link(*link)),
            Scalar::Coordinate(point, axis) => {
                let axis = if *axis == Axis::X { "x" } else { "y" };
                format!("{}.{axis}", self.point(*point))
            }
            Scalar::Distance([p, q]) => format!("distance({}, {})", self.point(*p), self.point(*q)),
            Scalar::Offset(point, guide) => {
                format!("offset({}, {})", self.point(*point), self.guide(*guide))
            }
            Scalar::AboveZero(number) => self.number(&number.value, unit),
            Scalar::Negate(inner) => format!("-{}", self.operand(inner, unit)),
            Scalar::Chain(first, rest) => self.chain(first, rest, unit),
            Scalar::Call(function, arguments) => {
                let measures = function.measures();
                let unit = unit_of_arguments(self.mechanism, measures, arguments, unit);
                let arguments: Vec<_> =
                    arguments.iter().map(|argument| self.number(argument, unit)).collect();
                format!("{}({})", function.name(), arguments.join(", "))
            }
            // Nothing that moves the machine reads them.
            Scalar::Pull
            | Scalar::Law(_)
            | Scalar::Twist(_)
            | Scalar::Effort(..)
            | Scalar::Rate(_) => "…".to_string(),
        }
    }

    /// Operations, each on what the one before has made.
    fn chain(&mut self, first: &Scalar, rest: &[(Operator, Scalar)], unit: DeclaredUnit) -> String {
        let is_product = |sign| matches!(sign, Operator::Mul | Operator::Div);
        let units = units_of_operands(self.mechanism, first, rest, unit);
        let mut text = self.operand(first, units[0]);
        for (index, (operator, operand)) in rest.iter().enumerate() {
            if is_product(*operator) && rest[..index].iter().any(|(sign, _)| !is_product(*sign)) {
                text = format!("({text})");
            }
            let sign = match operator {
                Operator::Add => '+',
                Operator::Sub => '-',
                Operator::Mul => '*',
                Operator::Div => '/',
            };
            text += &format!(" {sign} {}", self.operand(operand, units[index + 1]));
        }
        text
    }

    /// An operand, in parentheses where it is a chain itself.
    pub(super) fn operand(&mut self, value: &Scalar, unit: DeclaredUnit) -> String {
        let text = self.number(value, unit);
        match text.contains(' ') && !text.ends_with(')') || matches!(value, Scalar::Chain(..)) {
            true => format!("({text})"),
            false => text,
        }
    }

    pub(super) fn input(&mut self, input: InputId) -> String {
        self.inputs.insert(input.index());
        self.mechanism.inputs[input.index()].name.to_string()
    }

    pub(super) fn param(&mut self, param: ParamId) -> String {
        self.params.insert(param.index());
        self.mechanism.params[param.index()].name.to_string()
    }

    pub(super) fn point(&self, point: PointId) -> &Ident {
        &self.mechanism.points[point.index()].name
    }

    pub(super) fn link(&self, link: LinkId) -> &Ident {
        &self.mechanism.links[link.index()].name
    }

    pub(super) fn guide(&self, guide: GuideId) -> &Ident {
        &self.mechanism.guides[guide.index()].name
    }
}
