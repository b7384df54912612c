//! Tests of `interface/units_in_words`.

use crate::interface::quantity::Order;
use crate::model::mechanism::Dimension;
pub(crate) use linkage_compiler::interface::units_in_words::*;

#[test]
fn units_read_as_an_engineer_writes_them() {
    let dimension = |length, mass, time| Dimension { length, mass, time, angle: false };
    assert_eq!(unit(dimension(1, 0, 0), Order::Position), "m");
    assert_eq!(unit(Dimension::ANGLE, Order::Velocity), "rad/s");
    assert_eq!(unit(dimension(2, 1, 0), Order::Acceleration), "kg·m²/s²");
    assert_eq!(unit(dimension(0, 0, 0), Order::Position), "1");
    assert_eq!(unit(dimension(-1, 0, 0), Order::Position), "1/m");
    assert_eq!(unit(dimension(1, 1, -2), Order::Position), "N");
    assert_eq!(unit(dimension(2, 1, -2), Order::Position), "N·m");
    assert_eq!(unit(dimension(0, 1, -2), Order::Position), "N/m");
    assert_eq!(unit(dimension(1, 0, -2), Order::Position), "m/s²");
    assert_eq!(unit(dimension(0, 1, -1), Order::Position), "kg/s");
    assert_eq!(unit(dimension(-1, 1, -1), Order::Position), "kg/(m·s)");
}
