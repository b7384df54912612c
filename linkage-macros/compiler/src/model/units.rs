//! The units a literal may have, each an exact factor to SI.

use crate::exact::Exact;

use super::mechanism::Dimension;

/// The dimension of the unit and its exact value in SI.
pub fn unit(name: &str) -> Option<(Dimension, Exact)> {
    let ratio = |above: i64, below: i64| {
        Exact::integer(above).div(&Exact::integer(below)).expect("no unit divides by zero")
    };
    let (dimension, value) = match name {
        "m" => (Dimension::LENGTH, Exact::integer(1)),
        "cm" => (Dimension::LENGTH, ratio(1, 100)),
        "mm" => (Dimension::LENGTH, ratio(1, 1000)),
        "um" => (Dimension::LENGTH, ratio(1, 1_000_000)),
        "in" => (Dimension::LENGTH, ratio(254, 10_000)),
        "ft" => (Dimension::LENGTH, ratio(3048, 10_000)),
        "rad" => (Dimension::ANGLE, Exact::integer(1)),
        "deg" => (Dimension::ANGLE, Exact::pi().mul(&ratio(1, 180))),
        "turn" => (Dimension::ANGLE, Exact::pi().mul(&Exact::integer(2))),
        "kg" => (Dimension::MASS, Exact::integer(1)),
        "g" => (Dimension::MASS, ratio(1, 1000)),
        "t" => (Dimension::MASS, Exact::integer(1000)),
        "N" => (Dimension::FORCE, Exact::integer(1)),
        "kN" => (Dimension::FORCE, Exact::integer(1000)),
        "s" => (Dimension::TIME, Exact::integer(1)),
        "ms" => (Dimension::TIME, ratio(1, 1000)),
        _ => return None,
    };
    Some((dimension, value))
}

/// True if a unit is one of this dimension's, but not the SI unit that a bare number has.
pub(super) fn is_beside_si(name: &str, dimension: Dimension) -> bool {
    unit(name).is_some_and(|(own, value)| own == dimension && value != Exact::integer(1))
}
