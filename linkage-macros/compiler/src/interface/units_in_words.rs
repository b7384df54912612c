//! Units in words, for the docs.

use crate::interface::quantity::Order;
use crate::model::mechanism::Dimension;

/// The unit of a quantity or of its rates: `m`, `rad/s`, `N·m`; `1` for a plain number.
pub fn unit(dimension: Dimension, order: Order) -> String {
    let Dimension { length, mass, time, angle } = dimension;
    // Newtons, where a mass and as many seconds below the line are there for them.
    let forces = if mass > 0 && time <= -2 * mass { mass } else { 0 };
    let factors =
        [("N", forces), ("kg", mass - forces), ("m", length - forces), ("s", time + 2 * forces)];
    let line = |sign: i32| {
        let of_sign = factors.iter().filter(|(_, power)| power * sign > 0);
        of_sign.map(|(word, power)| raised(word, power * sign)).collect::<Vec<_>>().join("·")
    };
    let (above, below) = (line(1), line(-1));
    let unit = match (above.is_empty(), below.is_empty()) {
        (true, true) if angle => "rad".to_string(),
        (true, true) => "1".to_string(),
        (_, true) => above,
        (true, false) => format!("1/{below}"),
        (false, false) if below.contains('·') => format!("{above}/({below})"),
        (false, false) => format!("{above}/{below}"),
    };
    format!("{unit}{}", per_time(order))
}

/// The suffix of a unit at this order.
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
