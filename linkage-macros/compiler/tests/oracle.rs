//! The reference for the tests of several rooms: mechanisms from source text, programs computed in a hundred
//! digits, and their derivatives in time by central differences.

use crate::diagnostics::{Diagnostics, Failure};
use crate::exact::Exact;
use crate::exact::enclosure::Enclosure;
use crate::exact::reference::Reference;
use crate::function::Function;
use crate::ir::interpret::{Number, ProgramValues, Searched, interpret};
use crate::ir::program::Program;
use crate::model::mechanism::{Mechanism, ParamKind, Sign};
use crate::{model, syntax};

/// Fractional bits of the numbers below: about 120 decimals.
const BITS: u32 = 400;

/// The mechanism declared by the text, which must be free of mistakes.
pub(crate) fn mechanism(source: &str) -> Mechanism {
    let mut diagnostics = Diagnostics::new();
    let tokens = source.parse().expect("the declaration is made of tokens");
    let tree = syntax::parse(tokens, &mut diagnostics);
    let mechanism = tree.and_then(|tree| model::resolve(&tree, &mut diagnostics).ok());
    match diagnostics.finish() {
        Ok(()) => mechanism.expect("nothing was reported"),
        Err(Failure(mistakes)) => panic!("{source}\n{mistakes:#?}"),
    }
}

/// A number of a hundred digits.
#[derive(Clone)]
pub(crate) struct Digits(Enclosure);

impl Digits {
    pub(crate) fn float(value: f64) -> Self {
        Self::exact(&Exact::float(value).expect("finite"))
    }

    pub(crate) fn to_f64(&self) -> f64 {
        self.0.to_f64()
    }

    /// |self − other| relative to the larger of the two and one.
    pub(crate) fn apart(&self, other: &Self) -> f64 {
        let scale = self.to_f64().abs().max(other.to_f64().abs()).max(1.0);
        let difference = self.sub(other);
        assert!(difference.0.width() < 1e-60, "the numbers have run out of digits");
        difference.to_f64().abs() / scale
    }
}

impl Searched for Digits {
    fn point(&self) -> Self {
        Self(self.0.centre())
    }
}

impl Number for Digits {
    fn exact(value: &Exact) -> Self {
        Self(value.enclose(BITS).expect("constants of tests are tame"))
    }
    fn neg(&self) -> Self {
        Self(self.0.neg())
    }
    fn add(&self, other: &Self) -> Self {
        Self(self.0.add(&other.0))
    }
    fn sub(&self, other: &Self) -> Self {
        Self(self.0.sub(&other.0))
    }
    fn mul(&self, other: &Self) -> Self {
        Self(self.0.mul(&other.0))
    }
    fn div(&self, other: &Self) -> Self {
        Self(self.0.div(&other.0).expect("tests do not divide by zero"))
    }
    fn of(function: Function, operands: &[&Self]) -> Self {
        let operands: Vec<_> = operands.iter().map(|operand| &operand.0).collect();
        Self(Enclosure::of(function, &operands).expect("tests stay in the domain"))
    }
    fn is_at_least(&self, other: &Self) -> bool {
        self.to_f64() >= other.to_f64()
    }
}

/// The mechanism's parameters at their defaults.
pub(crate) fn defaults(mechanism: &Mechanism) -> Vec<Digits> {
    let sign = |sign: Sign| Exact::integer(if sign == Sign::Plus { 1 } else { -1 });
    mechanism
        .params
        .iter()
        .map(|param| match &param.kind {
            ParamKind::Number { default, .. } => Digits::exact(default),
            ParamKind::Mode { default, .. } => Digits::exact(&sign(*default)),
        })
        .collect()
}

/// The results of an entry point.
pub(crate) fn values(program: &Program, entry: &str, given: &ProgramValues<Digits>) -> Vec<Digits> {
    let entry = program.answer(entry).expect("the entry exists");
    let values = interpret(program, given);
    entry.sinks.iter().map(|sink| values[sink.index()].clone()).collect()
}

/// First and second derivative at 0 of a function of time, by 7-point central differences with
/// the step 2⁻⁴⁰: the truncation error is of the order h⁶ = 2⁻²⁴⁰, the rounding error of the
/// second one of the order 2⁻⁴⁰⁰/h² = 2⁻³²⁰.
pub(crate) fn derivatives(f: impl Fn(&Digits) -> Vec<Digits>) -> (Vec<Digits>, Vec<Digits>) {
    let step = Digits::float(0.5f64.powi(40));
    let whole = |n: i64| Digits::exact(&Exact::integer(n));
    let at: Vec<Vec<Digits>> = (-3..=3).map(|k| f(&step.mul(&whole(k)))).collect();
    let combine = |weights: [i64; 7], divisor: Digits| {
        (0..at[0].len())
            .map(|i| {
                let sum =
                    (0..7).fold(whole(0), |sum, k| sum.add(&at[k][i].mul(&whole(weights[k]))));
                sum.div(&divisor)
            })
            .collect()
    };
    let first = combine([-1, 9, -45, 0, 45, -9, 1], step.mul(&whole(60)));
    let second = combine([2, -27, 270, -490, 270, -27, 2], step.mul(&step).mul(&whole(180)));
    (first, second)
}
