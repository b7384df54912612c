//! Tests of `interface/quantity`.

pub(crate) use linkage_compiler::interface::quantity::*;

const ALL: [Quantity; 5] = [
    Quantity::Point,
    Quantity::Direction,
    Quantity::SlidingDirection,
    Quantity::Slide,
    Quantity::Value,
];

#[test]
fn rates_have_a_component_a_row() {
    for quantity in ALL {
        let rows = quantity.rows();
        for order in [Order::Velocity, Order::Acceleration] {
            let Layout { parts, rows: these, .. } = quantity.layout(order);
            assert_eq!((parts.len(), *these), (rows.len(), rows), "{quantity:?}");
        }
    }
}

#[test]
fn a_position_has_two_components_for_an_angle_and_one_for_every_other_row() {
    for quantity in ALL {
        let Layout { parts, rows, .. } = quantity.layout(Order::Position);
        let fields: Vec<_> = parts.iter().map(|part| part.field).collect();
        let expected: Vec<_> = (rows.iter())
            .flat_map(|&row| if row == "angle" { vec!["cos", "sin"] } else { vec![row] })
            .collect();
        assert_eq!(fields, expected, "{quantity:?}");
    }
}
