//! Units in words, for the docs.

use crate::interface::quantity::Order;
use crate::model::mechanism::Dimension;

/// The unit of a quantity or of its rates: `m`, `rad/s`, `kg·m²/s²`; `1` for a plain number.
pub(crate) fn unit(dimension: Dimension, order: Order) -> String {
    let factors = [("kg", dimension.mass), ("m", dimension.length)];
    let mut words: Vec<String> =
        factors.iter().filter(|(_, power)| *power != 0).map(|(w, p)| raised(w, *p)).collect();
    if words.is_empty() {
        words.push(if dimension.angle { "rad" } else { "1" }.to_string());
    }
    format!("{}{}", words.join("·"), per_time(order))
}

/// What an order adds to a unit.
pub(crate) fn per_time(order: Order) -> &'static str {
    match order {
        Order::Position => "",
        Order::Velocity => "/s",
        Order::Acceleration => "/s²",
    }
}

fn raised(word: &str, power: i32) -> String {
    match power {
        1 => word.to_string(),
        2 => format!("{word}²"),
        3 => format!("{word}³"),
        _ => format!("{word}^{power}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_read_as_an_engineer_writes_them() {
        let dimension = |length, mass, angle| Dimension { length, mass, angle };
        assert_eq!(unit(dimension(1, 0, false), Order::Position), "m");
        assert_eq!(unit(dimension(0, 0, true), Order::Velocity), "rad/s");
        assert_eq!(unit(dimension(2, 1, false), Order::Acceleration), "kg·m²/s²");
        assert_eq!(unit(dimension(0, 0, false), Order::Position), "1");
        assert_eq!(unit(dimension(-1, 0, false), Order::Position), "m^-1");
    }
}
